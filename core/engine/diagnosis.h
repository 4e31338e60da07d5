#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "core/engine/messages.h"

namespace kickstand {

// Why does it not work? What is looked at, in the order in which one thing needs the other, as plain facts;
// the sentences and remedies are made in core/engine/describe_findings.h. Any thread.

/// What is looked at.
enum class Check {
    Program,
    Device,      ///< Is one plugged in?
    Permission,  ///< May this user open it?
    Claim,       ///< Does another program hold it?
    Link,
    Stop,  ///< Is STOP latched?
    Radios,
    EmergencyStop,
    Robots,
    Feedback,
    Battery,
    Traffic,
    Answers,    ///< Does what is at a serial port answer?
    Catalogue,  ///< Can the user's catalogue of boards be read? Only where it cannot.
};

/// What is to answer at a serial port.
enum class Answerer { Nxt, Radio, Board };

/// "program", "device", …: stable names, for JSON.
const char* name(Check check);

/// How something that was looked at stands.
enum class CheckState { Ok, Warning, Problem, NotChecked };

/// "ok", "warning", "problem", "not-checked".
const char* name(CheckState state);

/// One thing that was looked at, with those facts that matter for it.
struct Finding {
    Check check = Check::Program;
    CheckState state = CheckState::Ok;
    std::optional<Error> error{};  ///< What went wrong, where an error says it.
    std::optional<LinkUri> link{};
    std::string port{};  ///< Where the device is on the bus.
    std::optional<DeviceHolder> holder{};
    std::string rule{};  ///< The udev rule that is installed for the device.
    bool cable = false;
    thunderbots::LinkState linkState = thunderbots::LinkState::Idle;
    StopReason stop = StopReason::None;
    thunderbots::wire::RadioState radios = thunderbots::wire::RadioState::PreInit;
    std::optional<thunderbots::wire::Channels> channels{};
    thunderbots::wire::EStop eStop = thunderbots::wire::EStop::Uninitialized;
    thunderbots::RobotMask robots = 0;  ///< Those that it is about.
    thunderbots::TrafficCounters traffic{};
    bool serial = false;  ///< It is about a serial port, and not a device on USB.
    Answerer answerer = Answerer::Nxt;
    int answering = 0;  ///< How many boards do.
};

/// Lines for what could not be looked at because something before it is wrong.
std::vector<Finding> notChecked(std::initializer_list<Check> checks);
/// What is said about the devices that are plugged in: Device, Permission, Claim.
std::vector<Finding> diagnoseDevices(const std::vector<FoundDevice>& devices);
/// What is said about a link that runs: Radios to Traffic.
std::vector<Finding> diagnoseLink(const thunderbots::Snapshot& state);
/// The line for a link that does not run because of `error`, and those for all that lies behind it.
std::vector<Finding> diagnoseFailedLink(const LinkUri& uri, const Error& error);
/// The line for a link that runs.
Finding runningLink(const LinkUri& uri, const thunderbots::Snapshot& state);

/// What is said about the link of a session and what lies behind it, in any state.
std::vector<Finding> diagnoseSession(const SessionSnapshot& session);

/// Everything, as the engine sees it now; `shown` is the session that a person looks at, null where there is
/// none.
std::vector<Finding> diagnose(const EngineSnapshot& engine, const SessionSnapshot* shown);

/// Whether nothing that was looked at is wrong.
bool isWell(const std::vector<Finding>& findings);

}  // namespace kickstand
