#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <variant>

#include "core/base/bytes.h"
#include "core/framing/byte_places.h"
#include "core/framing/inline_bytes.h"

/// API frames of XBee 802.15.4 modules: what stands between a program and its radio module on the serial
/// line (coach protocol 2).
namespace kickstand::xbee {

/// What every frame begins with.
inline constexpr std::uint8_t kDelimiter = 0x7E;
/// In API mode 2, what stands before an escaped byte, which follows XORed with kEscapeMask.
inline constexpr std::uint8_t kEscape = 0x7D;
inline constexpr std::uint8_t kEscapeMask = 0x20;
/// The longest frame data taken or sent, in bytes; a greater length is damage.
inline constexpr std::size_t kMaxFrameData = 110;
/// The longest payload of one packet, in bytes.
inline constexpr std::size_t kMaxPayload = 100;
/// The address that every module takes.
inline constexpr std::uint16_t kBroadcast = 0xFFFF;

/// How frames stand on the line.
enum class ApiMode : std::uint8_t {
    Plain = 1,    ///< As they are.
    Escaped = 2,  ///< 0x7E, 0x7D, 0x11 and 0x13 escaped: an unescaped 0x7E is always a beginning.
};

/// The first byte of the frame data: what kind of frame it is.
enum class FrameType : std::uint8_t {
    Tx16 = 0x01,
    AtCommand = 0x08,
    Rx16 = 0x81,
    AtResponse = 0x88,
    TxStatus = 0x89,
    ModemStatus = 0x8A,
};

// The frames. Views point into the bytes that were decoded and live as long as they.

/// Sends a packet. `frameId` 0 asks for no TX status.
struct Tx16 {
    std::uint8_t frameId = 0;
    std::uint16_t destination = kBroadcast;
    std::uint8_t options = 0;  ///< Bit 0: no acknowledgement is wanted.
    ByteView payload{};        ///< At most kMaxPayload bytes.
};
/// A packet that came.
struct Rx16 {
    std::uint16_t source = 0;
    int rssi_dBm = 0;  ///< -255 to 0; on the line without its sign.
    std::uint8_t options = 0;
    ByteView payload{};
};
/// What became of a packet.
struct TxStatus {
    std::uint8_t frameId = 0;
    std::uint8_t status = 0;  ///< TxOutcome, where it is one.
};
/// Asks or sets a parameter of the module: asks when `value` is empty.
struct AtCommand {
    std::uint8_t frameId = 0;
    std::array<char, 2> name{};
    ByteView value{};
};
/// The answer to an AtCommand.
struct AtResponse {
    std::uint8_t frameId = 0;
    std::array<char, 2> name{};
    std::uint8_t status = 0;  ///< AtOutcome, where it is one.
    ByteView value{};
};
/// The module says something of itself.
struct ModemStatus {
    std::uint8_t status = 0;  ///< 0 reset, 1 reset by its watchdog, 2 joined, 3 left.
};
/// A frame of a kind that this program does not use.
struct OtherFrame {
    std::uint8_t type = 0;
    ByteView rest{};
};

/// What became of a packet (TxStatus::status).
enum class TxOutcome : std::uint8_t { Success, NoAcknowledgement, ChannelBusy, Purged };
/// What became of an AT command (AtResponse::status).
enum class AtOutcome : std::uint8_t { Ok, Error, InvalidCommand, InvalidParameter };

/// Any frame, taken apart.
using Frame = std::variant<OtherFrame, Tx16, Rx16, TxStatus, AtCommand, AtResponse, ModemStatus>;

/// The data of a frame: what stands between its length and its checksum.
using FrameData = InlineBytes<kMaxFrameData>;
/// A whole frame as it goes over the line, with room for every byte escaped, and for a stripe that is copied
/// without counting.
using LineFrame = InlineBytes<1 + 2 * (2 + kMaxFrameData + 1) + kStripe>;

/// Takes the data of a frame apart; nothing where it is too short for its kind, or empty. Never allocates.
/// Any thread.
std::optional<Frame> decodeFrame(ByteView data) noexcept;

/// The data of a frame; empty where its payload or value does not fit. Never allocates. Any thread.
FrameData encodeFrame(const Frame& frame);

/// Puts delimiter, length and checksum around the data of a frame. Empty data, or more than kMaxFrameData,
/// gives nothing. Any thread.
LineFrame wrapFrame(ByteView data, ApiMode mode) noexcept;

/// What makes the sum of `data` and it 0xFF. Any thread.
std::uint8_t checksum(ByteView data) noexcept;

}  // namespace kickstand::xbee
