#include "core/smartdevice/wire/frame.h"

#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/hex.h"

namespace kickstand::smartdevice::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string frameText(Dialect dialect, const Message& message) {
    return toHex(encodeFrame(dialect, message).view());
}

Bytes bytesOfFrame(Dialect dialect, const Message& message) {
    const FrameBytes frame = encodeFrame(dialect, message);
    return {frame.begin(), frame.end()};
}

std::vector<Message> decoded(Decoder& decoder, ByteView bytes) {
    std::vector<Message> messages;
    decoder.feed(bytes, [&](const Message& message) { messages.push_back(message); });
    return messages;
}

ValueBytes values(const Bytes& bytes) {
    ValueBytes held;
    EXPECT_TRUE(held.append(bytes));
    return held;
}

Uid uid(Dialect dialect, const char* text) {
    const auto read = uidFromText(text);
    EXPECT_TRUE(read && read->dialect == dialect) << text;
    return read.value_or(Uid{});
}

/// One of each kind, with zeros where they hurt.
std::vector<Message> oneOfEach(Dialect dialect) {
    const char* const text =
        dialect == Dialect::Current ? "0c-05-010203040506070809" : "000c-05-0102030405060708";
    return {Ping{},
            SubscriptionRequest{5, 40},
            SubscriptionResponse{0, 0, uid(dialect, text)},
            DeviceRead{0xFFFF},
            DeviceWrite{1, values({0, 0, 0, 0x3F})},
            DeviceData{0x8000, values({})},
            DeviceDisable{},
            HeartbeatRequest{0xFF},
            HeartbeatResponse{0},
            ErrorMessage{0xFE}};
}

TEST(Frame, TheVectorsOfTheDocument) {
    EXPECT_EQ(frameText(Dialect::Current, Ping{}), "02 10 02 10 00");
    EXPECT_EQ(frameText(Dialect::Current, HeartbeatRequest{0xFF}), "05 17 01 ff e9 00");
    EXPECT_EQ(frameText(Dialect::Current, SubscriptionRequest{0b101, 40}), "04 11 03 05 03 28 3f 00");
    EXPECT_EQ(frameText(Dialect::Current, DeviceWrite{1, values({0, 0, 0, 0x3F})}),
              "04 14 06 01 01 01 01 03 3f 2c 00");
    EXPECT_EQ(frameText(Dialect::Current, ErrorMessage{0xFE}), "04 ff 01 fe 01 00");
    EXPECT_EQ(frameText(Dialect::Hibike, Ping{}), "00 04 02 10 02 10");
}

TEST(Frame, HibikeHasADelayOfTwoBytesAndAUidOfItsOwn) {
    const MessageBytes request = encodeMessage(Dialect::Hibike, SubscriptionRequest{1, 1000});
    EXPECT_EQ(toHex(request.view().first(6)), "11 04 01 00 e8 03");
    EXPECT_EQ(encodeMessage(Dialect::Current, SubscriptionRequest{1, 1000}).view()[4], 255)
        << "the longest delay there is";
    const Uid hibike = uid(Dialect::Hibike, "000c-05-0102030405060708");
    EXPECT_EQ(hibike.device(), 0x0C);
    EXPECT_EQ(hibike.year(), 5);
    EXPECT_EQ(toHex(hibike.bytes), "0c 00 05 01 02 03 04 05 06 07 08");
    EXPECT_EQ(toText(hibike), "000c-05-0102030405060708");
}

TEST(Frame, UidsAreTextsAndBack) {
    const Uid current = uid(Dialect::Current, "0c-05-010203040506070809");
    EXPECT_EQ(current.device(), 0x0C);
    EXPECT_EQ(current.year(), 5);
    EXPECT_EQ(toText(current), "0c-05-010203040506070809");
    EXPECT_EQ(uidFromText("0C-05-01020304050607080A"), uidFromText("0c-05-01020304050607080a"));
    for (const char* text :
         {"", "-", "0c", "0c-05", "0c-05-0102030405060708", "0c-05-01020304050607080",
          "0c-05-0102030405060708090a", "0c-05_010203040506070809", "0g-05-010203040506070809",
          "000c-05-01020304050607080", "c-05-0102030405060708090"})
        EXPECT_FALSE(uidFromText(text)) << text;
}

TEST(Frame, EveryMessageComesBackInBothDialectsHoweverItIsCut) {
    for (const Dialect dialect : {Dialect::Current, Dialect::Hibike}) {
        const std::vector<Message> sent = oneOfEach(dialect);
        Bytes line;
        for (const Message& message : sent) {
            const Bytes frame = bytesOfFrame(dialect, message);
            line.insert(line.end(), frame.begin(), frame.end());
        }
        for (const std::size_t piece : {1U, 2U, 3U, 7U, 1000U}) {
            Decoder decoder(dialect);
            std::vector<Message> got;
            for (std::size_t at = 0; at < line.size(); at += piece) {
                const auto more =
                    decoded(decoder, ByteView(line).subspan(at, std::min(piece, line.size() - at)));
                got.insert(got.end(), more.begin(), more.end());
            }
            EXPECT_EQ(got, sent);
            EXPECT_EQ(decoder.counts(), (DecoderCounts{.messages = sent.size()}));
        }
    }
}

TEST(Frame, TheLongestPayloadsComeBack) {
    for (const Dialect dialect : {Dialect::Current, Dialect::Hibike}) {
        for (const int filling : {0, 1, 255}) {
            const Message sent = DeviceData{
                0xFFFF, values(Bytes(mostPayload(dialect) - 2, static_cast<std::uint8_t>(filling)))};
            Decoder decoder(dialect);
            EXPECT_EQ(decoded(decoder, bytesOfFrame(dialect, sent)), std::vector<Message>{sent});
        }
    }
    const Message tooLong = DeviceData{1, values(Bytes(kMostPayload - 2, 7))};
    EXPECT_EQ(encodeMessage(Dialect::Hibike, tooLong).size(), kMostHibikePayload + kMessageOverhead);
}

TEST(Frame, AnEmptyFrameIsNoMessageAndNoDamage) {
    Decoder decoder(Dialect::Current);
    EXPECT_EQ(decoded(decoder, Bytes{0, 0, 2, 0x10, 2, 0x10, 0, 0}), std::vector<Message>{Ping{}});
    EXPECT_EQ(decoder.counts().faults(), 0U);
    Decoder hibike(Dialect::Hibike);
    EXPECT_EQ(decoded(hibike, Bytes{0, 0, 0, 4, 2, 0x10, 2, 0x10, 0}), std::vector<Message>{Ping{}});
    EXPECT_EQ(hibike.counts().faults(), 0U);
}

TEST(Frame, EachFaultIsCountedAndTheNextMessageIsRead) {
    const Bytes ping = bytesOfFrame(Dialect::Current, Ping{});
    const auto countsAfter = [&](Bytes bytes) {
        Decoder decoder(Dialect::Current);
        bytes.insert(bytes.end(), ping.begin(), ping.end());
        EXPECT_EQ(decoded(decoder, bytes), std::vector<Message>{Ping{}});
        return decoder.counts();
    };
    EXPECT_EQ(countsAfter({9, 1, 0}), (DecoderCounts{.messages = 1, .damaged = 1, .dropped = 2}));
    EXPECT_EQ(countsAfter({2, 0x10, 2, 0x11, 0}),
              (DecoderCounts{.messages = 1, .checksums = 1, .dropped = 4}));
    // An ID that is none, a payload of another length, a length that lies, and far too few bytes.
    EXPECT_EQ(countsAfter({2, 0x44, 2, 0x44, 0}),
              (DecoderCounts{.messages = 1, .malformed = 1, .dropped = 4}));
    EXPECT_EQ(countsAfter({5, 0x10, 1, 7, 0x16, 0}).malformed, 1U);
    EXPECT_EQ(countsAfter({4, 0x10, 9, 0x19, 0}).malformed, 1U);
    EXPECT_EQ(countsAfter({1, 0}).malformed, 1U);
    // Without end: dropped, and counted once.
    Bytes endless(5000, 0x42);
    endless.push_back(0);
    const DecoderCounts overlong = countsAfter(endless);
    EXPECT_EQ(overlong, (DecoderCounts{.messages = 1, .damaged = 1, .dropped = 5000}));
}

TEST(Frame, HibikeIsBackInStepWithTheNextZero) {
    const Bytes ping = bytesOfFrame(Dialect::Hibike, Ping{});
    for (const Bytes& before : {Bytes{0, 200, 1, 2, 3}, Bytes{7, 8, 9}, Bytes{0, 1}, Bytes{0, 2, 9, 9},
                                Bytes{0, 4, 2, 0x10, 2, 0x11}, Bytes{0, 4, 2, 0x10, 2, 0x10, 5, 5}}) {
        Decoder decoder(Dialect::Hibike);
        Bytes bytes = before;
        bytes.insert(bytes.end(), ping.begin(), ping.end());
        const auto messages = decoded(decoder, bytes);
        ASSERT_FALSE(messages.empty());
        EXPECT_EQ(messages.back(), Message(Ping{}));
        EXPECT_GT(decoder.counts().dropped + decoder.counts().damaged, 0U);
    }
}

TEST(Frame, ANewLineForgetsTheHalfOfAnOldFrame) {
    Decoder decoder(Dialect::Current);
    EXPECT_TRUE(decoded(decoder, Bytes{2, 0x10, 2}).empty());
    decoder.reset();
    EXPECT_EQ(decoded(decoder, bytesOfFrame(Dialect::Current, Ping{})), std::vector<Message>{Ping{}});
    EXPECT_EQ(decoder.counts().dropped, 3U);
}

TEST(Frame, HardlyAnyDamageMakesAMessageThatWasNotSentAndTheNextButOneIsRead) {
    constexpr int kRounds = 3000;
    std::mt19937 random(3);
    for (const Dialect dialect : {Dialect::Current, Dialect::Hibike}) {
        Decoder decoder(dialect);
        const auto all = oneOfEach(dialect);
        int wrong = 0;
        for (int round = 0; round < kRounds; ++round) {
            const Message sent = all[random() % all.size()];
            Bytes frame = bytesOfFrame(dialect, sent);
            frame[random() % frame.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
            for (const Message& got : decoded(decoder, frame))
                wrong += got == sent ? 0 : 1;
            // A damaged end takes the next frame along, but no more.
            decoded(decoder, bytesOfFrame(dialect, Ping{}));
            EXPECT_FALSE(decoded(decoder, bytesOfFrame(dialect, Ping{})).empty());
        }
        EXPECT_GT(decoder.counts().faults(), kRounds / 2U);
        // A flipped bit of a message is always seen. One of a COBS code moves a zero, and an XOR of eight
        // bits cannot see all of that.
        EXPECT_LT(wrong, kRounds / 100);
    }
}

TEST(Frame, FaultsOfSingleMessages) {
    const auto faultOf = [](const Bytes& bytes) {
        const auto message = decodeMessage(Dialect::Current, bytes);
        return message ? "none" : name(message.error());
    };
    EXPECT_STREQ(faultOf({}), "too-short");
    EXPECT_STREQ(faultOf({0x10, 0}), "too-short");
    EXPECT_STREQ(faultOf({0x10, 1, 0x11}), "bad-length");
    EXPECT_STREQ(faultOf({0x10, 0, 0x11}), "bad-checksum");
    EXPECT_STREQ(faultOf({0x19, 0, 0x19}), "unknown-id");
    EXPECT_STREQ(faultOf({0x10, 1, 0, 0x11}), "bad-payload");
    EXPECT_STREQ(faultOf({0x10, 0, 0x10}), "none");
}

}  // namespace
}  // namespace kickstand::smartdevice::wire
