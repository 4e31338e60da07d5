#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/pipes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// What the dongle and the directly cabled robot call themselves (protocol 3.1, 3.11).
inline constexpr std::uint16_t kVendorId = 0x04D8;
inline constexpr std::uint16_t kDongleProductId = 0x7839;
inline constexpr std::uint16_t kCableProductId = 0x783A;
inline constexpr std::uint16_t kDeviceRelease = 0x0100;
inline constexpr const char* kManufacturerName = "UBC Thunderbots Robocup Small Size Team";
inline constexpr const char* kProductName = "Thunderbots XBee Dongle";
inline constexpr const char* kLocalDataName = "Local Data";
inline constexpr const char* kMainTransportName = "Main Transport";
inline constexpr std::uint8_t kControlPacketBytes = 8;
inline constexpr std::uint16_t kMaxCurrent_mA = 500;
inline constexpr std::uint8_t kConfiguration = 1;
inline constexpr std::uint8_t kLocalDataInterface = 0;
inline constexpr std::uint8_t kMainTransportInterface = 1;

/// The endpoints' addresses (protocol 3.2).
enum class Endpoint : std::uint8_t {
    Status = 0x81,
    ErrorQueue = 0x82,
    Statistics = 0x83,  ///< Unused.
    DebugText = 0x84,
    StateOut = 0x05,
    StateIn = 0x85,
    MessageOut = 0x06,
    MessageIn = 0x86,
};
constexpr std::uint8_t address(Endpoint endpoint) noexcept {
    return static_cast<std::uint8_t>(endpoint);
}
/// The packet size of every endpoint but Status (kStatusBytes) and Statistics (kStatisticsBytes).
inline constexpr std::size_t kPacketBytes = 64;
inline constexpr std::size_t kStatisticsBytes = 8;

/// The vendor requests on endpoint 0, recipient device (protocol 3.3).
enum class VendorRequest : std::uint8_t {
    ReadRadioVersions = 0,  ///< IN, 4 bytes: RadioVersions.
    ReadChannels = 1,       ///< IN, 2 bytes: Channels.
    SetChannels = 2,        ///< OUT, wValue = encodeChannelsValue(); stalls once the radios are enabled.
    EnableRadios = 3,       ///< OUT.
    ResendStatus = 4,       ///< OUT.
};
/// bmRequestType of those requests.
inline constexpr std::uint8_t kVendorIn = 0xC0;
inline constexpr std::uint8_t kVendorOut = 0x40;

/// The dongle's two radio channels, 0x0B-0x1A each (protocol 3.3).
struct Channels {
    std::uint8_t channel0 = 0x0E;
    std::uint8_t channel1 = 0x0F;
    friend constexpr bool operator==(const Channels&, const Channels&) = default;
};
inline constexpr std::size_t kChannelsBytes = 2;
/// wValue of SetChannels. Errors: OutOfRange naming the channel. Any thread.
WireResult<std::uint16_t> encodeChannelsValue(const Channels& channels) noexcept;
/// The same, read by the dongle. Errors: BadValue naming the channel. Any thread.
WireResult<Channels> decodeChannelsValue(std::uint16_t value) noexcept;
/// The data of ReadChannels. Errors: OutOfRange; TooShort, TooLong, BadValue. Any thread.
WireResult<std::array<std::uint8_t, kChannelsBytes>> encodeChannels(const Channels& channels) noexcept;
WireResult<Channels> decodeChannels(ByteView data) noexcept;

/// The firmware versions of the dongle's two radios (protocol 3.3).
struct RadioVersions {
    std::uint16_t radio0 = 0;
    std::uint16_t radio1 = 0;
    friend constexpr bool operator==(const RadioVersions&, const RadioVersions&) = default;
};
inline constexpr std::size_t kRadioVersionsBytes = 4;
std::array<std::uint8_t, kRadioVersionsBytes> encodeRadioVersions(const RadioVersions& versions) noexcept;
/// Errors: TooShort, TooLong. Any thread.
WireResult<RadioVersions> decodeRadioVersions(ByteView data) noexcept;

/// The emergency stop switch (protocol 3.8).
enum class EStop : std::uint8_t { Uninitialized = 0, Disconnected = 1, Stop = 2, Run = 3 };
/// The dongle's radios (protocol 3.8).
enum class RadioState : std::uint8_t {
    PreInit = 0,
    InitRadio0 = 1,
    InitRadio1 = 2,
    Running = 3,
    Radio0Failed = 4,
    Radio1Failed = 5,
};

/// What the dongle sends on its status endpoint when it changes (protocol 3.8).
struct DongleStatus {
    EStop eStop = EStop::Uninitialized;
    RadioState radios = RadioState::PreInit;
    std::uint16_t aliveRobots = 0;  ///< Bit n: robot n is alive.

    constexpr bool alive(std::uint8_t robot) const noexcept {
        return robot < kRobotCount && (aliveRobots >> robot & 1) != 0;
    }
    friend constexpr bool operator==(const DongleStatus&, const DongleStatus&) = default;
};
inline constexpr std::size_t kStatusBytes = 4;

/// "uninitialized", "disconnected", "stop", "run"; "pre-init", "init-radio-0", …: stable names. Any thread.
const char* name(EStop state) noexcept;
const char* name(RadioState state) noexcept;

std::array<std::uint8_t, kStatusBytes> encodeStatus(const DongleStatus& status) noexcept;
/// Errors: TooShort, TooLong; BadValue naming estop or radios. Any thread.
WireResult<DongleStatus> decodeStatus(ByteView packet) noexcept;

}  // namespace kickstand::thunderbots::wire
