#include "core/motionplan/sim/motionplan_options.h"

#include <charconv>
#include <chrono>
#include <cmath>
#include <locale>
#include <sstream>
#include <string_view>

namespace kickstand::motionplan::sim {
namespace {

constexpr double kLongestDelay_ms = 5000;
constexpr double kFastestPace = 100;
constexpr double kSlowestPace = 0.1;
constexpr double kLargestSeed = 1e15;

Result<double> readNumber(const std::string& name, std::string_view text, double lowest, double highest) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return fail(Errc::BadArgument, name, std::string(text));
    if (value >= lowest && value <= highest) return value;
    return fail(outOfBounds(name, lowest, highest, text));
}

Result<void> readOption(NxtOptions& options, const std::string& name, const std::string& text) {
    if (name == "text") {
        if (text != "on" && text != "off") return fail(Errc::BadArgument, name, text);
        options.text = text == "on";
        return {};
    }
    double lowest = 0;
    double highest = 1;
    if (name == "delay_ms") highest = kLongestDelay_ms;
    if (name == "seed") highest = kLargestSeed;
    if (name == "pace") lowest = kSlowestPace;
    if (name == "pace") highest = kFastestPace;
    const auto value = readNumber(name, text, lowest, highest);
    if (!value) return fail(value.error());
    if (name == "loss") options.weather.loss = *value;
    if (name == "reply-loss") options.weather.replyLoss = *value;
    if (name == "duplicate") options.weather.duplicate = *value;
    if (name == "delay_ms") options.weather.delay = fromSeconds(*value / 1000);
    if (name == "seed") options.seed = static_cast<std::uint64_t>(*value);
    if (name == "pace") options.pace = *value;
    return {};
}

}  // namespace

Error outOfBounds(std::string_view name, double lowest, double highest, std::string_view given) {
    Error error{.code = Errc::OutOfRange, .subject = std::string(name), .detail = std::string(given)};
    if (lowest == std::floor(lowest) && highest == std::floor(highest)) {
        error.lowest = static_cast<std::int64_t>(lowest);
        error.highest = static_cast<std::int64_t>(highest);
    } else {
        std::ostringstream bounds;
        bounds.imbue(std::locale::classic());
        bounds << " (" << lowest << " to " << highest << ')';
        error.detail += bounds.str();
    }
    return error;
}

Result<NxtOptions> parseNxtOptions(const std::map<std::string, std::string>& given) {
    constexpr std::string_view kNames[] = {"loss", "reply-loss", "duplicate", "delay_ms",
                                           "seed", "pace",       "text"};
    NxtOptions options;
    for (const auto& [name, text] : given) {
        bool known = false;
        for (const std::string_view one : kNames)
            known = known || one == name;
        if (!known)
            return fail(Errc::UnknownName, name, "loss, reply-loss, duplicate, delay_ms, seed, pace, text");
        if (auto read = readOption(options, name, text); !read) return fail(read.error());
    }
    return options;
}

}  // namespace kickstand::motionplan::sim
