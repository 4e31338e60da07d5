#pragma once

#include <QObject>

class QWidget;

namespace kickstand::ui {

/// Tells when a window has been painted for the first time, and its picture is on its way to the screen.
class FirstPaint final : public QObject {
    Q_OBJECT
  public:
    explicit FirstPaint(QWidget& window);

    bool eventFilter(QObject* watched, QEvent* event) override;

  signals:
    void painted();
};

}  // namespace kickstand::ui
