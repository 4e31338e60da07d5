#include "app/kickstandctl/values.h"

#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::ctl {
namespace {

constexpr double kShortest_s = 0.01;
constexpr double kLongest_s = 86400;

QString shown(std::string_view text) {
    return printable(std::string(text));
}

std::optional<std::int64_t> wholeNumber(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        base = 16;
        text.remove_prefix(2);
    }
    // from_chars() would take a sign of its own here.
    if (text.empty() || text.starts_with('-')) return std::nullopt;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    if (error == std::errc::result_out_of_range) return negative ? INT64_MIN : INT64_MAX;
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return negative ? -value : value;
}

/// The pieces between commas.
std::vector<std::string_view> pieces(std::string_view text) {
    std::vector<std::string_view> all;
    for (;;) {
        const std::size_t comma = text.find(',');
        all.push_back(text.substr(0, comma));
        if (comma == std::string_view::npos) return all;
        text.remove_prefix(comma + 1);
    }
}

}  // namespace

Expected<int> parseWhole(std::string_view text, std::string_view what, int lowest, int highest) {
    const auto value = wholeNumber(text);
    if (value && *value >= lowest && *value <= highest) return static_cast<int>(*value);
    return badUsage(Words::tr("%1 cannot be “%2”.").arg(shown(what), shown(text)),
                    Words::tr("It is a whole number from %1 to %2.").arg(lowest).arg(highest));
}

Expected<double> parseDecimal(std::string_view text, std::string_view what, double lowest, double highest) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    if (whole && value >= lowest && value <= highest) return value;
    return badUsage(Words::tr("%1 cannot be “%2”.").arg(shown(what), shown(text)),
                    Words::tr("It is a number from %1 to %2.").arg(lowest).arg(highest));
}

Expected<Duration> parseSeconds(std::string_view text, std::string_view what) {
    return parseDecimal(text, what, kShortest_s, kLongest_s).map([](double span_s) {
        return fromSeconds(span_s);
    });
}

Expected<int> parseRobot(std::string_view text) {
    return parseWhole(text, "--robot", 0, thunderbots::kRobots - 1);
}

Expected<thunderbots::RobotMask> parseRobots(std::string_view text) {
    thunderbots::RobotMask robots = 0;
    for (const std::string_view piece : pieces(text)) {
        const std::size_t dash = piece.find('-');
        const auto first = wholeNumber(piece.substr(0, dash));
        const auto last = dash == std::string_view::npos ? first : wholeNumber(piece.substr(dash + 1));
        if (!first || !last || *first < 0 || *last >= thunderbots::kRobots || *first > *last)
            return badUsage(Words::tr("--robot cannot be “%1”.").arg(shown(text)),
                            Words::tr("It is one robot from 0 to 15, or several, as in 0,3,5-7."));
        for (auto robot = static_cast<int>(*first); robot <= *last; ++robot)
            robots |= thunderbots::maskOf(robot);
    }
    return robots;
}

Expected<thunderbots::WheelSpeeds> parseWheels(std::string_view text, int limit) {
    const auto speeds = pieces(text);
    if (speeds.size() != thunderbots::kWheels)
        return badUsage(Words::tr("--wheels cannot be “%1”.").arg(shown(text)),
                        Words::tr("It is four speeds with commas between them, as in 40,-36,36,0."));
    thunderbots::WheelSpeeds wheels{};
    for (std::size_t i = 0; i < wheels.size(); ++i) {
        const auto value = wholeNumber(speeds[i]);
        if (value && *value >= -limit && *value <= limit) {
            wheels[i] = static_cast<int>(*value);
            continue;
        }
        const QString what = Words::tr("Wheel %1 cannot be “%2”.").arg(i + 1).arg(shown(speeds[i]));
        const bool needsLimit =
            value && *value >= -thunderbots::kFastestWheel && *value <= thunderbots::kFastestWheel;
        if (needsLimit) return badUsage(what, Words::tr("More than ±%1 needs --limit.").arg(limit));
        return badUsage(what, Words::tr("It is a whole number from %1 to %2.").arg(-limit).arg(limit));
    }
    return wheels;
}

}  // namespace kickstand::ctl
