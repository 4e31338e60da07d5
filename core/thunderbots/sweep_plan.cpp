#include "core/thunderbots/sweep_plan.h"

#include <cstdlib>

#include "core/thunderbots/types.h"

namespace kickstand::thunderbots {
namespace {

struct Range {
    const char* subject;
    std::int64_t got;
    std::int64_t lowest;
    std::int64_t highest;
};

Result<void> check(const Range& range) {
    if (range.got >= range.lowest && range.got <= range.highest) return {};
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = range.subject;
    error.lowest = range.lowest;
    error.highest = range.highest;
    error.got = range.got;
    return fail(std::move(error));
}

std::int64_t wholeSeconds(Duration span) {
    return std::chrono::floor<std::chrono::seconds>(span).count();
}

Result<void> checkNumbers(const SweepPlan& plan) {
    const std::int64_t longest_s = wholeSeconds(SweepPlan::kLongestPause);
    const Range ranges[] = {
        {"robot", plan.robot, 0, kRobots - 1},
        {"solenoid", plan.solenoid, 1, 2},
        {"from", plan.from_us, 0, wire::kKickMax_us},
        {"to", plan.to_us, 0, wire::kKickMax_us},
        {"step", plan.step_us, wire::kKickStep_us, wire::kKickMax_us},
        {"other width", plan.otherWidth_us, 0, wire::kKickMax_us},
        {"offset", plan.offset_us, -wire::kKickMax_us, wire::kKickMax_us},
        {"kicks per step", plan.kicksPerStep, 1, SweepPlan::kMostKicksPerStep},
        {"pause", wholeSeconds(plan.pause), 0, longest_s},
        {"charge limit", wholeSeconds(plan.chargeLimit + std::chrono::seconds(1) - Duration(1)), 1,
         longest_s},
    };
    for (const Range& range : ranges) {
        if (auto in = check(range); !in) return in;
    }
    return {};
}

}  // namespace

int stepsOf(const SweepPlan& plan) {
    if (!checkNumbers(plan)) return 0;
    return std::abs(plan.to_us - plan.from_us) / plan.step_us + 1;
}

wire::KickPulses pulsesAt(const SweepPlan& plan, int step) {
    const int direction = plan.to_us < plan.from_us ? -1 : 1;
    const int width_us = plan.from_us + direction * step * plan.step_us;
    if (plan.solenoid == 1) return {width_us, plan.otherWidth_us, plan.offset_us};
    return {plan.otherWidth_us, width_us, plan.offset_us};
}

Result<std::vector<wire::KickTimes>> planSweep(const SweepPlan& plan) {
    if (auto numbers = checkNumbers(plan); !numbers) return fail(std::move(numbers.error()));
    std::vector<wire::KickTimes> kicks;
    const int steps = stepsOf(plan);
    kicks.reserve(static_cast<std::size_t>(steps) * static_cast<std::size_t>(plan.kicksPerStep));
    for (int step = 0; step < steps; ++step) {
        const auto encoded = wire::encodePulses(pulsesAt(plan, step));
        if (!encoded) return fail(wire::toError(encoded.error()));
        if (encoded->sent.width1_us == 0 && encoded->sent.width2_us == 0) {
            Error error;
            error.code = Errc::NoEncoding;
            error.robot = plan.robot;
            return fail(std::move(error));
        }
        kicks.insert(kicks.end(), static_cast<std::size_t>(plan.kicksPerStep), encoded->times);
    }
    return kicks;
}

}  // namespace kickstand::thunderbots
