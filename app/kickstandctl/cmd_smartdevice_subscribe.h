#pragma once

#include "app/kickstandctl/session_runner.h"

namespace kickstand::ctl {

/// `smartdevice subscribe`: what the device grants, then each of its updates, one a line.
Outcome subscribeBoard(const Context& context, SessionRunner& runner);

}  // namespace kickstand::ctl
