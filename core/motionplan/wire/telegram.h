#pragma once

#include <cstdint>
#include <variant>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/framing/inline_bytes.h"

namespace kickstand::motionplan::wire {

/// The length in front of a telegram, which does not count itself, and the longest one (protocol 2.1).
inline constexpr std::size_t kLengthBytes = 2;
inline constexpr std::size_t kMostTelegramBytes = 64;
/// The field of a MessageRead reply, and the longest message with its terminator (protocol 2.2, 2.3).
inline constexpr std::size_t kMailboxBytes = 59;
inline constexpr int kMailboxes = 10;
inline constexpr int kRemoteMailboxes = 20;

using TelegramBytes = InlineBytes<kLengthBytes + kMostTelegramBytes>;
using MailboxBytes = InlineBytes<kMailboxBytes>;

/// Puts a message into a mailbox of the robot (protocol 2.2).
struct MessageWrite {
    bool reply = false;    ///< Whether the NXT is to answer with a status.
    std::uint8_t box = 0;  ///< 0-9.
    /// 1 to 59 bytes; the last is the terminator, zero.
    MailboxBytes content{};

    friend bool operator==(const MessageWrite&, const MessageWrite&) = default;
};
/// The answer to one that asked for it.
struct WriteReply {
    std::uint8_t status = 0;

    friend bool operator==(const WriteReply&, const WriteReply&) = default;
};
/// Reads a mailbox of the robot (protocol 2.3).
struct MessageRead {
    std::uint8_t remoteBox = 0;  ///< 0-19; 10 to 19 are what the robot's program has put out.
    std::uint8_t localBox = 0;   ///< 0-9; comes back in the reply.
    bool remove = false;         ///< Whether what was read leaves the mailbox.

    friend bool operator==(const MessageRead&, const MessageRead&) = default;
};
struct ReadReply {
    std::uint8_t status = 0;
    std::uint8_t localBox = 0;
    MailboxBytes content{};  ///< As many bytes as the reply's size says.

    friend bool operator==(const ReadReply&, const ReadReply&) = default;
};

/// Any of them.
using Telegram = std::variant<MessageWrite, WriteReply, MessageRead, ReadReply>;

/// The bytes of a telegram, its length in front. Errors: OutOfRange with the field ("box", "remote-box",
/// "local-box", "size"); BadArgument where a message does not end with its terminator. Any thread.
Result<TelegramBytes> encodeTelegram(const Telegram& telegram);

/// Reads one whole telegram, its length in front. Errors: Malformed with what is wrong ("length", "type",
/// "command", "size", "terminator", "remote-box", "local-box", "remove", "padding"). Any thread.
Result<Telegram> decodeTelegram(ByteView bytes);

/// How many bytes the telegram has that begins with these, its length included; 0 where no telegram can begin
/// so. `bytes` may be only its beginning, from one byte on. Any thread.
std::size_t telegramSize(ByteView bytes) noexcept;

}  // namespace kickstand::motionplan::wire
