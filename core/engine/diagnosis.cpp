#include "core/engine/diagnosis.h"

#include <algorithm>
#include <iterator>

#include "core/engine/diagnosis_serial.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::LinkState;
using thunderbots::RobotMask;

constexpr auto kBehindTheLink = {Check::Radios,   Check::EmergencyStop, Check::Robots,
                                 Check::Feedback, Check::Battery,       Check::Traffic};

Finding finding(Check check, CheckState state = CheckState::Ok) {
    Finding made;
    made.check = check;
    made.state = state;
    return made;
}

void append(std::vector<Finding>& all, std::vector<Finding> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void addDevice(std::vector<Finding>& findings, const FoundDevice& device) {
    const bool forbidden = device.obstacle && device.obstacle->code == Errc::PermissionDenied;
    Finding found = finding(Check::Device);
    found.link = device.uri;
    found.port = device.info.port;
    Finding permission = finding(Check::Permission, forbidden ? CheckState::Problem : CheckState::Ok);
    permission.port = device.info.port;
    if (forbidden) permission.error = device.obstacle;
    permission.rule = device.rule;
    Finding claim = finding(Check::Claim, forbidden         ? CheckState::NotChecked
                                          : device.obstacle ? CheckState::Problem
                                                            : CheckState::Ok);
    claim.port = device.info.port;
    if (claim.state == CheckState::Problem) {
        claim.error = device.obstacle;
        claim.holder = device.holder;
    }
    findings.push_back(std::move(found));
    findings.push_back(std::move(permission));
    findings.push_back(std::move(claim));
}

RobotMask robotsWhere(const thunderbots::Snapshot& state, bool (*is)(const thunderbots::RobotState&)) {
    RobotMask robots = 0;
    for (int number = 0; number < thunderbots::kRobots; ++number) {
        if (is(state.robots[static_cast<std::size_t>(number)])) robots |= thunderbots::maskOf(number);
    }
    return robots;
}

Finding radios(const thunderbots::Snapshot& state) {
    Finding found = finding(Check::Radios);
    found.cable = state.cable;
    found.radios = state.radios;
    found.channels = state.channels;
    if (!state.cable && state.radios != wire::RadioState::Running) found.state = CheckState::Problem;
    return found;
}

Finding emergencyStop(const thunderbots::Snapshot& state) {
    Finding found = finding(Check::EmergencyStop);
    found.eStop = state.eStop;
    if (state.eStop != wire::EStop::Run) found.state = CheckState::Problem;
    return found;
}

Finding aboutRobots(Check check, CheckState state, RobotMask robots) {
    Finding found = finding(check, state);
    found.robots = robots;
    return found;
}

Finding feedback(const thunderbots::Snapshot& state, RobotMask live) {
    if (live == 0) return finding(Check::Feedback, CheckState::NotChecked);
    const RobotMask silent = robotsWhere(state, [](const thunderbots::RobotState& robot) {
        return robot.live && robot.freshness != thunderbots::Freshness::Current;
    });
    return aboutRobots(Check::Feedback, silent == 0 ? CheckState::Ok : CheckState::Problem, silent);
}

Finding battery(const thunderbots::Snapshot& state) {
    const RobotMask low = robotsWhere(state, [](const thunderbots::RobotState& robot) {
        return robot.freshness == thunderbots::Freshness::Current &&
               robot.readings.battery_V < wire::kBatteryLow_V;
    });
    return aboutRobots(Check::Battery, low == 0 ? CheckState::Ok : CheckState::Warning, low);
}

Finding traffic(const thunderbots::TrafficCounters& counters) {
    Finding found = finding(Check::Traffic);
    found.traffic = counters;
    if (counters.malformed > 0 || counters.stalls > 0 || counters.dongleErrors > 0)
        found.state = CheckState::Warning;
    return found;
}

std::vector<Finding> diagnoseSystem(const LinkUri& uri, const thunderbots::Snapshot& state) {
    std::vector<Finding> findings;
    if (state.link == LinkState::Running) {
        findings.push_back(runningLink(uri, state));
        append(findings, diagnoseLink(state));
        return findings;
    }
    if (state.error) return diagnoseFailedLink(uri, *state.error);
    Finding link = finding(Check::Link, CheckState::Warning);
    link.link = uri;
    link.linkState = state.link;
    findings.push_back(std::move(link));
    append(findings, notChecked(kBehindTheLink));
    return findings;
}

/// The other systems are on serial ports.
template <class Serial>
std::vector<Finding> diagnoseSystem(const LinkUri& uri, const Serial& state) {
    return diagnoseSerial(uri, state);
}

bool isSerial(const SessionSnapshot& session) {
    return !std::holds_alternative<thunderbots::Snapshot>(session.system);
}

bool looksRunning(const SessionSnapshot& session) {
    return std::visit(
        [](const auto& state) { return state.link == std::decay_t<decltype(state.link)>::Running; },
        session.system);
}

}  // namespace

const char* name(Check check) {
    switch (check) {
        case Check::Program:
            return "program";
        case Check::Device:
            return "device";
        case Check::Permission:
            return "permission";
        case Check::Claim:
            return "claim";
        case Check::Link:
            return "link";
        case Check::Stop:
            return "stop";
        case Check::Radios:
            return "radios";
        case Check::EmergencyStop:
            return "e-stop";
        case Check::Robots:
            return "robots";
        case Check::Feedback:
            return "feedback";
        case Check::Battery:
            return "battery";
        case Check::Traffic:
            return "traffic";
        case Check::Answers:
            return "answers";
        case Check::Catalogue:
            return "catalogue";
    }
    return "";
}

const char* name(CheckState state) {
    switch (state) {
        case CheckState::Ok:
            return "ok";
        case CheckState::Warning:
            return "warning";
        case CheckState::Problem:
            return "problem";
        case CheckState::NotChecked:
            return "not-checked";
    }
    return "";
}

std::vector<Finding> notChecked(std::initializer_list<Check> checks) {
    std::vector<Finding> findings;
    for (const Check check : checks)
        findings.push_back(finding(check, CheckState::NotChecked));
    return findings;
}

std::vector<Finding> diagnoseDevices(const std::vector<FoundDevice>& devices) {
    std::vector<Finding> findings;
    if (devices.empty()) {
        findings.push_back(finding(Check::Device, CheckState::Problem));
        findings.back().error = Error{.code = Errc::NoDevice};
    }
    for (const FoundDevice& device : devices)
        addDevice(findings, device);
    return findings;
}

std::vector<Finding> diagnoseLink(const thunderbots::Snapshot& state) {
    const RobotMask live =
        robotsWhere(state, [](const thunderbots::RobotState& robot) { return robot.live; });
    const CheckState heard = live == 0 ? CheckState::Problem : CheckState::Ok;
    return {radios(state),         emergencyStop(state), aboutRobots(Check::Robots, heard, live),
            feedback(state, live), battery(state),       traffic(state.traffic)};
}

std::vector<Finding> diagnoseFailedLink(const LinkUri& uri, const Error& error) {
    std::vector<Finding> findings{finding(Check::Link, CheckState::Problem)};
    findings.back().link = uri;
    findings.back().error = error;
    append(findings, notChecked(kBehindTheLink));
    return findings;
}

Finding runningLink(const LinkUri& uri, const thunderbots::Snapshot& state) {
    Finding found = finding(Check::Link);
    found.link = uri;
    found.port = state.device.port;
    found.cable = state.cable;
    found.linkState = LinkState::Running;
    return found;
}

std::vector<Finding> diagnoseSession(const SessionSnapshot& session) {
    return std::visit([&session](const auto& state) { return diagnoseSystem(session.uri, state); },
                      session.system);
}

std::vector<Finding> diagnose(const EngineSnapshot& engine, const SessionSnapshot* shown) {
    std::vector<Finding> findings{finding(Check::Program)};
    // What runs shows that there is a device and that it could be opened; what is simulated needs none.
    if (shown == nullptr || (!shown->uri.isSimulated() && !isSerial(*shown) && !looksRunning(*shown))) {
        append(findings, engine.discovered ? diagnoseDevices(engine.found) : notChecked({Check::Device}));
    }
    if (shown == nullptr) {
        findings.push_back(finding(Check::Link, CheckState::Problem));
        findings.back().error = Error{.code = Errc::NotConnected};
    }
    Finding stop =
        finding(Check::Stop, engine.stop == StopReason::None ? CheckState::Ok : CheckState::Problem);
    stop.stop = engine.stop;
    if (shown == nullptr) {
        findings.push_back(std::move(stop));
        append(findings, notChecked(kBehindTheLink));
        return findings;
    }
    auto session = diagnoseSession(*shown);
    const auto link = std::ranges::find(session, Check::Link, &Finding::check);
    session.insert(link == session.end() ? link : std::next(link), std::move(stop));
    append(findings, std::move(session));
    return findings;
}

bool isWell(const std::vector<Finding>& findings) {
    return std::none_of(findings.begin(), findings.end(),
                        [](const Finding& one) { return one.state == CheckState::Problem; });
}

}  // namespace kickstand
