#pragma once

#include <QDBusUnixFileDescriptor>
#include <QObject>

class QDBusPendingCallWatcher;

namespace kickstand::ui {

/// Tells before the machine goes to sleep, through logind on the system bus; without one it stays quiet.
/// Holds a delay lock, so that there is time to act.
class SuspendWatch final : public QObject {
    Q_OBJECT
  public:
    explicit SuspendWatch(QObject* parent = nullptr);

  signals:
    void aboutToSleep();

  public slots:
    /// What logind sends: true before the sleep, false after it.
    void prepareForSleep(bool before);

  private:
    void takeLock();

    QDBusUnixFileDescriptor lock_;
};

}  // namespace kickstand::ui
