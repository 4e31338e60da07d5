#include "core/coach/radio_settings.h"

#include <algorithm>

namespace kickstand::coach {
namespace {

constexpr std::uint8_t kLowestChannel = 0x0B;
constexpr std::uint8_t kHighestChannel = 0x1A;
constexpr Baud kFastest = 250000;

Result<void> outOfRange(const char* subject, std::int64_t lowest, std::int64_t highest, std::int64_t got) {
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = subject;
    error.lowest = lowest;
    error.highest = highest;
    error.got = got;
    return fail(std::move(error));
}

}  // namespace

Result<void> checkSettings(const RadioSettings& settings) {
    if (settings.channel < kLowestChannel || settings.channel > kHighestChannel)
        return outOfRange("channel", kLowestChannel, kHighestChannel, settings.channel);
    if (settings.baud < kModuleBauds.front() || settings.baud > kFastest)
        return outOfRange("baud", kModuleBauds.front(), kFastest, settings.baud);
    const auto printable = [](char c) { return c >= 0x20 && c < 0x7F && c != ','; };
    const std::string& name = settings.name;
    const bool fits = name.size() <= kMaxNodeName && !name.starts_with(' ');
    if (!fits || !std::all_of(name.begin(), name.end(), printable))
        return fail(Errc::BadArgument, "name", name);
    return {};
}

RadioSettings presetFor(wire::Role role, wire::Team team, const RadioSettings& present) {
    RadioSettings preset = present;
    preset.address = wire::addressOf(role, team);
    preset.mode = ModuleMode::Api;
    preset.baud = 9600;
    preset.name = (role == wire::Role::Coach ? "COACH " : "TOWRP ") + std::to_string(int{team});
    return preset;
}

RadioSettings thunderbotsPreset(std::optional<int> robot, int radio, const RadioSettings& present) {
    RadioSettings preset = present;
    const int base = robot ? (radio == 0 ? 0x7B20 : 0x7B30) + *robot : 0x7B40 + radio;
    preset.address = static_cast<std::uint16_t>(base);
    preset.pan = static_cast<std::uint16_t>(0x496C + radio);
    preset.mode = ModuleMode::Api;
    preset.baud = kThunderbotsBaud;
    preset.name = (robot ? "robot " + std::to_string(*robot) : std::string("dongle")) + " radio " +
                  std::to_string(radio);
    return preset;
}

std::uint32_t baudCode(Baud baud) {
    const auto at = std::find(kModuleBauds.begin(), kModuleBauds.end(), baud);
    return at == kModuleBauds.end() ? baud : static_cast<std::uint32_t>(at - kModuleBauds.begin());
}

Baud baudOf(std::uint32_t code) {
    return code < kModuleBauds.size() ? kModuleBauds[code] : code;
}

}  // namespace kickstand::coach
