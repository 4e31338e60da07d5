#include "core/thunderbots/bench_checker.h"

#include <algorithm>
#include <cmath>

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots {
namespace {

/// By then the lowest reading after a kick has come, also over a radio at its true pace.
constexpr Duration kKickWatched = std::chrono::seconds(2);

std::uint64_t numberOf(const KickRecord* record) {
    return record == nullptr ? 0 : record->number;
}

}  // namespace

void BenchChecker::begin(const CheckPlan& plan, const std::vector<CheckStep>& steps, TimePoint now) {
    progress_.emplace();
    progress_->plan = plan;
    progress_->began = now;
    progress_->rows.reserve(steps.size());
    for (const CheckStep& step : steps)
        progress_->rows.push_back({step, CheckVerdict::Waiting, {}, {}, {}});
    enter(Phase::Start, now);
}

void BenchChecker::end(Errc why) {
    if (!running()) return;
    if (row().verdict == CheckVerdict::Waiting) row().why = why;
    progress_->endedBy = why;
    progress_->stage = CheckStage::Ended;
    ++version_;
}

std::shared_ptr<const CheckProgress> BenchChecker::progress() const {
    if (progress_ && shownVersion_ != version_) {
        shown_ = std::make_shared<const CheckProgress>(*progress_);
        shownVersion_ = version_;
    }
    return shown_;
}

void BenchChecker::enter(Phase phase, TimePoint now) {
    phase_ = phase;
    phaseBegan_ = now;
    progress_->stage = phase == Phase::Ask       ? CheckStage::Asking
                       : phase == Phase::Prepare ? CheckStage::Discharging
                                                 : CheckStage::Running;
    ++version_;
}

void BenchChecker::judge(CheckVerdict verdict, std::optional<Errc> why) {
    if (!running()) return;
    row().verdict = verdict;
    row().why = why;
    goOn();
}

void BenchChecker::judgeValue(double value, double limit, bool good) {
    row().value = value;
    row().limit = limit;
    judge(good ? CheckVerdict::Passed : CheckVerdict::Failed);
}

void BenchChecker::goOn() {
    ++version_;
    phase_ = Phase::Start;
    if (++progress_->current < progress_->rows.size()) {
        progress_->stage = CheckStage::Running;
        return;
    }
    --progress_->current;
    progress_->stage = CheckStage::Ended;
}

void BenchChecker::leaveRobot(CheckVerdict verdict, Errc why) {
    if (!running()) return;
    const int robot = row().step.robot;
    judge(verdict, why);
    while (running(robot))
        judge(CheckVerdict::Skipped, why);
}

Result<void> BenchChecker::answer(std::size_t row, CheckAnswer answer, TimePoint now) {
    const bool asked = running() && progress_->stage == CheckStage::Asking && progress_->current == row;
    if (!asked || (answer == CheckAnswer::Again && !progress_->canRepeat()))
        return fail(Errc::BadArgument, "answer");
    const bool ready = this->row().step.kind == CheckKind::Ready;
    switch (answer) {
        case CheckAnswer::Yes:
            judge(CheckVerdict::Passed);
            break;
        case CheckAnswer::No:
            if (ready)
                leaveRobot(CheckVerdict::Skipped, Errc::Cancelled);
            else
                judge(CheckVerdict::NotSeen);
            break;
        case CheckAnswer::Skip:
            if (ready)
                leaveRobot(CheckVerdict::Skipped, Errc::Cancelled);
            else
                judge(CheckVerdict::Skipped);
            break;
        case CheckAnswer::Again:
            enter(Phase::Start, now);
            break;
    }
    return {};
}

CheckDemand BenchChecker::look(const CheckView& view, TimePoint now) {
    if (!running()) return {};
    if (!view.state.live || view.state.freshness != Freshness::Current) {
        robotLost(view.state.live ? Errc::ReadingsUnknown : Errc::RobotNotAlive);
        return {};
    }
    return act(view, now);
}

CheckDemand BenchChecker::act(const CheckView& view, TimePoint now) {
    const double battery_V = view.state.readings.battery_V;
    switch (row().step.kind) {
        case CheckKind::Ready:
            if (phase_ == Phase::Start) ask(now);
            return {};
        case CheckKind::Battery:
            judgeValue(battery_V, limits().leastBattery_V, battery_V >= limits().leastBattery_V);
            return {};
        case CheckKind::Wheel:
            return spinWheel(now);
        case CheckKind::Dribbler:
            return dribble(view, now);
        case CheckKind::Load:
            return load(view, now);
        case CheckKind::Charge:
            return charge(view, now);
        case CheckKind::Kick:
            return kick(view, now);
        case CheckKind::Discharge:
            return discharge(view, now);
        case CheckKind::Lights:
            return showLights(now);
    }
    return {};
}

CheckDemand BenchChecker::spinWheel(TimePoint now) {
    if (phase_ == Phase::Start) enter(Phase::Run, now);
    if (phase_ == Phase::Run && ranLongEnough(now)) ask(now);
    if (phase_ == Phase::Ask) return {};
    const CheckStep& step = row().step;
    const int speed = static_cast<int>(std::lround(limits().wheelSpeed));
    CheckDemand demand;
    demand.wheels[static_cast<std::size_t>(step.wheel - 1)] = step.forward ? speed : -speed;
    // Counting lights say that the encoder sees the wheel.
    demand.lights = {wire::TestClass::EncoderCount, static_cast<std::uint8_t>(step.wheel)};
    return demand;
}

CheckDemand BenchChecker::dribble(const CheckView& view, TimePoint now) {
    if (phase_ == Phase::Start) enter(Phase::Run, now);
    if (phase_ == Phase::Run && ranLongEnough(now)) {
        row().value = view.state.readings.dribbler_C;
        row().limit = limits().mostDribbler_C;
        if (*row().value > *row().limit) {
            judge(CheckVerdict::Failed);
            return {};
        }
        ask(now);
    }
    CheckDemand demand;
    demand.dribbler = phase_ == Phase::Run;
    return demand;
}

CheckDemand BenchChecker::load(const CheckView& view, TimePoint now) {
    const double battery_V = view.state.readings.battery_V;
    if (phase_ == Phase::Start) {
        rest_V_ = lowest_V_ = battery_V;
        enter(Phase::Run, now);
    }
    lowest_V_ = std::min(lowest_V_, battery_V);
    if (ranLongEnough(now)) {
        const double sag_V = rest_V_ - lowest_V_;
        judgeValue(sag_V, limits().mostSag_V, sag_V <= limits().mostSag_V);
        return {};
    }
    CheckDemand demand;
    if (progress_->plan.wheels) demand.wheels.fill(static_cast<int>(std::lround(limits().wheelSpeed)));
    demand.dribbler = progress_->plan.dribbler;
    return demand;
}

CheckDemand BenchChecker::charge(const CheckView& view, TimePoint now) {
    const Readings& readings = view.state.readings;
    CheckDemand demand;
    if (phase_ == Phase::Start && readings.capacitor_V > wire::kCapacitorLive_V) {
        enter(Phase::Prepare, now);
        demand.discharge = true;
        return demand;
    }
    if (phase_ == Phase::Prepare && view.discharging) {
        demand.discharge = true;
        return demand;
    }
    if (phase_ == Phase::Prepare && readings.capacitor_V > wire::kCapacitorLive_V) {
        judge(CheckVerdict::Failed, Errc::NotDischarging);
        return {};
    }
    if (phase_ != Phase::Run) enter(Phase::Run, now);
    const double took_s = seconds(now - phaseBegan_);
    if (readings.charged || took_s > limits().mostCharge_s) {
        row().limit = limits().mostCharge_s;
        if (readings.charged) row().value = took_s;
        const bool good = readings.charged && took_s <= limits().mostCharge_s;
        judge(good ? CheckVerdict::Passed : CheckVerdict::Failed,
              good ? std::nullopt : std::optional(Errc::NotCharging));
        demand.charger = good;
        return demand;
    }
    demand.charger = true;
    demand.lights = {wire::TestClass::Charger, 0};
    return demand;
}

bool BenchChecker::charged() const {
    for (const CheckRow& each : progress_->rows) {
        if (each.step.robot == row().step.robot && each.step.kind == CheckKind::Charge)
            return each.verdict == CheckVerdict::Passed;
    }
    return false;
}

CheckDemand BenchChecker::kick(const CheckView& view, TimePoint now) {
    if (!charged()) {
        judge(CheckVerdict::Skipped, Errc::NotCharging);
        return {};
    }
    if (phase_ == Phase::Run) return measureKick(view, now);
    if (phase_ == Phase::Start) enter(Phase::Await, now);
    CheckDemand demand;
    if (view.state.readings.charged && view.kickFree) {
        // The charger stays off, or it would fill up what the kick has taken.
        kicksBefore_ = numberOf(view.lastKick);
        enter(Phase::Run, now);
        demand.kick = true;
        return demand;
    }
    if (seconds(now - phaseBegan_) > limits().mostCharge_s) {
        judge(CheckVerdict::Failed, Errc::NotCharging);
        return {};
    }
    demand.charger = true;
    return demand;
}

CheckDemand BenchChecker::measureKick(const CheckView& view, TimePoint now) {
    if (now - phaseBegan_ < kKickWatched) return {};
    const bool given = numberOf(view.lastKick) > kicksBefore_;
    const auto drop_V = given ? view.lastKick->drop_V() : std::nullopt;
    if (drop_V) {
        judgeValue(*drop_V, limits().leastDrop_V, *drop_V >= limits().leastDrop_V);
    } else {
        judge(CheckVerdict::Failed, given ? Errc::ReadingsUnknown : Errc::KickExpired);
    }
    return {};
}

CheckDemand BenchChecker::discharge(const CheckView& view, TimePoint now) {
    const double capacitor_V = view.state.readings.capacitor_V;
    const bool begins = phase_ == Phase::Start;
    if (begins) enter(Phase::Run, now);
    CheckDemand demand;
    demand.discharge = capacitor_V > wire::kCapacitorDischarged_V && (begins || view.discharging);
    if (demand.discharge) return demand;
    judgeValue(capacitor_V, wire::kCapacitorDischarged_V, capacitor_V <= wire::kCapacitorDischarged_V);
    return {};
}

CheckDemand BenchChecker::showLights(TimePoint now) {
    const bool ofCharger = row().step.mode.testClass == wire::TestClass::Charger;
    if (ofCharger && !charged()) {
        judge(CheckVerdict::Skipped, Errc::NotCharging);
        return {};
    }
    if (phase_ == Phase::Start) ask(now);
    CheckDemand demand;
    demand.lights = row().step.mode;
    demand.charger = ofCharger;
    return demand;
}

}  // namespace kickstand::thunderbots
