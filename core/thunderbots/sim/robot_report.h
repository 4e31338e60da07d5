#pragma once

#include <array>
#include <cstdint>
#include <deque>

#include "core/base/time.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/kick_timing.h"
#include "core/thunderbots/wire/parameters.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::thunderbots::sim {

/// Whether a robot is there.
enum class RobotPower : std::uint8_t {
    Off,           ///< Switched off by hand.
    Booting,       ///< For 3 s.
    CopyingImage,  ///< Between two boots, for 5 s: the new microcontroller program is copied.
    Up,
    LockedOut,  ///< The battery was below 13.0 V for a second; until switched off and on.
};

/// One kick that a robot did.
struct KickRecord {
    TimePoint time{};
    std::array<wire::Pulse, 2> pulses{};  ///< Solenoid 1 and 2.
    double before_V = 0;                  ///< The capacitor.
    double after_V = 0;
    bool automatic = false;  ///< Set off by a ball in the beam.
};

/// Kicks that a report keeps; older ones are only counted.
inline constexpr std::size_t kKickRecords = 64;

/// Everything about one simulated robot that a test may want to know, at one moment.
struct RobotReport {
    RobotPower power = RobotPower::Up;
    std::uint32_t boots = 0;     ///< Counted from 1.
    std::uint8_t number = 0;     ///< As it took it at boot.
    wire::Channels channels;     ///< As it took them at boot.
    bool fpgaConfigured = true;  ///< False: no bitstream; it measures nothing and moves nothing.

    bool driveFresh = false;          ///< False: no block for a second; all that it asked for is off.
    wire::DriveBlock lastDrive;       ///< The last that came, fresh or not.
    TimePoint lastDriveTime{};        ///< When it, or a repetition of it, came.
    std::uint64_t driveBlocks = 0;    ///< How many came, repetitions included.
    std::uint64_t driveChanges = 0;   ///< Of them, those that said something else than the one before.
    std::uint64_t driveTimeouts = 0;  ///< How often none came for a second.

    std::uint64_t kicks = 0;           ///< Of both kinds.
    std::uint64_t automaticKicks = 0;  ///< Of them, set off by the beam.
    std::deque<KickRecord> lastKicks;  ///< The newest last.

    wire::TestMode testMode;                                    ///< What the LEDs are to show now.
    std::uint64_t testModeMessages = 0;                         ///< How many said so, legal ones.
    std::uint8_t leds = 0;                                      ///< Bit n: LED n.
    std::array<double, wire::kWheelCount> wheelSpeeds{};        ///< Quarter-degrees per 5 ms.
    std::array<std::int64_t, wire::kWheelCount> wheelCounts{};  ///< Quarter-degrees.
    double battery_V = 0;                                       ///< Under its present load.
    double capacitor_V = 0;
    double dribbler_C = 0;
    bool charging = false;
    bool dribbling = false;
    bool ball = false;

    wire::OperationalParameters shadow;     ///< As the host would read them.
    wire::OperationalParameters committed;  ///< As they will be after a reboot.

    std::uint64_t malformed = 0;     ///< Blocks and messages that it could not make sense of.
    std::uint64_t wrongCrcs = 0;     ///< Page programs refused.
    std::uint64_t lostMessages = 0;  ///< Of its own, given up before they were delivered.
};

}  // namespace kickstand::thunderbots::sim
