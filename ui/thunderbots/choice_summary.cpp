#include "ui/thunderbots/choice_summary.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

/// Counts how many of those that are heard have a thing.
class Tally {
  public:
    void add(bool has) {
        ++seen_;
        if (has) ++having_;
    }
    All all() const {
        if (having_ == 0) return All::None;
        return having_ == seen_ ? All::Every : All::Some;
    }

  private:
    int seen_ = 0;
    int having_ = 0;
};

void addCapacitor(ChoiceSummary& summary, int robot, const RobotState& state) {
    if (!state.capacitor) return;
    if (summary.capacitor_V && *summary.capacitor_V >= state.capacitor->last_V) return;
    summary.capacitor_V = state.capacitor->last_V;
    summary.capacitorRobot = robot;
    summary.capacitorStale = state.freshness != Freshness::Current;
    summary.capacitorSeen = state.currentUntil;
}

void addTold(ChoiceSummary& summary, const RobotState& state, bool first) {
    if (first) {
        summary.told = state.told;
    } else if (summary.told != state.told) {
        summary.toldDiffers = true;
    }
}

void addTargets(ChoiceSummary& summary, const RobotIntent& intent, bool first) {
    for (std::size_t wheel = 0; wheel < summary.target.size(); ++wheel) {
        if (first) {
            summary.target[wheel] = intent.target[wheel];
            summary.reached[wheel] = intent.commanded[wheel];
        } else if (summary.target[wheel] != intent.target[wheel]) {
            summary.target[wheel].reset();
        }
    }
}

}  // namespace

ChoiceSummary summarize(const Snapshot& snapshot, RobotMask chosen) {
    ChoiceSummary summary;
    summary.chosen = chosen;
    Tally run;
    Tally dribbler;
    Tally armed;
    Tally charger;
    Tally discharging;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(chosen, robot)) continue;
        const RobotState& state = snapshot.robots[static_cast<std::size_t>(robot)];
        addCapacitor(summary, robot, state);
        if (!state.live) continue;
        const RobotIntent& intent = snapshot.intents[static_cast<std::size_t>(robot)];
        const bool first = summary.live == 0;
        summary.live |= maskOf(robot);
        addTargets(summary, intent, first);
        addTold(summary, state, first);
        summary.mustPassZero = summary.mustPassZero || intent.mustPassZero;
        run.add(intent.run);
        dribbler.add(intent.dribbler);
        armed.add(intent.highVoltageArmed);
        charger.add(intent.charger);
        discharging.add(intent.discharging);
    }
    summary.run = run.all();
    summary.dribbler = dribbler.all();
    summary.armed = armed.all();
    summary.charger = charger.all();
    summary.discharging = discharging.all();
    return summary;
}

}  // namespace kickstand::ui
