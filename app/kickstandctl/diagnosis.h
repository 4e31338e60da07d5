#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "app/kickstandctl/device_holder.h"
#include "app/kickstandctl/failure.h"
#include "core/engine/messages.h"

namespace kickstand::ctl {

/// One thing that the doctor looked at.
struct Finding {
    enum class State { Ok, Warning, Problem, NotChecked };

    const char* check = "";  ///< Stable: "program", "device", "permission", "claim", "link", …
    State state = State::Ok;
    Description text;  ///< What there is, and what to do about it.
};

/// "ok", "warning", "problem", "not-checked".
const char* name(Finding::State state);

/// Who holds the device at a place, if that can be seen.
using HolderFinder = std::function<std::optional<Holder>(const std::string& port)>;

/// What is said about the devices that are plugged in: device, permission, claim.
std::vector<Finding> diagnoseDevices(const std::vector<FoundDevice>& devices, const HolderFinder& findHolder);
/// What is said about a link that runs: radios, e-stop, robots, feedback, traffic.
std::vector<Finding> diagnoseLink(const thunderbots::Snapshot& state);
/// Lines for what could not be looked at because something before it is wrong.
std::vector<Finding> notChecked(std::initializer_list<const char*> checks);

}  // namespace kickstand::ctl
