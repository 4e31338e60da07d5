#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace kickstand::ctl {

/// A program that holds a device open.
struct Holder {
    int pid = 0;
    std::string name;

    friend bool operator==(const Holder&, const Holder&) = default;
};

/// Who, besides this process, holds the USB device at that place ("1-2.3") open, as far as the system tells
/// this user: other people's processes hide what they hold. `root` stands in for / in tests.
std::optional<Holder> findHolder(const std::string& port, const std::filesystem::path& root = "/");

}  // namespace kickstand::ctl
