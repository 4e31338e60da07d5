#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/motionplan/wire/error_codes.h"

namespace kickstand::motionplan::wire {

/// What a byte of a message says.
enum class FieldId : std::uint8_t { Plan, Slot, Step, Error, Wheels, Change, Movements };

/// One field of a message: its name, place, range and meaning.
struct FieldSpec {
    FieldId id = FieldId::Plan;
    const char* name = "";
    std::uint8_t offset = 0;  ///< From the message's first byte on.
    int lowest = 0;           ///< Of Movements: how many bytes there are at least and at most.
    int highest = 0;
    const char* unit = "";
    const char* description = "";
    std::span<const char* const> labels = {};  ///< Names of the values from 0 on, where they have names.

    bool isBytes() const { return id == FieldId::Movements; }
};

/// A message and its fields in the order they stand in. The codec (message.h) reads and writes through these
/// same entries, so that there is one place that says where a byte lives.
struct MessageSpec {
    MessageKind kind = MessageKind::Create;
    std::uint8_t box = 0;      ///< The mailbox that it is sent to, or read from (protocol 3).
    const char* section = "";  ///< Of the protocol reference: "4.1".
    const char* summary = "";
    std::span<const FieldSpec> fields;

    /// Bytes of the message without its terminator.
    std::size_t fewestBytes() const;
    std::size_t mostBytes() const;
};

/// Every message, in the order of its command byte (protocol 4). Any thread.
std::span<const MessageSpec> messageSpecs() noexcept;
/// That of a kind. Any thread.
const MessageSpec& specOf(MessageKind kind) noexcept;

/// Plans are known by 1 to 254; 0 is an empty slot and 255 the dummy of a query (protocol 6.2).
inline constexpr int kFirstPlan = 1;
inline constexpr int kLastPlan = 254;
inline constexpr int kNoPlan = 0;
inline constexpr int kDummyPlan = 0xFF;
inline constexpr int kSlots = 5;
/// What fits into a mailbox beside the header (protocol 4.1, 4.9).
inline constexpr int kMostMovements = 55;
inline constexpr int kMostTriggerMovements = 56;
inline constexpr int kMostChange_percent = 100;

/// The mailboxes for commands and for the trigger plan, and where a host reads what the robot has put there
/// (protocol 3).
inline constexpr std::uint8_t kCommandBox = 7;
inline constexpr std::uint8_t kTriggerBox = 5;
inline constexpr std::uint8_t kCommandOutbox = 17;
inline constexpr std::uint8_t kTriggerOutbox = 15;

}  // namespace kickstand::motionplan::wire
