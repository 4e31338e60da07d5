#pragma once

#include <QPlainTextEdit>

#include "core/coach/traffic.h"

namespace kickstand::ui {

class Bench;

/// The newest packets in words, the last one at the bottom: when, from or to whom, what, and what became of
/// it.
class ConversationView final : public QPlainTextEdit {
    Q_OBJECT
  public:
    explicit ConversationView(Bench& bench, QWidget* parent = nullptr);

    /// Of what a panel has to give it takes the rest, and asks for some lines.
    QSize sizeHint() const override { return {320, 64}; }

    void show(const std::shared_ptr<const coach::TrafficEntries>& entries);

  private:
    QString lineOf(const coach::TrafficEntry& entry) const;

    Bench& bench_;
    std::shared_ptr<const coach::TrafficEntries> shown_;
};

}  // namespace kickstand::ui
