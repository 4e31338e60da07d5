#include "core/motionplan/wire/telegram.h"

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/motionplan/wire/message.h"
#include "core/motionplan/wire/telegram_parser.h"

namespace kickstand::motionplan::wire {
namespace {

std::string hexOf(const Telegram& telegram) {
    const auto bytes = encodeTelegram(telegram);
    return bytes ? toHex(bytes->view()) : std::string("refused: ") + bytes.error().subject;
}

MailboxBytes content(const char* hex) {
    MailboxBytes bytes;
    bytes.append(*parseHex(hex));
    return bytes;
}

// The protocol's own sample (protocol 4.1).
constexpr const char* kSample = "0d 00 80 09 07 09 00 09 04 0d 5c 12 7e 37 00";

TEST(Telegram, TheSamplePlanIsWrittenToTheByte) {
    Message create;
    create.kind = MessageKind::Create;
    create.plan = 9;
    create.slot = 4;
    for (const Movement movement :
         {Movement{Wheels::BothForward, 25}, Movement{Wheels::LeftForward, 84},
          Movement{Wheels::BothForward, 50}, Movement{Wheels::LeftBack, 90}, Movement{Wheels::BothBack, 100}})
        create.movements.push_back(*encodeMovement(movement));
    MessageWrite write;
    write.box = kCommandBox;
    write.content.append(encodeMessage(create)->view());
    write.content.append(std::uint8_t{0});
    EXPECT_EQ(hexOf(write), kSample);
    const auto back = decodeTelegram(*parseHex(kSample));
    ASSERT_TRUE(back);
    EXPECT_EQ(std::get<MessageWrite>(*back), write);
}

TEST(Telegram, EachKindHasItsBytes) {
    EXPECT_EQ(hexOf(MessageWrite{true, 7, content("01 00")}), "06 00 00 09 07 02 01 00");
    EXPECT_EQ(hexOf(WriteReply{0xEC}), "03 00 02 09 ec");
    EXPECT_EQ(hexOf(MessageRead{17, 7, true}), "05 00 00 13 11 07 01");
    EXPECT_EQ(hexOf(MessageRead{15, 5, false}), "05 00 00 13 0f 05 00");
    const std::string reply = hexOf(ReadReply{0, 7, content("03 09 04 00")});
    EXPECT_TRUE(reply.starts_with("40 00 02 13 00 07 04 03 09 04 00 00 00")) << reply;
    EXPECT_EQ(parseHex(reply)->size(), 66U);
}

TEST(Telegram, EachKindComesBack) {
    for (const Telegram& telegram :
         {Telegram(MessageWrite{false, 5, content("08 01 0d 00")}), Telegram(WriteReply{0x20}),
          Telegram(MessageRead{19, 9, true}), Telegram(ReadReply{0x40, 7, {}}),
          Telegram(ReadReply{0, 5, content("08 01 0d 00")})}) {
        const auto back = decodeTelegram(*parseHex(hexOf(telegram)));
        ASSERT_TRUE(back);
        EXPECT_EQ(*back, telegram);
    }
}

TEST(Telegram, WhatIsOutOfRangeIsNotWritten) {
    EXPECT_EQ(hexOf(MessageWrite{false, 10, content("01 00")}), "refused: box");
    EXPECT_EQ(hexOf(MessageWrite{false, 7, {}}), "refused: size");
    EXPECT_EQ(hexOf(MessageWrite{false, 7, content("01")}), "refused: terminator");
    EXPECT_EQ(hexOf(MessageRead{20, 0, true}), "refused: remote-box");
    EXPECT_EQ(hexOf(MessageRead{17, 10, true}), "refused: local-box");
}

TEST(Telegram, DamagedBytesSayWhatIsWrong) {
    const auto wrong = [](const char* hex) { return decodeTelegram(*parseHex(hex)).error().subject; };
    EXPECT_EQ(wrong(""), "length");
    EXPECT_EQ(wrong("04 00 02 09 ec"), "length");
    EXPECT_EQ(wrong("04 00 02 09 ec 00"), "length");
    EXPECT_EQ(wrong("03 00 01 09 ec"), "type");
    EXPECT_EQ(wrong("03 00 02 07 ec"), "command");
    EXPECT_EQ(wrong("06 00 80 09 0a 02 01 00"), "box");
    EXPECT_EQ(wrong("06 00 80 09 07 03 01 00"), "size");
    EXPECT_EQ(wrong("06 00 80 09 07 02 01 01"), "terminator");
    EXPECT_EQ(wrong("05 00 00 13 14 07 01"), "remote-box");
    EXPECT_EQ(wrong("05 00 00 13 11 0a 01"), "local-box");
    EXPECT_EQ(wrong("05 00 00 13 11 07 02"), "remove");
    auto reply = *parseHex(hexOf(ReadReply{0, 7, {}}));
    reply[6] = 60;
    EXPECT_EQ(decodeTelegram(reply).error().subject, "size");
}

struct Taken {
    TelegramParser parser;
    std::vector<Telegram> telegrams;
    void feed(ByteView bytes) {
        parser.feed(bytes, [this](const Telegram& telegram) { telegrams.push_back(telegram); });
    }
};

TEST(TelegramParser, FindsTelegramsInWhateverPiecesTheyCome) {
    auto stream = *parseHex(kSample);
    const auto reply = *encodeTelegram(ReadReply{0, 7, content("03 09 04 00")});
    stream.insert(stream.end(), reply.begin(), reply.end());
    for (std::size_t piece = 1; piece <= stream.size(); ++piece) {
        Taken taken;
        for (std::size_t at = 0; at < stream.size(); at += piece)
            taken.feed(ByteView(stream).subspan(at, std::min(piece, stream.size() - at)));
        EXPECT_EQ(taken.telegrams.size(), 2U) << piece;
        EXPECT_EQ(taken.parser.counters().skipped, 0U) << piece;
        EXPECT_FALSE(taken.parser.hasBegun());
    }
}

TEST(TelegramParser, GarbageIsSkippedAndCounted) {
    Taken taken;
    taken.feed(*parseHex("ff 00 00 13 41 03 00"));
    taken.feed(*parseHex("03 00 02 09 40"));
    ASSERT_EQ(taken.telegrams.size(), 1U);
    EXPECT_EQ(std::get<WriteReply>(taken.telegrams[0]).status, 0x40);
    EXPECT_EQ(taken.parser.counters().skipped, 7U);
}

TEST(TelegramParser, WholeTelegramsThatCannotBeAreCounted) {
    Taken taken;
    taken.feed(*parseHex("06 00 80 09 07 03 01 00"));
    EXPECT_EQ(taken.parser.counters().malformed, 1U);
    taken.feed(*parseHex(kSample));
    EXPECT_EQ(taken.telegrams.size(), 1U);
}

TEST(TelegramParser, WhatWillNotComeIsForgotten) {
    Taken taken;
    taken.feed(*parseHex("40 00 02 13 00 07"));
    EXPECT_TRUE(taken.parser.hasBegun());
    taken.parser.abandon();
    EXPECT_EQ(taken.parser.counters().skipped, 6U);
    taken.feed(*parseHex(kSample));
    EXPECT_EQ(taken.telegrams.size(), 1U);
}

}  // namespace
}  // namespace kickstand::motionplan::wire
