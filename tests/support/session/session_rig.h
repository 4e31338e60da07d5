#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/engine/engine_core.h"
#include "core/link/tap.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand::testing {

/// How a rig is made.
struct SessionRigOptions {
    thunderbots::sim::ThunderbotsSimOptions sim;
    EngineOptions engine;
    /// Makes the link to the simulated device; without it that is a loopback.
    std::function<std::unique_ptr<UsbLink>(UsbDeviceModel& device, Scheduler& scheduler)> makeLink;
    /// Puts something around the link to the simulated device, such as faults.
    std::function<std::unique_ptr<UsbLink>(std::unique_ptr<UsbLink> link, Scheduler& scheduler)> decorate;
    /// Whether every OUT packet that the link took is kept, in packets().
    bool keepPackets = true;
    /// Sees all that passes on the link too; may be null.
    UsbTapObserver* observer = nullptr;
};

/// An OUT packet that the link took.
struct TakenPacket {
    TimePoint time{};
    std::uint8_t endpoint = 0;
    std::vector<std::uint8_t> bytes;
};

/// The engine without its thread, a session of simulated robots behind it, and a person's hand on both, all
/// on one fake clock. The person's side is alive as long as beat() says so.
class SessionRig final : private LinkProvider, private UsbTapObserver {
  public:
    explicit SessionRig(SessionRigOptions options = {});
    ~SessionRig() override;
    SessionRig(const SessionRig&) = delete;
    SessionRig& operator=(const SessionRig&) = delete;

    /// Asks for a session, and waits until it runs and has found every robot that is up. False when that
    /// takes more than 20 s.
    bool connect();
    /// Only asks for it.
    void beginConnect();
    /// Whether the session runs and has found every robot that is up.
    bool isRunning();

    void advance(Duration span) { scheduler_.advance(span); }
    /// Lets time pass until `done` holds. False when it does not within `limit`.
    bool waitUntil(const std::function<bool()>& done, Duration limit = std::chrono::seconds(5)) {
        return scheduler_.runUntil(done, limit);
    }
    /// Whether the person's side gives signs of life, every 50 ms; it does from the start.
    void beat(bool alive) { beating_ = alive; }

    /// Hands in a command.
    CommandId give(const thunderbots::Command& command);
    CommandId give(CommandBody body, SessionId session);
    /// The answer to a command, when it has come.
    std::optional<Result<void>> answer(CommandId id);
    /// How many answers a command has had.
    std::size_t answers(CommandId id);
    /// Every command that was handed in and has no answer.
    std::vector<CommandId> unanswered();
    /// Hands in a command and waits for its answer; TimedOut when none comes within 2 s.
    Result<void> ask(const thunderbots::Command& command);
    /// The code of ask()'s error; none when the command was done.
    std::optional<Errc> refusal(const thunderbots::Command& command);

    /// STOP, as the engine's own face does it.
    void stop(StopReason reason = StopReason::Person);
    void rearm();
    /// Makes an armed robot of one that is alive: its charger may be switched on, it may kick.
    Result<void> arm(int robot) { return ask(thunderbots::ArmHighVoltage{thunderbots::maskOf(robot), true}); }

    /// The session as it was last published.
    thunderbots::Snapshot state();
    const std::vector<thunderbots::Event>& events();
    std::size_t count(thunderbots::EventKind kind);
    std::optional<thunderbots::Event> last(thunderbots::EventKind kind);
    const std::vector<TakenPacket>& packets() const { return packets_; }
    void forgetPackets() { packets_.clear(); }
    /// Forgets answers, events and packets that were seen, for runs that last long.
    void forget();

    /// The program ends without a word: no braked blocks, no closing. The device keeps its configuration.
    void killHost();
    EngineCore& core() { return *core_; }
    EngineFlows& flows() { return core_->flows(); }
    FakeScheduler& scheduler() { return scheduler_; }
    thunderbots::sim::ThunderbotsSim& sim() { return sim_; }
    thunderbots::sim::RobotReport robot(int unit) const { return sim_.robot(unit); }
    /// Does something to the simulated world; -1 for all robots, or for the device.
    void simulate(const char* action, double value, int unit = -1);
    /// Whether any wheel of any robot turns.
    bool anyWheelTurns() const;

  private:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override;
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override;
    void observe(const UsbTapRecord& record) override;
    void heartbeat();
    void readFlows();

    FakeScheduler scheduler_;
    SessionRigOptions options_;
    thunderbots::sim::ThunderbotsSim sim_;
    bool beating_ = true;
    std::vector<TakenPacket> packets_;
    std::unique_ptr<EngineCore> core_;
    SessionId session_ = 0;
    CommandId lastCommand_ = 0;
    std::map<CommandId, std::vector<Result<void>>> answers_;
    std::vector<thunderbots::Event> events_;
    std::uint64_t eventCursor_ = 0;
};

}  // namespace kickstand::testing
