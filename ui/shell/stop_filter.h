#pragma once

#include <QObject>
#include <functional>

class QKeyEvent;

namespace kickstand::ui {

/// Space and Esc are STOP, wherever the focus is and whatever dialog is open: an event filter on the
/// application, ahead of everything. Only while nothing moves, charges, is armed or executes does Space type
/// a space into a text field, and does Esc close a menu or a dialog. Since Space never presses a button,
/// Enter does.
class StopFilter final : public QObject {
    Q_OBJECT
  public:
    /// Installs itself on the application. `isActive` tells whether anything moves, charges, is armed or
    /// executes.
    explicit StopFilter(std::function<bool()> isActive, QObject* parent = nullptr);

    bool eventFilter(QObject* watched, QEvent* event) override;

  signals:
    void stopAsked();

  private:
    bool isStop(const QKeyEvent& event) const;
    static bool pressButton(const QKeyEvent& event);

    std::function<bool()> isActive_;
};

}  // namespace kickstand::ui
