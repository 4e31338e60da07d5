#pragma once

#include <QWidget>
#include <vector>

#include "core/engine/messages.h"

class QLabel;
class QVBoxLayout;

namespace kickstand::ui {

class Bench;
class Connector;

/// What fills the window while nothing is connected: what was found, what to plug in, and simulated robots,
/// offered with one big button and never taken unasked.
class StartPage final : public QWidget {
    Q_OBJECT
  public:
    StartPage(Bench& bench, Connector& connector, QWidget* parent = nullptr);

  signals:
    void doctorAsked();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void addOffers(QVBoxLayout* column);
    void addPort(const BytePort& port);
    void refresh();

    Bench& bench_;
    Connector& connector_;
    QLabel* headline_;
    QLabel* advice_;
    QVBoxLayout* found_;
    QStringList shown_;
};

}  // namespace kickstand::ui
