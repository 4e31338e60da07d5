#include <numeric>

#include <gtest/gtest.h>

#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

ThunderbotsSimOptions badRadio(RadioPace pace, std::uint64_t seed) {
    ThunderbotsSimOptions options = quietOptions(0x0007);
    options.pace = pace;
    options.seed = seed;
    options.weather = {.loss = 0.3, .duplication = 0.3, .delay = 5ms};
    return options;
}

class Radio : public testing::TestWithParam<RadioPace> {};

TEST_P(Radio, FindsTheRobotsThatAreThere) {
    ThunderbotsSimOptions options = quietOptions(0x8421);
    options.pace = GetParam();
    SimHost host(options);
    EXPECT_TRUE(host.start(0x8421));
    host.run(5s);
    EXPECT_EQ(host.sim.deviceReport().status.aliveRobots, 0x8421);
    EXPECT_EQ(host.feedback.size(), 4U);
}

TEST_P(Radio, EveryKickArrivesExactlyOnceAndInOrderHoweverBadTheRadioIs) {
    SimHost host(badRadio(GetParam(), 7));
    ASSERT_TRUE(host.start(0x0007));
    constexpr int kKicks = 300;
    std::array<std::vector<int>, 3> got;
    const auto collect = [&](std::size_t robot) {
        const RobotReport report = host.sim.robot(static_cast<int>(robot));
        const std::size_t fresh = report.kicks - got[robot].size();
        ASSERT_LE(fresh, report.lastKicks.size());
        for (auto kick = report.lastKicks.end() - static_cast<std::ptrdiff_t>(fresh);
             kick != report.lastKicks.end(); ++kick)
            got[robot].push_back(kick->pulses[0].width_us / 32);
    };
    std::vector<int> sent(kKicks);
    for (int i = 0; i < kKicks; ++i) {
        sent[static_cast<std::size_t>(i)] = i % 128;
        for (std::uint8_t robot = 0; robot < 3; ++robot) {
            const wire::KickTimes times{.flag1 = true, .t1 = static_cast<std::uint8_t>(i % 128)};
            while (host.kick(robot, times) == UsbHandshake::Nak)
                host.run(5ms);
        }
        for (std::size_t robot = 0; robot < 3; ++robot)
            collect(robot);
    }
    host.run(5s);
    for (std::size_t robot = 0; robot < 3; ++robot) {
        collect(robot);
        EXPECT_EQ(got[robot], sent);
    }
    EXPECT_TRUE(host.errors.empty());
}

TEST_P(Radio, EveryAutokickIsIndicatedExactlyOnce) {
    SimHost host(badRadio(GetParam(), 11));
    ASSERT_TRUE(host.start(0x0007));
    wire::DriveBlock block;
    block.autokickArmed = true;
    block.autokick.t1 = 10;
    host.drive(1, block);
    host.run(500ms);
    for (int i = 0; i < 100; ++i) {
        host.perform("ball", 1, 1);
        host.run(50ms);
        host.perform("ball", 1, 0);
        host.run(300ms);
    }
    host.run(3s);
    EXPECT_EQ(host.sim.robot(1).automaticKicks, 100U);
    EXPECT_EQ(host.count(wire::Pipe::Indicator), 100U);
}

TEST_P(Radio, ASilentRobotIsDroppedAfterFiftyFailuresAndFoundAgain) {
    ThunderbotsSimOptions options = quietOptions(0x0003);
    options.pace = GetParam();
    SimHost host(options);
    ASSERT_TRUE(host.start(0x0003));
    host.perform("dead", 1, 1);
    const TimePoint died = host.scheduler.now();
    ASSERT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.aliveRobots == 0x0001; }, 10s));
    // Fifty polls, each given 25 ms.
    EXPECT_GE(host.scheduler.now() - died, 1250ms);
    EXPECT_LE(host.scheduler.now() - died, 3s);
    host.perform("dead", 1, 0);
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.aliveRobots == 0x0003; }, 5s));
    host.kick(1, {.t1 = 5});
    host.run(200ms);
    EXPECT_EQ(host.sim.robot(1).kicks, 1U) << "both sides' sequence numbers began anew";
}

TEST_P(Radio, MessagesOfADroppedRobotAreReportedAsFailed) {
    ThunderbotsSimOptions options = quietOptions(0x0001);
    options.pace = GetParam();
    SimHost host(options);
    ASSERT_TRUE(host.start(0x0001));
    host.perform("dead", 0, 1);
    for (int i = 0; i < 6; ++i)
        ASSERT_EQ(host.kick(0, {.t1 = 5}), UsbHandshake::Ack);
    host.run(5s);
    EXPECT_EQ(host.errors, std::vector<std::uint8_t>(6, 41));
    EXPECT_EQ(host.sim.deviceReport().messagesHeld, 0U);
}

TEST_P(Radio, ARobotThatRebootedIsDroppedAndFoundWithFreshSequenceNumbers) {
    ThunderbotsSimOptions options = quietOptions(0x0001);
    options.pace = GetParam();
    SimHost host(options);
    ASSERT_TRUE(host.start(0x0001));
    for (int i = 0; i < 5; ++i)
        host.kick(0, {.t1 = 5});
    host.run(200ms);
    ASSERT_TRUE(host.ask(0, wire::RebootRequest{}));
    ASSERT_TRUE(host.runUntil([&] { return !host.sim.deviceReport().status.alive(0); }, 20s));
    ASSERT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(0); }, 20s));
    EXPECT_EQ(host.sim.robot(0).boots, 2U);
    host.kick(0, {.t1 = 5});
    host.run(200ms);
    EXPECT_EQ(host.sim.robot(0).kicks, 6U);
}

INSTANTIATE_TEST_SUITE_P(Pace, Radio, testing::Values(RadioPace::True, RadioPace::Ideal),
                         [](const auto& pace) { return pace.param == RadioPace::True ? "True" : "Ideal"; });

/// How often each robot's feedback came in ten seconds of noisy readings.
std::vector<std::size_t> feedbackCounts(ThunderbotsSimOptions options, Duration span) {
    options.noise = true;
    SimHost host(options);
    EXPECT_TRUE(host.start(options.robots));
    host.feedback.clear();
    host.run(span);
    std::vector<std::size_t> counts;
    for (const auto& [robot, blocks] : host.feedback)
        counts.push_back(blocks.size());
    return counts;
}

TEST(RadioPaces, TrueIsSomeSevenAnswersASecondFromEachOfSixteen) {
    ThunderbotsSimOptions options = quietOptions(0xFFFF);
    options.pace = RadioPace::True;
    const auto counts = feedbackCounts(options, 20s);
    ASSERT_EQ(counts.size(), 16U);
    for (const std::size_t count : counts) {
        EXPECT_GE(count, 20U * 6);
        EXPECT_LE(count, 20U * 7);
    }
}

TEST(RadioPaces, IdealIsNearlyTwoHundred) {
    const auto counts = feedbackCounts(quietOptions(0xFFFF), 5s);
    ASSERT_EQ(counts.size(), 16U);
    for (const std::size_t count : counts) {
        EXPECT_GE(count, 5U * 190);
        EXPECT_LE(count, 5U * 200 + 1);
    }
}

TEST(RadioPaces, IdealDeliversMessagesAndBlocksAtOnce) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    host.run(52ms);
    host.drive(0, running(10));
    host.kick(0, {.t1 = 3});
    host.scheduler.runPending();
    EXPECT_EQ(host.sim.robot(0).kicks, 1U);
    EXPECT_EQ(host.sim.robot(0).lastDrive, running(10));
}

TEST(RadioFaults, TheSameSeedGivesTheSameFates) {
    const auto trace = [](std::uint64_t seed) {
        SimHost host(badRadio(RadioPace::True, seed));
        host.start(0x0007);
        std::vector<std::uint64_t> seen;
        for (int i = 0; i < 50; ++i) {
            host.kick(static_cast<std::uint8_t>(i % 3), {.t1 = static_cast<std::uint8_t>(i)});
            host.run(20ms);
            seen.push_back(host.sim.robot(0).driveBlocks);
            seen.push_back(host.sim.robot(i % 3).kicks);
        }
        return seen;
    };
    EXPECT_EQ(trace(1), trace(1));
    EXPECT_NE(trace(1), trace(2));
}

TEST(RadioFaults, LossThinsOutTheBroadcasts) {
    ThunderbotsSimOptions options = quietOptions();
    SimHost good(options);
    options.weather.loss = 0.5;
    SimHost bad(options);
    ASSERT_TRUE(good.start(0x0001));
    ASSERT_TRUE(bad.start(0x0001));
    const std::uint64_t goodBefore = good.sim.robot(0).driveBlocks;
    const std::uint64_t badBefore = bad.sim.robot(0).driveBlocks;
    good.run(10s);
    bad.run(10s);
    const double ratio = static_cast<double>(bad.sim.robot(0).driveBlocks - badBefore) /
                         static_cast<double>(good.sim.robot(0).driveBlocks - goodBefore);
    EXPECT_NEAR(ratio, 0.5, 0.05);
}

TEST(RadioFaults, ADelayedFrameOvertakesNoOther) {
    ThunderbotsSimOptions options = quietOptions();
    options.weather.delay = 20ms;
    SimHost host(options);
    ASSERT_TRUE(host.start(0x0001));
    std::int16_t last = 0;
    for (std::int16_t speed = 1; speed <= 200; ++speed) {
        host.drive(0, running(speed));
        host.run(2ms);
        const std::int16_t now = host.sim.robot(0).lastDrive.wheels[0];
        EXPECT_GE(now, last);
        EXPECT_LE(now, speed);
        last = now;
    }
    host.run(50ms);
    EXPECT_EQ(host.sim.robot(0).lastDrive, running(200));
}

TEST(RadioFaults, AnAnswerOfAnEarlierConversationIsNotTakenForOneOfTheNext) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        ThunderbotsSimOptions options = quietOptions();
        options.seed = seed;
        SimHost host(options);
        ASSERT_TRUE(host.start(0x0001));
        // The first answer with a message is on its way when the robot is lost and found again.
        host.perform("delay", -1, 1000);
        host.perform("experiment", 0, 1);
        host.run(300ms);
        host.perform("loss", -1, 1);
        host.kick(0, {.t1 = 1});
        ASSERT_TRUE(host.runUntil([&] { return !host.sim.deviceReport().status.alive(0); }, 5s));
        host.perform("loss", -1, 0);
        host.perform("delay", -1, 0);
        ASSERT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.alive(0); }, 5s));
        host.messages.clear();
        host.run(2s);
        wire::DriveBlock block;
        block.autokickArmed = true;
        block.autokick.t1 = 10;
        host.drive(0, block);
        host.perform("ball", 0, 1);
        host.run(2s);
        ASSERT_EQ(host.messages.size(), 1U) << seed;
        EXPECT_TRUE(host.messages.front().payload.empty()) << seed;
    }
}

TEST(RadioFaults, ARobotThatIsFoundAgainGivesUpWhatItHadToSay) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    for (int i = 0; i < 3; ++i)
        host.perform("experiment", 0, 1);
    host.scheduler.advance(500ms);
    ASSERT_TRUE(host.start(0x0001));
    host.run(500ms);
    EXPECT_TRUE(host.messages.empty());
    EXPECT_EQ(host.sim.robot(0).lostMessages, 8U) << "sixteen were with the dongle";
}

TEST(RadioFaults, RobotsOnOtherChannelsAreNotHeard) {
    ThunderbotsSimOptions options = quietOptions();
    options.dongleChannels = {.channel0 = 0x0B, .channel1 = 0x0C};
    SimHost host(options);
    host.configure();
    host.run(5s);
    EXPECT_EQ(host.sim.deviceReport().status.radios, wire::RadioState::Running);
    EXPECT_EQ(host.sim.deviceReport().status.aliveRobots, 0);
}

TEST(RadioFaults, TwoRobotsWithOneNumberAreNotUnderstood) {
    SimHost host(quietOptions(0x0003));
    ASSERT_TRUE(host.start(0x0003));
    wire::OperationalParameters parameters = host.sim.robot(1).shadow;
    parameters.robotNumber = 0;
    ASSERT_TRUE(host.ask(1, wire::SetParametersRequest{parameters}));
    ASSERT_TRUE(host.ask(1, wire::CommitParametersRequest{}));
    EXPECT_EQ(host.sim.robot(1).number, 1) << "the number takes effect at boot";
    ASSERT_TRUE(host.ask(1, wire::RebootRequest{}));
    host.run(10s);
    EXPECT_EQ(host.sim.robot(1).number, 0);
    EXPECT_EQ(host.sim.deviceReport().status.aliveRobots, 0);
}

TEST(RadioFaults, MessagesThatTheHostDoesNotReadWaitAtTheRobot) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    for (int i = 0; i < 3; ++i)
        host.perform("experiment", 0, 1);
    for (int i = 0; i < 10; ++i) {
        host.keepAlive();
        host.scheduler.advance(300ms);
    }
    host.run(1s);
    EXPECT_EQ(host.count(wire::Pipe::Indicator), 24U) << "sixteen fit into the dongle; none is lost";
    EXPECT_EQ(std::ranges::count(host.errors, 57), 1) << "and it is said once";
}

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
