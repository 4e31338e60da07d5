#pragma once

#include <QString>
#include <string_view>

namespace kickstand::ctl {

/// Help on the program (empty name), on a group ("thunderbots") or on one command ("thunderbots drive").
QString helpText(std::string_view name);

/// "kickstandctl 0.1.0".
QString versionText();

}  // namespace kickstand::ctl
