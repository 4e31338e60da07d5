#include "core/thunderbots/wire/message_packet.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(MessagePackets, CarryHeaderAndPayload) {
    EXPECT_EQ(bytesOf(encodeMessagePacket(11, Pipe::Kick, hex("cb 80 00")).value()), hex("b2 cb 80 00"));
    const Bytes packet = hex("36");
    const auto decoded = decodeMessagePacket(packet, Direction::In);
    ASSERT_TRUE(decoded.has_value());
    EXPECT_EQ(decoded->robot, 3);
    EXPECT_EQ(decoded->pipe, Pipe::Indicator);
    EXPECT_TRUE(decoded->payload.empty());
}

TEST(MessagePackets, EveryPipePassesOnlyInItsDirection) {
    const auto allowed = [](int pipe, Direction direction) {
        if (direction == Direction::Out) return pipe == 2 || pipe == 3 || pipe == 5;
        return pipe == 4 || pipe == 6;
    };
    for (int header = 0; header < 256; ++header) {
        for (const Direction direction : {Direction::Out, Direction::In}) {
            const Bytes packet{static_cast<std::uint8_t>(header), 1, 2};
            const auto decoded = decodeMessagePacket(packet, direction);
            ASSERT_EQ(decoded.has_value(), allowed(header & 15, direction)) << header;
            if (!decoded) {
                expectFault(decoded, WireFault::UnknownKind, "pipe");
                continue;
            }
            EXPECT_EQ(decoded->robot, header >> 4);
            EXPECT_EQ(bytesOf(encodeMessagePacket(decoded->robot, decoded->pipe, decoded->payload).value()),
                      packet);
        }
    }
}

TEST(MessagePackets, LengthsAreBounded) {
    EXPECT_EQ(encodeMessagePacket(0, Pipe::Kick, Bytes(63)).value().size(), 64U);
    expectFault(encodeMessagePacket(0, Pipe::Kick, Bytes(64)), WireFault::TooLong, "length");
    Bytes packet(64);
    packet[0] = 0x02;
    EXPECT_EQ(decodeMessagePacket(packet, Direction::Out).value().payload.size(), 63U);
    packet.push_back(0);
    expectFault(decodeMessagePacket(packet, Direction::Out), WireFault::TooLong, "length");
    expectFault(decodeMessagePacket({}, Direction::Out), WireFault::TooShort, "length");
}

TEST(MessagePackets, NoSuchRobotOrPipeIsSentTo) {
    expectFault(encodeMessagePacket(16, Pipe::Kick, {}), WireFault::OutOfRange, "robot");
    expectFault(encodeMessagePacket(0, Pipe::Drive, {}), WireFault::UnknownKind, "pipe");
    expectFault(encodeMessagePacket(0, Pipe::Feedback, {}), WireFault::UnknownKind, "pipe");
    expectFault(encodeMessagePacket(0, static_cast<Pipe>(7), {}), WireFault::UnknownKind, "pipe");
}

TEST(Pipes, KnowTheirNumberTypeAndDirection) {
    for (std::uint8_t number = 0; number < 16; ++number) {
        EXPECT_EQ(pipeFromNumber(number).has_value(), number < kPipeCount) << int{number};
    }
    EXPECT_EQ(typeOf(Pipe::Drive), PipeType::StateTransport);
    EXPECT_EQ(typeOf(Pipe::Feedback), PipeType::StateTransport);
    EXPECT_EQ(typeOf(Pipe::Indicator), PipeType::Message);
    EXPECT_EQ(directionOf(Pipe::Drive), Direction::Out);
    EXPECT_EQ(directionOf(Pipe::Feedback), Direction::In);
    EXPECT_STREQ(name(Pipe::FirmwareRequest), "firmware-request");
    EXPECT_STREQ(name(static_cast<Pipe>(9)), "reserved");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
