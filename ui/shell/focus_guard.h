#pragma once

#include <QObject>

namespace kickstand::ui {

class Bench;

/// STOP when the window loses the keyboard while something moves: whoever drives cannot stop it by key any
/// more. A setting, for driving by gamepad.
class FocusGuard final : public QObject {
    Q_OBJECT
  public:
    explicit FocusGuard(Bench& bench, QObject* parent = nullptr);

    bool isOn() const { return on_; }
    void setOn(bool on);

  private:
    void stateChanged(Qt::ApplicationState state);

    Bench& bench_;
    bool on_ = true;
};

}  // namespace kickstand::ui
