#pragma once

#include <QObject>
#include <array>

class QSocketNotifier;

namespace kickstand::ui {

/// Turns SIGTERM, SIGINT and SIGHUP into a signal of Qt's, on the GUI thread. One at a time.
class SignalWatch final : public QObject {
    Q_OBJECT
  public:
    explicit SignalWatch(QObject* parent = nullptr);
    ~SignalWatch() override;

  signals:
    void quitAsked();

  private:
    std::array<int, 2> pipe_{-1, -1};
};

}  // namespace kickstand::ui
