#include "core/thunderbots/sweeper.h"

#include <utility>

namespace kickstand::thunderbots {

void Sweeper::begin(const SweepPlan& plan, std::vector<wire::KickTimes> kicks, bool chargerWasOn,
                    TimePoint now) {
    ++number_;
    kicks_ = std::move(kicks);
    progress_ = SweepProgress{plan, SweepStage::Charging, 0, static_cast<int>(kicks_.size()), {}};
    waitingSince_ = now;
    lastKick_.reset();
    chargerWasOn_ = chargerWasOn;
}

void Sweeper::end(std::optional<Errc> why) {
    if (!running()) return;
    setStage(SweepStage::Ended);
    progress_->endedBy = why;
}

Sweeper::Finding Sweeper::look(const RobotState& state, bool measuring, TimePoint now) {
    if (state.freshness != Freshness::Current) return Finding::Unknown;
    const bool charged = state.readings.charged;
    if (charged) waitingSince_ = now;
    if (now - waitingSince_ >= progress_->plan.chargeLimit) return Finding::NotCharged;
    if (measuring) {
        // Right after a kick the robot still says "charged": its next reading is on its way.
        setStage(progress_->given == 0 ? SweepStage::Charging : SweepStage::Measuring);
        return Finding::Wait;
    }
    if (progress_->given == progress_->total) return Finding::Through;
    if (!charged) {
        setStage(SweepStage::Charging);
        return Finding::Wait;
    }
    if (lastKick_ && now - *lastKick_ < progress_->plan.pause) {
        setStage(SweepStage::Pausing);
        return Finding::Wait;
    }
    return Finding::Kick;
}

void Sweeper::kicked(TimePoint now) {
    ++progress_->given;
    setStage(SweepStage::Measuring);
    waitingSince_ = now;
    lastKick_ = now;
}

}  // namespace kickstand::thunderbots
