#include "core/thunderbots/wire/dongle.h"

#include "core/thunderbots/wire/layout_dongle.h"

namespace kickstand::thunderbots::wire {
namespace {

template <std::size_t count>
const char* nameIn(const std::array<const char*, count>& names, std::size_t number) noexcept {
    return number < count ? names[number] : "undefined";
}

}  // namespace

const char* name(EStop state) noexcept {
    return nameIn(layout::status::kEStopNames, static_cast<std::size_t>(state));
}
const char* name(RadioState state) noexcept {
    return nameIn(layout::status::kRadioNames, static_cast<std::size_t>(state));
}

WireResult<std::array<std::uint8_t, kChannelsBytes>> encodeChannels(const Channels& channels) noexcept {
    std::array<std::uint8_t, kChannelsBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.number(layout::channels::kChannel0, channels.channel0);
    out.number(layout::channels::kChannel1, channels.channel1);
    return out.result(bytes);
}

WireResult<Channels> decodeChannels(ByteView data) noexcept {
    if (const auto error = lengthFault(data.size(), kChannelsBytes, kChannelsBytes))
        return tl::unexpected(*error);
    FieldReader<BitOrder::LsbFirst> in(data);
    Channels channels;
    channels.channel0 = in.byte(layout::channels::kChannel0);
    channels.channel1 = in.byte(layout::channels::kChannel1);
    return in.result(channels);
}

WireResult<std::uint16_t> encodeChannelsValue(const Channels& channels) noexcept {
    const auto bytes = encodeChannels(channels);
    if (!bytes) return tl::unexpected(bytes.error());
    return loadLe16(*bytes, 0);
}

WireResult<Channels> decodeChannelsValue(std::uint16_t value) noexcept {
    std::array<std::uint8_t, kChannelsBytes> bytes{};
    storeLe16(bytes, 0, value);
    return decodeChannels(bytes);
}

std::array<std::uint8_t, kRadioVersionsBytes> encodeRadioVersions(const RadioVersions& versions) noexcept {
    std::array<std::uint8_t, kRadioVersionsBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.number(layout::radio_versions::kRadio0, versions.radio0);
    out.number(layout::radio_versions::kRadio1, versions.radio1);
    return bytes;
}

WireResult<RadioVersions> decodeRadioVersions(ByteView data) noexcept {
    if (const auto error = lengthFault(data.size(), kRadioVersionsBytes, kRadioVersionsBytes)) {
        return tl::unexpected(*error);
    }
    FieldReader<BitOrder::LsbFirst> in(data);
    RadioVersions versions;
    versions.radio0 = in.word(layout::radio_versions::kRadio0);
    versions.radio1 = in.word(layout::radio_versions::kRadio1);
    return in.result(versions);
}

std::array<std::uint8_t, kStatusBytes> encodeStatus(const DongleStatus& status) noexcept {
    std::array<std::uint8_t, kStatusBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.put(layout::status::kEStop, static_cast<std::int32_t>(status.eStop));
    out.put(layout::status::kRadios, static_cast<std::int32_t>(status.radios));
    out.put(layout::status::kAlive, status.aliveRobots);
    return bytes;
}

WireResult<DongleStatus> decodeStatus(ByteView packet) noexcept {
    if (const auto error = lengthFault(packet.size(), kStatusBytes, kStatusBytes))
        return tl::unexpected(*error);
    FieldReader<BitOrder::LsbFirst> in(packet);
    DongleStatus status;
    status.eStop = static_cast<EStop>(in.byte(layout::status::kEStop));
    status.radios = static_cast<RadioState>(in.byte(layout::status::kRadios));
    status.aliveRobots = in.word(layout::status::kAlive);
    return in.result(status);
}

}  // namespace kickstand::thunderbots::wire
