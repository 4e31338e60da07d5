#pragma once

#include <cstdint>
#include <functional>

#include "core/base/bytes.h"
#include "core/framing/cobs.h"
#include "core/framing/inline_bytes.h"
#include "core/smartdevice/wire/message.h"

namespace kickstand::smartdevice::wire {

/// The COBS bytes of the longest message.
inline constexpr std::size_t kMostCobs = cobsMost(kMostMessage);
/// With Hibike's zero and length, or the zero at the end.
using FrameBytes = InlineBytes<kMostCobs + 2>;

/// A message as it stands on the line (protocol 1). Allocates nothing. Any thread.
FrameBytes encodeFrame(Dialect dialect, const Message& message) noexcept;

/// What a decoder has seen.
struct DecoderCounts {
    std::uint64_t messages = 0;
    std::uint64_t damaged = 0;    ///< Frames that are no COBS, or cut short, or too long.
    std::uint64_t checksums = 0;  ///< Frames whose checksum is wrong.
    std::uint64_t malformed = 0;  ///< Frames that are no message for another reason.
    std::uint64_t dropped = 0;    ///< Bytes of all those, and between frames.

    /// Frames that came and were no message.
    std::uint64_t faults() const noexcept { return damaged + checksums + malformed; }
    friend bool operator==(const DecoderCounts&, const DecoderCounts&) = default;
};

/// Finds the messages in what comes over a line, in whatever pieces. After any damage it is back in step with
/// the next zero. Allocates nothing. One thread at a time.
class Decoder {
  public:
    using Sink = std::function<void(const Message&)>;

    explicit Decoder(Dialect dialect) noexcept : dialect_(dialect) {}

    Dialect dialect() const noexcept { return dialect_; }
    /// Takes what came, and calls `sink` for each message that is complete. The sink may destroy what it
    /// likes but this.
    void feed(ByteView bytes, const Sink& sink);
    /// Forgets what is half there: the line begins anew. The counts stay.
    void reset() noexcept;
    const DecoderCounts& counts() const noexcept { return counts_; }

  private:
    void feedCurrent(std::uint8_t byte, const Sink& sink);
    void feedHibike(std::uint8_t byte, const Sink& sink);
    void finish(const Sink& sink);
    void damage();

    const Dialect dialect_;
    InlineBytes<kMostCobs> frame_;
    std::size_t awaited_ = 0;  ///< Hibike: how long the frame will be.
    bool begun_ = false;       ///< Hibike: its zero has come.
    bool overlong_ = false;    ///< Current: more came than a frame can have.
    DecoderCounts counts_;
};

}  // namespace kickstand::smartdevice::wire
