#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/bytes.h"

namespace kickstand::smartdevice::wire {

/// How a board frames and lays out its messages (protocol 1.1). A board speaks one dialect for life.
enum class Dialect : std::uint8_t {
    Current,  ///< Frames end in a zero.
    Hibike,   ///< Frames begin with a zero and their length: boards flashed 2016-2020.
};
/// "current", "hibike". Any thread.
const char* name(Dialect dialect) noexcept;

inline constexpr std::size_t kUidSize = 11;

/// What a board is known by, in both dialects eleven bytes (protocol 2.2).
struct Uid {
    Dialect dialect = Dialect::Current;
    std::array<std::uint8_t, kUidSize> bytes{};

    /// The kind of board: 8 bits, 16 in Hibike.
    std::uint16_t device() const noexcept;
    /// 0 is the season of spring 2016.
    std::uint8_t year() const noexcept;

    friend auto operator<=>(const Uid&, const Uid&) = default;
};

/// Reads one; nothing unless there are eleven bytes. Any thread.
std::optional<Uid> readUid(Dialect dialect, ByteView bytes) noexcept;
/// "0c-05-010203040506070809"; in Hibike "000c-05-0102030405060708". Any thread.
std::string toText(const Uid& uid);
/// Reads such a text, also in capital letters. Any thread.
std::optional<Uid> uidFromText(std::string_view text);

}  // namespace kickstand::smartdevice::wire
