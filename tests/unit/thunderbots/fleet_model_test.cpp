#include "core/thunderbots/fleet_model.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/thunderbots/wire/readings.h"
#include "tests/unit/thunderbots/model_testing.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;
using testing::readings;
using testing::SampleRecorder;
using wire::Endpoint;

class FleetModelTest : public ::testing::Test {
  protected:
    std::vector<Event> of(EventKind kind) const {
        std::vector<Event> found;
        std::ranges::copy_if(events, std::back_inserter(found),
                             [kind](const Event& event) { return event.kind == kind; });
        return found;
    }
    const RobotState& robot(int number) const { return model.robot(number); }
    /// The link is open, the radios run, robots 0-3 are alive.
    void begin() {
        wire.opened();
        wire.status(0b1111);
    }

    SampleRecorder samples;
    std::vector<Event> events;
    FleetModel model{samples, [this](const Event& event) { events.push_back(event); }};
    testing::Wire wire{model};
};

TEST_F(FleetModelTest, KnowsNothingBeforeAnythingPassed) {
    EXPECT_FALSE(model.isOpen());
    EXPECT_EQ(robot(0).freshness, Freshness::NotHeard);
    EXPECT_FALSE(robot(0).feedback);
    EXPECT_FALSE(robot(0).capacitor);
    EXPECT_FALSE(robot(0).told);
}

// What can be said of a reading, by what has passed (protocol 6.9).
TEST_F(FleetModelTest, ARobotThatIsAliveAndHasSaidNothingIsWaitedFor) {
    begin();
    EXPECT_TRUE(robot(0).live);
    EXPECT_EQ(robot(0).freshness, Freshness::Waiting);
    EXPECT_EQ(robot(4).freshness, Freshness::NotHeard);
    EXPECT_EQ(of(EventKind::RobotFound).size(), 4U);
}

TEST_F(FleetModelTest, SilenceIsNotAge) {
    begin();
    wire.feedback(0, readings(900, 0));
    wire.pass(1h);
    model.tick(wire.now());
    EXPECT_EQ(robot(0).freshness, Freshness::Current);
}

TEST_F(FleetModelTest, ReadingsOfARobotThatIsNotAliveAreStale) {
    begin();
    wire.feedback(9, readings(900, 100));
    EXPECT_EQ(robot(9).freshness, Freshness::Stale);
    EXPECT_TRUE(samples.entries.empty()) << "nobody can say how long they hold";
    wire.status(1U << 9);
    EXPECT_EQ(robot(9).freshness, Freshness::Current);
    EXPECT_EQ(samples.entries.size(), 4U);
}

TEST_F(FleetModelTest, ALostRobotIsStaleSinceItWasLastAlive) {
    begin();
    wire.feedback(1, readings(900, 100));
    wire.pass(10s);
    wire.status(0b1101);
    const TimePoint lost = wire.now();
    EXPECT_FALSE(robot(1).live);
    EXPECT_EQ(robot(1).freshness, Freshness::Stale);
    EXPECT_EQ(robot(1).currentUntil, lost);
    ASSERT_EQ(samples.entries.size(), 8U);
    for (std::size_t i = 4; i < 8; ++i) {
        EXPECT_FALSE(samples.entries[i].value) << "a gap for each signal";
        EXPECT_EQ(samples.entries[i].time, lost);
    }
    wire.status(0b1111);
    EXPECT_EQ(robot(1).freshness, Freshness::Current) << "what has not changed is not sent again";
}

TEST_F(FleetModelTest, ReadingsAreStaleWhenTheRadiosDoNotRun) {
    begin();
    wire.feedback(1, readings(900, 100));
    wire.status(0b1111, wire::EStop::Run, wire::RadioState::InitRadio0);
    EXPECT_EQ(robot(1).freshness, Freshness::Stale);
    EXPECT_FALSE(robot(1).live);
}

TEST_F(FleetModelTest, ReadingsAreStaleWhenTheLinkIsLostAndUntilTheNextOneBringsNewOnes) {
    begin();
    wire.feedback(1, readings(900, 100));
    wire.lost();
    EXPECT_EQ(robot(1).freshness, Freshness::Stale);
    EXPECT_EQ(of(EventKind::RobotLost).size(), 4U);
    wire.opened();
    EXPECT_EQ(robot(1).freshness, Freshness::Stale);
    wire.status(0b1111);
    EXPECT_EQ(robot(1).freshness, Freshness::Stale) << "an old number must not look fresh";
    EXPECT_TRUE(robot(1).feedback) << "what was last seen is remembered";
    wire.feedback(1, readings(900, 100));
    EXPECT_EQ(robot(1).freshness, Freshness::Current);
}

TEST_F(FleetModelTest, WithoutTheValidBitReadingsAreUnknownAndNotZero) {
    begin();
    wire.feedback(0, readings(900, 2000));
    wire::FeedbackBlock invalid;
    wire.feedback(0, invalid);
    EXPECT_EQ(robot(0).freshness, Freshness::Stale);
    EXPECT_DOUBLE_EQ(robot(0).readings.battery_V, wire::battery_V(900));
    ASSERT_TRUE(robot(0).capacitor);
    EXPECT_DOUBLE_EQ(robot(0).capacitor->last_V, wire::capacitor_V(2000));
    EXPECT_FALSE(samples.entries.back().value);
    wire.feedback(2, invalid);
    EXPECT_EQ(robot(2).freshness, Freshness::Waiting);
    EXPECT_FALSE(robot(2).feedback);
}

TEST_F(FleetModelTest, TurnsReadingsIntoVoltsAndSamples) {
    begin();
    wire.feedback(2, readings(900, 2000));
    EXPECT_DOUBLE_EQ(robot(2).readings.capacitor_V, wire::capacitor_V(2000));
    EXPECT_DOUBLE_EQ(robot(2).readings.dribbler_C, wire::dribbler_C(400));
    EXPECT_EQ(robot(2).readings.light_adc, 17);
    const std::vector<SampleRecorder::Entry> expected{
        {{2, 0}, wire.now(), static_cast<float>(wire::battery_V(900))},
        {{2, 1}, wire.now(), static_cast<float>(wire::capacitor_V(2000))},
        {{2, 2}, wire.now(), static_cast<float>(wire::dribbler_C(400))},
        {{2, 3}, wire.now(), 17.0F}};
    EXPECT_EQ(samples.entries, expected);
}

TEST_F(FleetModelTest, RemembersALiveCapacitorWhenItsRobotIsLost) {
    begin();
    wire.feedback(0, readings(900, 3900));
    wire.pass(5s);
    wire.status(0);
    const auto lost = of(EventKind::RobotLost);
    ASSERT_FALSE(lost.empty());
    EXPECT_EQ(lost.front().robot, 0);
    EXPECT_DOUBLE_EQ(lost.front().value, wire::capacitor_V(3900));
    EXPECT_DOUBLE_EQ(lost.back().value, 0) << "robot 3 never told of any volts";
    EXPECT_EQ(robot(0).capacitor->at, wire.now()) << "it was so until now";
    wire.lost();
    wire.opened();
    EXPECT_DOUBLE_EQ(robot(0).capacitor->last_V, wire::capacitor_V(3900));
}

TEST_F(FleetModelTest, TellsOfALowBatteryOnceAMark) {
    begin();
    const auto volts = [this](double value) { wire.feedback(0, readings(wire::battery_adc(value), 0)); };
    for (const double value : {16.0, 14.9, 15.05, 14.95, 13.9, 13.8, 14.1, 13.9})
        volts(value);
    auto low = of(EventKind::BatteryLow);
    ASSERT_EQ(low.size(), 2U);
    EXPECT_EQ(low[0].code, 1);
    EXPECT_EQ(low[1].code, 2);
    volts(16.0);
    volts(14.9);
    EXPECT_EQ(of(EventKind::BatteryLow).size(), 3U) << "after it had recovered it is news again";
}

TEST_F(FleetModelTest, CountsAutokicksAndSaysWhen) {
    begin();
    for (int i = 0; i < 3; ++i)
        wire.message(Endpoint::MessageIn, 2, wire::Pipe::Indicator, {});
    EXPECT_EQ(robot(2).autokicks, 3U);
    EXPECT_EQ(robot(2).lastAutokickAt, wire.now());
    EXPECT_EQ(of(EventKind::Autokick).back().code, 3);
    EXPECT_EQ(robot(1).autokicks, 0U);
}

TEST_F(FleetModelTest, PutsExperimentDataTogetherAndKnowsItsGaps) {
    begin();
    const auto piece = [this](std::uint8_t offset, std::uint8_t fill) {
        std::vector<std::uint8_t> payload(33, fill);
        payload[0] = offset;
        wire.message(Endpoint::MessageIn, 1, wire::Pipe::Indicator, payload);
    };
    piece(0, 1);
    piece(224, 2);
    piece(40, 3);
    piece(16, 4);
    const ExperimentBuffer& buffer = robot(1).experiment;
    EXPECT_EQ(buffer.messages, 4U);
    EXPECT_EQ(buffer.known.count(), 16U + 32U + 24U + 32U);
    EXPECT_EQ(buffer.data[15], 1);
    EXPECT_EQ(buffer.data[16], 4) << "the newest counts where they overlap";
    EXPECT_EQ(buffer.data[48], 3);
    EXPECT_EQ(buffer.data[255], 2);
    EXPECT_FALSE(buffer.known[72]);
    EXPECT_FALSE(buffer.known[223]);
    EXPECT_EQ(of(EventKind::ExperimentData).back().code, 104);
}

TEST_F(FleetModelTest, ReportsExperimentOffsetsPastTheLastLegalOne) {
    begin();
    std::vector<std::uint8_t> payload(33, 7);
    for (const std::uint8_t offset : std::vector<std::uint8_t>{225, 255}) {
        payload[0] = offset;
        wire.message(Endpoint::MessageIn, 1, wire::Pipe::Indicator, payload);
    }
    EXPECT_EQ(robot(1).experiment.rejected, 2U);
    EXPECT_EQ(robot(1).experiment.messages, 0U);
    EXPECT_TRUE(robot(1).experiment.known.none());
    EXPECT_EQ(model.traffic().malformed, 2U);
    EXPECT_FALSE(of(EventKind::Malformed).empty());
}

TEST_F(FleetModelTest, ForgetsTheExperimentOfOneRobotAlone) {
    begin();
    const std::vector<std::uint8_t> payload(33, 7);
    for (const int robot : {1, 2})
        wire.message(Endpoint::MessageIn, robot, wire::Pipe::Indicator, payload);
    model.clearExperiment(1);
    EXPECT_TRUE(robot(1).experiment.known.none());
    EXPECT_EQ(robot(1).experiment.messages, 0U);
    EXPECT_EQ(robot(2).experiment.known.count(), 32U);
}

TEST_F(FleetModelTest, KnowsWhatEachRobotWasToldOnThisConnection) {
    begin();
    wire::DriveBlock block;
    block.run = true;
    block.charge = true;
    block.wheels = {1, -2, 3, -4};
    wire.drive(3, block);
    EXPECT_EQ(robot(3).told, block);
    EXPECT_EQ(robot(3).toldAt, wire.now());
    EXPECT_EQ(of(EventKind::Charger).back().code, 1);
    wire.lost();
    wire.opened();
    EXPECT_FALSE(robot(3).told);
}

TEST_F(FleetModelTest, TakesOnlyWhatTheLinkTookForTold) {
    begin();
    wire::StatePacketBuilder packet;
    ASSERT_TRUE(packet.add(0, wire::brakedBlock()));
    for (const UsbStatus status : {UsbStatus::Stalled, UsbStatus::Cancelled, UsbStatus::NoDevice})
        wire.bytes(Endpoint::StateOut, packet.packet(), status);
    EXPECT_FALSE(robot(0).told);
    EXPECT_EQ(model.traffic().packetsOut, 0U);
    EXPECT_EQ(model.traffic().stalls, 1U);
}

TEST_F(FleetModelTest, CountsKicksGivenAndRemembersTheTestMode) {
    begin();
    const wire::KickTimes kick{true, true, 75, 0, 0};
    wire.message(Endpoint::MessageOut, 2, wire::Pipe::Kick, wire::encodeKick(kick).value());
    EXPECT_EQ(robot(2).kicks, 1U);
    EXPECT_EQ(robot(2).lastKick, kick);
    EXPECT_EQ(of(EventKind::KickGiven).back().code, 2400);
    const wire::TestMode mode{wire::TestClass::Hall, 5};
    wire.message(Endpoint::MessageOut, 2, wire::Pipe::TestMode, wire::encodeTestMode(mode).value());
    EXPECT_EQ(robot(2).toldTestMode, mode);
    EXPECT_EQ(robot(2).toldTestModeAt, wire.now());
}

TEST_F(FleetModelTest, KnowsSinceWhenADriveBlockHasAskedForATestMode) {
    begin();
    wire::DriveBlock block = wire::brakedBlock();
    block.testClass = 3;
    block.testTarget = 2;
    wire.drive(4, block);
    const TimePoint asked = wire.now();
    EXPECT_EQ(robot(4).blockTestModeAt, asked);
    block.dribble = true;
    wire.drive(4, block);
    EXPECT_EQ(robot(4).blockTestModeAt, asked) << "the same mode goes on";
    block.testTarget = 3;
    wire.drive(4, block);
    EXPECT_EQ(robot(4).blockTestModeAt, wire.now());
    EXPECT_FALSE(robot(4).toldTestMode) << "no message was sent";
}

TEST_F(FleetModelTest, ReadsChannelsAndVersionsOffTheControlTransfers) {
    begin();
    const UsbSetup channels{wire::kVendorIn, 1, 0, 0, 2};
    const UsbSetup versions{wire::kVendorIn, 0, 0, 0, 4};
    wire.control(channels, std::vector<std::uint8_t>{0x0C, 0x19});
    wire.control(versions, std::vector<std::uint8_t>{0xE8, 0x10, 0x34, 0x12});
    EXPECT_EQ(model.channels(), (wire::Channels{0x0C, 0x19}));
    EXPECT_EQ(model.radioVersions(), (wire::RadioVersions{0x10E8, 0x1234}));
    wire.control(channels, std::vector<std::uint8_t>{0x0C});
    wire.control(versions, std::vector<std::uint8_t>{});
    EXPECT_EQ(model.traffic().malformed, 2U);
}

TEST_F(FleetModelTest, TellsOfTheEmergencyStopAndTheRadios) {
    wire.opened();
    wire.status(0, wire::EStop::Stop, wire::RadioState::InitRadio0);
    wire.status(0, wire::EStop::Run, wire::RadioState::Running);
    const auto stops = of(EventKind::EmergencyStop);
    ASSERT_EQ(stops.size(), 2U);
    EXPECT_EQ(stops[1].code, static_cast<int>(wire::EStop::Run));
    EXPECT_EQ(stops[1].previous, static_cast<int>(wire::EStop::Stop));
    EXPECT_EQ(of(EventKind::Radios).size(), 2U);
    wire.status(0, wire::EStop::Run, wire::RadioState::Running);
    EXPECT_EQ(of(EventKind::EmergencyStop).size(), 2U) << "what has not changed is no news";
}

TEST_F(FleetModelTest, TellsEveryCodeOfTheErrorQueue) {
    begin();
    wire.bytes(Endpoint::ErrorQueue, std::vector<std::uint8_t>{41, 111, 200});
    const auto faults = of(EventKind::DongleFault);
    ASSERT_EQ(faults.size(), 3U);
    EXPECT_EQ(faults[2].code, 200);
    EXPECT_EQ(model.traffic().dongleErrors, 3U);
}

// Bytes from outside: every endpoint, damaged in every way, is counted and told, and breaks nothing.
TEST_F(FleetModelTest, CountsAndTellsWhateverIsDamaged) {
    begin();
    struct Case {
        Endpoint endpoint;
        std::vector<std::uint8_t> bytes;
    };
    const std::vector<Case> cases{
        {Endpoint::Status, {}},
        {Endpoint::Status, {3, 3, 0}},
        {Endpoint::Status, {3, 3, 0, 0, 0}},
        {Endpoint::Status, {4, 3, 0, 0}},
        {Endpoint::Status, {3, 6, 0, 0}},
        {Endpoint::StateIn, {11}},
        {Endpoint::StateIn, {0, 0x01}},
        {Endpoint::StateIn, {11, 0x01, 1}},
        {Endpoint::StateIn, {12, 0x01, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
        {Endpoint::StateIn, {11, 0x00, 1, 0, 0, 0, 0, 0, 0, 0, 0}},
        {Endpoint::StateIn, {11, 0x01, 1, 0xFF, 0xFF, 0, 0, 0, 0, 0, 0}},
        {Endpoint::MessageIn, {}},
        {Endpoint::MessageIn, {0x02}},
        {Endpoint::MessageIn, {0x0F}},
        {Endpoint::MessageIn, {0x06, 1}},
    };
    std::uint64_t expected = 0;
    for (const Case& damaged : cases) {
        wire.pass(1s);
        wire.bytes(damaged.endpoint, damaged.bytes);
        EXPECT_EQ(model.traffic().malformed, ++expected)
            << int{wire::address(damaged.endpoint)} << " case " << expected;
        const auto told = of(EventKind::Malformed);
        ASSERT_EQ(told.size(), expected);
        EXPECT_EQ(told.back().code, wire::address(damaged.endpoint));
        EXPECT_FALSE(told.back().text.empty());
    }
    EXPECT_EQ(robot(0).freshness, Freshness::Waiting) << "nothing of it was believed";
}

TEST_F(FleetModelTest, CountsAnOverlongPacket) {
    begin();
    wire.bytes(Endpoint::StateIn, {}, UsbStatus::Overflow);
    EXPECT_EQ(model.traffic().malformed, 1U);
}

TEST_F(FleetModelTest, KeepsWhatStoodBeforeTheDamageInAPacket) {
    begin();
    wire::StatePacketBuilder packet;
    ASSERT_TRUE(packet.add(0, readings(900, 0)));
    std::vector<std::uint8_t> bytes(packet.packet().begin(), packet.packet().end());
    bytes.push_back(99);
    wire.bytes(Endpoint::StateIn, bytes);
    EXPECT_EQ(robot(0).freshness, Freshness::Current);
    EXPECT_EQ(model.traffic().malformed, 1U);
}

TEST_F(FleetModelTest, TellsOfAFloodOfDamageNowAndThenWithoutLosingCount) {
    begin();
    for (int i = 0; i < 500; ++i)
        wire.bytes(Endpoint::MessageIn, {});
    model.tick(wire.now() + 200ms);
    const auto told = of(EventKind::Malformed);
    EXPECT_LE(told.size(), 4U);
    double sum = 0;
    for (const Event& event : told)
        sum += event.value;
    EXPECT_EQ(sum, 500);
}

TEST_F(FleetModelTest, TellsTheRestOfTheDamageWhenTheLinkEnds) {
    begin();
    for (int i = 0; i < 3; ++i)
        wire.bytes(Endpoint::MessageIn, {});
    wire.closed();
    double sum = 0;
    for (const Event& event : of(EventKind::Malformed))
        sum += event.value;
    EXPECT_EQ(sum, 3);
}

TEST_F(FleetModelTest, TellsDebugTextByLinesOfBoundedLength) {
    begin();
    const auto text = [this](std::string_view piece) {
        wire.bytes(Endpoint::DebugText, std::vector<std::uint8_t>(piece.begin(), piece.end()));
    };
    text("ra");
    text("dio 0\r\n\nup\n");
    auto told = of(EventKind::DongleText);
    ASSERT_EQ(told.size(), 2U);
    EXPECT_EQ(told[0].text, "radio 0");
    EXPECT_EQ(told[1].text, "up");
    text(
        "a\x01\xFF"
        "b\n");
    EXPECT_EQ(of(EventKind::DongleText).back().text, "a??b");
    for (int i = 0; i < 100; ++i)
        text(std::string(64, 'x'));
    std::size_t characters = 0;
    for (const Event& event : of(EventKind::DongleText)) {
        EXPECT_LE(event.text.size(), 256U);
        characters += static_cast<std::size_t>(std::ranges::count(event.text, 'x'));
    }
    EXPECT_GE(characters, 6400U - 256U);
    wire.closed();
    characters = 0;
    for (const Event& event : of(EventKind::DongleText))
        characters += static_cast<std::size_t>(std::ranges::count(event.text, 'x'));
    EXPECT_EQ(characters, 6400U) << "what has no end of line is told at the end of the link";
}

TEST_F(FleetModelTest, MeasuresTheRateOfPacketsOverASecond) {
    model.tick(wire.now());
    begin();
    const TimePoint since = wire.now() + 1s;
    model.tick(since);
    for (int i = 0; i < 50; ++i)
        wire.feedback(0, readings(900, 0));
    model.tick(since + 1s);
    EXPECT_DOUBLE_EQ(model.traffic().packets_per_s, 50);
    model.tick(since + 2s);
    EXPECT_DOUBLE_EQ(model.traffic().packets_per_s, 0);
}

TEST_F(FleetModelTest, EveryChangeRaisesTheVersion) {
    std::uint64_t before = model.version();
    const auto rose = [this, &before] { return std::exchange(before, model.version()) < model.version(); };
    begin();
    EXPECT_TRUE(rose());
    wire.feedback(0, readings(900, 0));
    EXPECT_TRUE(rose());
    wire.bytes(Endpoint::MessageIn, {});
    EXPECT_TRUE(rose());
    wire.lost();
    EXPECT_TRUE(rose());
}

}  // namespace
}  // namespace kickstand::thunderbots
