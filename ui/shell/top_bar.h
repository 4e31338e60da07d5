#pragma once

#include <QWidget>
#include <vector>

class QHBoxLayout;
class QMenu;
class QPushButton;

namespace kickstand::ui {

class Bench;
class StateLabel;
class StopButton;

/// The bar at the top: connecting, how things stand, menus, and STOP at the right end, always in the same
/// place.
class TopBar final : public QWidget {
    Q_OBJECT
  public:
    TopBar(Bench& bench, QMenu* connectMenu, QMenu* viewMenu, QMenu* helpMenu, QWidget* parent = nullptr);

    QPushButton* connectButton() const { return connect_; }
    StopButton* stopButton() const { return stop_; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void refresh();
    StateLabel* stateLabel(std::size_t index);

    Bench& bench_;
    QPushButton* connect_;
    StopButton* stop_;
    QHBoxLayout* states_;
    std::vector<StateLabel*> labels_;
};

}  // namespace kickstand::ui
