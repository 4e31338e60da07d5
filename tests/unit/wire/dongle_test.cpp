#include "core/thunderbots/wire/dongle.h"

#include "tests/unit/wire/wire_testing.h"

namespace kickstand::thunderbots::wire {
namespace {

using namespace testing;

TEST(Status, TellsEStopRadiosAndWhoIsAlive) {
    const auto status = decodeStatus(hex("03 03 81 80")).value();
    EXPECT_EQ(status.eStop, EStop::Run);
    EXPECT_EQ(status.radios, RadioState::Running);
    for (std::uint8_t robot = 0; robot < 32; ++robot) {
        EXPECT_EQ(status.alive(robot), robot == 0 || robot == 7 || robot == 15) << int{robot};
    }
}

TEST(Status, EveryLegalPacketComesBackAndNoOtherIsTaken) {
    for (int eStop = 0; eStop < 256; ++eStop) {
        for (int radios = 0; radios < 256; ++radios) {
            const Bytes packet{static_cast<std::uint8_t>(eStop), static_cast<std::uint8_t>(radios), 0x34,
                               0x12};
            const auto status = decodeStatus(packet);
            ASSERT_EQ(status.has_value(), eStop <= 3 && radios <= 5) << eStop << ' ' << radios;
            if (status) {
                ASSERT_EQ(bytesOf(encodeStatus(*status)), packet);
            }
        }
    }
    expectFault(decodeStatus(hex("04 00 00 00")), WireFault::BadValue, "estop");
    expectFault(decodeStatus(hex("00 06 00 00")), WireFault::BadValue, "radios");
    expectFault(decodeStatus(hex("03 03 00")), WireFault::TooShort, "length");
    expectFault(decodeStatus(hex("03 03 00 00 00")), WireFault::TooLong, "length");
}

TEST(Status, NamesItsStates) {
    EXPECT_STREQ(name(EStop::Run), "run");
    EXPECT_STREQ(name(EStop::Disconnected), "disconnected");
    EXPECT_STREQ(name(RadioState::Radio1Failed), "radio-1-failed");
    EXPECT_STREQ(name(static_cast<EStop>(9)), "undefined");
    EXPECT_STREQ(name(static_cast<RadioState>(9)), "undefined");
}

TEST(ChannelRequests, PutChannel0Low) {
    EXPECT_EQ(encodeChannelsValue({0x0B, 0x1A}).value(), 0x1A0B);
    EXPECT_EQ(bytesOf(encodeChannels({0x0B, 0x1A}).value()), hex("0b 1a"));
    EXPECT_EQ(decodeChannels(hex("0e 0f")).value(), Channels{});
    EXPECT_EQ(decodeChannelsValue(0x1A0B).value(), (Channels{0x0B, 0x1A}));
}

TEST(ChannelRequests, TakeOnlyChannelsThatExist) {
    for (int value = 0; value < 65536; ++value) {
        const auto fits = [](int channel) { return channel >= 0x0B && channel <= 0x1A; };
        const auto channels = decodeChannelsValue(static_cast<std::uint16_t>(value));
        ASSERT_EQ(channels.has_value(), fits(value & 255) && fits(value >> 8)) << value;
        if (channels) {
            ASSERT_EQ(encodeChannelsValue(*channels).value(), value);
        }
    }
    expectFault(encodeChannelsValue({0x0A, 0x0F}), WireFault::OutOfRange, "channel0");
    expectFault(encodeChannels({0x0E, 0x1B}), WireFault::OutOfRange, "channel1");
    expectFault(decodeChannels(hex("0e")), WireFault::TooShort, "length");
    expectFault(decodeChannels(hex("0e 0f 10")), WireFault::TooLong, "length");
}

TEST(RadioVersionReplies, AreLittleEndian) {
    EXPECT_EQ(decodeRadioVersions(hex("cd 10 e6 10")).value(), (RadioVersions{0x10CD, 0x10E6}));
    EXPECT_EQ(bytesOf(encodeRadioVersions({0x10CD, 0x10E6})), hex("cd 10 e6 10"));
    expectFault(decodeRadioVersions(hex("cd 10 e6")), WireFault::TooShort, "length");
    expectFault(decodeRadioVersions(hex("cd 10 e6 10 00")), WireFault::TooLong, "length");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
