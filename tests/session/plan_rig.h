#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/link/byte_tap.h"
#include "core/motionplan/session.h"
#include "core/motionplan/sim/nxt_sim.h"

namespace kickstand::testing {

/// A motion-plan session, a simulated NXT behind it and a person's hand on both, all on one fake clock.
class PlanRig : private ByteTapObserver {
  public:
    using Movements = std::vector<motionplan::wire::Movement>;

    explicit PlanRig(const motionplan::sim::NxtOptions& options = {});
    ~PlanRig() override;
    PlanRig(const PlanRig&) = delete;
    PlanRig& operator=(const PlanRig&) = delete;

    /// Starts the session and waits until it runs and the NXT has answered.
    bool connect();
    void advance(Duration span) { scheduler_.advance(span); }
    bool waitUntil(const std::function<bool()>& done, Duration limit = std::chrono::seconds(10)) {
        return scheduler_.runUntil(done, limit);
    }

    CommandId give(const motionplan::Command& command);
    std::optional<Result<void>> answer(CommandId id) const;
    std::size_t answers(CommandId id) const;
    /// Hands in a command and waits for its answer; Io when none comes within a minute.
    Result<void> ask(const motionplan::Command& command);
    /// The code of ask()'s error; none when the command was done.
    std::optional<Errc> refusal(const motionplan::Command& command);
    /// Creates the plan that most tests use: `plan` in `slot`, 20 cm and a right angle.
    bool create(int plan = 9, int slot = 4, const Movements& movements = kShort);
    static const Movements kShort;
    static const Movements kLong;  ///< More than a minute.

    void stop(StopReason reason = StopReason::Person);
    void beat(bool alive) { beating_ = alive; }

    motionplan::Snapshot state() const { return session_->snapshot(); }
    motionplan::Session& session() { return *session_; }
    const std::vector<motionplan::Event>& events() const { return events_; }
    std::size_t count(motionplan::EventKind kind) const;
    motionplan::sim::NxtSim& sim() { return sim_; }
    const motionplan::sim::RobotProgram& robot() const { return sim_.program(); }
    FakeScheduler& scheduler() { return scheduler_; }
    StopLatch& latch() { return stop_; }
    void simulate(const char* action, double value);
    /// Messages that the host has written into the command mailbox and the trigger plan's, as hex, without
    /// their terminator; those that were lost on their way included.
    const std::vector<std::string>& written() const { return written_; }
    void forgetWritten() { written_.clear(); }
    /// How many of them begin with this byte.
    std::size_t writtenOf(motionplan::wire::MessageKind kind) const;

  private:
    class Samples;

    void step();
    void observe(const ByteTapRecord& record) override;

    FakeScheduler scheduler_;
    StopLatch stop_;
    motionplan::sim::NxtSim sim_;
    motionplan::wire::TelegramParser watched_;
    std::vector<std::string> written_;
    std::vector<motionplan::Event> events_;
    std::map<CommandId, std::vector<Result<void>>> answers_;
    CommandId lastCommand_ = 0;
    bool beating_ = true;
    std::unique_ptr<Samples> samples_;
    std::unique_ptr<motionplan::Session> session_;
};

}  // namespace kickstand::testing
