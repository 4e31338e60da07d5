#pragma once

#include <deque>
#include <memory>
#include <random>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/byte_device_model.h"
#include "core/link/sim_control.h"
#include "core/motionplan/sim/motionplan_options.h"
#include "core/motionplan/sim/robot_program.h"
#include "core/motionplan/wire/telegram_parser.h"

namespace kickstand::motionplan::sim {

/// What a test may want to know about a simulated NXT.
struct NxtReport {
    bool attached = false;
    bool open = false;  ///< A host holds the line.
    bool programRuns = true;
    std::uint64_t written = 0;    ///< Messages that a host wrote and that arrived.
    std::uint64_t reads = 0;      ///< Reads that were answered.
    std::uint64_t lost = 0;       ///< Messages and replies lost by chance or on purpose.
    std::uint64_t overflows = 0;  ///< Messages pushed out of a full outbox.
    std::uint64_t skipped = 0;    ///< Bytes that belonged to no telegram.
};

/// A simulated NXT: its mailboxes, its Bluetooth line, and the robot's program behind them. Every method on
/// the scheduler's thread.
class NxtSim final : public ByteDeviceModel {
  public:
    /// How many messages an outbox holds before the oldest is lost (protocol 3), how long the NXT takes to
    /// answer, and how long the program takes to look into its mailbox.
    static constexpr std::size_t kOutbox = 5;
    static constexpr Duration kReplyTime = std::chrono::milliseconds(30);
    static constexpr Duration kProgramTime = std::chrono::milliseconds(20);
    static constexpr Duration kTick = std::chrono::milliseconds(20);

    explicit NxtSim(Scheduler& scheduler, const NxtOptions& options = {});
    ~NxtSim() override;
    NxtSim(const NxtSim&) = delete;
    NxtSim& operator=(const NxtSim&) = delete;

    SimControl& control() { return *control_; }
    RobotProgram& program() { return program_; }
    const RobotProgram& program() const { return program_; }
    NxtReport report() const;

    Weather weather() const { return options_.weather; }
    void setWeather(const Weather& weather) { options_.weather = weather; }
    bool readsText() const { return options_.text; }
    void setReadsText(bool text) { options_.text = text; }
    /// Bluetooth within reach, or not: the robot then starts its trigger plan.
    void setAttached(bool attached);
    void setProgramRuns(bool runs);
    bool programRuns() const { return programRuns_; }
    /// The next so many messages to the robot, or from it, do not arrive.
    void loseNext(int toRobot, int fromRobot);
    int loseNextToRobot() const { return loseToRobot_; }
    int loseNextFromRobot() const { return loseFromRobot_; }
    /// Of the messages from the robot only this one, counted from 1, does not arrive; 0 for none.
    void loseOne(int fromRobot) { loseOneFromRobot_ = fromRobot; }
    int loseOneFromRobot() const { return loseOneFromRobot_; }
    /// The robot's program puts out a message, which is lost, doubled and late as the weather wants.
    void put(ByteView message);

    bool attached() const override { return attached_; }
    void setListener(ByteDeviceListener* listener) override { listener_ = listener; }
    void lineOpened(Baud baud) override;
    void lineClosed() override;
    void lineBaudChanged(Baud baud) override;
    void hostSent(ByteView bytes) override;

  private:
    void take(const wire::Telegram& telegram);
    std::uint8_t write(const wire::MessageWrite& write);
    wire::ReadReply read(const wire::MessageRead& read);
    void arrived(std::uint8_t box, const wire::MailboxBytes& content);
    void putNow(const wire::MailboxBytes& content);
    void reply(const wire::Telegram& telegram);
    void gone();
    bool byChance(double probability);
    /// As Scheduler::callAfter(), unless this is gone by then.
    void later(Duration delay, std::function<void()> act);
    void tick();

    Scheduler& scheduler_;
    NxtOptions options_;
    std::mt19937_64 random_;
    RobotProgram program_;
    wire::TelegramParser parser_;
    ByteDeviceListener* listener_ = nullptr;
    std::deque<wire::MailboxBytes> outbox_;
    wire::MailboxBytes triggerBox_;
    bool attached_ = true;
    bool open_ = false;
    bool programRuns_ = true;
    int loseToRobot_ = 0;
    int loseFromRobot_ = 0;
    int loseOneFromRobot_ = 0;
    NxtReport counters_;
    std::uint64_t connection_ = 0;
    std::unique_ptr<SimControl> control_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace kickstand::motionplan::sim
