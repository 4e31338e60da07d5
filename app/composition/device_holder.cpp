#include "app/composition/device_holder.h"

#include <charconv>
#include <fstream>

#include <unistd.h>

namespace kickstand {
namespace {

namespace fs = std::filesystem;

std::optional<int> number(const std::string& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

std::string firstLine(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
}

std::string threeDigits(int value) {
    const std::string digits = std::to_string(value);
    return digits.size() < 3 ? std::string(3 - digits.size(), '0') + digits : digits;
}

/// "/dev/bus/usb/001/005", by what the kernel says of the place.
std::optional<std::string> nodeOf(const std::string& port, const fs::path& root) {
    if (port.empty() || port.find('/') != std::string::npos) return std::nullopt;
    const fs::path device = root / "sys/bus/usb/devices" / port;
    const auto bus = number(firstLine(device / "busnum"));
    const auto address = number(firstLine(device / "devnum"));
    if (!bus || !address) return std::nullopt;
    return "/dev/bus/usb/" + threeDigits(*bus) + '/' + threeDigits(*address);
}

bool holds(const fs::path& process, const std::string& node) {
    std::error_code error;
    for (fs::directory_iterator entry(process / "fd", error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code unreadable;
        if (fs::read_symlink(entry->path(), unreadable) == node) return true;
    }
    return false;
}

}  // namespace

std::optional<DeviceHolder> findHolder(const std::string& port, const fs::path& root) {
    const auto node = nodeOf(port, root);
    if (!node) return std::nullopt;
    std::error_code error;
    for (fs::directory_iterator entry(root / "proc", error), end; !error && entry != end;
         entry.increment(error)) {
        const auto pid = number(entry->path().filename().string());
        if (!pid || *pid == ::getpid() || !holds(entry->path(), *node)) continue;
        return DeviceHolder{*pid, firstLine(entry->path() / "comm")};
    }
    return std::nullopt;
}

}  // namespace kickstand
