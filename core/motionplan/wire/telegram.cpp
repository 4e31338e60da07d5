#include "core/motionplan/wire/telegram.h"

namespace kickstand::motionplan::wire {
namespace {

// The first byte of a telegram: what kind it is (protocol 2.2).
constexpr std::uint8_t kDirectCommand = 0x00;
constexpr std::uint8_t kDirectCommandNoReply = 0x80;
constexpr std::uint8_t kReply = 0x02;
// The second: the command (protocol 2.2, 2.3).
constexpr std::uint8_t kMessageWrite = 0x09;
constexpr std::uint8_t kMessageRead = 0x13;

constexpr std::size_t kHeader = kLengthBytes + 2;
constexpr std::size_t kWriteHeader = kHeader + 2;
constexpr std::size_t kReadReplyHeader = kHeader + 3;

// Lengths as they stand in front (protocol 2.1).
constexpr std::size_t kReadLength = 5;
constexpr std::size_t kWriteReplyLength = 3;
constexpr std::size_t kFewestWriteLength = 5;
constexpr std::size_t kMostWriteLength = 4 + kMailboxBytes;

tl::unexpected<Error> malformed(const char* what, std::int64_t lowest, std::int64_t highest,
                                std::int64_t got) {
    return fail({.code = Errc::Malformed, .subject = what, .lowest = lowest, .highest = highest, .got = got});
}

Result<void> checkRange(const char* what, std::size_t got, std::size_t lowest, std::size_t highest) {
    if (got >= lowest && got <= highest) return {};
    return fail({.code = Errc::OutOfRange,
                 .subject = what,
                 .lowest = static_cast<std::int64_t>(lowest),
                 .highest = static_cast<std::int64_t>(highest),
                 .got = static_cast<std::int64_t>(got)});
}

TelegramBytes begin(std::uint8_t type, std::uint8_t command) {
    TelegramBytes bytes;
    bytes.resize(kLengthBytes);
    bytes.append(type);
    bytes.append(command);
    return bytes;
}

TelegramBytes finish(TelegramBytes bytes) {
    storeLe16(bytes.span(), 0, static_cast<std::uint16_t>(bytes.size() - kLengthBytes));
    return bytes;
}

Result<TelegramBytes> encode(const MessageWrite& write) {
    if (auto box = checkRange("box", write.box, 0, kMailboxes - 1); !box) return fail(box.error());
    if (auto size = checkRange("size", write.content.size(), 1, kMailboxBytes); !size)
        return fail(size.error());
    if (write.content[write.content.size() - 1] != 0) return fail(Errc::BadArgument, "terminator");
    TelegramBytes bytes = begin(write.reply ? kDirectCommand : kDirectCommandNoReply, kMessageWrite);
    bytes.append(write.box);
    bytes.append(static_cast<std::uint8_t>(write.content.size()));
    bytes.append(write.content.view());
    return finish(bytes);
}

Result<TelegramBytes> encode(const WriteReply& reply) {
    TelegramBytes bytes = begin(kReply, kMessageWrite);
    bytes.append(reply.status);
    return finish(bytes);
}

Result<TelegramBytes> encode(const MessageRead& read) {
    if (auto box = checkRange("remote-box", read.remoteBox, 0, kRemoteMailboxes - 1); !box)
        return fail(box.error());
    if (auto box = checkRange("local-box", read.localBox, 0, kMailboxes - 1); !box) return fail(box.error());
    TelegramBytes bytes = begin(kDirectCommand, kMessageRead);
    bytes.append(read.remoteBox);
    bytes.append(read.localBox);
    bytes.append(read.remove ? 1 : 0);
    return finish(bytes);
}

Result<TelegramBytes> encode(const ReadReply& reply) {
    if (auto box = checkRange("local-box", reply.localBox, 0, kMailboxes - 1); !box) return fail(box.error());
    TelegramBytes bytes = begin(kReply, kMessageRead);
    bytes.append(reply.status);
    bytes.append(reply.localBox);
    bytes.append(static_cast<std::uint8_t>(reply.content.size()));
    bytes.append(reply.content.view());
    bytes.resize(TelegramBytes::maxSize());
    return finish(bytes);
}

Result<Telegram> decodeWrite(ByteView bytes) {
    MessageWrite write;
    write.reply = bytes[kLengthBytes] == kDirectCommand;
    write.box = bytes[kHeader];
    if (write.box >= kMailboxes) return malformed("box", 0, kMailboxes - 1, write.box);
    const ByteView content = bytes.subspan(kWriteHeader);
    const std::uint8_t size = bytes[kHeader + 1];
    if (size != content.size()) {
        const auto there = static_cast<std::int64_t>(content.size());
        return malformed("size", there, there, size);
    }
    if (content.back() != 0) return malformed("terminator", 0, 0, content.back());
    write.content.append(content);
    return write;
}

Result<Telegram> decodeRead(ByteView bytes) {
    const std::uint8_t remote = bytes[kHeader];
    const std::uint8_t local = bytes[kHeader + 1];
    const std::uint8_t remove = bytes[kHeader + 2];
    if (remote >= kRemoteMailboxes) return malformed("remote-box", 0, kRemoteMailboxes - 1, remote);
    if (local >= kMailboxes) return malformed("local-box", 0, kMailboxes - 1, local);
    if (remove > 1) return malformed("remove", 0, 1, remove);
    return MessageRead{remote, local, remove != 0};
}

Result<Telegram> decodeReadReply(ByteView bytes) {
    ReadReply reply;
    reply.status = bytes[kHeader];
    reply.localBox = bytes[kHeader + 1];
    const std::uint8_t size = bytes[kHeader + 2];
    if (reply.localBox >= kMailboxes) return malformed("local-box", 0, kMailboxes - 1, reply.localBox);
    if (size > kMailboxBytes) return malformed("size", 0, kMailboxBytes, size);
    reply.content.append(bytes.subspan(kReadReplyHeader, size));
    return reply;
}

/// The lengths that a telegram of that type and command may have; none for no such telegram.
struct Lengths {
    std::size_t fewest = 1;
    std::size_t most = 0;

    bool contain(std::size_t length) const { return length >= fewest && length <= most; }
};
Lengths lengthsOf(std::uint8_t type, std::uint8_t command) {
    if (type == kReply && command == kMessageWrite) return {kWriteReplyLength, kWriteReplyLength};
    if (type == kReply && command == kMessageRead) return {kMostTelegramBytes, kMostTelegramBytes};
    if (type == kDirectCommand && command == kMessageRead) return {kReadLength, kReadLength};
    if ((type == kDirectCommand || type == kDirectCommandNoReply) && command == kMessageWrite)
        return {kFewestWriteLength, kMostWriteLength};
    return {};
}

}  // namespace

Result<TelegramBytes> encodeTelegram(const Telegram& telegram) {
    return std::visit([](const auto& one) { return encode(one); }, telegram);
}

Result<Telegram> decodeTelegram(ByteView bytes) {
    const auto size = static_cast<std::int64_t>(bytes.size());
    constexpr auto kFewest = static_cast<std::int64_t>(kLengthBytes + kWriteReplyLength);
    if (size < kFewest || bytes.size() > TelegramBytes::maxSize())
        return malformed("length", kFewest, TelegramBytes::maxSize(), size);
    if (const std::uint16_t length = loadLe16(bytes, 0); length != bytes.size() - kLengthBytes) {
        const std::int64_t there = size - static_cast<std::int64_t>(kLengthBytes);
        return malformed("length", there, there, length);
    }
    const std::uint8_t type = bytes[kLengthBytes];
    const std::uint8_t command = bytes[kLengthBytes + 1];
    const Lengths lengths = lengthsOf(type, command);
    if (lengths.most == 0) {
        const bool knownType = type == kReply || type == kDirectCommand || type == kDirectCommandNoReply;
        return knownType ? malformed("command", kMessageWrite, kMessageRead, command)
                         : malformed("type", kDirectCommand, kDirectCommandNoReply, type);
    }
    if (!lengths.contain(bytes.size() - kLengthBytes))
        return malformed("length", static_cast<std::int64_t>(lengths.fewest),
                         static_cast<std::int64_t>(lengths.most),
                         size - static_cast<std::int64_t>(kLengthBytes));
    if (type != kReply) return command == kMessageWrite ? decodeWrite(bytes) : decodeRead(bytes);
    if (command == kMessageWrite) return WriteReply{bytes[kHeader]};
    return decodeReadReply(bytes);
}

std::size_t telegramSize(ByteView bytes) noexcept {
    if (bytes.empty() || bytes[0] < kWriteReplyLength || bytes[0] > kMostTelegramBytes) return 0;
    if (bytes.size() > 1 && bytes[1] != 0) return 0;
    const std::size_t length = bytes[0];
    if (bytes.size() > kLengthBytes) {
        const std::uint8_t type = bytes[kLengthBytes];
        // Before the command is there, either of them may follow.
        const bool known = bytes.size() < kHeader ? lengthsOf(type, kMessageWrite).contain(length) ||
                                                        lengthsOf(type, kMessageRead).contain(length)
                                                  : lengthsOf(type, bytes[kLengthBytes + 1]).contain(length);
        if (!known) return 0;
    }
    return kLengthBytes + length;
}

}  // namespace kickstand::motionplan::wire
