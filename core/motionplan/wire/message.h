#pragma once

#include <cstdint>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/framing/inline_bytes.h"
#include "core/motionplan/wire/fields.h"
#include "core/motionplan/wire/movement.h"

namespace kickstand::motionplan::wire {

/// A message in a mailbox holds this much without its terminator (protocol 2.2).
inline constexpr std::size_t kMostMessageBytes = 58;
using MessageBytes = InlineBytes<kMostMessageBytes>;

/// What goes into a mailbox, in either direction. Of the members those count that the kind's fields name
/// (fields.h).
struct Message {
    MessageKind kind = MessageKind::Stop;
    int plan = 0;
    int slot = 0;
    int step = 0;
    int error = 0;
    Wheels wheels = Wheels::BothForward;
    int change_percent = 0;
    std::vector<std::uint8_t> movements{};

    friend bool operator==(const Message&, const Message&) = default;

    /// The value of a field that is not bytes, as the field's number.
    int value(FieldId field) const;
    void setValue(FieldId field, int value);
};

/// The bytes of a message, without a terminator. Errors: OutOfRange with the field and its range; for
/// movements with how many there are ("movements") or the byte that is none ("movement"). Any thread.
Result<MessageBytes> encodeMessage(const Message& message);

/// Reads a message, without its terminator. Errors: Malformed with what is wrong ("command", "length", a
/// field, "movement"), its range and what there was. Any thread.
Result<Message> decodeMessage(ByteView bytes);

/// What a mailbox held, without its terminator. A robot may leave the terminator away: a zero that a message
/// of fixed length needs is not taken for one (protocol 3). Any thread.
ByteView withoutTerminator(ByteView held) noexcept;

/// Where bytes of a message are zero, counted from its first. A robot whose program reads a mailbox as text
/// loses what follows the first of them (protocol 5.3). Any thread.
std::vector<std::size_t> zeroBytes(ByteView message);

}  // namespace kickstand::motionplan::wire
