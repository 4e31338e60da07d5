#pragma once

#include <variant>
#include <vector>

#include "core/thunderbots/bench_check.h"
#include "core/thunderbots/flash_plan.h"
#include "core/thunderbots/sweep_plan.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/parameters.h"
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
    static constexpr bool kMovesNothing = true;
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
    static constexpr bool kMovesNothing = true;
    RobotMask robots = 0;
};

/// Kicks again and again with a growing or shrinking pulse, each time with a charged capacitor. Switches the
/// charger on, and back to what it was when the sweep ends. Answered when it has begun; the snapshot's
/// `sweep` and events tell how it goes. Refused with NotArmed, ReadingsUnknown, SweepRunning, and
/// planSweep()'s errors. While it runs, its robot takes no other kick, autokick or discharge (SweepRunning).
struct StartSweep {
    SweepPlan plan;
};

/// Checks robots, one after another, by a fixed list of steps. Nothing moves before a person has said that
/// the robot stands free. Answered when it has begun; the snapshot's `check` and events tell how it goes.
/// What the chosen robots were doing ends. Refused with NotArmed where high voltage is to be checked,
/// RobotNotAlive when none of them is heard, CheckRunning, SweepRunning, OutOfRange past the wheels' limit,
/// and planCheck()'s errors. While it runs, the robot at work takes nothing else that moves, charges or kicks
/// (CheckRunning); to brake it, disarm it or switch something of it off ends the check.
struct StartCheck {
    CheckPlan plan;
};

/// Answers what is asked in row `row` of the check. Refused with BadArgument when something else is, or
/// nothing.
struct AnswerCheck {
    std::size_t row = 0;
    CheckAnswer answer = CheckAnswer::Skip;
};

/// Ends the check; its robot is braked, its charger off. Done as well where none runs.
struct StopCheck {
    static constexpr bool kMovesNothing = true;
};

/// Ends the sweep, and takes its kick back where the dongle does not have it yet. Done as well where none
/// runs.
struct StopSweep {
    static constexpr bool kMovesNothing = true;
};

/// Sets the dongle's radio channels (0x0B-0x1A), which takes a new start of the radios. OutOfRange;
/// Unsupported on a cable. Everything is braked first.
struct SetChannels {
    std::uint8_t channel0 = 0;
    std::uint8_t channel1 = 0;
};

/// Reads a robot's operational parameters, or its build signatures, which takes the robot some seconds
/// (protocol 4.7, 4.8). Answered when they are in the snapshot. Refused with RobotNotAlive, FlashRunning
/// and RequestPending; Unanswered or TimedOut where the robot does not answer.
struct ReadParameters {
    static constexpr bool kMovesNothing = true;
    int robot = 0;
};
struct ReadSignatures {
    static constexpr bool kMovesNothing = true;
    int robot = 0;
};

/// Writes a robot's parameters to its volatile copy, where they live until it reboots, and reads them again.
/// Refused with ParametersUnread before they have been read on this session; BadArgument where what lies
/// behind the known fields is not as it was read; OutOfRange; NotVerified where the robot has something else
/// afterwards; ReadParameters' errors.
struct ApplyParameters {
    static constexpr bool kMovesNothing = true;
    int robot = 0;
    wire::OperationalParameters parameters;
};

/// Lets a robot keep its volatile copy for good; its next reboot proves it. Refused with ParametersUnread;
/// ReadParameters' errors.
struct CommitParameters {
    static constexpr bool kMovesNothing = true;
    int robot = 0;
};

/// Reboots a robot: it is gone for some seconds. Refused with StopLatched; NotBraked while it moves, charges
/// or is armed, ReadingsUnknown and CapacitorLive from 50 V on; NotCommitted while it has applied parameters
/// that would be lost, unless `discard`; ReadParameters' errors.
struct RebootRobot {
    static constexpr bool kMovesNothing = true;
    int robot = 0;
    bool discard = false;
    bool capacitorUnknown = false;  ///< The capacitor is empty, though nobody measures it.
};

/// What a person may have seen to that the program cannot know.
struct FlashOptions {
    bool lowBattery = false;        ///< A battery below 14 V will do.
    bool capacitorUnknown = false;  ///< The capacitor is empty, though nobody measures it.
};

/// Uploads firmware to robots, each for itself (protocol 6.7): one image, or the microcontroller's and then
/// the FPGA's. Answered when it has begun; the snapshot's `flash` and events tell how it goes. Refused with
/// StopLatched, BadArgument for other images than these, RobotNotAlive, FlashRunning, RequestPending;
/// NotBraked while it moves, charges or is armed, CapacitorLive from 50 V on, BatteryLow below 14 V;
/// NotCommitted while it has applied parameters that would be lost. A robot without a bitstream measures
/// nothing: it is taken as it is where its capacitor was last known to be empty, else ReadingsUnknown.
/// Meanwhile the robot takes nothing that moves, charges or asks it something (FlashRunning). STOP lets it
/// finish its page and pauses it.
struct StartFlash {
    static constexpr bool kMovesNothing = true;
    RobotMask robots = 0;
    std::vector<SharedFlashPlan> plans;
    FlashOptions options;
};

/// Ends uploads at once; the snapshot's `flash` says how each robot is left. FlashNotRunning.
struct CancelFlash {
    static constexpr bool kMovesNothing = true;
    RobotMask robots = 0;
};

/// Goes on with uploads that STOP has paused. StopLatched before it was re-armed; FlashNotRunning.
struct ResumeFlash {
    static constexpr bool kMovesNothing = true;
    RobotMask robots = 0;
};

/// Any of them.
using Command =
    std::variant<SetWheels, Brake, SetWheelLimit, SetDribbler, ArmHighVoltage, SetCharger, Kick, SetAutokick,
                 SetTestMode, Discharge, ClearExperiment, StartSweep, StopSweep, StartCheck, AnswerCheck,
                 StopCheck, SetChannels, ReadParameters, ReadSignatures, ApplyParameters, CommitParameters,
                 RebootRobot, StartFlash, CancelFlash, ResumeFlash>;

}  // namespace kickstand::thunderbots
