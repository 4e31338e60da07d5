#include "core/coach/sim/coach_sim.h"

#include <algorithm>

namespace kickstand::coach::sim {
namespace {

constexpr std::uint64_t kFirstSerial = 0x0013A20040000000;
constexpr double kTopMorale = 127;

ModuleMemory memoryOf(std::uint16_t address, bool fresh) {
    ModuleMemory memory;
    if (fresh) return memory;
    memory.address = address;
    memory.mode = 1;
    memory.name = "bench";
    return memory;
}

}  // namespace

CoachSim::CoachSim(Scheduler& scheduler, const CoachSimOptions& options) : medium_(scheduler, options.seed) {
    medium_.setLoss(options.loss);
    const ModuleMemory common;
    for (const std::uint16_t address : options.modules)
        modules_.push_back(std::make_unique<XbeeSim>(scheduler, medium_, memoryOf(address, options.fresh),
                                                     kFirstSerial + modules_.size()));
    for (const wire::Team team : options.boats)
        boats_.push_back(std::make_unique<TowrpSim>(scheduler, medium_, team, common.channel, common.pan,
                                                    CrewOptions{options.fall}));
    for (const auto& [team, loss] : options.lossy)
        boat(team)->setLoss(loss);
    for (const wire::Team team : options.rivals)
        rivals_.push_back(std::make_unique<RivalSim>(scheduler, medium_, team, common.channel, common.pan));
}

TowrpSim* CoachSim::boat(int team) const {
    for (const auto& boat : boats_) {
        if (boat->team() == team) return boat.get();
    }
    return nullptr;
}

std::vector<SimAction> CoachSim::actions() const {
    return {{"morale", true, "morale", wire::kMutinyMorale, kTopMorale},
            {"dead", true, "0 or 1", 0, 1},
            {"boat-loss", true, "probability", 0, 1},
            {"loss", false, "probability", 0, 1},
            {"plugged", false, "0 or 1", 0, 1},
            {"restart", false, "1", 1, 1}};
}

std::vector<int> CoachSim::units() const {
    std::vector<int> teams;
    for (const auto& boat : boats_)
        teams.push_back(boat->team());
    std::sort(teams.begin(), teams.end());
    return teams;
}

Result<void> CoachSim::performOne(std::string_view action, TowrpSim& boat, double value) {
    if (action == "morale") {
        boat.setMorale(static_cast<int>(value));
    } else if (action == "boat-loss") {
        boat.setLoss(value);
    } else {
        boat.setOn(value < 0.5);
    }
    return {};
}

Result<void> CoachSim::perform(std::string_view action, int unit, double value) {
    const std::vector<SimAction> all = actions();
    const auto found =
        std::find_if(all.begin(), all.end(), [action](const SimAction& one) { return one.name == action; });
    if (found == all.end()) return fail(Errc::UnknownName, std::string(action));
    if (!(value >= found->lowest && value <= found->highest)) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = found->name;
        error.lowest = static_cast<std::int64_t>(found->lowest);
        error.highest = static_cast<std::int64_t>(found->highest);
        return fail(std::move(error));
    }
    if (found->perUnit) {
        if (unit >= 0 && boat(unit) == nullptr) return fail(Errc::BadArgument, "team", std::to_string(unit));
        for (const auto& boat : boats_) {
            if (unit < 0 || boat->team() == unit) static_cast<void>(performOne(action, *boat, value));
        }
    } else if (action == "loss") {
        medium_.setLoss(value);
    } else {
        for (const auto& module : modules_) {
            if (action == "restart") {
                module->restart();
            } else {
                module->setAttached(value >= 0.5);
            }
        }
    }
    return {};
}

std::optional<double> CoachSim::value(std::string_view action, int unit) const {
    if (action == "loss") return medium_.loss();
    if (action == "plugged" && !modules_.empty()) return modules_.front()->attached() ? 1 : 0;
    const TowrpSim* one = boat(unit);
    if (one == nullptr) return std::nullopt;
    if (action == "morale") return one->morale();
    if (action == "dead") return one->isOn() ? 0 : 1;
    if (action == "boat-loss") return one->loss();
    return std::nullopt;
}

}  // namespace kickstand::coach::sim
