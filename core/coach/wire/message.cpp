#include "core/coach/wire/message.h"

#include "core/coach/wire/velocity.h"
#include "core/framing/bit_field.h"

namespace kickstand::coach::wire {
namespace {

constexpr const char* kColors[] = {"red", "blue"};

constexpr FieldSpec kColor[] = {
    {"color", FieldKind::Unsigned, 0, 8, 0, 1, "", "The COACH's team color", kColors}};
constexpr FieldSpec kVelocity[] = {
    {"forward", FieldKind::Level, 0, 4, -kTopLevel, kTopLevel, "%", "Forward velocity; negative is backward"},
    {"turn", FieldKind::Level, 4, 4, -kTopLevel, kTopLevel, "%", "Turning; positive is counterclockwise"}};
constexpr FieldSpec kAnalog[] = {
    {"magnitude", FieldKind::Signed, 0, 8, -100, 100, "%", "What the COACH's analog input says"}};
constexpr FieldSpec kCoach[] = {
    {"coach", FieldKind::Unsigned, 0, 8, 0, 255, "", "The team of the COACH that controls the boat now"}};
constexpr FieldSpec kMorale[] = {
    {"morale", FieldKind::Signed, 0, 8, -128, 127, "", "The crew's morale; at -10 it mutinies"}};

constexpr MessageSpec kMessages[] = {
    {"suppress-mutiny", Opcode::SuppressMutiny, Role::Coach, false, "4.1", "Ends a mutiny", {}},
    {"assert-command", Opcode::AssertCommand, Role::Coach, false, "4.1", "Asks a boat to obey this COACH",
     kColor},
    {"jettison", Opcode::Jettison, Role::Coach, false, "4.1", "Gives the boat up", {}},
    {"velocity", Opcode::Velocity, Role::Coach, false, "4.2", "Steers, for one second", kVelocity},
    {"free-digital", Opcode::FreeDigital, Role::Coach, false, "4.1", "Whatever the team makes of it", {}},
    {"free-analog", Opcode::FreeAnalog, Role::Coach, false, "4.1", "Whatever the team makes of it", kAnalog},
    {"mutiny-in-progress", Opcode::MutinyInProgress, Role::Towrp, false, "4.3", "The crew mutinies", {}},
    {"available", Opcode::Available, Role::Towrp, true, "4.3", "The boat obeys nobody", {}},
    {"assertion-result", Opcode::AssertionResult, Role::Towrp, true, "4.3", "Whom the boat obeys now",
     kCoach},
    {"update-morale", Opcode::UpdateMorale, Role::Towrp, false, "4.3", "Acknowledges, and tells the morale",
     kMorale},
};

}  // namespace

std::span<const MessageSpec> messages() noexcept {
    return kMessages;
}

const MessageSpec* findMessage(std::uint8_t opcode) noexcept {
    for (const MessageSpec& message : kMessages) {
        if (static_cast<std::uint8_t>(message.opcode) == opcode) return &message;
    }
    return nullptr;
}

const MessageSpec* findMessage(std::string_view name) noexcept {
    for (const MessageSpec& message : kMessages) {
        if (name == message.name) return &message;
    }
    return nullptr;
}

const MessageSpec& specOf(Opcode opcode) noexcept {
    const MessageSpec* found = findMessage(static_cast<std::uint8_t>(opcode));
    return found != nullptr ? *found : kMessages[0];
}

std::int32_t readField(const FieldSpec& field, ByteView bytes) noexcept {
    const std::uint32_t raw = readBits<BitOrder::MsbFirst>(bytes, field.firstBit, field.width);
    switch (field.kind) {
        case FieldKind::Signed:
            return signExtend(raw, field.width);
        case FieldKind::Level:
            return detail::levelOf(raw);
        case FieldKind::Rssi:
            return -static_cast<std::int32_t>(raw);
        case FieldKind::Unsigned:
        case FieldKind::Address:
            break;
    }
    return static_cast<std::int32_t>(raw);
}

void writeField(const FieldSpec& field, ByteSpan bytes, std::int32_t value) noexcept {
    auto raw = static_cast<std::uint32_t>(value);
    if (field.kind == FieldKind::Level) raw = detail::nibbleOf(value);
    if (field.kind == FieldKind::Rssi) raw = static_cast<std::uint32_t>(-value);
    writeBits<BitOrder::MsbFirst>(bytes, field.firstBit, field.width, raw);
}

std::optional<Message> decodeMessage(ByteView bytes) noexcept {
    if (bytes.size() != kMessageBytes) return std::nullopt;
    const MessageSpec* spec = findMessage(bytes[0]);
    if (spec == nullptr) return std::nullopt;
    for (const FieldSpec& field : spec->fields) {
        const std::int32_t value = readField(field, bytes.subspan(1));
        if (value < field.lowest || value > field.highest) return std::nullopt;
    }
    return Message{spec->opcode, bytes[1]};
}

}  // namespace kickstand::coach::wire
