#include "core/thunderbots/sim/sim_options.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

namespace kickstand::thunderbots::sim {
namespace {

constexpr std::int64_t kMaxDelay_ms = 1000;
constexpr std::int64_t kLastRobot = wire::kRobotCount - 1;

Result<std::int64_t> readInteger(std::string_view text, const std::string& option, std::int64_t lowest,
                                 std::int64_t highest) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        return fail(Errc::BadArgument, option, std::string(text));
    if (value < lowest || value > highest)
        return fail({.code = Errc::OutOfRange,
                     .subject = option,
                     .lowest = lowest,
                     .highest = highest,
                     .got = value,
                     .detail = std::string(text)});
    return value;
}

Result<double> readProbability(std::string_view text, const std::string& option) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return fail(Errc::BadArgument, option, std::string(text));
    if (value < 0 || value > 1)
        return fail({.code = Errc::OutOfRange,
                     .subject = option,
                     .lowest = 0,
                     .highest = 1,
                     .detail = std::string(text)});
    return value;
}

/// "0-3", "5": one piece of a list of robots.
Result<std::uint16_t> readRange(std::string_view text, const std::string& option) {
    const std::size_t dash = text.find('-', text.empty() ? 0 : 1);
    const auto first = readInteger(text.substr(0, dash), option, 0, kLastRobot);
    if (!first) return fail(first.error());
    const auto last = dash == std::string_view::npos
                          ? first
                          : readInteger(text.substr(dash + 1), option, *first, kLastRobot);
    if (!last) return fail(last.error());
    const unsigned below = (1U << (*last + 1)) - 1;
    const unsigned before = (1U << *first) - 1;
    return static_cast<std::uint16_t>(below & ~before);
}

Result<std::uint16_t> readRobots(std::string_view text, const std::string& option) {
    std::uint16_t robots = 0;
    for (;;) {
        const std::size_t comma = text.find(',');
        const auto piece = readRange(text.substr(0, comma), option);
        if (!piece) return fail(piece.error());
        robots = static_cast<std::uint16_t>(robots | *piece);
        if (comma == std::string_view::npos) return robots;
        text.remove_prefix(comma + 1);
    }
}

/// One of two words: true for the first.
Result<bool> readWord(const std::string& text, const std::string& option, std::string_view yes,
                      std::string_view no) {
    if (text == yes) return true;
    if (text == no) return false;
    return fail(Errc::BadArgument, option, text);
}

/// Puts a value that was read where it belongs.
template <class T, class Put>
Result<void> store(const Result<T>& value, Put put) {
    if (!value) return fail(value.error());
    put(*value);
    return {};
}

Result<void> readOption(ThunderbotsSimOptions& options, const std::string& name, const std::string& text) {
    if (name == "robots")
        return store(readRobots(text, name), [&](std::uint16_t robots) { options.robots = robots; });
    if (name == "cable")
        return store(readInteger(text, name, 0, kLastRobot),
                     [&](std::int64_t robot) { options.cableRobot = static_cast<std::uint8_t>(robot); });
    if (name == "loss")
        return store(readProbability(text, name), [&](double value) { options.weather.loss = value; });
    if (name == "duplicate")
        return store(readProbability(text, name), [&](double value) { options.weather.duplication = value; });
    if (name == "delay_ms")
        return store(readInteger(text, name, 0, kMaxDelay_ms), [&](std::int64_t delay_ms) {
            options.weather.delay = std::chrono::milliseconds(delay_ms);
        });
    if (name == "seed")
        return store(readInteger(text, name, 0, std::numeric_limits<std::int64_t>::max()),
                     [&](std::int64_t seed) { options.seed = static_cast<std::uint64_t>(seed); });
    if (name == "radio")
        return store(readWord(text, name, "ideal", "true"),
                     [&](bool ideal) { options.pace = ideal ? RadioPace::Ideal : RadioPace::True; });
    if (name == "noise")
        return store(readWord(text, name, "on", "off"), [&](bool noise) { options.noise = noise; });
    return fail(Errc::UnknownName, name, "robots, cable, loss, duplicate, delay_ms, seed, radio, noise");
}

}  // namespace

Result<ThunderbotsSimOptions> parseSimOptions(const LinkUri& uri) {
    if (uri.options.contains("cable") && uri.options.contains("robots"))
        return fail(Errc::BadArgument, "robots", "a cable leads to one robot");
    for (const char* ofRadio : {"radio", "loss", "duplicate", "delay_ms"}) {
        if (uri.options.contains("cable") && uri.options.contains(ofRadio))
            return fail(Errc::BadArgument, ofRadio, "a cable has no radio");
    }
    ThunderbotsSimOptions options;
    for (const auto& [name, text] : uri.options) {
        if (const auto read = readOption(options, name, text); !read) return fail(read.error());
    }
    return options;
}

}  // namespace kickstand::thunderbots::sim
