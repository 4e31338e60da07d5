#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/error.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::thunderbots {

/// A series of kicks of one robot in which one pulse grows or shrinks step by step. A plain value.
struct SweepPlan {
    static constexpr int kMostKicksPerStep = 50;
    static constexpr Duration kLongestPause = std::chrono::minutes(5);

    int robot = 0;     ///< 0-15.
    int solenoid = 1;  ///< Whose pulse changes: 1 or 2.
    int from_us = 0;   ///< 0-4064, as the wire has them; the steps end at or before `to_us`.
    int to_us = 0;
    int step_us = wire::kKickStep_us;  ///< 32-4064, upwards or downwards as from and to have it.
    int otherWidth_us = 0;             ///< The other solenoid's pulse, 0-4064; 0 for none.
    int offset_us = 0;                 ///< As KickPulses::offset_us.
    int kicksPerStep = 1;              ///< 1-kMostKicksPerStep.
    Duration pause{};                  ///< At least so long from kick to kick; 0-kLongestPause.
    Duration chargeLimit = std::chrono::seconds(30);  ///< Not charged within this: it ends. Over 0.

    friend bool operator==(const SweepPlan&, const SweepPlan&) = default;
};

/// How many different pulses a plan has; 0 where its numbers make none. Any thread.
int stepsOf(const SweepPlan& plan);
/// The pulses of step `step`, from 0 on, in a person's terms. Any thread.
wire::KickPulses pulsesAt(const SweepPlan& plan, int step);
/// Every kick of a plan, in order, as the wire has it. Errors: OutOfRange naming the number that is past its
/// range, NoEncoding for a pulse that ends too late or a kick without any. Any thread.
Result<std::vector<wire::KickTimes>> planSweep(const SweepPlan& plan);

/// What a sweep is doing.
enum class SweepStage : std::uint8_t {
    Charging,   ///< Waits until the capacitor is charged.
    Pausing,    ///< Charged; the pause is not over.
    Measuring,  ///< A kick was given; waits until its effect is known.
    Ended,
};

/// How far a sweep has come.
struct SweepProgress {
    SweepPlan plan;
    SweepStage stage = SweepStage::Charging;
    int given = 0;  ///< Kicks given to the dongle.
    int total = 0;
    std::optional<Errc> endedBy;  ///< Why it ended before it was through.

    bool running() const { return stage != SweepStage::Ended; }
};

}  // namespace kickstand::thunderbots
