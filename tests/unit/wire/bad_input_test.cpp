// Every decoder on empty, short, long and random bytes: an answer each time, and what is accepted must encode
// to the bytes that it came from.
#include <functional>
#include <random>
#include <string>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/firmware.h"
#include "core/thunderbots/wire/generic.h"
#include "core/thunderbots/wire/indicator.h"
#include "core/thunderbots/wire/micropacket.h"
#include "core/thunderbots/wire/test_mode.h"
#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

/// Decodes, and encodes again what was accepted; empty where it was refused, by either.
using Echo = std::function<std::optional<Bytes>(ByteView)>;

template <auto decode, auto encode>
std::optional<Bytes> echo(ByteView bytes) {
    const auto decoded = decode(bytes);
    if (!decoded) return std::nullopt;
    const auto encoded = encode(*decoded);
    if constexpr (requires { encoded.has_value(); }) {
        if (!encoded) return std::nullopt;
        return bytesOf(*encoded);
    } else {
        return bytesOf(encoded);
    }
}

std::optional<Bytes> echoMessage(ByteView bytes) {
    for (const Direction direction : {Direction::Out, Direction::In}) {
        const auto message = decodeMessagePacket(bytes, direction);
        if (message)
            return bytesOf(encodeMessagePacket(message->robot, message->pipe, message->payload).value());
    }
    return std::nullopt;
}

struct Decoder {
    const char* name;
    Echo echo;
    std::vector<std::uint8_t>
        ignoredBits;  ///< Reserved bits, by byte: set in what comes in, never in what goes out.
};

const std::vector<Decoder>& decoders() {
    static const std::vector<Decoder> all{
        {"drive", echo<decodeDrive, encodeDrive>, {3, 0, 0, 0, 0, 0, 0, 0, 0, 1}},
        {"feedback", echo<decodeFeedback, encodeFeedback>, {0xF0}},
        {"kick", echo<decodeKick, encodeKick>, {0, 0, 0x80}},
        {"test mode", echo<decodeTestMode, encodeTestMode>, {}},
        {"indicator", echo<decodeIndicator, encodeIndicator>, {}},
        {"firmware request", echo<decodeFirmwareRequest, encodeFirmwareRequest>, {}},
        {"firmware response", echo<decodeFirmwareResponse, encodeFirmwareResponse>, {}},
        {"parameters", echo<decodeParameters, encodeParameters>, {}},
        {"status", echo<decodeStatus, encodeStatus>, {}},
        {"channels", echo<decodeChannels, encodeChannels>, {}},
        {"radio versions", echo<decodeRadioVersions, encodeRadioVersions>, {}},
        {"message packet", echoMessage, {}},
    };
    return all;
}

void expectAnswer(const Decoder& decoder, Bytes bytes) {
    const auto again = decoder.echo(bytes);
    if (!again) return;
    for (std::size_t i = 0; i < decoder.ignoredBits.size() && i < bytes.size(); ++i) {
        bytes[i] = static_cast<std::uint8_t>(bytes[i] & ~decoder.ignoredBits[i]);
    }
    ASSERT_EQ(*again, bytes) << decoder.name;
}

TEST(BadInput, EveryDecoderTakesEveryLengthOfEveryByte) {
    for (const Decoder& decoder : decoders()) {
        for (std::size_t length = 0; length <= 130; ++length) {
            for (const int value : {0x00, 0x01, 0x7F, 0x80, 0xFF}) {
                expectAnswer(decoder, Bytes(length, static_cast<std::uint8_t>(value)));
            }
        }
    }
}

TEST(BadInput, EveryDecoderTakesRandomBytes) {
    std::mt19937 random(10);
    for (const Decoder& decoder : decoders()) {
        for (int i = 0; i < 20'000; ++i) {
            Bytes bytes = randomBytes(random, static_cast<std::size_t>(between(random, 0, 70)));
            if (!bytes.empty() && i % 2 == 0) bytes[0] &= 0x0F;
            expectAnswer(decoder, std::move(bytes));
        }
    }
}

TEST(BadInput, EveryByteOfAStatePacketIsEitherReadOrCountedAsDropped) {
    std::mt19937 random(11);
    for (int i = 0; i < 50'000; ++i) {
        StatePacketBuilder builder;
        const int blocks = between(random, 0, 5);
        for (int robot = 0; robot < blocks; ++robot) {
            ASSERT_TRUE(builder.add(static_cast<std::uint8_t>(robot), randomDrive(random)).has_value());
        }
        Bytes packet = bytesOf(builder.packet());
        packet.resize(static_cast<std::size_t>(between(random, 0, 70)), static_cast<std::uint8_t>(random()));
        if (!packet.empty()) packet[random() % packet.size()] ^= static_cast<std::uint8_t>(random());
        MicropacketReader reader(packet, Direction::Out);
        std::size_t read = 0;
        bool failed = false;
        while (const auto next = reader.next()) {
            ASSERT_FALSE(failed);
            failed = !next->has_value();
            if (!failed) read += kMicropacketHeaderBytes + (*next)->payload.size();
        }
        ASSERT_EQ(read + reader.droppedBytes(), packet.size());
        ASSERT_EQ(failed, reader.droppedBytes() > 0);
    }
}

TEST(BadInput, TheNamedCodecTakesAnyTextAsAnyField) {
    std::mt19937 random(12);
    const char* const names[] = {"thunderbots.drive", "thunderbots.state-packet", "thunderbots.experiment"};
    const char* const fields[] = {"run",     "1.robot", "data", "999999999999.robot",
                                  "0.robot", ".",       "",     "-1.code"};
    for (int i = 0; i < 3'000; ++i) {
        const Bytes noise = randomBytes(random, static_cast<std::size_t>(between(random, 0, 12)));
        const std::vector<FieldText> given{{fields[random() % 8], std::string(noise.begin(), noise.end())}};
        const auto encoded = encodeMessage(names[random() % 3], given);
        if (!encoded) {
            ASSERT_NE(encoded.error().subject, "");
        }
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
