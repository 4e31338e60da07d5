#include "core/smartdevice/wire/fields.h"

#include <algorithm>

namespace kickstand::smartdevice::wire {
namespace {

constexpr FieldSpec kParameters{"parameters",    FieldKind::Mask, {2, 2}, "", "bit n stands for parameter n",
                                {0xFFFF, 0xFFFF}};
constexpr FieldSpec kDelay{
    "delay_ms",    FieldKind::Number, {1, 2}, "ms", "time from one update to the next; 0 for none",
    {0xFF, 0xFFFF}};
constexpr FieldSpec kUid{"uid", FieldKind::Uid, {kUidSize, kUidSize}, "", "kind of board, year, random part"};
constexpr FieldSpec kValues{
    "values", FieldKind::Values, {0, 0}, "", "the values of the set bits, ascending, little-endian"};
constexpr FieldSpec kBeat{"heartbeat", FieldKind::Number, {1, 1}, "", "tells outstanding requests apart",
                          {0xFF, 0xFF}};
constexpr FieldSpec kCode{"code", FieldKind::Code, {1, 1}, "", "what went wrong on the device", {0xFF, 0xFF}};

constexpr std::array kSubscribe{kParameters, kDelay};
constexpr std::array kSubscribed{kParameters, kDelay, kUid};
constexpr std::array kRead{kParameters};
constexpr std::array kWithValues{kParameters, kValues};
constexpr std::array kHeartbeat{kBeat};
constexpr std::array kError{kCode};

constexpr std::array kMessages{
    MessageSpec{MessageId::Ping, "ping", Direction::ToDevice, "3.1", "asks who is there", {}},
    MessageSpec{MessageId::SubscriptionRequest, "subscription-request", Direction::ToDevice, "3.2",
                "asks for updates", kSubscribe},
    MessageSpec{MessageId::SubscriptionResponse, "subscription-response", Direction::ToHost, "3.3",
                "says who is there and what it will send", kSubscribed},
    MessageSpec{MessageId::DeviceRead, "device-read", Direction::ToDevice, "3.4", "asks for values once",
                kRead},
    MessageSpec{MessageId::DeviceWrite, "device-write", Direction::ToDevice, "3.5", "sets values",
                kWithValues},
    MessageSpec{MessageId::DeviceData, "device-data", Direction::ToHost, "3.6", "tells values", kWithValues},
    MessageSpec{
        MessageId::DeviceDisable, "device-disable", Direction::ToDevice, "3.7", "stops everything", {}},
    MessageSpec{MessageId::HeartbeatRequest, "heartbeat-request", Direction::Both, "3.8",
                "asks for a sign of life", kHeartbeat},
    MessageSpec{MessageId::HeartbeatResponse, "heartbeat-response", Direction::Both, "3.8",
                "gives a sign of life", kHeartbeat},
    MessageSpec{MessageId::Error, "error", Direction::ToHost, "3.9", "tells what went wrong", kError}};

}  // namespace

std::span<const MessageSpec> messages() noexcept {
    return kMessages;
}

const MessageSpec* messageSpec(MessageId id) noexcept {
    const auto* const found = std::ranges::find(kMessages, id, &MessageSpec::id);
    return found == kMessages.end() ? nullptr : found;
}

PayloadBounds payloadBounds(const MessageSpec& message, Dialect dialect) noexcept {
    PayloadBounds bounds;
    bool open = false;
    for (const FieldSpec& field : message.fields) {
        bounds.least += field.bytes.at(static_cast<std::size_t>(dialect));
        open = open || field.kind == FieldKind::Values;
    }
    bounds.most = open ? mostPayload(dialect) : bounds.least;
    return bounds;
}

}  // namespace kickstand::smartdevice::wire
