#pragma once

#include <optional>

#include "core/link/byte_link.h"

namespace kickstand::pty {

/// The speed that a program has set at the host's end of a pseudo-terminal, any that there can be; nothing
/// where the system does not tell. Any thread.
std::optional<Baud> baudOf(int terminal);

}  // namespace kickstand::pty
