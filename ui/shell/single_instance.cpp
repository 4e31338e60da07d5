#include "ui/shell/single_instance.h"

#include <QDir>
#include <QLocalServer>
#include <QLocalSocket>

namespace kickstand::ui {

namespace {

/// The other one is on this machine: it answers at once, or not at all.
constexpr int kWakeLimit_ms = 500;

}  // namespace

SingleInstance::SingleInstance(const QString& folder, QObject* parent)
    : QObject(parent),
      lock_(QDir(folder).filePath(QStringLiteral("kickstand-window.lock"))),
      socket_(QDir(folder).filePath(QStringLiteral("kickstand-window"))) {
    // One that has crashed is told by its process, not by the lock's age.
    lock_.setStaleLockTime(0);
}

SingleInstance::~SingleInstance() = default;

bool SingleInstance::claim() {
    if (lock_.tryLock(0)) {
        listen();
        return true;
    }
    // Where no lock can be had at all, a program that starts is better than one that refuses to.
    if (lock_.error() != QLockFile::LockFailedError) return true;
    wakeOther();
    return false;
}

void SingleInstance::listen() {
    server_ = new QLocalServer(this);
    server_->setSocketOptions(QLocalServer::UserAccessOption);
    server_->setMaxPendingConnections(1);
    connect(server_, &QLocalServer::newConnection, this, [this] {
        while (QLocalSocket* other = server_->nextPendingConnection()) {
            connect(other, &QLocalSocket::disconnected, other, &QObject::deleteLater);
            emit showAsked();
            other->disconnectFromServer();
        }
    });
    // The lock is held: whatever stands at this place was left behind.
    QLocalServer::removeServer(socket_);
    server_->listen(socket_);
}

void SingleInstance::wakeOther() const {
    QLocalSocket other;
    other.connectToServer(socket_);
    if (!other.waitForConnected(kWakeLimit_ms)) return;
    other.waitForDisconnected(kWakeLimit_ms);
}

}  // namespace kickstand::ui
