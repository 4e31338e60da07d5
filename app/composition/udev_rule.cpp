#include "app/composition/udev_rule.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <map>
#include <string_view>

namespace kickstand {
namespace {

namespace fs = std::filesystem;

/// A rule file is a few lines; what is longer is not read to its end.
constexpr int kMostLines = 10000;

std::string hex(std::uint16_t number) {
    std::array<char, 5> digits{};
    std::snprintf(digits.data(), digits.size(), "%04x", number);
    return digits.data();
}

/// Whether a line asks for this value, perhaps beside others: KEY=="7839|783a".
bool asksFor(std::string_view line, std::string_view key, std::string_view value) {
    const std::string opening = "{" + std::string(key) + "}==\"";
    const std::size_t found = line.find(opening);
    if (found == std::string_view::npos) return false;
    std::string_view values = line.substr(found + opening.size());
    values = values.substr(0, values.find('"'));
    for (std::size_t bar = 0; bar != std::string_view::npos; values.remove_prefix(bar + 1)) {
        bar = values.find('|');
        if (values.substr(0, bar) == value) return true;
        if (bar == std::string_view::npos) break;
    }
    return false;
}

/// Whether a line lets somebody in to that device, rather than only naming it.
bool admits(const std::string& line, const std::string& vendor, const std::string& product) {
    if (line.empty() || line.front() == '#') return false;
    return asksFor(line, "idVendor", vendor) && asksFor(line, "idProduct", product) &&
           (line.find("TAG+=\"uaccess\"") != std::string::npos || line.find("MODE=") != std::string::npos ||
            line.find("GROUP=") != std::string::npos);
}

bool fileAdmits(const fs::path& file, const std::string& vendor, const std::string& product) {
    std::ifstream stream(file);
    std::string line;
    for (int i = 0; i < kMostLines && std::getline(stream, line); ++i) {
        if (admits(line, vendor, product)) return true;
    }
    return false;
}

}  // namespace

std::optional<std::string> findUdevRule(std::uint16_t vendor, std::uint16_t product, const fs::path& root) {
    // By name, as udev takes them: a file in an earlier folder replaces those of its name in later ones, also
    // where it is empty or a link to /dev/null.
    std::map<std::string, fs::path> files;
    for (const char* folder : {"etc/udev/rules.d", "run/udev/rules.d", "usr/local/lib/udev/rules.d",
                               "usr/lib/udev/rules.d", "lib/udev/rules.d"}) {
        std::error_code error;
        for (fs::directory_iterator entry(root / folder, error), end; !error && entry != end;
             entry.increment(error)) {
            const fs::path name = entry->path().filename();
            if (name.extension() == ".rules") files.emplace(name.string(), fs::path(folder) / name);
        }
    }
    for (const auto& [name, file] : files) {
        if (fileAdmits(root / file, hex(vendor), hex(product))) return (fs::path("/") / file).string();
    }
    return std::nullopt;
}

}  // namespace kickstand
