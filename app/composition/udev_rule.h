#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace kickstand {

/// The udev rule on this machine that names a device of this vendor and product, by its path; the one that
/// counts where several folders have it. Empty where there is none, as on systems without udev. `root` stands
/// in for / in tests.
std::optional<std::string> findUdevRule(std::uint16_t vendor, std::uint16_t product,
                                        const std::filesystem::path& root = "/");

}  // namespace kickstand
