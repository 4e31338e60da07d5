#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include <tl/expected.hpp>

#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
#include "core/smartdevice/wire/uid.h"

namespace kickstand::smartdevice::wire {

/// The kinds of message (protocol 3).
enum class MessageId : std::uint8_t {
    Ping = 0x10,
    SubscriptionRequest = 0x11,
    SubscriptionResponse = 0x12,
    DeviceRead = 0x13,
    DeviceWrite = 0x14,
    DeviceData = 0x15,
    DeviceDisable = 0x16,
    HeartbeatRequest = 0x17,
    HeartbeatResponse = 0x18,
    Error = 0xFF,
};
/// "ping", "subscription-request", …; null for a number that is none. Any thread.
const char* name(MessageId id) noexcept;
/// Whether a byte is one of them. Any thread.
std::optional<MessageId> messageId(std::uint8_t byte) noexcept;

/// What an Error message says (protocol 3.9).
enum class ErrorCode : std::uint8_t { Delimiter = 0xFD, Checksum = 0xFE, Generic = 0xFF };
/// "delimiter", "checksum", "generic"; null for another number. Any thread.
const char* name(ErrorCode code) noexcept;

inline constexpr int kMostParameters = 16;
/// Bytes of a payload: the length field's highest in the current dialect; what one frame can count in Hibike.
inline constexpr std::size_t kMostPayload = 255;
inline constexpr std::size_t kMostHibikePayload = 250;
constexpr std::size_t mostPayload(Dialect dialect) noexcept {
    return dialect == Dialect::Current ? kMostPayload : kMostHibikePayload;
}
/// Before the payload, ID and length; behind it, the checksum.
inline constexpr std::size_t kMessageOverhead = 3;
inline constexpr std::size_t kMostMessage = kMostPayload + kMessageOverhead;
using MessageBytes = InlineBytes<kMostMessage>;
/// The values of a Write or Data message.
using ValueBytes = InlineBytes<kMostPayload - 2>;

/// Bit n stands for parameter n.
using ParameterMask = std::uint16_t;

struct Ping {
    friend bool operator==(const Ping&, const Ping&) = default;
};
struct SubscriptionRequest {
    ParameterMask parameters = 0;
    std::uint16_t delay_ms = 0;  ///< 0 ends the subscription. Up to 255 in the current dialect.
    friend bool operator==(const SubscriptionRequest&, const SubscriptionRequest&) = default;
};
struct SubscriptionResponse {
    ParameterMask parameters = 0;  ///< What the device will send.
    std::uint16_t delay_ms = 0;
    Uid uid;
    friend bool operator==(const SubscriptionResponse&, const SubscriptionResponse&) = default;
};
struct DeviceRead {
    ParameterMask parameters = 0;
    friend bool operator==(const DeviceRead&, const DeviceRead&) = default;
};
struct DeviceWrite {
    ParameterMask parameters = 0;
    ValueBytes values;  ///< Of the set bits, ascending.
    friend bool operator==(const DeviceWrite&, const DeviceWrite&) = default;
};
struct DeviceData {
    ParameterMask parameters = 0;
    ValueBytes values;
    friend bool operator==(const DeviceData&, const DeviceData&) = default;
};
struct DeviceDisable {
    friend bool operator==(const DeviceDisable&, const DeviceDisable&) = default;
};
struct HeartbeatRequest {
    std::uint8_t id = 0;
    friend bool operator==(const HeartbeatRequest&, const HeartbeatRequest&) = default;
};
struct HeartbeatResponse {
    std::uint8_t id = 0;
    friend bool operator==(const HeartbeatResponse&, const HeartbeatResponse&) = default;
};
struct ErrorMessage {
    std::uint8_t code = 0;  ///< An ErrorCode, or what no document names.
    friend bool operator==(const ErrorMessage&, const ErrorMessage&) = default;
};

/// Any of them.
using Message = std::variant<Ping, SubscriptionRequest, SubscriptionResponse, DeviceRead, DeviceWrite,
                             DeviceData, DeviceDisable, HeartbeatRequest, HeartbeatResponse, ErrorMessage>;

/// The kind of a message. Any thread.
MessageId idOf(const Message& message);

/// What is wrong with bytes that should be a message.
enum class MessageFault : std::uint8_t {
    TooShort,   ///< Less than ID, length and checksum.
    BadLength,  ///< The length field contradicts the bytes there are.
    BadChecksum,
    UnknownId,
    BadPayload,  ///< Not as long as this message's payload is.
};
/// "too-short", … Any thread.
const char* name(MessageFault fault) noexcept;

/// XOR of all the bytes (protocol 2.1). Any thread.
std::uint8_t checksum(ByteView bytes) noexcept;

/// Reads a message, checksum included. Allocates nothing. Any thread.
tl::expected<Message, MessageFault> decodeMessage(Dialect dialect, ByteView bytes) noexcept;

/// Writes a message, checksum included; values that do not fit a payload of the dialect are cut, delays that
/// do not fit its field become the longest. Allocates nothing. Any thread.
MessageBytes encodeMessage(Dialect dialect, const Message& message);

}  // namespace kickstand::smartdevice::wire
