#include "app/composition/udev_rule.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <vector>

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

/// Whether a line lets somebody in to that device, rather than only naming it.
bool admits(const std::string& line, const std::string& vendor, const std::string& product) {
    if (line.empty() || line.front() == '#') return false;
    const bool names = line.find("{idVendor}==\"" + vendor + '"') != std::string::npos &&
                       line.find("{idProduct}==\"" + product + '"') != std::string::npos;
    return names && (line.find("TAG+=\"uaccess\"") != std::string::npos ||
                     line.find("MODE=") != std::string::npos || line.find("GROUP=") != std::string::npos);
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
    // In udev's own order: a file here replaces one of the same name further on.
    for (const char* folder : {"etc/udev/rules.d", "run/udev/rules.d", "usr/local/lib/udev/rules.d",
                               "usr/lib/udev/rules.d", "lib/udev/rules.d"}) {
        std::error_code error;
        std::vector<fs::path> files;
        for (fs::directory_iterator entry(root / folder, error), end; !error && entry != end;
             entry.increment(error)) {
            if (entry->path().extension() == ".rules") files.push_back(entry->path());
        }
        std::sort(files.begin(), files.end());
        for (const fs::path& file : files) {
            if (fileAdmits(file, hex(vendor), hex(product)))
                return (fs::path("/") / folder / file.filename()).string();
        }
    }
    return std::nullopt;
}

}  // namespace kickstand
