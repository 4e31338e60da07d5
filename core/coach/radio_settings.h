#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/coach/wire/address.h"
#include "core/link/byte_link.h"

namespace kickstand::coach {

/// How a radio module talks to its program (coach protocol 2.2).
enum class ModuleMode : std::uint8_t {
    Transparent = 0,  ///< No frames: bytes go out as they come. How a fresh module is.
    Api = 1,
    ApiEscaped = 2,
};

/// What can be set in a radio module (coach protocol 2.3).
struct RadioSettings {
    std::uint16_t address = 0;                  ///< MY. 0xFFFF and 0xFFFE switch 16-bit addresses off.
    std::uint8_t channel = 0x0C;                ///< CH, 0x0B-0x1A.
    std::uint16_t pan = 0x3332;                 ///< ID.
    ModuleMode mode = ModuleMode::Transparent;  ///< AP.
    Baud baud = 9600;                           ///< BD.
    std::string name;                           ///< NI, at most 20 printable characters.

    friend bool operator==(const RadioSettings&, const RadioSettings&) = default;
};

/// What a module is, besides.
struct RadioIdentity {
    std::uint64_t serial = 0;    ///< SH and SL.
    std::uint16_t firmware = 0;  ///< VR.
    std::uint16_t hardware = 0;  ///< HV.

    friend bool operator==(const RadioIdentity&, const RadioIdentity&) = default;
};

/// What a radio module said of itself.
struct FoundRadio {
    RadioSettings settings;
    RadioIdentity identity;

    friend bool operator==(const FoundRadio&, const FoundRadio&) = default;
};

/// The longest node name, in characters.
inline constexpr std::size_t kMaxNodeName = 20;
/// The speeds that a module can be at, as BD numbers them from 0 on, and the one of the Thunderbots' radios.
inline constexpr std::array<Baud, 8> kModuleBauds{1200, 2400, 4800, 9600, 19200, 38400, 57600, 115200};
inline constexpr Baud kThunderbotsBaud = 250000;

/// Whether a module can be set so. Errors: OutOfRange with the field and its range; BadArgument for a name.
/// Any thread.
Result<void> checkSettings(const RadioSettings& settings);

/// `draft` as the radio of that team's side needs it; channel, network and speed of `present` stay, as the
/// protocol leaves them open, but for the speed, which is 9600. Any thread.
RadioSettings presetFor(wire::Role role, wire::Team team, const RadioSettings& present);
/// Robot 0-15's radio of the Thunderbots, `radio` 0 or 1; the dongle's with no robot. The channel of
/// `present` stays. Any thread.
RadioSettings thunderbotsPreset(std::optional<int> robot, int radio, const RadioSettings& present);

/// BD's number for a speed. Any thread.
std::uint32_t baudCode(Baud baud);
/// The speed for BD's number. Any thread.
Baud baudOf(std::uint32_t code);

}  // namespace kickstand::coach
