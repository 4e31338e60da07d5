#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::thunderbots {

/// What a robot has to keep within to pass, and how it is made to show it. Each number has its range in
/// checkLimitInfos(); the units are in the names. Voltages and temperatures are the robot's own readings
/// (protocol 6.2-6.4).
struct CheckLimits {
    double leastBattery_V = 15.0;  ///< At rest.
    double mostSag_V = 1.0;        ///< How far the battery may give way under load.
    double mostDribbler_C = 70;    ///< After it has run.
    double mostCharge_s = 8;       ///< From below 50 V to "charged".
    double leastDrop_V = 30;       ///< What a kick has to take from the capacitor.
    double wheelSpeed = 60;        ///< Of each wheel, in units of the wire.
    double run_s = 1.5;            ///< How long a wheel or the dribbler runs.
    double kick_us = 2400;         ///< The kick's pulse on solenoid 1.

    friend bool operator==(const CheckLimits&, const CheckLimits&) = default;
};

/// One of these numbers: a stable name for files, its unit ("" for none) and its range.
struct CheckLimitInfo {
    const char* name;
    const char* unit;
    double lowest;
    double highest;
    int decimals;
    double CheckLimits::*member;
};
/// All of them, in the order in which they are shown. Any thread.
std::span<const CheckLimitInfo> checkLimitInfos();

/// What is to be checked, of which robots. The battery at rest always is. A plain value.
struct CheckPlan {
    RobotMask robots = 0;
    bool wheels = true;
    bool dribbler = true;
    bool highVoltage = true;  ///< Charging, a kick, and a discharge at the end.
    bool lights = true;       ///< The test modes, each asked for.
    CheckLimits limits;

    friend bool operator==(const CheckPlan&, const CheckPlan&) = default;
};

/// The kinds of steps, in the order in which a robot goes through them; Lights stand at several places.
enum class CheckKind : std::uint8_t {
    Ready,     ///< A person says that the robot stands free. Nothing moves before.
    Battery,   ///< Its voltage at rest.
    Wheel,     ///< One wheel, one way round: seen by a person, as no feedback tells of wheels (protocol 4.3).
    Dribbler,  ///< Its temperature; that it turned is seen by a person.
    Load,      ///< How far the battery gives way with wheels and dribbler running.
    Charge,    ///< How long the capacitor takes to be charged, from below 50 V.
    Kick,      ///< How far a kick lets the capacitor's voltage fall.
    Discharge,  ///< The capacitor is empty afterwards.
    Lights,     ///< What the LEDs show in a test mode: seen by a person (protocol 4.2).
};

/// One step of one robot.
struct CheckStep {
    int robot = 0;
    CheckKind kind = CheckKind::Ready;
    int wheel = 0;        ///< 1-4 for Wheel.
    bool forward = true;  ///< For Wheel: a positive speed.
    wire::TestMode mode;  ///< For Lights.

    friend bool operator==(const CheckStep&, const CheckStep&) = default;
};

/// The steps of a plan, one robot after another. Errors: BadArgument without robots, OutOfRange naming the
/// limit that is past its range. Any thread.
Result<std::vector<CheckStep>> planCheck(const CheckPlan& plan);

/// How a step ended.
enum class CheckVerdict : std::uint8_t {
    Waiting,  ///< It has not ended, or was never begun.
    Passed,
    Failed,
    Skipped,
    NotSeen,  ///< A person did not see what should have been seen.
};

/// One step and what came of it.
struct CheckRow {
    CheckStep step;
    CheckVerdict verdict = CheckVerdict::Waiting;
    std::optional<double> value;  ///< In the unit of its kind: V, °C or s.
    std::optional<double> limit;  ///< What the value was held against.
    std::optional<Errc> why;      ///< What kept it from passing, where the value does not say so.

    friend bool operator==(const CheckRow&, const CheckRow&) = default;
};

/// What a person says to a question. No: it was not seen. Again: once more, please.
enum class CheckAnswer : std::uint8_t { Yes, No, Skip, Again };

/// What the step under way is doing.
enum class CheckStage : std::uint8_t { Discharging, Running, Asking, Ended };

/// How far a check has come, and at its end the whole report.
struct CheckProgress {
    CheckPlan plan;
    std::vector<CheckRow> rows;
    std::size_t current = 0;  ///< The row at work.
    CheckStage stage = CheckStage::Running;
    TimePoint began{};
    std::optional<Errc> endedBy;  ///< Why it ended before it was through.

    bool running() const { return stage != CheckStage::Ended; }
    /// Whether the step at work can be shown once more.
    bool canRepeat() const;
};

/// A robot's verdict: Failed when a step failed or was not seen, Skipped when one was left out, Waiting while
/// one is to come. Any thread.
CheckVerdict verdictOf(const CheckProgress& progress, int robot);
/// Whether the check is through and every robot of its plan has passed. Any thread.
bool allPassed(const CheckProgress& progress);
/// "passed", "not-seen", …: stable names for JSON. Any thread.
const char* name(CheckVerdict verdict);
/// "battery", "wheel", …: stable names for JSON. Any thread.
const char* name(CheckKind kind);

}  // namespace kickstand::thunderbots
