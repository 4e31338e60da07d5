#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/coach/sim/coach_sim.h"

namespace kickstand::coach::sim {
namespace {

constexpr double kSlowestFall_s = 3600;

tl::unexpected<Error> outOfRange(const std::string& option, const std::string& text, std::int64_t lowest,
                                 std::int64_t highest) {
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = option;
    error.lowest = lowest;
    error.highest = highest;
    error.detail = text;
    return fail(std::move(error));
}

Result<std::uint32_t> readWhole(const std::string& option, std::string_view text, std::uint32_t highest) {
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    std::uint32_t value = 0;
    const std::string_view digits = hex ? text.substr(2) : text;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, hex ? 16 : 10);
    if (error != std::errc() || end != digits.data() + digits.size())
        return fail(Errc::BadArgument, option, std::string(text));
    if (value > highest) return outOfRange(option, std::string(text), 0, highest);
    return value;
}

Result<double> readNumber(const std::string& option, const std::string& text, double highest) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return fail(Errc::BadArgument, option, text);
    if (value < 0 || value > highest) return outOfRange(option, text, 0, static_cast<std::int64_t>(highest));
    return value;
}

/// Numbers between commas, each once; nothing at all is none.
template <class Number>
Result<std::vector<Number>> readList(const std::string& option, std::string_view text,
                                     std::uint32_t highest) {
    std::vector<Number> numbers;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const auto number = readWhole(option, text.substr(0, comma), highest);
        if (!number) return fail(number.error());
        for (const Number one : numbers) {
            if (one == *number) return fail(Errc::BadArgument, option, std::string(text));
        }
        numbers.push_back(static_cast<Number>(*number));
        if (comma == std::string_view::npos) break;
        text.remove_prefix(comma + 1);
        if (text.empty()) return fail(Errc::BadArgument, option, ",");
    }
    return numbers;
}

/// TEAM:PROBABILITY, with commas between them.
Result<std::map<wire::Team, double>> readLossy(const std::string& option, std::string_view text) {
    std::map<wire::Team, double> lossy;
    while (true) {
        const std::string_view one = text.substr(0, text.find(','));
        const std::size_t colon = one.find(':');
        if (colon == std::string_view::npos) return fail(Errc::BadArgument, option, std::string(one));
        const auto team = readWhole(option, one.substr(0, colon), 255);
        if (!team) return fail(team.error());
        const auto loss = readNumber(option, std::string(one.substr(colon + 1)), 1);
        if (!loss) return fail(loss.error());
        if (!lossy.emplace(static_cast<wire::Team>(*team), *loss).second)
            return fail(Errc::BadArgument, option, std::string(one));
        if (one.size() == text.size()) return lossy;
        text.remove_prefix(one.size() + 1);
    }
}

Result<void> readOption(CoachSimOptions& options, const std::string& option, const std::string& text) {
    const auto into = [](auto& place, auto result) -> Result<void> {
        if (!result) return fail(result.error());
        place = static_cast<std::decay_t<decltype(place)>>(*result);
        return {};
    };
    if (option == "address") return into(options.modules, readList<std::uint16_t>(option, text, 0xFFFF));
    if (option == "towrps") return into(options.boats, readList<wire::Team>(option, text, 255));
    if (option == "coaches") return into(options.rivals, readList<wire::Team>(option, text, 255));
    if (option == "lossy") {
        auto lossy = readLossy(option, text);
        if (!lossy) return fail(lossy.error());
        options.lossy = std::move(*lossy);
        return {};
    }
    if (option == "loss") return into(options.loss, readNumber(option, text, 1));
    if (option == "seed") return into(options.seed, readWhole(option, text, 0xFFFFFFFF));
    if (option == "fresh") return into(options.fresh, readWhole(option, text, 1));
    if (option == "fall") {
        double fall_s = 0;
        auto read = into(fall_s, readNumber(option, text, kSlowestFall_s));
        options.fall = fromSeconds(fall_s);
        return read;
    }
    return fail(Errc::UnknownName, option, "address, fresh, towrps, coaches, loss, lossy, seed, fall");
}

}  // namespace

Result<CoachSimOptions> parseSimOptions(const LinkUri& uri) {
    CoachSimOptions options;
    for (const auto& [option, text] : uri.options) {
        if (auto read = readOption(options, option, text); !read) return fail(read.error());
    }
    if (options.modules.empty()) return fail(Errc::BadArgument, "address", "");
    for (const auto& [team, loss] : options.lossy) {
        if (std::find(options.boats.begin(), options.boats.end(), team) == options.boats.end())
            return fail(Errc::BadArgument, "lossy", std::to_string(int{team}));
    }
    return options;
}

}  // namespace kickstand::coach::sim
