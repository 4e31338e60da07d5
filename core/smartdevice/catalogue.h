#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/smartdevice/wire/message.h"
#include "core/smartdevice/wire/value.h"

namespace kickstand::smartdevice {

/// What may be done with a parameter (protocol 2.4).
enum class Access : std::uint8_t { Read, Write, ReadWrite };

/// One parameter of a kind of board.
struct ParameterSpec {
    std::string name;
    wire::ValueType type = wire::ValueType::Raw;
    Access access = Access::ReadWrite;
    std::string unit{};
    std::optional<double> lowest{};
    std::optional<double> highest{};
    std::uint8_t rawWidth = 0;  ///< Bytes of a Raw one, as the device sent them.
    bool zeroOnStop = false;    ///< STOP writes zero to it: what drives a motor, never a position.
    bool moves = false;         ///< What it does goes on: a motor, a servo.
    std::string note{};

    /// Bytes on the wire.
    std::size_t width() const { return type == wire::ValueType::Raw ? rawWidth : wire::widthOf(type); }
    bool readable() const { return access != Access::Write; }
    bool writable() const { return access != Access::Read; }
    friend bool operator==(const ParameterSpec&, const ParameterSpec&) = default;
};

/// A kind of board. Parameter n stands at place n.
struct DeviceSpec {
    std::uint16_t id = 0;
    std::string name;
    std::string note{};
    bool reserved = false;  ///< The number is taken, but there is no such board.
    bool known = true;      ///< False for a number that no catalogue has: its parameters were found out.
    std::vector<ParameterSpec> parameters{};

    /// -1 where there is none of that name.
    int find(std::string_view parameter) const;
    wire::ParameterMask readable() const;
    wire::ParameterMask writable() const;
    friend bool operator==(const DeviceSpec&, const DeviceSpec&) = default;
};
using SharedDeviceSpec = std::shared_ptr<const DeviceSpec>;

/// All kinds of board that are known. Immutable once made; any thread.
class Catalogue {
  public:
    /// Null where it is unknown.
    SharedDeviceSpec find(std::uint16_t id) const;
    SharedDeviceSpec find(std::string_view name) const;
    const std::vector<SharedDeviceSpec>& devices() const { return devices_; }

    /// Adds it, or puts it in the place of the one with its number.
    void put(DeviceSpec device);

  private:
    std::vector<SharedDeviceSpec> devices_;  ///< By number.
};

/// The catalogue file that the program was built with.
std::string_view builtInCatalogueText();

/// Reads a catalogue file over `base`: its boards replace those of their number (help: the catalogue file).
/// Errors: Malformed with `source` and what is wrong where. Any thread.
Result<Catalogue> readCatalogue(std::string_view text, const std::string& source, Catalogue base = {});

/// The built-in catalogue, with the user's file over it where there is one. Errors as readCatalogue(), of the
/// user's file. Any thread.
Result<Catalogue> makeCatalogue(std::string_view userText = {}, const std::string& source = {});

}  // namespace kickstand::smartdevice
