#include "core/thunderbots/kick_log.h"

#include <algorithm>
#include <utility>

namespace kickstand::thunderbots {
namespace {

/// Recent looks back this far at least, and twice as far at most. A robot's report of an autokick comes well
/// within it.
constexpr Duration kRecentSpan = std::chrono::seconds(1);

bool isCapacitor(SignalId signal) {
    return signal.signal == static_cast<std::uint16_t>(Signal::Capacitor_V) && signal.unit < kRobots;
}

}  // namespace

void KickLog::Recent::restart(TimePoint time, double volts) {
    *this = {time, volts, volts, volts, volts};
}

void KickLog::Recent::add(TimePoint time, double volts) {
    roll(time);
    last_V = volts;
    lowest_V = volts >= peak_V() ? volts : std::min(lowest_V, volts);
    newer_V = std::max(newer_V, volts);
}

void KickLog::Recent::roll(TimePoint time) {
    const Duration since = time - began;
    if (since < kRecentSpan) return;
    const double before_V = peak_V();
    // A reading holds until the next one, so the last one belongs to every span since.
    older_V = since < 2 * kRecentSpan ? newer_V : last_V;
    newer_V = last_V;
    began = time - since % kRecentSpan;
    if (peak_V() < before_V) lowest_V = last_V;
}

KickLog::KickLog(SampleSink& onward, std::function<void(const Event&)> event)
    : onward_(onward), event_(std::move(event)) {
    records_.reserve(kMost);
}

void KickLog::sample(SignalId signal, TimePoint time, float value) {
    onward_.sample(signal, time, value);
    if (isCapacitor(signal)) reading(signal.unit, static_cast<double>(value), time);
}

void KickLog::gap(SignalId signal, TimePoint time) {
    onward_.gap(signal, time);
    if (isCapacitor(signal)) unknown(signal.unit, time);
}

void KickLog::heard(const Event& event, const RobotState& state) {
    if (event.robot < 0) return;
    ChargeRecord& charge = chargeOf(event.robot);
    const ChargeRecord before = charge;
    switch (event.kind) {
        case EventKind::KickGiven:
            begin(event.robot, KickCause::Asked, state.lastKick, event.time);
            break;
        case EventKind::Autokick:
            begin(event.robot, KickCause::Autokick, at(event.robot).autokick, event.time);
            break;
        case EventKind::Charger:
            charge = {};
            if (event.code != 0 && at(event.robot).known && !state.readings.charged)
                charge.since = event.time;
            break;
        case EventKind::Charged:
            if (charge.since) charge = {std::nullopt, event.time - *charge.since};
            if (auto& open = at(event.robot).open;
                open && recordOf(*open).measure == KickMeasure::Recharging && !open->crossedAt)
                open->crossedAt = event.time;
            break;
        default:
            return;
    }
    if (charge != before) ++version_;
}

bool KickLog::isTooSoon(int robot, bool autokick, TimePoint time) {
    const Robot& known = at(robot);
    if (known.unclearUntil && time < *known.unclearUntil) return true;
    if (!known.open) return false;
    if (recordOf(*known.open).measure == KickMeasure::Waiting) return true;
    // What has been read may be an autokick's doing well before that is told.
    return time - known.open->fellAt < (autokick ? kRecentSpan : kSettle);
}

void KickLog::begin(int robot, KickCause cause, const std::optional<wire::KickTimes>& times, TimePoint time) {
    Robot& known = at(robot);
    // What is in between says nothing about how long charging takes from the beginning.
    chargeOf(robot).since.reset();
    const bool autokick = cause == KickCause::Autokick;
    const bool tooSoon = isTooSoon(robot, autokick, time);
    if (known.open) {
        if (tooSoon) recordOf(*known.open).after_V.reset();
        finish(robot, KickMeasure::Overtaken, time);
    }
    const bool isKick = autokick || expected_;
    known.unclearUntil.reset();
    if (tooSoon || !isKick) known.unclearUntil = time + kDropLimit;
    // A pulse of a discharge moves the voltage as a kick does, and is none.
    if (!isKick) return;
    KickRecord record;
    record.number = ++given_;
    record.robot = robot;
    record.cause = autokick ? cause : *expected_;
    record.time = time;
    record.times = times;
    record.measure = tooSoon ? KickMeasure::Overtaken : KickMeasure::Lost;
    if (records_.size() == kMost) {
        for (Robot& other : robots_) {
            // The kick whose record gives way is no longer measured.
            if (other.open && other.open->number == records_.front().number) other.open.reset();
        }
        records_.erase(records_.begin());
    }
    records_.push_back(record);
    if (known.known && !tooSoon) measureFrom(robot, records_.back(), time);
    publish();
}

void KickLog::measureFrom(int robot, KickRecord& record, TimePoint time) {
    Robot& known = at(robot);
    const bool autokick = record.cause == KickCause::Autokick;
    known.recent.roll(time);
    record.measure = KickMeasure::Waiting;
    record.before_V = autokick ? known.recent.peak_V() : known.recent.last_V;
    known.open = Open{record.number, {}, {}};
    if (autokick) fall(record, *known.open, known.recent.lowest_V, time);
    known.recent.restart(time, known.recent.last_V);
}

KickRecord& KickLog::recordOf(const Open& open) {
    // They are numbered without gaps, and one that is still open has not given way.
    return records_[static_cast<std::size_t>(open.number - records_.front().number)];
}

void KickLog::reading(int robot, double volts, TimePoint time) {
    Robot& known = at(robot);
    if (known.known) {
        known.recent.add(time, volts);
    } else {
        known.known = true;
        known.recent.restart(time, volts);
    }
    if (!known.open) return;
    KickRecord& record = recordOf(*known.open);
    if (record.measure == KickMeasure::Waiting) {
        // The charger may go on until the kick comes; an autokick has come already.
        if (record.cause != KickCause::Autokick) record.before_V = std::max(*record.before_V, volts);
        fall(record, *known.open, volts, time);
        publish();
        return;
    }
    if (volts < *record.after_V && time - known.open->fellAt < kSettle) {
        record.after_V = volts;
        known.recent.restart(time, volts);
        known.open->crossedAt.reset();
        publish();
    } else {
        // Of a small drop half has to be regained: the next reading may be as high by noise alone.
        const double target_V =
            std::max(kRecharged * *record.before_V, (*record.before_V + *record.after_V) / 2);
        if (volts >= target_V && !known.open->crossedAt) known.open->crossedAt = time;
    }
    advance(robot, time);
}

void KickLog::fall(KickRecord& record, Open& open, double volts, TimePoint time) {
    if (*record.before_V - volts < kLeastDrop_V) return;
    record.measure = KickMeasure::Recharging;
    record.after_V = volts;
    open.fellAt = time;
    // What is higher than this again belongs to whatever comes next.
    at(record.robot).recent.restart(time, volts);
}

void KickLog::unknown(int robot, TimePoint time) {
    Robot& known = at(robot);
    known.known = false;
    if (chargeOf(robot).since) ++version_;
    chargeOf(robot).since.reset();
    if (!known.open) return;
    KickRecord& record = recordOf(*known.open);
    // A lower reading may have been missed.
    if (time - known.open->fellAt < kSettle) record.after_V.reset();
    finish(robot, KickMeasure::Lost, time);
}

void KickLog::advance(int robot, TimePoint time) {
    Robot& known = at(robot);
    if (known.unclearUntil && time >= *known.unclearUntil) {
        known.unclearUntil.reset();
        known.recent.restart(time, known.recent.last_V);
    }
    if (!known.open) return;
    KickRecord& record = recordOf(*known.open);
    if (record.measure == KickMeasure::Waiting) {
        if (time - record.time < kDropLimit) return;
        // A lower reading from before may be the charger's doing, and is no drop.
        record.after_V = record.before_V;
        finish(robot, KickMeasure::NoDrop, time);
        return;
    }
    if (known.open->crossedAt && time - known.open->fellAt >= kSettle) {
        record.recharge = *known.open->crossedAt - record.time;
        finish(robot, KickMeasure::Recharged, time);
    } else if (time - record.time >= kRechargeLimit) {
        finish(robot, KickMeasure::NotRecharged, time);
    }
}

void KickLog::tick(TimePoint now) {
    for (int robot = 0; robot < kRobots; ++robot)
        advance(robot, now);
}

void KickLog::finish(int robot, KickMeasure how, TimePoint time) {
    KickRecord& record = recordOf(*at(robot).open);
    record.measure = how;
    at(robot).open.reset();
    publish();
    if (!record.after_V) return;
    const std::int64_t recharge_ms =
        record.recharge ? std::chrono::duration_cast<std::chrono::milliseconds>(*record.recharge).count()
                        : -1;
    event_(Event{EventKind::KickMeasured,
                 time,
                 robot,
                 recharge_ms,
                 static_cast<std::int64_t>(*record.before_V * 1000),
                 *record.after_V,
                 {}});
}

void KickLog::publish() {
    shown_ = std::make_shared<const KickRecords>(records_);
    ++version_;
}

}  // namespace kickstand::thunderbots
