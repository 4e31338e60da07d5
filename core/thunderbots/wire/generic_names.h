#pragma once

#include <string>
#include <string_view>

#include "core/thunderbots/wire/fields.h"

namespace kickstand::thunderbots::wire {

/// Whether messages() has variants of that name, and no message of just that name. Any thread.
bool isFamily(std::string_view name) noexcept;

/// All names of messages(), for an error that says what there is. Any thread.
std::string knownMessageNames();

/// The names of a message's fields that can be given. Any thread.
std::string knownFieldNames(const MessageSpec& message);

}  // namespace kickstand::thunderbots::wire
