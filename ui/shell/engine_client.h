#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/engine/engine.h"

namespace kickstand::ui {

/// The engine as the window sees it: state and events arrive as signals at the screen's rate, answers find
/// who asked, and the heartbeat that everything moving needs is sent from this thread's own event loop, so
/// that a frozen window stops the robots. GUI thread.
class EngineClient final : public QObject {
    Q_OBJECT
  public:
    using Answered = std::function<void(const Result<void>&)>;

    /// The engine must outlive this.
    explicit EngineClient(Engine& engine, QObject* parent = nullptr);

    /// The latest state; never null.
    const EngineSnapshot& snapshot() const { return *snapshot_; }
    const SessionSnapshot* session(SessionId id) const;
    TimePoint now() const { return engine_.now(); }
    std::chrono::system_clock::time_point wallTime(TimePoint time) const { return engine_.wallTime(time); }

    /// Hands in a command. `answered` is called once, later, unless `context` is gone by then. A refusal is
    /// also told to everybody by refused().
    void submit(SessionId session, CommandBody body, QObject* context = nullptr, Answered answered = {});
    /// Opens a session. Where it cannot be made connectRefused() tells.
    Result<SessionId> connectTo(const LinkUri& uri);
    /// Whether a system's command waits for its answer.
    bool hasPending() const { return waiting_ > 0; }
    /// Whether one does that may set something in motion: more may move than the snapshot knows.
    bool hasMotionPending() const { return waitingToMove_ > 0; }

    void stop(StopReason reason);
    void rearm();
    bool isStopped() const { return engine_.isStopped(); }
    /// Why; None while nothing is stopped.
    StopReason stopReason() const;

  signals:
    void snapshotChanged();
    /// Oldest first. `lost` more had been forgotten before they could be read.
    void eventsArrived(const std::vector<kickstand::EngineEvent>& events, quint64 lost);
    void refused(const kickstand::Error& error);
    void connectRefused(quint32 session, const kickstand::Error& error);
    /// The latch was set or released.
    void stopChanged();

  private:
    struct Pending {
        QPointer<QObject> context;
        bool hasContext = false;
        bool toSystem = false;
        bool moves = false;
        Answered answered;
    };

    void poll();
    void takeAnswers();
    void takeEvents();
    void noticeStop();

    Engine& engine_;
    std::shared_ptr<const EngineSnapshot> snapshot_;
    std::uint64_t version_ = 0;
    std::uint64_t cursor_ = 0;
    bool stopped_ = false;
    StopReason asked_ = StopReason::None;
    std::unordered_map<CommandId, Pending> pending_;
    int waiting_ = 0;
    int waitingToMove_ = 0;
    QTimer poll_;
    QTimer heartbeat_;
};

}  // namespace kickstand::ui
