#pragma once

#include <QObject>
#include <map>
#include <vector>

#include "ui/shell/engine_client.h"
#include "ui/shell/system_view.h"

class QSettings;

namespace kickstand::ui {

/// What every part of the window works with: the engine, the session that is shown, the systems there are,
/// and what is remembered between runs. GUI thread.
class Bench final : public QObject {
    Q_OBJECT
  public:
    /// All of them must outlive this.
    Bench(EngineClient& client, const SystemRegistry& systems, QSettings& settings,
          QObject* parent = nullptr);

    EngineClient& client() const { return client_; }
    const SystemRegistry& systems() const { return systems_; }
    QSettings& settings() const { return settings_; }

    /// The session that the window shows; null where there is none.
    const SessionSnapshot* session() const { return client_.session(current_); }
    SessionId sessionId() const { return current_; }
    /// Whether a session has been asked for and is not there yet.
    bool isConnecting() const { return awaited_ != 0; }
    /// The view of that session's system; null where there is none.
    const SystemView* view() const;
    void show(SessionId id);
    /// Whether anything of any session moves, charges or executes, or a command that is not answered yet may
    /// make it so.
    bool isMoving() const;
    /// The same, or is armed.
    bool isActive() const;

    /// What was dangerous when its link was let go: nobody has seen it safe since. Not of simulated links,
    /// whose robots are gone with them.
    const std::vector<Hazard>& leftBehind() const { return leftBehind_; }
    /// A person says that it is safe now.
    void forgetLeftBehind();

    /// Hands in a command for the shown session.
    void submit(CommandBody body, QObject* context = nullptr, EngineClient::Answered answered = {});

    /// Opens a link and shows it; what was connected before is let go, so that nothing simulated mixes with
    /// hardware.
    void connectTo(const LinkUri& uri);
    /// As connectTo(), beside what is connected.
    void connectBeside(const LinkUri& uri);
    void disconnectAll();

    /// Which of a quantity's units a person has chosen, by its place in UnitChoice::units. Remembered.
    int unitOf(const QString& quantity) const;
    void chooseUnit(const QString& quantity, int unit);

    /// Brings a panel to the front; "faults#dongle-41" also names one thing in it.
    void goTo(const QString& place);

  signals:
    /// A panel, by its id, and what to show in it.
    void placeAsked(const QString& panel, const QString& detail);
    /// There is a new snapshot, or another session is shown.
    void changed();
    /// Another session is shown, or none.
    void sessionChanged();
    void unitsChanged();
    /// A link could not be made.
    void connectRefused(const kickstand::Error& error);

  private:
    void follow();
    bool any(bool (SystemView::*holds)(const SystemSnapshot&) const) const;
    void rememberHazards();
    void giveUp(SessionId id, const Error& error);

    EngineClient& client_;
    const SystemRegistry& systems_;
    QSettings& settings_;
    SessionId current_ = 0;
    SessionId awaited_ = 0;
    std::map<SessionId, std::vector<Hazard>> hazards_;  ///< Of hardware, as last known.
    std::vector<Hazard> leftBehind_;
};

}  // namespace kickstand::ui
