#include "app/kickstandctl/diagnosis.h"

#include <algorithm>

#include "app/kickstandctl/text.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::ctl {
namespace {

namespace wire = thunderbots::wire;
using State = Finding::State;
using thunderbots::RobotMask;

Finding fine(const char* check, const QString& what) {
    return {check, State::Ok, {what, {}, {}}};
}
Finding problem(const char* check, const QString& what, const QString& remedy) {
    return {check, State::Problem, {what, remedy, {}}};
}
Finding warning(const char* check, const QString& what, const QString& remedy) {
    return {check, State::Warning, {what, remedy, {}}};
}

Finding permission(const FoundDevice& device) {
    if (device.obstacle && device.obstacle->code == Errc::PermissionDenied)
        return {"permission", State::Problem, describe(*device.obstacle)};
    return fine("permission",
                Words::tr("This user may open the device at %1.").arg(printable(device.info.port)));
}

Finding claim(const FoundDevice& device, const HolderFinder& findHolder) {
    if (device.obstacle && device.obstacle->code == Errc::PermissionDenied)
        return notChecked({"claim"}).front();
    if (!device.obstacle)
        return fine("claim",
                    Words::tr("No other program holds the device at %1.").arg(printable(device.info.port)));
    Finding finding{"claim", State::Problem, describe(*device.obstacle)};
    if (const auto holder = findHolder(device.info.port)) {
        finding.text.what = Words::tr("The device at %1 is held by %2 (process %3).")
                                .arg(printable(device.info.port), printable(holder->name))
                                .arg(holder->pid);
        finding.text.remedy = Words::tr("Close that program.");
    } else {
        finding.text.remedy = Words::tr(
            "Close that program; it belongs to somebody else, so only root can see which one it is.");
    }
    return finding;
}

RobotMask robotsWhere(const thunderbots::Snapshot& state, bool (*is)(const thunderbots::RobotState&)) {
    RobotMask robots = 0;
    for (int number = 0; number < thunderbots::kRobots; ++number) {
        if (is(state.robots[static_cast<std::size_t>(number)])) robots |= thunderbots::maskOf(number);
    }
    return robots;
}

Finding radios(const thunderbots::Snapshot& state) {
    if (state.cable) return fine("radios", Words::tr("A cable needs none."));
    if (state.radios != wire::RadioState::Running)
        return problem("radios", Words::tr("The dongle's radios: %1.").arg(describe(state.radios)),
                       Words::tr("Unplug the dongle and plug it in again."));
    if (!state.channels) return fine("radios", Words::tr("The dongle's radios run."));
    return fine("radios", Words::tr("The dongle's radios run on channels %1 and %2.")
                              .arg(state.channels->channel0)
                              .arg(state.channels->channel1));
}

Finding emergencyStop(const thunderbots::Snapshot& state) {
    if (state.eStop == wire::EStop::Run) return fine("e-stop", Words::tr("The emergency stop is at “run”."));
    Finding finding{"e-stop", State::Problem, describe(Error{.code = Errc::EmergencyStopNotRun})};
    finding.text.what = Words::tr("The emergency stop: %1.").arg(describe(state.eStop));
    return finding;
}

Finding robots(RobotMask live) {
    if (live != 0) return fine("robots", Words::tr("Heard: %1.").arg(robotsPhrase(live)));
    return problem(
        "robots", Words::tr("No robot is heard."),
        Words::tr("Switch one on; check that its battery is full and that its channels are the dongle's."));
}

Finding feedback(const thunderbots::Snapshot& state, RobotMask live) {
    if (live == 0) return notChecked({"feedback"}).front();
    const RobotMask silent = robotsWhere(state, [](const thunderbots::RobotState& robot) {
        return robot.live && robot.freshness != thunderbots::Freshness::Current;
    });
    if (silent == 0) return fine("feedback", Words::tr("Every robot that is heard sends its readings."));
    return problem("feedback", Words::tr("No readings come from %1.").arg(robotsPhrase(silent)),
                   Words::tr("Wait a moment and look again; if it stays so, switch it off and on."));
}

Finding battery(const thunderbots::Snapshot& state) {
    const RobotMask low = robotsWhere(state, [](const thunderbots::RobotState& robot) {
        return robot.freshness == thunderbots::Freshness::Current &&
               robot.readings.battery_V < wire::kBatteryLow_V;
    });
    if (low == 0) return fine("battery", Words::tr("No battery is low."));
    return warning("battery", Words::tr("The battery is low: %1.").arg(robotsPhrase(low)),
                   Words::tr("Change it soon."));
}

Finding traffic(const thunderbots::TrafficCounters& traffic) {
    if (traffic.malformed == 0 && traffic.stalls == 0 && traffic.dongleErrors == 0)
        return fine("traffic", Words::tr("Nothing on the link is damaged."));
    return warning(
        "traffic",
        Words::tr("Damaged or refused on the link: unreadable %1, stalls %2, reported by the dongle %3.")
            .arg(traffic.malformed)
            .arg(traffic.stalls)
            .arg(traffic.dongleErrors),
        Words::tr("A few of them do no harm; `kickstandctl thunderbots monitor` shows each."));
}

}  // namespace

const char* name(State state) {
    switch (state) {
        case State::Ok:
            return "ok";
        case State::Warning:
            return "warning";
        case State::Problem:
            return "problem";
        case State::NotChecked:
            return "not-checked";
    }
    return "";
}

std::vector<Finding> notChecked(std::initializer_list<const char*> checks) {
    std::vector<Finding> findings;
    for (const char* check : checks)
        findings.push_back(
            {check, State::NotChecked, {Words::tr("Not looked at: something before it is wrong."), {}, {}}});
    return findings;
}

std::vector<Finding> diagnoseDevices(const std::vector<FoundDevice>& devices,
                                     const HolderFinder& findHolder) {
    std::vector<Finding> findings;
    if (devices.empty())
        findings.push_back({"device", State::Problem, describe(Error{.code = Errc::NoDevice})});
    for (const FoundDevice& device : devices) {
        findings.push_back(fine(
            "device", Words::tr("%1 is plugged in at %2.")
                          .arg(QString::fromStdString(toString(device.uri)), printable(device.info.port))));
        findings.push_back(permission(device));
        findings.push_back(claim(device, findHolder));
    }
    return findings;
}

std::vector<Finding> diagnoseLink(const thunderbots::Snapshot& state) {
    const RobotMask live =
        robotsWhere(state, [](const thunderbots::RobotState& robot) { return robot.live; });
    return {radios(state),         emergencyStop(state), robots(live),
            feedback(state, live), battery(state),       traffic(state.traffic)};
}

}  // namespace kickstand::ctl
