#pragma once

#include <array>
#include <bitset>
#include <optional>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/link/usb_types.h"
#include "core/thunderbots/bench_check.h"
#include "core/thunderbots/flash_progress.h"
#include "core/thunderbots/kick_record.h"
#include "core/thunderbots/parameter_state.h"
#include "core/thunderbots/request_state.h"
#include "core/thunderbots/sweep_plan.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/indicator.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::thunderbots {

/// How much a robot's readings can be trusted (protocol 6.9).
enum class Freshness : std::uint8_t {
    NotHeard,  ///< Never heard on this connection, nor before.
    Waiting,   ///< Alive, but it has never sent valid readings.
    Current,   ///< What is shown is what is.
    Stale,     ///< What is shown was so until RobotState::currentUntil.
};

/// The physical meaning of a feedback block (protocol 6.2-6.5).
struct Readings {
    double battery_V = 0;
    double capacitor_V = 0;
    double dribbler_C = 0;
    int light_adc = 0;
    bool ball = false;
    bool charged = false;
};

/// The 256-byte experiment buffer as far as it has arrived (protocol 4.6).
struct ExperimentBuffer {
    std::array<std::uint8_t, wire::kExperimentBufferBytes> data{};
    std::bitset<wire::kExperimentBufferBytes> known;
    std::uint32_t messages = 0;
    std::uint32_t rejected = 0;  ///< Messages whose offset was past the last legal one.
};

/// The highest voltage that may still be on a capacitor: remembered when the robot is stale or lost.
struct CapacitorMemory {
    double last_V = 0;
    TimePoint at{};
};

/// One robot, as the model knows it from what passed on the link.
struct RobotState {
    bool live = false;  ///< The dongle's live bit.
    Freshness freshness = Freshness::NotHeard;
    TimePoint currentUntil{};  ///< For Stale: until when the readings were known to be true.
    std::optional<wire::FeedbackBlock> feedback;  ///< The last valid block ever.
    Readings readings;                            ///< Of that block.
    std::optional<CapacitorMemory> capacitor;

    std::optional<wire::DriveBlock> told;  ///< The last drive block that the link took, on this connection.
    TimePoint toldAt{};
    TimePoint blockTestModeAt{};  ///< Since when the drive blocks have asked for the test mode of `told`.
    std::optional<wire::TestMode> toldTestMode;  ///< The last one that went as a message.
    TimePoint toldTestModeAt{};
    std::uint32_t kicks = 0;  ///< Kicks given to the dongle.
    std::optional<wire::KickTimes> lastKick;
    TimePoint lastKickAt{};
    std::uint32_t autokicks = 0;
    TimePoint lastAutokickAt{};
    ExperimentBuffer experiment;
};

/// What the engine has been asked to do with one robot.
struct RobotIntent {
    WheelSpeeds target{};     ///< What was asked for.
    WheelSpeeds commanded{};  ///< What the ramp has come to.
    bool run = false;
    bool dribbler = false;
    bool highVoltageArmed = false;
    bool charger = false;
    bool autokick = false;
    wire::KickTimes autokickTimes;
    wire::TestMode driveTestMode;
    bool mustPassZero = true;  ///< Held inputs are refused until they have been at zero.
    bool discharging = false;
    bool sweeping = false;
    bool checking = false;  ///< A check is at work on it.

    /// What keeps it from being at rest; null where nothing does.
    const char* unrest() const {
        if (run) return "wheels";
        if (dribbler) return "dribbler";
        if (charger) return "charger";
        if (autokick) return "autokick";
        if (discharging) return "discharge";
        if (sweeping) return "sweep";
        return checking ? "check" : nullptr;
    }
    /// Whether it moves, charges, discharges or sweeps.
    bool busy() const { return run || dribbler || charger || autokick || discharging || sweeping; }
    /// The same, or is armed or being checked.
    bool active() const { return busy() || highVoltageArmed || checking; }
};

/// How much passed on the link and how much of it was damaged, since the session began.
struct TrafficCounters {
    std::uint64_t packetsOut = 0;
    std::uint64_t packetsIn = 0;
    std::uint64_t malformed = 0;  ///< Packets, micropackets or messages that could not be read.
    std::uint64_t stalls = 0;
    std::uint64_t dongleErrors = 0;  ///< Codes from the dongle's error queue.
    double packets_per_s = 0;        ///< Both directions, over the last second.
};

/// All there is to show of one thunderbots session at one moment.
struct Snapshot {
    TimePoint time{};
    LinkState link = LinkState::Idle;
    std::optional<Error> error;  ///< Why the link failed or waits.
    UsbDeviceInfo device;
    std::optional<Duration> roundTrip;  ///< To a USB/IP server and back; none on this machine's own bus.
    bool cable = false;
    wire::EStop eStop = wire::EStop::Uninitialized;
    wire::RadioState radios = wire::RadioState::PreInit;
    std::optional<wire::Channels> channels;
    std::optional<wire::RadioVersions> radioVersions;
    int wheelLimit = kStartingWheelLimit;
    std::array<RobotState, kRobots> robots;
    std::array<RobotIntent, kRobots> intents;
    /// The newest kicks of this session, oldest first; never null, immutable.
    std::shared_ptr<const KickRecords> kicks = std::make_shared<const KickRecords>();
    std::array<ChargeRecord, kRobots> charges;
    std::optional<SweepProgress> sweep;  ///< The one that runs, or the last one that did.
    std::array<ParameterState, kRobots> parameters;
    std::array<std::optional<FlashProgress>, kRobots> flash;  ///< The robots' last uploads.
    std::array<RequestState, kRobots> requests;               ///< What each robot is being asked.
    /// The check that runs, or the last one that did; without rows there was none. Never null, immutable.
    std::shared_ptr<const CheckProgress> check = std::make_shared<const CheckProgress>();
    TrafficCounters traffic;
    std::uint64_t connections = 0;  ///< How often the link has come to run.

    /// Whether anything moves, charges, is armed or discharges.
    bool active() const {
        for (const RobotIntent& intent : intents) {
            if (intent.active()) return true;
        }
        return false;
    }
};

}  // namespace kickstand::thunderbots
