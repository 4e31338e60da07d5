#pragma once

#include <array>
#include <cstdint>

#include "core/framing/byte_places.h"
#include "core/framing/xbee.h"

namespace kickstand::xbee {

/// What a parser has seen.
struct ParserCounters {
    std::uint64_t frames = 0;       ///< Whole ones with the right checksum.
    std::uint64_t badChecksum = 0;  ///< Dropped.
    std::uint64_t badLength = 0;    ///< Dropped: of length zero, or over kMaxFrameData.
    std::uint64_t brokenOff = 0;    ///< In API mode 2: another frame began before the end.
    std::uint64_t skipped = 0;      ///< Bytes that belong to no frame.

    std::uint64_t damaged() const { return badChecksum + badLength + brokenOff; }
    friend bool operator==(const ParserCounters&, const ParserCounters&) = default;
};

/// Finds the frames in a stream of bytes that comes in any pieces. What is damaged is dropped and counted,
/// and the next frame is looked for from the byte behind the delimiter on, so that a frame inside damaged
/// data is found too. Holds at most one frame; never allocates. One thread.
class Parser {
  public:
    explicit Parser(ApiMode mode = ApiMode::Plain) noexcept : mode_(mode) {}

    /// The data of the next whole frame, taken off the front of `input`; empty when no frame ends in it, and
    /// then all of `input` is taken. What it gives is valid until the next call and as long as the input is.
    ByteView next(ByteView& input) noexcept;

    /// Forgets a frame that has begun: the line was silent, or speaks another mode from now on.
    void reset(ApiMode mode) noexcept;

    ApiMode mode() const noexcept { return mode_; }
    const ParserCounters& counters() const noexcept { return counters_; }

  private:
    static constexpr std::size_t kHeader = 3;
    static constexpr std::size_t kMaxFrame = kHeader + kMaxFrameData + 1;

    ByteView nextPlain(ByteView& input) noexcept;
    ByteView nextEscaped(ByteView& input) noexcept;
    ByteView nextWholeEscaped(ByteView& input) noexcept;
    void beginHeld() noexcept;
    ByteView scan(ByteView input, std::size_t& used) noexcept;
    ByteView takeHeld(std::size_t size) noexcept;
    void dropHeld(std::size_t count) noexcept;
    std::size_t missing() const noexcept;

    ApiMode mode_;
    InlineBytes<kMaxFrame> held_;  ///< The beginning of a frame, delimiter first; in mode 2 unescaped.
    /// A frame that came in one piece, unescaped, and what was copied with it.
    std::array<std::uint8_t, kMaxFrameData + 1 + kStripe> whole_;
    std::size_t released_ = 0;  ///< So much of it was given out by the last call.
    bool escaping_ = false;
    ParserCounters counters_;
};

}  // namespace kickstand::xbee
