#include "core/thunderbots/parameters.h"

#include <algorithm>
#include <charconv>
#include <string>

namespace kickstand::thunderbots {
namespace {

struct FieldFacts {
    std::string_view name;
    std::uint8_t wire::OperationalParameters::*member;
    int lowest;
    int highest;
    const char* accepted;
};

constexpr std::array<FieldFacts, kParameterFieldCount> kFacts{{
    {"flash_contents", &wire::OperationalParameters::flashContents, 0, 255, "fpga, microcontroller, no-data"},
    {"channel0", &wire::OperationalParameters::channel0, wire::kLowestChannel, wire::kHighestChannel,
     "0x0B-0x1A, 11-26, none"},
    {"channel1", &wire::OperationalParameters::channel1, wire::kLowestChannel, wire::kHighestChannel,
     "0x0B-0x1A, 11-26, none"},
    {"robot_number", &wire::OperationalParameters::robotNumber, 0, kRobots - 1, "0-15"},
    {"dribbler_duty", &wire::OperationalParameters::dribblerDuty, 0, 255, "0-255, 0%-100%"},
}};

constexpr std::array kContents{wire::FlashContents::FpgaBitstream, wire::FlashContents::Microcontroller,
                               wire::FlashContents::NoData};

const FieldFacts& factsOf(ParameterField field) {
    return kFacts[static_cast<std::size_t>(field)];
}

bool isChannel(ParameterField field) {
    return field == ParameterField::Channel0 || field == ParameterField::Channel1;
}

std::optional<int> parseWhole(std::string_view text) {
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        base = 16;
    }
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
    const bool sign = !text.empty() && text.front() == '-' && base == 16;
    if (error != std::errc() || end != text.data() + text.size() || sign) return std::nullopt;
    return value;
}

/// "47%" or "47.5 %": digits and at most one point before the sign.
std::optional<double> parsePercent(std::string_view text) {
    if (!text.ends_with('%')) return std::nullopt;
    text.remove_suffix(1);
    while (text.ends_with(' '))
        text.remove_suffix(1);
    double value = 0;
    const auto [end, error] =
        std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0) || value > 100)
        return std::nullopt;
    return value;
}

/// Values that have a name, or are not written as whole numbers.
std::optional<std::uint8_t> parseNamed(ParameterField field, std::string_view text) {
    if (isChannel(field) && text == "none") return std::uint8_t{0};
    if (field == ParameterField::FlashContents) {
        for (const wire::FlashContents contents : kContents) {
            if (text == name(contents)) return static_cast<std::uint8_t>(contents);
        }
    }
    if (field == ParameterField::DribblerDuty) {
        if (const auto percent = parsePercent(text)) return dutyOfPercent(*percent);
    }
    return std::nullopt;
}

}  // namespace

std::string_view name(ParameterField field) {
    return factsOf(field).name;
}

std::optional<ParameterField> parameterFieldFromName(std::string_view name) {
    for (const ParameterField field : kParameterFields) {
        if (factsOf(field).name == name) return field;
    }
    return std::nullopt;
}

std::uint8_t valueOf(const wire::OperationalParameters& parameters, ParameterField field) {
    return parameters.*factsOf(field).member;
}

void setValue(wire::OperationalParameters& parameters, ParameterField field, std::uint8_t value) {
    parameters.*factsOf(field).member = value;
}

Result<void> checkParameter(ParameterField field, int value) {
    const FieldFacts& facts = factsOf(field);
    if ((isChannel(field) && value == 0) || (value >= facts.lowest && value <= facts.highest)) return {};
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = facts.name;
    error.lowest = facts.lowest;
    error.highest = facts.highest;
    error.got = value;
    return fail(std::move(error));
}

Result<std::uint8_t> parseParameter(ParameterField field, std::string_view text) {
    if (const auto named = parseNamed(field, text)) return *named;
    const auto number = parseWhole(text);
    if (!number) {
        Error error;
        error.code = Errc::Malformed;
        error.subject = factsOf(field).name;
        error.detail = std::string("it is one of ") + factsOf(field).accepted;
        return fail(std::move(error));
    }
    if (auto legal = checkParameter(field, *number); !legal) return tl::unexpected(std::move(legal.error()));
    return static_cast<std::uint8_t>(*number);
}

std::string_view name(wire::FlashContents contents) {
    switch (contents) {
        case wire::FlashContents::FpgaBitstream:
            return "fpga";
        case wire::FlashContents::Microcontroller:
            return "microcontroller";
        case wire::FlashContents::NoData:
            break;
    }
    return "no-data";
}

ParameterMask differences(const wire::OperationalParameters& a, const wire::OperationalParameters& b) {
    ParameterMask mask = 0;
    for (const ParameterField field : kParameterFields) {
        if (valueOf(a, field) != valueOf(b, field)) mask = static_cast<ParameterMask>(mask | maskOf(field));
    }
    return mask;
}

std::vector<ParameterWarning> parameterWarnings(int robot, const wire::OperationalParameters& block,
                                                const std::optional<wire::OperationalParameters>& now,
                                                const std::optional<wire::Channels>& channels,
                                                RobotMask alive) {
    std::vector<ParameterWarning> warnings;
    const auto warn = [&](ParameterRisk risk) {
        warnings.push_back({risk, robot, block.robotNumber, block.channel0, block.channel1});
    };
    const bool flashChanges = !now || now->flash() != block.flash();
    if (flashChanges && block.flash() == wire::FlashContents::Microcontroller)
        warn(ParameterRisk::CopiesFlash);
    if (block.channel0 == 0 || block.channel1 == 0) {
        warn(ParameterRisk::NoChannel);
    } else if (channels && *channels != wire::Channels{block.channel0, block.channel1}) {
        warn(ParameterRisk::OtherChannels);
    }
    if (block.robotNumber != robot) {
        const bool taken = block.robotNumber < kRobots && contains(alive, block.robotNumber);
        warn(taken ? ParameterRisk::NumberTaken : ParameterRisk::NumberChanges);
    }
    if (flashChanges && block.flash() == wire::FlashContents::NoData) warn(ParameterRisk::NoBitstream);
    if (now && flashChanges && block.flash() == wire::FlashContents::FpgaBitstream)
        warn(ParameterRisk::OtherBitstream);
    return warnings;
}

}  // namespace kickstand::thunderbots
