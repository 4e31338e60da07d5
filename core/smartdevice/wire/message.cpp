#include "core/smartdevice/wire/message.h"

#include <algorithm>
#include <limits>

#include "core/smartdevice/wire/fields.h"

namespace kickstand::smartdevice::wire {
namespace {

constexpr std::size_t kHeader = 2;
constexpr std::size_t kMask = 2;

using Decoded = tl::expected<Message, MessageFault>;

void appendLe16(MessageBytes& bytes, std::uint16_t value) noexcept {
    bytes.append(static_cast<std::uint8_t>(value));
    bytes.append(static_cast<std::uint8_t>(value >> 8));
}

void appendDelay(Dialect dialect, MessageBytes& bytes, std::uint16_t delay_ms) noexcept {
    if (dialect == Dialect::Hibike) return appendLe16(bytes, delay_ms);
    constexpr std::uint16_t kLongest = std::numeric_limits<std::uint8_t>::max();
    bytes.append(static_cast<std::uint8_t>(std::min(delay_ms, kLongest)));
}

std::uint16_t readDelay(Dialect dialect, ByteView payload) noexcept {
    return dialect == Dialect::Current ? payload[kMask] : loadLe16(payload, kMask);
}

template <class T>
Decoded readValues(ByteView payload) noexcept {
    T message;
    message.parameters = loadLe16(payload, 0);
    message.values.append(payload.subspan(kMask));
    return message;
}

Decoded readResponse(Dialect dialect, ByteView payload) noexcept {
    const auto uid = readUid(dialect, payload.last(kUidSize));
    if (!uid) return tl::unexpected(MessageFault::BadPayload);
    return SubscriptionResponse{loadLe16(payload, 0), readDelay(dialect, payload), *uid};
}

Decoded readPayload(Dialect dialect, MessageId id, ByteView payload) noexcept {
    switch (id) {
        case MessageId::Ping:
            return Ping{};
        case MessageId::SubscriptionRequest:
            return SubscriptionRequest{loadLe16(payload, 0), readDelay(dialect, payload)};
        case MessageId::SubscriptionResponse:
            return readResponse(dialect, payload);
        case MessageId::DeviceRead:
            return DeviceRead{loadLe16(payload, 0)};
        case MessageId::DeviceWrite:
            return readValues<DeviceWrite>(payload);
        case MessageId::DeviceData:
            return readValues<DeviceData>(payload);
        case MessageId::DeviceDisable:
            return DeviceDisable{};
        case MessageId::HeartbeatRequest:
            return HeartbeatRequest{payload[0]};
        case MessageId::HeartbeatResponse:
            return HeartbeatResponse{payload[0]};
        case MessageId::Error:
            return ErrorMessage{payload[0]};
    }
    return tl::unexpected(MessageFault::UnknownId);
}

/// Writes the payload of each kind.
struct PayloadWriter {
    Dialect dialect;
    MessageBytes& bytes;

    void operator()(const Ping&) const noexcept {}
    void operator()(const DeviceDisable&) const noexcept {}
    void operator()(const SubscriptionRequest& message) const noexcept {
        appendLe16(bytes, message.parameters);
        appendDelay(dialect, bytes, message.delay_ms);
    }
    void operator()(const SubscriptionResponse& message) const noexcept {
        appendLe16(bytes, message.parameters);
        appendDelay(dialect, bytes, message.delay_ms);
        bytes.append(message.uid.bytes);
    }
    void operator()(const DeviceRead& message) const noexcept { appendLe16(bytes, message.parameters); }
    void operator()(const DeviceWrite& message) const noexcept { values(message.parameters, message.values); }
    void operator()(const DeviceData& message) const noexcept { values(message.parameters, message.values); }
    void operator()(const HeartbeatRequest& message) const noexcept { bytes.append(message.id); }
    void operator()(const HeartbeatResponse& message) const noexcept { bytes.append(message.id); }
    void operator()(const ErrorMessage& message) const noexcept { bytes.append(message.code); }

    void values(ParameterMask parameters, const ValueBytes& written) const noexcept {
        appendLe16(bytes, parameters);
        bytes.append(written.view().first(std::min(written.size(), mostPayload(dialect) - kMask)));
    }
};

}  // namespace

const char* name(MessageId id) noexcept {
    const MessageSpec* spec = messageSpec(id);
    return spec == nullptr ? nullptr : spec->name;
}

std::optional<MessageId> messageId(std::uint8_t byte) noexcept {
    const auto id = static_cast<MessageId>(byte);
    if (messageSpec(id) == nullptr) return std::nullopt;
    return id;
}

const char* name(ErrorCode code) noexcept {
    switch (code) {
        case ErrorCode::Delimiter:
            return "delimiter";
        case ErrorCode::Checksum:
            return "checksum";
        case ErrorCode::Generic:
            return "generic";
    }
    return nullptr;
}

const char* name(MessageFault fault) noexcept {
    switch (fault) {
        case MessageFault::TooShort:
            return "too-short";
        case MessageFault::BadLength:
            return "bad-length";
        case MessageFault::BadChecksum:
            return "bad-checksum";
        case MessageFault::UnknownId:
            return "unknown-id";
        case MessageFault::BadPayload:
            return "bad-payload";
    }
    return "";
}

MessageId idOf(const Message& message) {
    struct Ids {
        MessageId operator()(const Ping&) const noexcept { return MessageId::Ping; }
        MessageId operator()(const SubscriptionRequest&) const noexcept {
            return MessageId::SubscriptionRequest;
        }
        MessageId operator()(const SubscriptionResponse&) const noexcept {
            return MessageId::SubscriptionResponse;
        }
        MessageId operator()(const DeviceRead&) const noexcept { return MessageId::DeviceRead; }
        MessageId operator()(const DeviceWrite&) const noexcept { return MessageId::DeviceWrite; }
        MessageId operator()(const DeviceData&) const noexcept { return MessageId::DeviceData; }
        MessageId operator()(const DeviceDisable&) const noexcept { return MessageId::DeviceDisable; }
        MessageId operator()(const HeartbeatRequest&) const noexcept { return MessageId::HeartbeatRequest; }
        MessageId operator()(const HeartbeatResponse&) const noexcept { return MessageId::HeartbeatResponse; }
        MessageId operator()(const ErrorMessage&) const noexcept { return MessageId::Error; }
    };
    return std::visit(Ids{}, message);
}

std::uint8_t checksum(ByteView bytes) noexcept {
    std::uint8_t sum = 0;
    for (const std::uint8_t byte : bytes)
        sum = static_cast<std::uint8_t>(sum ^ byte);
    return sum;
}

Decoded decodeMessage(Dialect dialect, ByteView bytes) noexcept {
    if (bytes.size() < kMessageOverhead) return tl::unexpected(MessageFault::TooShort);
    const std::size_t length = bytes[1];
    if (length != bytes.size() - kMessageOverhead || length > mostPayload(dialect))
        return tl::unexpected(MessageFault::BadLength);
    if (checksum(bytes) != 0) return tl::unexpected(MessageFault::BadChecksum);
    const auto id = messageId(bytes[0]);
    if (!id) return tl::unexpected(MessageFault::UnknownId);
    const PayloadBounds bounds = payloadBounds(*messageSpec(*id), dialect);
    if (length < bounds.least || length > bounds.most) return tl::unexpected(MessageFault::BadPayload);
    return readPayload(dialect, *id, bytes.subspan(kHeader, length));
}

MessageBytes encodeMessage(Dialect dialect, const Message& message) {
    MessageBytes bytes;
    bytes.append(static_cast<std::uint8_t>(idOf(message)));
    bytes.append(0);
    std::visit(PayloadWriter{dialect, bytes}, message);
    bytes.span()[1] = static_cast<std::uint8_t>(bytes.size() - kHeader);
    bytes.append(checksum(bytes.view()));
    return bytes;
}

}  // namespace kickstand::smartdevice::wire
