#pragma once

#include <variant>

#include "core/thunderbots/sweep_plan.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::thunderbots {

// What a person, a script or a panel may ask of a session. Plain values; each is answered once. A command for
// several robots is done for those that it can be done for; the answer is the error of the first that it
// could not be done for.
//
// All of them can be refused with StopLatched or NotConnected; those that move or charge also with
// RobotNotAlive and EmergencyStopNotRun.

/// Runs the wheels at these speeds. Clamped by the ramp, refused (OutOfRange) past the connection's limit.
/// `held`: it comes from an input that is held in place (key, stick, slider); such a one must have been at
/// zero once since the last connection, STOP or loss of the robot, or it is refused with MustPassZero.
struct SetWheels {
    RobotMask robots = 0;
    WheelSpeeds wheels{};
    bool held = false;
};

/// Brakes the wheels at once. The charger, dribbler and autokick stay as they are.
struct Brake {
    RobotMask robots = 0;
};

/// Lets wheels go faster than kStartingWheelLimit, without a ramp, until the connection ends. 0-1023;
/// OutOfRange.
struct SetWheelLimit {
    int limit = kStartingWheelLimit;
};

/// Switches the dribbler. It runs only while its motor is within its temperatures (protocol 6.4).
struct SetDribbler {
    RobotMask robots = 0;
    bool on = false;
};

/// A person has armed (or disarmed) the high voltage of these robots on screen: kick, charge, autokick and
/// discharge need it. Disarming also switches the charger and autokick off.
struct ArmHighVoltage {
    RobotMask robots = 0;
    bool armed = false;
};

/// Refused with NotArmed.
struct SetCharger {
    RobotMask robots = 0;
    bool on = false;
};

/// Fires once. Refused with NotArmed, NoEncoding (both pulses empty) and KickOutstanding. Answered when the
/// dongle has taken it, which is not yet the robot; KickExpired when that took more than 200 ms and it was
/// dropped.
struct Kick {
    int robot = 0;
    wire::KickTimes times;
};

/// Arms or disarms autokick. Refused with NotArmed, and with NoEncoding for all-zero times (protocol 4.1).
struct SetAutokick {
    RobotMask robots = 0;
    bool armed = false;
    wire::KickTimes times;
};

/// Where a test mode goes: in the drive block, shown while it is sent, or as a message, shown until another
/// one or a reboot (protocol 4.5).
enum class TestModeWay : std::uint8_t { DriveBlock, Message };

/// Shows a test on the robots' LEDs (protocol 4.2, 4.5). OutOfRange for a target that the class does not
/// have, or that the drive block has no room for.
struct SetTestMode {
    RobotMask robots = 0;
    wire::TestMode mode;
    TestModeWay way = TestModeWay::Message;
};

/// Empties the capacitor with 96 µs pulses until 25 V, or stops doing so. Switches the charger and autokick
/// off. Answered when it has begun; events tell how it goes. Refused with NotArmed and ReadingsUnknown.
struct Discharge {
    int robot = 0;
    bool on = true;
};

/// Forgets what has arrived of these robots' experiment buffers, so that the next experiment begins with none
/// of it known (protocol 4.6). Nothing is sent.
struct ClearExperiment {
    RobotMask robots = 0;
};

/// Kicks again and again with a growing or shrinking pulse, each time with a charged capacitor. Switches the
/// charger on, and back to what it was when the sweep ends. Answered when it has begun; the snapshot's
/// `sweep` and events tell how it goes. Refused with NotArmed, ReadingsUnknown, SweepRunning, and
/// planSweep()'s errors. While it runs, its robot takes no other kick, autokick or discharge (SweepRunning).
struct StartSweep {
    SweepPlan plan;
};

/// Ends the sweep, and takes its kick back where the dongle does not have it yet. Done as well where none
/// runs.
struct StopSweep {};

/// Sets the dongle's radio channels (0x0B-0x1A), which takes a new start of the radios. OutOfRange;
/// Unsupported on a cable. Everything is braked first.
struct SetChannels {
    std::uint8_t channel0 = 0;
    std::uint8_t channel1 = 0;
};

/// Any of them.
using Command =
    std::variant<SetWheels, Brake, SetWheelLimit, SetDribbler, ArmHighVoltage, SetCharger, Kick, SetAutokick,
                 SetTestMode, Discharge, ClearExperiment, StartSweep, StopSweep, SetChannels>;

}  // namespace kickstand::thunderbots
