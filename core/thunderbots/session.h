#pragma once

#include <array>
#include <memory>

#include "core/base/session_host.h"
#include "core/link/tapped_usb_link.h"
#include "core/thunderbots/bench_checker.h"
#include "core/thunderbots/commands.h"
#include "core/thunderbots/discharger.h"
#include "core/thunderbots/dongle_controller.h"
#include "core/thunderbots/flash_queue.h"
#include "core/thunderbots/fleet_model.h"
#include "core/thunderbots/kick_log.h"
#include "core/thunderbots/parameter_service.h"
#include "core/thunderbots/robot_driver.h"
#include "core/thunderbots/robot_requests.h"
#include "core/thunderbots/sweeper.h"

namespace kickstand::thunderbots {

/// One connection to a fleet: the model that watches the link, the controller that works it, and between them
/// the rules by which a person's commands may move, charge or fire anything. Engine thread.
class Session {
  public:
    using Host = SessionHost<Event>;

    /// Wraps `link` in the tap that feeds the model. Nothing is opened before start().
    Session(Host host, std::unique_ptr<UsbLink> link);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Begins to look for the device.
    void start();
    /// Does a command; the answer comes through the host, now or later, exactly once.
    void execute(CommandId id, const Command& command);
    /// The safety step, every 10 ms: ramps, keep-alives while a person's side is alive, braked blocks when it
    /// is not.
    void step(TimePoint now, bool heartbeatFresh);
    /// STOP has been latched: kicks are dropped and braked blocks go to everybody.
    void halt();
    /// Whether anything moves, charges, is armed or discharges.
    bool active() const;
    /// Brakes, waits until the link has taken it, but not for long, and closes. `done` comes once. Commands
    /// are refused from here on, and those under way are answered before it comes.
    void shutdown(std::function<void()> done);

    /// Rises whenever snapshot() would show something else.
    std::uint64_t version() const {
        return model_.version() + kickLog_.version() + requests_.version() + parameters_.version() +
               flash_.version() + version_;
    }
    Snapshot snapshot() const;

  private:
    /// How long braked blocks are waited for before a link is given up or its radios begin anew.
    static constexpr Duration kLastBlocksLimit = std::chrono::milliseconds(300);

    void perform(CommandId id, const SetWheels& command);
    void perform(CommandId id, const Brake& command);
    void perform(CommandId id, const SetWheelLimit& command);
    void perform(CommandId id, const SetDribbler& command);
    void perform(CommandId id, const ArmHighVoltage& command);
    void perform(CommandId id, const SetCharger& command);
    void perform(CommandId id, const Kick& command);
    void perform(CommandId id, const SetAutokick& command);
    void perform(CommandId id, const SetTestMode& command);
    void perform(CommandId id, const Discharge& command);
    void perform(CommandId id, const ClearExperiment& command);
    void perform(CommandId id, const StartSweep& command);
    void perform(CommandId id, const StopSweep& command);
    void perform(CommandId id, const StartCheck& command);
    void perform(CommandId id, const AnswerCheck& command);
    void perform(CommandId id, const StopCheck& command);
    void perform(CommandId id, const SetChannels& command);
    void perform(CommandId id, const StartFlash& command);
    void perform(CommandId id, const CancelFlash& command);
    void perform(CommandId id, const ResumeFlash& command);
    Result<void> checkStartFlash(int robot) const;
    /// Whether a robot's capacitor is below 50 V, or was when it was last measured.
    Result<void> checkCapacitor(int robot, bool unknownWillDo) const;
    /// Whether a robot that is being flashed may be erased or rebooted.
    Result<void> checkAtRest(int robot, const FlashOptions& options) const;
    /// Whether the cable that was lost belongs to a robot that was told to reboot: nothing is wrong then.
    bool wentWithItsRobot() const;
    void flashEnded(int robot, const FlashProgress& progress);
    void perform(CommandId id, const ReadParameters& command);
    void perform(CommandId id, const ReadSignatures& command);
    void perform(CommandId id, const ApplyParameters& command);
    void perform(CommandId id, const CommitParameters& command);
    void perform(CommandId id, const RebootRobot& command);

    /// Does `one` for every robot of the mask that `check` lets pass, and answers with the first error.
    void forRobots(CommandId id, RobotMask robots, const std::function<Result<void>(int)>& check,
                   const std::function<Result<void>(int)>& one);
    Result<void> checkRunning() const;
    /// Whether a robot may move at all; checkMayMove(): by a person's hand.
    Result<void> checkReady(int robot) const;
    Result<void> checkMayMove(int robot) const;
    Result<void> checkHighVoltage(int robot) const;
    Result<void> checkNotSweeping(int robot) const;
    Result<void> checkAskable(int robot) const;
    Result<void> checkApply(const ApplyParameters& command) const;
    Result<void> checkReboot(const RebootRobot& command) const;
    /// Gives the command's answer when the robot's has come.
    ParameterService::Done answering(CommandId id);
    RobotMask aliveRobots() const;
    Result<void> checkSweep(const SweepPlan& plan) const;
    Result<void> checkCheck(const CheckPlan& plan) const;
    /// `cause`: what it is to be logged as; none for a pulse of a discharge.
    Result<void> giveKick(int robot, const wire::KickTimes& times, std::optional<KickCause> cause,
                          std::function<void(Result<void>)> done);
    void modelEvent(const Event& event);
    void stateChanged();
    void robotLost(int robot, TimePoint time);
    void brakeForStaleHeartbeat(bool fresh);
    void stopAfterSilence();
    void sendBlock(int robot);
    void sendRamps(TimePoint now);
    void stepDischarge(int robot, TimePoint now);
    void endDischarge(int robot, std::int64_t code);
    void stepSweep(TimePoint now);
    void giveSweepKick(TimePoint now);
    void endSweep(std::optional<Errc> why);
    void stepCheck(TimePoint now);
    Result<void> demand(int robot, const CheckDemand& demand, TimePoint now);
    Result<void> demandKick(int robot);
    void leaveChecked(int robot);
    bool othersBusy(int robot) const;
    void beginDischarge(int robot);
    void endCheck(Errc why);
    void checkedRobotLost(int robot);
    void haltDrivers();
    void resetConnection();
    void close();
    void raise(EventKind kind, int robot = -1, std::int64_t code = 0, std::int64_t previous = 0,
               std::string text = {});
    RobotDriver& driver(int robot) { return drivers_[static_cast<std::size_t>(robot)]; }
    const RobotDriver& driver(int robot) const { return drivers_[static_cast<std::size_t>(robot)]; }

    Host host_;
    TappedUsbLink link_;
    KickLog kickLog_;
    FleetModel model_;
    DongleController controller_;
    RobotRequests requests_;
    ParameterService parameters_;
    FlashQueue flash_;
    std::array<FlashOptions, kRobots> flashOptions_;
    std::array<RobotDriver, kRobots> drivers_;
    Discharger discharger_;
    Sweeper sweeper_;
    BenchChecker checker_;
    int wheelLimit_ = kStartingWheelLimit;
    bool kickOutstanding_ = false;
    bool sweepKickOutstanding_ = false;
    bool heartbeatFresh_ = false;
    bool restarting_ = false;  ///< Braking for a new start of the radios: takes no commands.
    bool ending_ = false;      ///< shutdown() has been called: nothing begins any more.
    std::function<void()> shutDown_;
    TimerId shutdownDeadline_ = 0;
    TimerId restartDeadline_ = 0;
    std::uint64_t connections_ = 0;
    std::uint64_t version_ = 0;
    LinkState lastState_ = LinkState::Idle;
};

}  // namespace kickstand::thunderbots
