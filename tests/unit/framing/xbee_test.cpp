#include "core/framing/xbee.h"

#include <array>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/framing/xbee_parser.h"

namespace kickstand::xbee {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::vector<Bytes> framesIn(Parser& parser, ByteView input, std::size_t piece) {
    std::vector<Bytes> frames;
    for (std::size_t at = 0; at < input.size(); at += piece) {
        ByteView part = input.subspan(at, std::min(piece, input.size() - at));
        for (ByteView data = parser.next(part); !data.empty(); data = parser.next(part))
            frames.emplace_back(data.begin(), data.end());
        EXPECT_TRUE(part.empty());
    }
    return frames;
}

Bytes bytesOf(const LineFrame& frame) {
    return {frame.begin(), frame.end()};
}

TEST(Xbee, TransmitFrameAsTheProtocolPrintsIt) {
    const Bytes message{0x03, 0x70};
    const FrameData data = encodeFrame(Tx16{1, 0xAF05, 0, message});
    EXPECT_EQ(bytesOf(wrapFrame(data.view(), ApiMode::Plain)),
              (Bytes{0x7e, 0x00, 0x07, 0x01, 0x01, 0xaf, 0x05, 0x00, 0x03, 0x70, 0xd6}));
}

TEST(Xbee, ReceivedFrameTakenApart) {
    const Bytes line{0x7e, 0x00, 0x07, 0x81, 0xaf, 0x05, 0x28, 0x00, 0x23, 0xfb, 0x84};
    Parser parser;
    ByteView input = line;
    const auto frame = decodeFrame(parser.next(input));
    ASSERT_TRUE(frame && std::holds_alternative<Rx16>(*frame));
    const Rx16& rx = std::get<Rx16>(*frame);
    EXPECT_EQ(rx.source, 0xAF05);
    EXPECT_EQ(rx.rssi_dBm, -40);
    ASSERT_EQ(rx.payload.size(), 2U);
    EXPECT_EQ(rx.payload[1], 0xFB);
}

TEST(Xbee, TxStatusTakenApart) {
    const Bytes line{0x7e, 0x00, 0x03, 0x89, 0x01, 0x00, 0x75};
    Parser parser;
    ByteView input = line;
    const auto frame = decodeFrame(parser.next(input));
    ASSERT_TRUE(frame && std::holds_alternative<TxStatus>(*frame));
    EXPECT_EQ(std::get<TxStatus>(*frame).frameId, 1);
    EXPECT_EQ(std::get<TxStatus>(*frame).status, 0);
}

TEST(Xbee, EveryKindComesBack) {
    const Bytes payload{1, 2, 3};
    const Frame frames[] = {
        Tx16{9, 0x1234, 1, payload},       Rx16{0x4321, -255, 2, payload},        TxStatus{7, 3},
        AtCommand{4, {'M', 'Y'}, payload}, AtResponse{4, {'C', 'H'}, 0, payload}, ModemStatus{2},
        OtherFrame{0x80, payload}};
    for (const Frame& frame : frames) {
        const FrameData data = encodeFrame(frame);
        const auto back = decodeFrame(data.view());
        ASSERT_TRUE(back);
        EXPECT_EQ(back->index(), frame.index());
        EXPECT_EQ(encodeFrame(*back), data);
    }
}

TEST(Xbee, RefusesWhatIsTooShortOrTooLong) {
    for (const std::uint8_t type : Bytes{0x01, 0x08, 0x81, 0x88, 0x89, 0x8A})
        EXPECT_FALSE(decodeFrame(Bytes{type}));
    EXPECT_FALSE(decodeFrame({}));
    const Bytes tooMuch(kMaxPayload + 1);
    EXPECT_TRUE(encodeFrame(Tx16{1, 2, 0, tooMuch}).empty());
    EXPECT_TRUE(encodeFrame(Rx16{1, 5, 0, {}}).empty()) << "a strength above 0 dBm";
    EXPECT_TRUE(wrapFrame(Bytes(kMaxFrameData + 1), ApiMode::Plain).empty());
    EXPECT_TRUE(wrapFrame({}, ApiMode::Plain).empty());
}

TEST(Xbee, EscapesWhatControlsTheLine) {
    const Bytes data{0x23, 0x7E, 0x7D, 0x11, 0x13};
    const Bytes line = bytesOf(wrapFrame(data, ApiMode::Escaped));
    EXPECT_EQ(line, (Bytes{0x7E, 0x00, 0x05, 0x23, 0x7D, 0x5E, 0x7D, 0x5D, 0x7D, 0x31, 0x7D, 0x33, 0xBD}));
    Parser parser(ApiMode::Escaped);
    EXPECT_EQ(framesIn(parser, line, 1), std::vector<Bytes>{data});
}

class XbeeParser : public ::testing::TestWithParam<ApiMode> {};

TEST_P(XbeeParser, FindsFramesInAnyPiecesAmongNoise) {
    std::mt19937 random(7);
    Bytes stream;
    std::vector<Bytes> expected;
    for (int i = 0; i < 300; ++i) {
        Bytes data(1 + random() % kMaxFrameData);
        for (auto& byte : data)
            byte = static_cast<std::uint8_t>(random());
        const LineFrame line = wrapFrame(data, GetParam());
        stream.insert(stream.end(), line.begin(), line.end());
        expected.push_back(std::move(data));
        // Noise without a delimiter never costs a frame.
        for (std::size_t noise = random() % 5; noise > 0; --noise)
            stream.push_back(static_cast<std::uint8_t>(random() % 0x7E));
    }
    for (const std::size_t piece : {std::size_t{1}, std::size_t{3}, std::size_t{64}, stream.size()}) {
        Parser parser(GetParam());
        EXPECT_EQ(framesIn(parser, stream, piece), expected) << piece;
        EXPECT_EQ(parser.counters().frames, expected.size());
        EXPECT_EQ(parser.counters().damaged(), 0U);
    }
}

TEST_P(XbeeParser, PiecesMakeNoDifferenceToDamage) {
    std::mt19937 random(11);
    Bytes stream;
    for (int i = 0; i < 400; ++i) {
        Bytes data(1 + random() % 20);
        for (auto& byte : data)
            byte = static_cast<std::uint8_t>(random() % 3 == 0 ? kDelimiter : random());
        const LineFrame line = wrapFrame(data, GetParam());
        stream.insert(stream.end(), line.begin(), line.end());
        if (random() % 4 == 0) stream[stream.size() - 1 - random() % line.size()] ^= 0x40;
    }
    Parser whole(GetParam());
    const auto expected = framesIn(whole, stream, stream.size());
    EXPECT_GT(expected.size(), 200U);
    EXPECT_GT(whole.counters().damaged(), 10U);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{2}, std::size_t{7}, std::size_t{100}}) {
        Parser parser(GetParam());
        EXPECT_EQ(framesIn(parser, stream, piece), expected) << piece;
        EXPECT_EQ(parser.counters(), whole.counters()) << piece;
    }
}

/// Long frames full of bytes that API mode 2 marks, damaged by more of them: what is read in one go and what
/// is read byte by byte must not differ.
TEST_P(XbeeParser, MarkedBytesEverywhereMakeNoDifference) {
    constexpr std::array<std::uint8_t, 6> kMarked{kDelimiter, kEscape, 0x11, 0x13, 0x5D, 0x5E};
    std::mt19937 random(13);
    const auto marked = [&random, &kMarked] { return kMarked.at(random() % kMarked.size()); };
    Bytes stream;
    for (int i = 0; i < 3000; ++i) {
        const unsigned rarity = 1U << random() % 8;
        Bytes data(1 + random() % kMaxFrameData);
        for (auto& byte : data)
            byte = random() % rarity == 0 ? marked() : static_cast<std::uint8_t>(random());
        const LineFrame line = wrapFrame(data, GetParam());
        stream.insert(stream.end(), line.begin(), line.end());
        if (random() % 4 == 0) stream[stream.size() - 1 - random() % line.size()] = marked();
    }
    Parser whole(GetParam());
    const auto expected = framesIn(whole, stream, stream.size());
    EXPECT_GT(expected.size(), 2000U);
    EXPECT_GT(whole.counters().damaged(), 300U);
    for (const std::size_t piece : {std::size_t{1}, std::size_t{65}, std::size_t{200}, std::size_t{1000}}) {
        Parser parser(GetParam());
        EXPECT_EQ(framesIn(parser, stream, piece), expected) << piece;
        EXPECT_EQ(parser.counters(), whole.counters()) << piece;
    }
}

/// A frame with one escape, at each place of a line that is longer than a stripe.
TEST_P(XbeeParser, AnEscapeMayStandAnywhere) {
    for (std::size_t size : {std::size_t{60}, std::size_t{63}, std::size_t{64}, kMaxFrameData}) {
        for (std::size_t place = 0; place < size; ++place) {
            Bytes data(size, 0x20);
            data[place] = kEscape;
            Bytes stream = bytesOf(wrapFrame(data, GetParam()));
            stream.resize(stream.size() + 300, 0x20);
            Parser parser(GetParam());
            EXPECT_EQ(framesIn(parser, stream, stream.size()), std::vector<Bytes>{data}) << place;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Modes, XbeeParser, ::testing::Values(ApiMode::Plain, ApiMode::Escaped));

TEST(XbeeParser, FindsAFrameInsideADamagedOne) {
    const Bytes inner = bytesOf(wrapFrame(Bytes{0x89, 0x01, 0x00}, ApiMode::Plain));
    Bytes stream{0x7E, 0x00, 0x0C};
    stream.insert(stream.end(), inner.begin(), inner.end());
    stream.insert(stream.end(), 6, 0x00);
    for (const std::size_t piece : {std::size_t{1}, stream.size()}) {
        Parser parser;
        EXPECT_EQ(framesIn(parser, stream, piece), (std::vector<Bytes>{{0x89, 0x01, 0x00}}));
        EXPECT_EQ(parser.counters().badChecksum, 1U);
        EXPECT_EQ(parser.counters().skipped, stream.size() - inner.size());
    }
}

TEST(XbeeParser, DropsImpossibleLengths) {
    Parser parser;
    const Bytes stream{0x7E, 0x00, 0x00, 0x7E, 0x00, 0x6F, 0x7E, 0x01, 0x00, 0x7E, 0x00, 0x01, 0x55, 0xAA};
    EXPECT_EQ(framesIn(parser, stream, 1), (std::vector<Bytes>{{0x55}}));
    EXPECT_EQ(parser.counters().badLength, 3U);
}

TEST(XbeeParser, TheFrameStaysWholeUntilTheNextCall) {
    const Bytes first = bytesOf(wrapFrame(Bytes{1, 2, 3}, ApiMode::Plain));
    Parser parser;
    ByteView head = ByteView(first).first(4);
    EXPECT_TRUE(parser.next(head).empty());
    Bytes rest(first.begin() + 4, first.end());
    ByteView tail = rest;
    const ByteView data = parser.next(tail);
    rest.assign(rest.size(), 0);
    EXPECT_EQ(Bytes(data.begin(), data.end()), (Bytes{1, 2, 3}));
}

TEST(XbeeParser, ResetForgetsTheBeginning) {
    Parser parser;
    const Bytes begun{0x7E, 0x00, 0x05, 0x01};
    ByteView input = begun;
    EXPECT_TRUE(parser.next(input).empty());
    parser.reset(ApiMode::Escaped);
    EXPECT_EQ(parser.mode(), ApiMode::Escaped);
    EXPECT_EQ(parser.counters().skipped, begun.size());
    EXPECT_EQ(framesIn(parser, bytesOf(wrapFrame(Bytes{0x8A, 0x00}, ApiMode::Escaped)), 1).size(), 1U);
}

}  // namespace
}  // namespace kickstand::xbee
