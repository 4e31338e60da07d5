#pragma once

#include <QWidget>

#include "ui/thunderbots/choice_summary.h"

namespace kickstand::ui {

/// The highest voltage among the chosen robots' capacitors, large, with where it lies on the way to full.
class CapacitorReadout final : public QWidget {
    Q_OBJECT
  public:
    explicit CapacitorReadout(QWidget* parent = nullptr);

    void showState(const ChoiceSummary& summary, TimePoint now);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString number_;
    QString caption_;
    double level_ = 0;
    bool live_ = false;
};

}  // namespace kickstand::ui
