#include "core/thunderbots/bench_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::thunderbots {
namespace {

using wire::TestClass;

constexpr std::array kInfos{
    CheckLimitInfo{"least_battery_V", "V", 0, 18, 1, &CheckLimits::leastBattery_V},
    CheckLimitInfo{"most_sag_V", "V", 0, 10, 2, &CheckLimits::mostSag_V},
    CheckLimitInfo{"most_dribbler_C", "°C", 0, 150, 0, &CheckLimits::mostDribbler_C},
    CheckLimitInfo{"most_charge_s", "s", 0.5, 60, 1, &CheckLimits::mostCharge_s},
    CheckLimitInfo{"least_drop_V", "V", 0, 240, 0, &CheckLimits::leastDrop_V},
    CheckLimitInfo{"wheel_speed", "", 1, kStartingWheelLimit, 0, &CheckLimits::wheelSpeed},
    CheckLimitInfo{"run_s", "s", 0.5, 5, 1, &CheckLimits::run_s},
    CheckLimitInfo{"kick_us", "µs", wire::kKickStep_us, wire::kKickMax_us, 0, &CheckLimits::kick_us},
};

Result<void> checkLimits(const CheckLimits& limits) {
    for (const CheckLimitInfo& info : kInfos) {
        const double value = limits.*info.member;
        if (value >= info.lowest && value <= info.highest) continue;
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = info.name;
        error.lowest = static_cast<std::int64_t>(std::ceil(info.lowest));
        error.highest = std::llround(info.highest);
        error.detail = std::to_string(value);
        return fail(std::move(error));
    }
    return {};
}

void addLights(std::vector<CheckStep>& steps, int robot, TestClass testClass) {
    const wire::TestTargets targets = wire::targetsOf(testClass);
    const int last = targets.any() ? targets.last : 0;
    for (int target = targets.first; target <= last; ++target)
        steps.push_back({robot, CheckKind::Lights, 0, true, {testClass, static_cast<std::uint8_t>(target)}});
}

void addRobot(std::vector<CheckStep>& steps, int robot, const CheckPlan& plan) {
    const auto add = [&steps, robot](CheckKind kind) { steps.push_back({robot, kind, 0, true, {}}); };
    add(CheckKind::Ready);
    add(CheckKind::Battery);
    for (int wheel = 1; plan.wheels && wheel <= kWheels; ++wheel) {
        steps.push_back({robot, CheckKind::Wheel, wheel, true, {}});
        steps.push_back({robot, CheckKind::Wheel, wheel, false, {}});
    }
    if (plan.dribbler) add(CheckKind::Dribbler);
    if (plan.wheels || plan.dribbler) add(CheckKind::Load);
    if (plan.lights) {
        for (const TestClass shown :
             {TestClass::Lamp, TestClass::Hall, TestClass::Encoder, TestClass::EncoderCount})
            addLights(steps, robot, shown);
    }
    if (!plan.highVoltage) return;
    add(CheckKind::Charge);
    // Its lights can be judged only after a charge was watched.
    if (plan.lights) addLights(steps, robot, TestClass::Charger);
    add(CheckKind::Kick);
    add(CheckKind::Discharge);
}

}  // namespace

std::span<const CheckLimitInfo> checkLimitInfos() {
    return kInfos;
}

Result<std::vector<CheckStep>> planCheck(const CheckPlan& plan) {
    if (plan.robots == 0) return fail(Errc::BadArgument, "robots");
    if (auto limits = checkLimits(plan.limits); !limits) return fail(std::move(limits.error()));
    std::vector<CheckStep> steps;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(plan.robots, robot)) addRobot(steps, robot, plan);
    }
    return steps;
}

bool CheckProgress::canRepeat() const {
    if (stage != CheckStage::Asking) return false;
    const CheckStep& step = rows[current].step;
    // What was charged once cannot be watched charging again.
    return step.kind == CheckKind::Wheel || step.kind == CheckKind::Dribbler ||
           (step.kind == CheckKind::Lights && step.mode.testClass != TestClass::Charger);
}

CheckVerdict verdictOf(const CheckProgress& progress, int robot) {
    bool waiting = false;
    bool skipped = false;
    for (const CheckRow& row : progress.rows) {
        if (row.step.robot != robot) continue;
        if (row.verdict == CheckVerdict::Failed || row.verdict == CheckVerdict::NotSeen)
            return CheckVerdict::Failed;
        waiting |= row.verdict == CheckVerdict::Waiting;
        skipped |= row.verdict == CheckVerdict::Skipped;
    }
    if (waiting) return CheckVerdict::Waiting;
    return skipped ? CheckVerdict::Skipped : CheckVerdict::Passed;
}

bool allPassed(const CheckProgress& progress) {
    return !progress.running() && !progress.endedBy &&
           std::ranges::all_of(progress.rows,
                               [](const CheckRow& row) { return row.verdict == CheckVerdict::Passed; });
}

const char* name(CheckVerdict verdict) {
    switch (verdict) {
        case CheckVerdict::Waiting:
            return "not-done";
        case CheckVerdict::Passed:
            return "passed";
        case CheckVerdict::Failed:
            return "failed";
        case CheckVerdict::Skipped:
            return "skipped";
        case CheckVerdict::NotSeen:
            return "not-seen";
    }
    return "unknown";
}

const char* name(CheckKind kind) {
    switch (kind) {
        case CheckKind::Ready:
            return "ready";
        case CheckKind::Battery:
            return "battery";
        case CheckKind::Wheel:
            return "wheel";
        case CheckKind::Dribbler:
            return "dribbler";
        case CheckKind::Load:
            return "load";
        case CheckKind::Charge:
            return "charge";
        case CheckKind::Kick:
            return "kick";
        case CheckKind::Discharge:
            return "discharge";
        case CheckKind::Lights:
            return "lights";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots
