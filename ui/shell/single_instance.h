#pragma once

#include <QLockFile>
#include <QObject>

class QLocalServer;

namespace kickstand::ui {

/// One running window for each user: two of them would drive the same robots. The first one keeps a place in
/// `folder`; whoever comes later is told so, and the first is asked to show itself.
class SingleInstance final : public QObject {
    Q_OBJECT
  public:
    /// `folder` belongs to the user alone and is there until the session ends.
    explicit SingleInstance(const QString& folder, QObject* parent = nullptr);
    ~SingleInstance() override;

    /// True when this is the first from now on, or nobody can tell. False when another one runs; it has been
    /// asked to show itself.
    bool claim();

  signals:
    /// Another one was started: this window is what its user is looking for.
    void showAsked();

  private:
    void listen();
    void wakeOther() const;

    QLockFile lock_;
    QString socket_;
    QLocalServer* server_ = nullptr;
};

}  // namespace kickstand::ui
