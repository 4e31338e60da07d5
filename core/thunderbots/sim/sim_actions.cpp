#include "core/thunderbots/sim/sim_actions.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <span>
#include <string>

namespace kickstand::thunderbots::sim {
namespace {

/// The row of an action: what a person is told of it, and what it does.
struct Row {
    const char* name;
    const char* unit;
    double lowest;
    double highest;
    bool whole;  ///< Takes whole numbers only.
};
struct RobotRow : Row {
    void (*perform)(RobotSim& robot, double value);
    std::optional<double> (*value)(RobotSim& robot);
};
struct DeviceRow : Row {
    bool dongleOnly;
    void (*perform)(SimWorld& world, double value);
    std::optional<double> (*value)(const SimWorld& world);
};

constexpr double kNoRadio = -1;

bool isDead(RobotPower power) {
    return power == RobotPower::Off || power == RobotPower::LockedOut;
}

constexpr RobotRow kRobotRows[] = {
    {{"ball", "0 or 1", 0, 1, true},
     [](RobotSim& robot, double value) { robot.setBall(value != 0); },
     [](RobotSim& robot) -> std::optional<double> { return robot.ball() ? 1 : 0; }},
    {{"battery", "V", 0, 18, false},
     [](RobotSim& robot, double value) { robot.setBattery(value); },
     [](RobotSim& robot) -> std::optional<double> { return robot.battery_V(); }},
    {{"capacitor", "V", 0, 240, false},
     [](RobotSim& robot, double value) { robot.setCapacitor(value); },
     [](RobotSim& robot) -> std::optional<double> { return robot.report().capacitor_V; }},
    {{"temperature", "°C", -20, 150, false},
     [](RobotSim& robot, double value) { robot.setTemperature(value); },
     [](RobotSim& robot) -> std::optional<double> { return robot.report().dribbler_C; }},
    {{"dead-wheels", "1 for wheel 1, 2 for 2, 4 for 3, 8 for 4, added up", 0, 15, true},
     [](RobotSim& robot, double value) { robot.setDeadWheels(static_cast<std::uint8_t>(value)); },
     [](RobotSim& robot) -> std::optional<double> { return robot.deadWheels(); }},
    {{"broken-charger", "0 or 1", 0, 1, true},
     [](RobotSim& robot, double value) { robot.setChargerBroken(value != 0); },
     [](RobotSim& robot) -> std::optional<double> { return robot.chargerBroken() ? 1 : 0; }},
    {{"dead", "0 or 1", 0, 1, true},
     [](RobotSim& robot, double value) { robot.switchPower(value == 0); },
     [](RobotSim& robot) -> std::optional<double> { return isDead(robot.report().power) ? 1 : 0; }},
    {{"experiment", "1", 1, 1, true},
     [](RobotSim& robot, double) { robot.sendExperiment(); },
     [](RobotSim&) -> std::optional<double> { return std::nullopt; }},
};

void setWeather(SimWorld& world, void (*change)(RadioWeather& weather, double value), double value) {
    RadioWeather weather = world.medium().weather();
    change(weather, value);
    world.medium().setWeather(weather);
}

bool isPlugged(const SimWorld& world) {
    return world.cable() ? world.cable()->plugged() : world.usb().attached();
}

constexpr DeviceRow kDeviceRows[] = {
    {{"plugged", "0 or 1", 0, 1, true},
     false,
     [](SimWorld& world, double value) {
         const bool plugged = value != 0;
         world.cable() ? world.cable()->setPlugged(plugged) : world.dongle()->setPlugged(plugged);
     },
     [](const SimWorld& world) -> std::optional<double> { return isPlugged(world) ? 1 : 0; }},
    {{"stall", "endpoint address", 0, 255, true},
     false,
     [](SimWorld& world, double value) { world.usb().halt(static_cast<std::uint8_t>(value)); },
     [](const SimWorld&) -> std::optional<double> { return std::nullopt; }},
    {{"error", "dongle error code", 0, 255, true},
     false,
     [](SimWorld& world, double value) { world.usb().queueError(static_cast<std::uint8_t>(value)); },
     [](const SimWorld&) -> std::optional<double> { return std::nullopt; }},
    {{"e-stop", "0 uninitialized, 1 disconnected, 2 stop, 3 run", 0, 3, true},
     true,
     [](SimWorld& world, double value) {
         world.dongle()->setEStop(static_cast<wire::EStop>(static_cast<std::uint8_t>(value)));
     },
     [](const SimWorld& world) -> std::optional<double> {
         return static_cast<double>(world.dongle()->eStop());
     }},
    {{"radio-failure", "radio 0 or 1, -1 for none", kNoRadio, 1, true},
     true,
     [](SimWorld& world, double value) {
         world.dongle()->setRadioFailure(value == kNoRadio ? std::nullopt
                                                           : std::optional(static_cast<std::uint8_t>(value)));
     },
     [](const SimWorld& world) -> std::optional<double> {
         const auto radio = world.dongle()->radioFailure();
         return radio ? *radio : kNoRadio;
     }},
    {{"loss", "probability", 0, 1, false},
     true,
     [](SimWorld& world, double value) {
         setWeather(
             world, [](RadioWeather& weather, double loss) { weather.loss = loss; }, value);
     },
     [](const SimWorld& world) -> std::optional<double> { return world.medium().weather().loss; }},
    {{"duplicate", "probability", 0, 1, false},
     true,
     [](SimWorld& world, double value) {
         setWeather(
             world, [](RadioWeather& weather, double part) { weather.duplication = part; }, value);
     },
     [](const SimWorld& world) -> std::optional<double> { return world.medium().weather().duplication; }},
    {{"delay", "ms", 0, 1000, false},
     true,
     [](SimWorld& world, double value) {
         setWeather(
             world, [](RadioWeather& weather, double ms) { weather.delay = fromSeconds(ms / 1000); }, value);
     },
     [](const SimWorld& world) -> std::optional<double> {
         return seconds(world.medium().weather().delay) * 1000;
     }},
};

template <class Rows>
auto findRow(const Rows& rows, std::string_view name) -> decltype(&rows[0]) {
    const auto found = std::ranges::find_if(rows, [name](const Row& row) { return row.name == name; });
    return found == std::end(rows) ? nullptr : &*found;
}

const DeviceRow* findDeviceRow(const SimWorld& world, std::string_view name) {
    const DeviceRow* row = findRow(kDeviceRows, name);
    return row && row->dongleOnly && !world.dongle() ? nullptr : row;
}

SimAction describe(const Row& row, bool perUnit) {
    return {
        .name = row.name, .perUnit = perUnit, .unit = row.unit, .lowest = row.lowest, .highest = row.highest};
}

Result<void> check(const Row& row, double value) {
    if (!(value >= row.lowest && value <= row.highest))
        return fail({.code = Errc::OutOfRange,
                     .subject = row.name,
                     .lowest = std::llround(row.lowest),
                     .highest = std::llround(row.highest),
                     .detail = std::to_string(value)});
    if (row.whole && value != std::floor(value))
        return fail(Errc::BadArgument, row.name, "not a whole number");
    return {};
}

bool hasEndpoint(const SimWorld& world, double address) {
    return std::ranges::any_of(world.usb().descriptors().endpoints,
                               [address](const UsbEndpointInfo& info) { return info.address == address; });
}

}  // namespace

std::vector<SimAction> SimActions::actions() const {
    std::vector<SimAction> all;
    for (const RobotRow& row : kRobotRows)
        all.push_back(describe(row, true));
    for (const DeviceRow& row : kDeviceRows) {
        if (!row.dongleOnly || world_.dongle()) all.push_back(describe(row, false));
    }
    return all;
}

std::vector<int> SimActions::units() const {
    std::vector<int> units;
    for (int unit = 0; unit < static_cast<int>(wire::kRobotCount); ++unit) {
        if (world_.robot(unit)) units.push_back(unit);
    }
    return units;
}

Result<void> SimActions::perform(std::string_view action, int unit, double value) {
    if (const RobotRow* row = findRow(kRobotRows, action)) {
        if (auto checked = check(*row, value); !checked) return checked;
        if (unit == -1) {
            for (const auto& robot : world_.robots())
                row->perform(*robot, value);
            return {};
        }
        RobotSim* robot = world_.robot(unit);
        if (!robot) return fail({.code = Errc::BadArgument, .subject = row->name, .robot = unit});
        row->perform(*robot, value);
        return {};
    }
    const DeviceRow* row = findDeviceRow(world_, action);
    if (!row) return fail(Errc::UnknownName, std::string(action));
    if (auto checked = check(*row, value); !checked) return checked;
    if (std::string_view(row->name) == "stall" && !hasEndpoint(world_, value))
        return fail({.code = Errc::BadArgument,
                     .subject = row->name,
                     .endpoint = static_cast<std::uint8_t>(value),
                     .detail = "no such endpoint"});
    row->perform(world_, value);
    return {};
}

std::optional<double> SimActions::value(std::string_view action, int unit) const {
    if (const RobotRow* row = findRow(kRobotRows, action)) {
        RobotSim* robot = world_.robot(unit);
        return robot ? row->value(*robot) : std::nullopt;
    }
    const DeviceRow* row = findDeviceRow(world_, action);
    return row ? row->value(world_) : std::nullopt;
}

}  // namespace kickstand::thunderbots::sim
