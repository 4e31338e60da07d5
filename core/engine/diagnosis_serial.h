#pragma once

#include "core/engine/diagnosis.h"

namespace kickstand {

// What is said about a link over a serial port, and about what answers there: Device, Permission and Claim of
// the port, where it is a real one, then Link and Answers. Any thread.

std::vector<Finding> diagnoseSerial(const LinkUri& uri, const motionplan::Snapshot& state);
std::vector<Finding> diagnoseSerial(const LinkUri& uri, const coach::Snapshot& state);
/// Of each port that cannot be opened; of one that can the last two alone.
std::vector<Finding> diagnoseSerial(const LinkUri& uri, const smartdevice::Snapshot& state);

}  // namespace kickstand
