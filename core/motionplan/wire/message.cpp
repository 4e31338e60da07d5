#include "core/motionplan/wire/message.h"

namespace kickstand::motionplan::wire {
namespace {

tl::unexpected<Error> malformed(const char* what, std::int64_t lowest, std::int64_t highest,
                                std::int64_t got) {
    return fail({.code = Errc::Malformed, .subject = what, .lowest = lowest, .highest = highest, .got = got});
}

tl::unexpected<Error> outOfRange(const char* what, std::int64_t lowest, std::int64_t highest,
                                 std::int64_t got) {
    return fail(
        {.code = Errc::OutOfRange, .subject = what, .lowest = lowest, .highest = highest, .got = got});
}

int readByte(const FieldSpec& field, std::uint8_t byte) {
    return field.lowest < 0 ? static_cast<std::int8_t>(byte) : byte;
}

/// The first byte that is no movement; -1 where all are.
int notAMovement(ByteView bytes) {
    for (const std::uint8_t byte : bytes) {
        if (!decodeMovement(byte)) return byte;
    }
    return -1;
}

}  // namespace

int Message::value(FieldId field) const {
    switch (field) {
        case FieldId::Plan:
            return plan;
        case FieldId::Slot:
            return slot;
        case FieldId::Step:
            return step;
        case FieldId::Error:
            return error;
        case FieldId::Wheels:
            return static_cast<int>(wheels);
        case FieldId::Change:
            return change_percent;
        case FieldId::Movements:
            return static_cast<int>(movements.size());
    }
    return 0;
}

void Message::setValue(FieldId field, int value) {
    switch (field) {
        case FieldId::Plan:
            plan = value;
            break;
        case FieldId::Slot:
            slot = value;
            break;
        case FieldId::Step:
            step = value;
            break;
        case FieldId::Error:
            error = value;
            break;
        case FieldId::Wheels:
            wheels = static_cast<Wheels>(value);
            break;
        case FieldId::Change:
            change_percent = value;
            break;
        case FieldId::Movements:
            break;
    }
}

Result<MessageBytes> encodeMessage(const Message& message) {
    const MessageSpec& spec = specOf(message.kind);
    MessageBytes bytes;
    bytes.append(static_cast<std::uint8_t>(message.kind));
    for (const FieldSpec& field : spec.fields) {
        const int value = message.value(field.id);
        if (value < field.lowest || value > field.highest)
            return outOfRange(field.name, field.lowest, field.highest, value);
        if (!field.isBytes()) {
            bytes.append(static_cast<std::uint8_t>(value));
            continue;
        }
        if (const int byte = notAMovement(message.movements); byte >= 0)
            return outOfRange("movement", 0, 0xBE, byte);
        bytes.append(message.movements);
    }
    return bytes;
}

Result<Message> decodeMessage(ByteView bytes) {
    const auto size = static_cast<std::int64_t>(bytes.size());
    if (bytes.empty()) return malformed("length", 1, kMostMessageBytes, size);
    if (bytes[0] >= kMessageKinds) return malformed("command", 0, kMessageKinds - 1, bytes[0]);
    Message message;
    message.kind = static_cast<MessageKind>(bytes[0]);
    const MessageSpec& spec = specOf(message.kind);
    if (bytes.size() < spec.fewestBytes() || bytes.size() > spec.mostBytes())
        return malformed("length", static_cast<std::int64_t>(spec.fewestBytes()),
                         static_cast<std::int64_t>(spec.mostBytes()), size);
    for (const FieldSpec& field : spec.fields) {
        if (field.isBytes()) {
            const ByteView rest = bytes.subspan(field.offset);
            if (const int byte = notAMovement(rest); byte >= 0) return malformed("movement", 0, 0xBE, byte);
            message.movements.assign(rest.begin(), rest.end());
            continue;
        }
        const int value = readByte(field, bytes[field.offset]);
        if (value < field.lowest || value > field.highest)
            return malformed(field.name, field.lowest, field.highest, value);
        message.setValue(field.id, value);
    }
    return message;
}

ByteView withoutTerminator(ByteView held) noexcept {
    if (held.empty() || held.back() != 0) return held;
    const std::size_t shorter = held.size() - 1;
    if (held[0] < kMessageKinds && shorter > 0) {
        const MessageSpec& spec = specOf(static_cast<MessageKind>(held[0]));
        const bool fixed = spec.fewestBytes() == spec.mostBytes();
        if (fixed && held.size() == spec.mostBytes()) return held;
    }
    return held.first(shorter);
}

std::vector<std::size_t> zeroBytes(ByteView message) {
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < message.size(); ++i) {
        if (message[i] == 0) places.push_back(i);
    }
    return places;
}

}  // namespace kickstand::motionplan::wire
