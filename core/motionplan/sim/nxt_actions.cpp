#include "core/motionplan/sim/nxt_actions.h"

#include <cmath>
#include <string>

#include "core/motionplan/sim/nxt_sim.h"

namespace kickstand::motionplan::sim {
namespace {

struct Row {
    const char* name;
    const char* unit;
    double lowest;
    double highest;
    bool whole;
    void (*perform)(NxtSim& sim, double value);
    std::optional<double> (*value)(const NxtSim& sim);
};

template <class Change>
void change(NxtSim& sim, Change apply) {
    Weather weather = sim.weather();
    apply(weather);
    sim.setWeather(weather);
}

constexpr Row kRows[] = {
    {"plugged", "0 or 1", 0, 1, true, [](NxtSim& sim, double value) { sim.setAttached(value != 0); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.attached() ? 1 : 0; }},
    {"loss", "probability", 0, 1, false,
     [](NxtSim& sim, double value) { change(sim, [value](Weather& weather) { weather.loss = value; }); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.weather().loss; }},
    {"reply-loss", "probability", 0, 1, false,
     [](NxtSim& sim, double value) { change(sim, [value](Weather& weather) { weather.replyLoss = value; }); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.weather().replyLoss; }},
    {"duplicate", "probability", 0, 1, false,
     [](NxtSim& sim, double value) { change(sim, [value](Weather& weather) { weather.duplicate = value; }); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.weather().duplicate; }},
    {"delay", "ms", 0, 5000, false,
     [](NxtSim& sim, double value) {
         change(sim, [value](Weather& weather) { weather.delay = fromSeconds(value / 1000); });
     },
     [](const NxtSim& sim) -> std::optional<double> { return seconds(sim.weather().delay) * 1000; }},
    {"lose-next", "messages to the robot", 0, 1000, true,
     [](NxtSim& sim, double value) { sim.loseNext(static_cast<int>(value), sim.loseNextFromRobot()); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.loseNextToRobot(); }},
    {"lose-next-out", "messages from the robot", 0, 1000, true,
     [](NxtSim& sim, double value) { sim.loseNext(sim.loseNextToRobot(), static_cast<int>(value)); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.loseNextFromRobot(); }},
    {"lose-one-out", "which message from the robot, from 1", 0, 1000, true,
     [](NxtSim& sim, double value) { sim.loseOne(static_cast<int>(value)); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.loseOneFromRobot(); }},
    {"text", "0 or 1", 0, 1, true, [](NxtSim& sim, double value) { sim.setReadsText(value != 0); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.readsText() ? 1 : 0; }},
    {"program", "0 or 1", 0, 1, true, [](NxtSim& sim, double value) { sim.setProgramRuns(value != 0); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.programRuns() ? 1 : 0; }},
    {"pace", "times real", 0.1, 100, false, [](NxtSim& sim, double value) { sim.program().setPace(value); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.program().pace(); }},
    {"strict-update", "0 or 1", 0, 1, true,
     [](NxtSim& sim, double value) { sim.program().setStrictUpdate(value != 0); },
     [](const NxtSim& sim) -> std::optional<double> { return sim.program().strictUpdate() ? 1 : 0; }},
    {"error", "error code", 0, 255, true,
     [](NxtSim& sim, double value) { sim.program().putError(static_cast<int>(value)); },
     [](const NxtSim&) -> std::optional<double> { return std::nullopt; }},
};

const Row* find(std::string_view name) {
    for (const Row& row : kRows) {
        if (name == row.name) return &row;
    }
    return nullptr;
}

}  // namespace

std::vector<SimAction> NxtActions::actions() const {
    std::vector<SimAction> actions;
    for (const Row& row : kRows)
        actions.push_back({row.name, false, row.unit, row.lowest, row.highest});
    return actions;
}

Result<void> NxtActions::perform(std::string_view action, int unit, double value) {
    const Row* const row = find(action);
    if (row == nullptr) {
        std::string known;
        for (const Row& one : kRows)
            known += (known.empty() ? "" : ", ") + std::string(one.name);
        return fail(Errc::UnknownName, std::string(action), std::move(known));
    }
    if (unit != -1) return fail(Errc::BadArgument, std::string(action), "it takes no number of a robot");
    const bool legal = std::isfinite(value) && value >= row->lowest && value <= row->highest &&
                       (!row->whole || value == std::floor(value));
    if (!legal) return fail(outOfBounds(action, row->lowest, row->highest, std::to_string(value)));
    row->perform(sim_, value);
    return {};
}

std::optional<double> NxtActions::value(std::string_view action, int unit) const {
    const Row* const row = find(action);
    return row == nullptr || unit != -1 ? std::nullopt : row->value(sim_);
}

}  // namespace kickstand::motionplan::sim
