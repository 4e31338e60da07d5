#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/engine/link_provider.h"

namespace kickstand {

/// Who, besides this process, holds the USB device at that place ("1-2.3") open, as far as the system tells
/// this user: other people's processes hide what they hold. `root` stands in for / in tests.
std::optional<DeviceHolder> findHolder(const std::string& port, const std::filesystem::path& root = "/");

}  // namespace kickstand
