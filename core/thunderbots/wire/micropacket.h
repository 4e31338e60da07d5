#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/pipes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// A state transport packet is a list of micropackets: length (itself and the header included), header,
/// payload (protocol 3.6).
inline constexpr std::size_t kMaxStatePacket = 64;
inline constexpr std::size_t kMicropacketHeaderBytes = 2;
inline constexpr std::size_t kDriveMicropacketBytes = kMicropacketHeaderBytes + kDriveBytes;
inline constexpr std::size_t kFeedbackMicropacketBytes = kMicropacketHeaderBytes + kFeedbackBytes;
/// Micropackets in one packet, at most.
inline constexpr std::size_t kMaxMicropackets = 5;

/// One micropacket that was read. `payload` points into the packet and has the length its pipe has.
struct Micropacket {
    std::uint8_t robot = 0;
    ByteView payload;
};

/// Takes a state transport packet apart (protocol 3.6). What follows a damaged micropacket cannot be trusted:
/// the first error ends the packet, and droppedBytes() tells how much of it was given up. The packet must
/// outlive the reader. Not thread-safe.
class MicropacketReader {
  public:
    /// A packet that went out carries drive blocks, one that came in feedback.
    MicropacketReader(ByteView packet, Direction direction) noexcept : rest_(packet), direction_(direction) {}

    /// The next micropacket or the error that ends the packet; none at its end. An empty packet has none: it
    /// is a keep-alive. Errors: TooLong for a packet past 64 bytes; TooShort for a last byte alone; BadLength
    /// where the length points outside the packet or is not that of the pipe; UnknownKind for another pipe.
    std::optional<WireResult<Micropacket>> next() noexcept;

    /// Bytes given up after an error, the damaged micropacket's own included. Known once next() gave the
    /// error.
    std::size_t droppedBytes() const noexcept { return droppedBytes_; }

  private:
    WireResult<Micropacket> giveUp(WireError error) noexcept;

    ByteView rest_;
    std::size_t droppedBytes_ = 0;
    Direction direction_;
    bool first_ = true;
};

/// Puts a state transport packet together. Not thread-safe.
class StatePacketBuilder {
  public:
    /// Adds a drive block (a packet that goes out) or a feedback block (one that comes in). Errors: TooLong
    /// where five are in already or the bytes do not fit; OutOfRange naming robot, or what the block's
    /// encoder refuses.
    WireResult<void> add(std::uint8_t robot, const DriveBlock& block) noexcept;
    WireResult<void> add(std::uint8_t robot, const FeedbackBlock& block) noexcept;
    /// The same for bytes that are encoded already.
    WireResult<void> addDrive(std::uint8_t robot,
                              const std::array<std::uint8_t, kDriveBytes>& block) noexcept;
    WireResult<void> addFeedback(std::uint8_t robot,
                                 const std::array<std::uint8_t, kFeedbackBytes>& block) noexcept;

    bool full() const noexcept { return count_ == kMaxMicropackets; }
    std::size_t count() const noexcept { return count_; }
    /// The packet so far; valid until the next change.
    ByteView packet() const noexcept { return packet_.view(); }
    void clear() noexcept;

  private:
    WireResult<void> append(std::uint8_t robot, Pipe pipe, ByteView payload) noexcept;

    InlineBytes<kMaxStatePacket> packet_;
    std::size_t count_ = 0;
};

}  // namespace kickstand::thunderbots::wire
