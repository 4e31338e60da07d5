#include "core/thunderbots/robot_model.h"

#include "core/thunderbots/wire/kick_timing.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots {
namespace {

/// A battery must rise this far above a mark before falling below it is news again.
constexpr double kBatteryHysteresis_V = 0.2;

Readings readingsOf(const wire::FeedbackBlock& block) {
    Readings readings;
    readings.battery_V = wire::battery_V(block.battery_adc);
    readings.capacitor_V = wire::capacitor_V(block.capacitor_adc);
    readings.dribbler_C = wire::dribbler_C(block.thermistor_adc);
    readings.light_adc = block.light_adc;
    readings.ball = block.ball;
    readings.charged = block.charged;
    return readings;
}

SignalId idOf(int robot, Signal signal) {
    return {static_cast<std::uint16_t>(robot), static_cast<std::uint16_t>(signal)};
}

}  // namespace

RobotModel::RobotModel(int robot, SampleSink& samples, const std::function<void(const Event&)>& event)
    : robot_(robot), samples_(samples), event_(event) {}

void RobotModel::raise(EventKind kind, TimePoint time, std::int64_t code, std::int64_t previous,
                       double value) {
    event_(Event{kind, time, robot_, code, previous, value, {}});
}

void RobotModel::connectionBegan() {
    heardThisConnection_ = false;
    state_.told.reset();
    state_.toldTestMode.reset();
}

void RobotModel::setLive(bool live, TimePoint time) {
    if (live == state_.live) return;
    state_.live = live;
    if (live) {
        // The dongle repeats nothing that has not changed: what was heard on this connection holds again.
        // What an earlier one left behind stays old until something new comes.
        if (heardThisConnection_) {
            state_.freshness = Freshness::Current;
        } else {
            state_.freshness = state_.feedback ? Freshness::Stale : Freshness::Waiting;
        }
        if (heardThisConnection_) sampleReadings(time);
        raise(EventKind::RobotFound, time);
        return;
    }
    markStale(time);
    const bool capacitorLive = state_.capacitor && state_.capacitor->last_V >= wire::kCapacitorLive_V;
    raise(EventKind::RobotLost, time, 0, 0, capacitorLive ? state_.capacitor->last_V : 0);
}

void RobotModel::markStale(TimePoint time) {
    if (state_.freshness == Freshness::Current) {
        state_.currentUntil = time;
        if (state_.capacitor) state_.capacitor->at = time;
        for (int signal = 0; signal < kSignals; ++signal)
            samples_.gap(idOf(robot_, static_cast<Signal>(signal)), time);
    }
    state_.freshness = state_.feedback ? Freshness::Stale : Freshness::NotHeard;
}

void RobotModel::feedback(const wire::FeedbackBlock& block, TimePoint time) {
    if (!block.valid) {
        // Unknown, not zero: the last valid readings stay, as what they are.
        heardThisConnection_ = false;
        markStale(time);
        if (state_.live && !state_.feedback) state_.freshness = Freshness::Waiting;
        return;
    }
    state_.feedback = block;
    state_.readings = readingsOf(block);
    state_.capacitor = CapacitorMemory{state_.readings.capacitor_V, time};
    heardThisConnection_ = true;
    state_.freshness = state_.live ? Freshness::Current : Freshness::Stale;
    state_.currentUntil = time;
    if (state_.live) sampleReadings(time);
    watchBattery(time);
    if (block.charged != chargedSaid_) {
        chargedSaid_ = block.charged;
        if (block.charged) raise(EventKind::Charged, time, 0, 0, state_.readings.capacitor_V);
    }
}

void RobotModel::sampleReadings(TimePoint time) {
    samples_.sample(idOf(robot_, Signal::Battery_V), time, static_cast<float>(state_.readings.battery_V));
    samples_.sample(idOf(robot_, Signal::Capacitor_V), time, static_cast<float>(state_.readings.capacitor_V));
    samples_.sample(idOf(robot_, Signal::Dribbler_C), time, static_cast<float>(state_.readings.dribbler_C));
    samples_.sample(idOf(robot_, Signal::Light), time, static_cast<float>(state_.readings.light_adc));
}

void RobotModel::watchBattery(TimePoint time) {
    const double battery_V = state_.readings.battery_V;
    int mark = 0;
    if (battery_V < wire::kBatteryLow_V) mark = 1;
    if (battery_V < wire::kBatteryEmpty_V) mark = 2;
    if (mark > batteryMark_) {
        batteryMark_ = mark;
        raise(EventKind::BatteryLow, time, mark, 0, battery_V);
        return;
    }
    const double rearm_V =
        (batteryMark_ == 2 ? wire::kBatteryEmpty_V : wire::kBatteryLow_V) + kBatteryHysteresis_V;
    if (mark < batteryMark_ && battery_V > rearm_V) batteryMark_ = mark;
}

void RobotModel::indicator(const wire::IndicatorMessage& message, TimePoint time) {
    if (std::holds_alternative<wire::AutokickFired>(message)) {
        ++state_.autokicks;
        state_.lastAutokickAt = time;
        raise(EventKind::Autokick, time, state_.autokicks);
        return;
    }
    const auto& piece = std::get<wire::ExperimentData>(message);
    ExperimentBuffer& buffer = state_.experiment;
    for (std::size_t i = 0; i < piece.data.size(); ++i) {
        buffer.data[piece.offset + i] = piece.data[i];
        buffer.known.set(piece.offset + i);
    }
    ++buffer.messages;
    raise(EventKind::ExperimentData, time, static_cast<std::int64_t>(buffer.known.count()));
}

void RobotModel::experimentRejected() {
    ++state_.experiment.rejected;
}

void RobotModel::clearExperiment() {
    state_.experiment = ExperimentBuffer{};
}

void RobotModel::told(const wire::DriveBlock& block, TimePoint time) {
    const wire::DriveBlock before = state_.told.value_or(wire::brakedBlock());
    state_.told = block;
    state_.toldAt = time;
    if (block.charge != before.charge) raise(EventKind::Charger, time, block.charge ? 1 : 0);
    if (block.autokickArmed != before.autokickArmed)
        raise(EventKind::AutokickArmed, time, block.autokickArmed ? 1 : 0);
    if (block.testClass != before.testClass || block.testTarget != before.testTarget) {
        state_.blockTestModeAt = time;
        raise(EventKind::TestMode, time, block.testClass, block.testTarget);
    }
}

void RobotModel::kickGiven(const wire::KickTimes& times, TimePoint time) {
    ++state_.kicks;
    state_.lastKick = times;
    state_.lastKickAt = time;
    const wire::KickPulses pulses = wire::personTermsOf(times);
    raise(EventKind::KickGiven, time, pulses.width1_us, pulses.width2_us, pulses.offset_us);
}

void RobotModel::testModeGiven(const wire::TestMode& mode, TimePoint time) {
    state_.toldTestMode = mode;
    state_.toldTestModeAt = time;
    raise(EventKind::TestMode, time, static_cast<std::int64_t>(mode.testClass), mode.target);
}

}  // namespace kickstand::thunderbots
