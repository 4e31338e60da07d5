#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "tests/rules/layers.h"
#include "tests/rules/rules.h"

namespace kickstand::rules {
namespace {

struct Include {
    std::size_t line = 1;
    std::string target;
    bool quoted = false;
};

std::string_view skipSpace(std::string_view text) {
    const std::size_t start = text.find_first_not_of(" \t");
    return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

/// Reads `#include "x"` or `#include <x>`, with spaces wherever the preprocessor allows them.
std::optional<Include> readInclude(std::string_view text) {
    constexpr std::string_view kWord = "include";
    text = skipSpace(text);
    if (!text.starts_with('#')) return std::nullopt;
    text = skipSpace(text.substr(1));
    if (!text.starts_with(kWord)) return std::nullopt;
    text = skipSpace(text.substr(kWord.size()));
    if (!text.starts_with('"') && !text.starts_with('<')) return std::nullopt;
    const bool quoted = text.starts_with('"');
    const std::size_t end = text.find(quoted ? '"' : '>', 1);
    if (end == std::string_view::npos) return std::nullopt;
    return Include{.target = std::string(text.substr(1, end - 1)), .quoted = quoted};
}

bool isFromRoot(std::string_view target) {
    return target.starts_with("app/") || target.starts_with("core/") || target.starts_with("ui/") ||
           target.starts_with("tests/");
}

struct OutsideLibrary {
    std::string_view name;
    std::string_view home;
    bool (*matches)(std::string_view target);
};
constexpr std::array<OutsideLibrary, 6> kOutsideLibraries{{
    {"Asio", "core/link/socket/",
     [](std::string_view t) { return t == "asio.hpp" || t.starts_with("asio/"); }},
    {"libusb", "core/link/usb/", [](std::string_view t) { return t.ends_with("libusb.h"); }},
    {"Qt SerialPort", "core/link/serial/",
     [](std::string_view t) { return t.find("SerialPort") != t.npos && t.starts_with('Q'); }},
    {"QCustomPlot", "ui/plot/", [](std::string_view t) { return t.ends_with("qcustomplot.h"); }},
    {"SQLite", "core/ledger/", [](std::string_view t) { return t == "sqlite3.h"; }},
    {"SDL", "ui/gamepad/", [](std::string_view t) { return t.starts_with("SDL"); }},
}};

bool isQt(std::string_view target) {
    return target.size() > 1 && target[0] == 'Q' && std::isalpha(static_cast<unsigned char>(target[1])) != 0;
}

/// The places of core that may use Qt: sentences for people, and serial ports.
bool mayUseQt(const SourceFile& file) {
    return !file.isIn("core/") || file.isIn("core/engine/describe") || file.isIn("core/link/serial/");
}

bool isStandardOrExpected(std::string_view target) {
    const bool plain = std::ranges::all_of(
        target, [](unsigned char c) { return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '_'; });
    // The compiler's own words for the processor's instructions come with it, as the standard library does.
    return plain || target.starts_with("tl/") || target == "emmintrin.h";
}

void checkInclude(const SourceFile& file, const Include& include, std::vector<Violation>& found) {
    const auto report = [&](std::string_view rule, std::string message) {
        found.push_back({file.path, include.line, rule, std::move(message)});
    };
    const std::string& target = include.target;

    // A benchmark may name what it measures against.
    const bool namesPeer = file.isIn("tests/bench/");
    for (const OutsideLibrary& library : kOutsideLibraries) {
        if (library.matches(target) && !file.isIn(library.home) && !namesPeer) {
            report(kLibrary,
                   std::string(library.name) + " may be included only in " + std::string(library.home));
        }
    }
    if (isFromRoot(target)) {
        if (!mayInclude(file.path, target)) {
            report(kLayer, "may not include " + target + "; allowed: " + std::string(allowanceOf(file.path)));
        }
        return;
    }
    if (isQt(target) && !mayUseQt(file)) report(kCoreQt, "no Qt here: " + target);
    const Layer layer = placeOf(file.path).layer;
    const bool isPure = layer == Layer::Wire || layer == Layer::Image || layer == Layer::Framing;
    if (isPure && !isStandardOrExpected(target)) {
        report(kPure,
               "wire/, image/ and framing/ include only the standard library, framing and base: " + target);
    }
    const bool outside = target.ends_with("qcustomplot.h") || target.ends_with(".moc");
    if (include.quoted && !outside)
        report(kIncludePath, "quoted includes start at the root of the repository: " + target);
}

}  // namespace

std::vector<Violation> checkIncludes(const Tree& tree) {
    std::vector<Violation> found;
    for (const SourceFile& file : tree.files) {
        if (!file.isCode()) continue;
        for (std::size_t i = 0; i < file.lines.size(); ++i) {
            std::optional<Include> include = readInclude(file.lines[i]);
            if (!include) continue;
            include->line = i + 1;
            checkInclude(file, *include, found);
        }
        if (file.isHeader() && std::ranges::find(file.lines, "#pragma once") == file.lines.end()) {
            found.push_back({file.path, 1, kPragmaOnce, "a header begins with #pragma once"});
        }
    }
    return found;
}

}  // namespace kickstand::rules
