#include "core/thunderbots/wire/micropacket.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

/// Everything a reader gives: the robots it found, and the error that ended the packet, if one did.
struct Reading {
    std::vector<int> robots;
    std::optional<WireError> error;
    std::size_t dropped = 0;
};

Reading readAll(ByteView packet, Direction direction) {
    Reading reading;
    MicropacketReader reader(packet, direction);
    while (const auto next = reader.next()) {
        if (*next) {
            reading.robots.push_back((*next)->robot);
        } else {
            EXPECT_FALSE(reading.error) << "one error ends the packet";
            reading.error = next->error();
        }
    }
    reading.dropped = reader.droppedBytes();
    return reading;
}

TEST(StatePackets, CarryAtMostFiveDriveBlocks) {
    std::mt19937 random(7);
    StatePacketBuilder builder;
    std::vector<DriveBlock> blocks;
    for (std::uint8_t robot = 0; robot < kMaxMicropackets; ++robot) {
        EXPECT_FALSE(builder.full());
        blocks.push_back(randomDrive(random));
        ASSERT_TRUE(builder.add(robot, blocks.back()).has_value());
    }
    EXPECT_TRUE(builder.full());
    expectFault(builder.add(5, brakedBlock()), WireFault::TooLong, "length");
    EXPECT_EQ(builder.packet().size(), 60U);

    MicropacketReader reader(builder.packet(), Direction::Out);
    for (std::uint8_t robot = 0; robot < kMaxMicropackets; ++robot) {
        const auto next = reader.next();
        ASSERT_TRUE(next && *next);
        EXPECT_EQ((*next)->robot, robot);
        EXPECT_EQ(decodeDrive((*next)->payload).value(), blocks[robot]);
    }
    EXPECT_FALSE(reader.next());
    EXPECT_EQ(reader.droppedBytes(), 0U);
}

TEST(StatePackets, CarryAtMostFiveFeedbackBlocks) {
    StatePacketBuilder builder;
    for (std::uint8_t robot = 11; robot < 16; ++robot) {
        FeedbackBlock block;
        block.battery_adc = robot;
        ASSERT_TRUE(builder.add(robot, block).has_value());
    }
    expectFault(builder.add(0, FeedbackBlock{}), WireFault::TooLong, "length");
    EXPECT_EQ(builder.packet().size(), 55U);
    EXPECT_EQ(readAll(builder.packet(), Direction::In).robots, (std::vector<int>{11, 12, 13, 14, 15}));
    builder.clear();
    EXPECT_EQ(builder.count(), 0U);
    EXPECT_TRUE(builder.packet().empty());
}

TEST(StatePackets, StandAsTheReferenceHasThem) {
    StatePacketBuilder builder;
    DriveBlock block;
    block.run = true;
    ASSERT_TRUE(builder.add(11, block).has_value());
    EXPECT_EQ(bytesOf(builder.packet()), hex("0c b0 80 00 00 00 00 00 00 00 00 00"));
}

TEST(StatePackets, ABuilderRefusesWhatCannotBeSentAndStaysAsItWas) {
    StatePacketBuilder builder;
    expectFault(builder.add(16, brakedBlock()), WireFault::OutOfRange, "robot");
    DriveBlock block;
    block.wheels[2] = -1024;
    expectFault(builder.add(0, block), WireFault::OutOfRange, "wheel3");
    FeedbackBlock feedback;
    feedback.light_adc = 1024;
    expectFault(builder.add(0, feedback), WireFault::OutOfRange, "light");
    EXPECT_TRUE(builder.packet().empty());
}

TEST(StatePackets, AnEmptyPacketIsAKeepAlive) {
    const Reading reading = readAll({}, Direction::Out);
    EXPECT_TRUE(reading.robots.empty());
    EXPECT_FALSE(reading.error);
}

TEST(StatePackets, TheRestBehindADamagedMicropacketIsDroppedAndCounted) {
    const Bytes good = hex("0c 10 80 00 00 00 00 00 00 00 00 00");
    struct Case {
        const char* damage;
        WireFault fault;
    };
    for (const auto& [damage, fault] :
         {Case{"0c", WireFault::TooShort}, Case{"00 10", WireFault::BadLength},
          Case{"01 10 00", WireFault::BadLength}, Case{"0c 10 80", WireFault::BadLength},
          Case{"ff 10 80", WireFault::BadLength}, Case{"0b 10 80", WireFault::BadLength},
          Case{"0c 11 80", WireFault::UnknownKind}, Case{"0c 1f 80", WireFault::UnknownKind}}) {
        Bytes packet = good;
        const Bytes rest = hex(damage);
        packet.insert(packet.end(), rest.begin(), rest.end());
        const Reading reading = readAll(packet, Direction::Out);
        EXPECT_EQ(reading.robots, std::vector<int>{1}) << damage;
        ASSERT_TRUE(reading.error) << damage;
        EXPECT_STREQ(name(reading.error->fault), name(fault)) << damage;
        EXPECT_EQ(reading.dropped, rest.size()) << damage;
    }
}

TEST(StatePackets, PacketsPast64BytesAreRefusedWhole) {
    Bytes packet;
    for (int i = 0; i < 6; ++i) {
        const Bytes one = hex("0c 10 80 00 00 00 00 00 00 00 00 00");
        packet.insert(packet.end(), one.begin(), one.end());
    }
    const Reading reading = readAll(packet, Direction::Out);
    EXPECT_TRUE(reading.robots.empty());
    ASSERT_TRUE(reading.error);
    EXPECT_EQ(reading.error->fault, WireFault::TooLong);
    EXPECT_EQ(reading.dropped, 72U);
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
