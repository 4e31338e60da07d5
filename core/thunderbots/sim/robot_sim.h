#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <random>

#include "core/thunderbots/sim/break_beam.h"
#include "core/thunderbots/sim/firmware_service.h"
#include "core/thunderbots/sim/flash_chip.h"
#include "core/thunderbots/sim/microcontroller.h"
#include "core/thunderbots/sim/robot_body.h"
#include "core/thunderbots/sim/robot_report.h"
#include "core/thunderbots/sim/timers.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::sim {

/// How a robot comes out of the factory.
struct RobotSettings {
    std::uint8_t number = 0;
    double battery_V = 16.0;
    wire::Channels channels{};
    std::uint64_t seed = 1;
    bool noise = true;  ///< Whether its converters are off by a step now and then.
};

/// A message that a robot has for the host.
struct OutgoingMessage {
    wire::Pipe pipe = wire::Pipe::Indicator;
    wire::MessagePayload payload;
    bool rebootAfterwards = false;
};

/// One robot (protocol 6): what it does with what reaches it, however that is carried. Its mechanics are
/// worked out when somebody looks or something changes, not by ticks: a robot that nobody asks costs nothing.
/// On the scheduler's thread.
class RobotSim {
  public:
    using FeedbackBytes = std::array<std::uint8_t, wire::kFeedbackBytes>;
    /// What a carrier wants to hear of; either may be empty.
    struct Listener {
        std::function<void()> messageWaiting;
        std::function<void()> powerChanged;
    };

    /// The robot is up from the start.
    RobotSim(Scheduler& scheduler, const RobotSettings& settings);
    RobotSim(const RobotSim&) = delete;
    RobotSim& operator=(const RobotSim&) = delete;

    // For whoever carries its data.
    void setListener(Listener listener) { listener_ = std::move(listener); }
    bool up() const { return power_ == RobotPower::Up; }
    /// How often it has come up; a carrier that finds another number than before finds it without memory.
    std::uint32_t boots() const { return boots_; }
    std::uint8_t number() const { return number_; }
    const wire::Channels& channels() const { return channels_; }
    /// A fresh drive block of any content and length (protocol 4.1, 6.1).
    void takeDrive(ByteView block);
    /// The last drive block counts as fresh again, unless it has timed out (protocol 3.11).
    void refreshDrive();
    /// A message for one of its pipes, each once and in order.
    void takeMessage(wire::Pipe pipe, ByteView payload);
    /// What it measures now; none where it is not up.
    std::optional<FeedbackBytes> feedback();
    /// The message to send next; null for none.
    const OutgoingMessage* outgoing() const { return outgoing_.empty() ? nullptr : &outgoing_.front(); }
    /// That message has reached the host.
    void outgoingDelivered();
    /// What waits to be sent is given up.
    void dropOutgoing();

    // For a hand from outside.
    /// Puts a ball into the break beam, or takes it out.
    void setBall(bool ball);
    bool ball() const { return beam_.ball(); }
    /// The battery's voltage at rest, volts.
    void setBattery(double volts);
    double battery_V() const { return body_.battery.rest_V(); }
    void setCapacitor(double volts);
    void setTemperature(double celsius);
    /// Bit n: wheel n + 1 does not turn any more.
    void setDeadWheels(std::uint8_t wheels);
    std::uint8_t deadWheels() const { return body_.deadWheels; }
    /// A charger that gives nothing.
    void setChargerBroken(bool broken);
    bool chargerBroken() const { return body_.chargerBroken; }
    /// Switches the robot off, or on again; that ends a lock-out too. Coming up takes a boot.
    void switchPower(bool on);
    /// Sends the eight pieces of an experiment's buffer (protocol 4.6).
    void sendExperiment();

    // For a look.
    /// Everything about it at this moment.
    RobotReport report();
    const FlashChip& flash() const { return flash_; }

  private:
    void advance();
    void passTo(TimePoint until);
    BodyInputs inputs() const;
    void act(const wire::DriveBlock& block);
    void considerAutokick();
    void takeKick(ByteView payload);
    void kick(const wire::KickTimes& times, bool automatic);
    void takeTestMode(ByteView payload);
    wire::TestMode shownTestMode() const;
    wire::FeedbackBlock measure();
    void send(wire::Pipe pipe, const wire::MessagePayload& payload, bool rebootAfterwards = false);
    void powerDown(RobotPower state);
    void reboot();
    void boot();
    void bootDone();
    void comeUp();
    void configure();

    Scheduler& scheduler_;
    Listener listener_;
    RobotBody body_;
    BreakBeam beam_;
    FlashChip flash_;
    Microcontroller controller_;
    FirmwareService firmware_;
    Timer bootTimer_;
    Timer lockOutTimer_;
    std::mt19937_64 noise_;
    const bool noisy_;

    RobotPower power_ = RobotPower::Up;
    std::uint32_t boots_ = 0;
    std::uint8_t number_ = 0;
    wire::Channels channels_;
    bool fpga_ = true;
    TimePoint time_;       ///< Up to when the mechanics are worked out.
    TimePoint detailEnd_;  ///< Until then in short steps; nothing but slow curves after.
    TimePoint validFrom_;

    bool driveFresh_ = false;
    std::array<std::uint8_t, wire::kDriveBytes> driveBytes_{};
    wire::DriveBlock lastDrive_;
    wire::DriveBlock acting_;  ///< The last block while it is fresh, else a braked one.
    TimePoint driveTime_{};
    wire::TestMode testMode_;
    std::deque<OutgoingMessage> outgoing_;

    std::uint64_t driveBlocks_ = 0;
    std::uint64_t driveChanges_ = 0;
    std::uint64_t driveTimeouts_ = 0;
    std::uint64_t testModeMessages_ = 0;
    std::uint64_t kicks_ = 0;
    std::uint64_t automaticKicks_ = 0;
    std::deque<KickRecord> lastKicks_;
    std::uint64_t malformed_ = 0;
    std::uint64_t lostMessages_ = 0;
};

}  // namespace kickstand::thunderbots::sim
