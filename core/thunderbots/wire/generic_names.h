#pragma once

#include <string>
#include <string_view>

#include "core/thunderbots/wire/fields.h"

namespace kickstand::thunderbots::wire {

/// All names of messages(), for an error that says what there is. Any thread.
std::string knownMessageNames();

/// The names of a message's fields that can be given. Any thread.
std::string knownFieldNames(const MessageSpec& message);

}  // namespace kickstand::thunderbots::wire
