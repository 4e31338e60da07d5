// Sessions on links that fail in every way and at every moment: nothing hangs, every command is answered
// once, nothing is replayed, and the robots end braked.

#include <random>

#include "tests/session/safety_testing.h"
#include "tests/support/session/faulty_usb_link.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using kickstand::testing::FaultPlan;
using kickstand::testing::FaultyUsbLink;
using kickstand::testing::SessionRig;
using kickstand::testing::SessionRigOptions;

constexpr RobotMask kRobotsThere = 0x000F;

/// A rig whose link follows a plan of faults and calls `step` at every submission.
class BadRig {
  public:
    explicit BadRig(const FaultPlan& plan = {}) {
        SessionRigOptions options;
        options.sim.robots = kRobotsThere;
        options.sim.pace = sim::RadioPace::Ideal;
        options.sim.seed = plan.seed;
        options.decorate = [this, plan](std::unique_ptr<UsbLink> inner, Scheduler& scheduler) {
            const auto step = [this](std::uint64_t count) {
                steps = count;
                if (count == actAt) act();
            };
            auto faulty = std::make_unique<FaultyUsbLink>(std::move(inner), scheduler, plan, step);
            link = faulty.get();
            return faulty;
        };
        rig = std::make_unique<SessionRig>(std::move(options));
    }

    bool connect() {
        rig->beginConnect();
        return comesToRun();
    }
    bool comesToRun() {
        for (int i = 0; i < 200; ++i) {
            rig->advance(100ms);
            if (rig->isRunning()) return true;
        }
        return false;
    }
    bool anyDriven() const {
        for (int robot = 0; robot < 4; ++robot) {
            const auto report = rig->robot(robot);
            if (report.driveFresh && report.lastDrive != wire::brakedBlock()) return true;
        }
        return false;
    }
    void replug() {
        rig->simulate("plugged", 0);
        rig->advance(100ms);
        rig->simulate("plugged", 1);
    }

    FaultyUsbLink* link = nullptr;
    std::uint64_t steps = 0;
    std::uint64_t actAt = 0;
    std::function<void()> act;
    std::unique_ptr<SessionRig> rig;
};

/// Every command there is, with what a hurried person might give it.
Command anyCommand(std::mt19937_64& random) {
    const auto pick = [&random](int count) {
        return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    const auto robots = static_cast<RobotMask>(random() & 0x1F);
    const auto time = static_cast<std::uint8_t>(pick(140));
    switch (pick(12)) {
        case 0:
        case 1:
            return SetWheels{robots, {pick(240) - 120, pick(240) - 120, 0, 0}, pick(2) == 0};
        case 2:
            return Brake{robots};
        case 3:
            return SetDribbler{robots, pick(2) == 0};
        case 4:
            return ArmHighVoltage{robots, pick(4) != 0};
        case 5:
            return SetCharger{robots, pick(2) == 0};
        case 6:
        case 7:
            return Kick{pick(18) - 1, {true, true, time, time, 0}};
        case 8:
            return SetAutokick{robots, pick(2) == 0, {true, true, time, 0, 0}};
        case 9:
            return SetTestMode{robots,
                               {static_cast<wire::TestClass>(pick(7)),
                                static_cast<std::uint8_t>(pick(3) == 0 ? pick(256) : pick(6))},
                               pick(2) == 0 ? TestModeWay::DriveBlock : TestModeWay::Message};
        case 10:
            return Discharge{pick(5), pick(2) == 0};
        default:
            return SetWheelLimit{pick(1200) - 50};
    }
}

void expectAllAnsweredOnce(SessionRig& rig, const std::vector<CommandId>& given) {
    EXPECT_TRUE(rig.unanswered().empty());
    for (const CommandId id : given)
        EXPECT_EQ(rig.answers(id), 1U) << "command " << id;
}

/// After a reconnection nothing but braked blocks has gone.
void expectNothingReplayed(SessionRig& rig) {
    for (const SentBlock& sent : blocksIn(rig.packets()))
        EXPECT_EQ(sent.block, wire::brakedBlock()) << "robot " << sent.robot;
    EXPECT_EQ(kicksIn(rig.packets()), 0U);
}

class Faults : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(Faults, AnswerEveryCommandOnceAndEndBraked) {
    FaultPlan plan;
    plan.seed = GetParam();
    plan.drop = plan.duplicate = plan.truncate = plan.corrupt = plan.delay = 0.03;
    plan.stall = 0.02;
    BadRig bad(plan);
    SessionRig& rig = *bad.rig;
    rig.beginConnect();
    std::mt19937_64 random(GetParam());
    std::vector<CommandId> given;
    for (int i = 0; i < 600; ++i) {
        rig.advance(Duration(random() % 60'000'000));
        given.push_back(rig.give(anyCommand(random)));
        if (random() % 40 == 0) rig.stop();
        if (random() % 10 == 0) rig.rearm();
        if (random() % 100 == 0) rig.beat(random() % 3 != 0);
        if (rig.state().link == LinkState::Failed || random() % 150 == 0) bad.replug();
    }
    rig.simulate("plugged", 0);
    rig.advance(1100ms);
    EXPECT_FALSE(bad.anyDriven());
    expectAllAnsweredOnce(rig, given);
    rig.forgetPackets();
    rig.rearm();
    rig.simulate("plugged", 1);
    rig.advance(5s);
    expectNothingReplayed(rig);
    const Snapshot now = rig.state();
    std::uint64_t delivered = 0;
    std::uint64_t kicksGiven = 0;
    for (int robot = 0; robot < 4; ++robot) {
        delivered += rig.robot(robot).kicks - rig.robot(robot).automaticKicks;
        kicksGiven += now.robots[static_cast<std::size_t>(robot)].kicks;
    }
    EXPECT_LE(delivered, kicksGiven) << "no kick was delivered twice";
    std::size_t done = 0;
    for (const CommandId id : given)
        done += *rig.answer(id) ? 1 : 0;
    EXPECT_GT(done, given.size() / 10) << "most of the time the session did run";
    EXPECT_GT(now.traffic.malformed, 0U);
    EXPECT_GT(now.traffic.stalls, 0U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Faults, ::testing::Range<std::uint64_t>(1, 25));

/// The submissions that a start-up on a good link takes.
std::uint64_t stepsOfStartUp() {
    BadRig good;
    EXPECT_TRUE(good.connect());
    return good.steps;
}

TEST(BadLink, AnUnplugAtAnyStepOfTheStartUpIsOutlived) {
    const std::uint64_t last = stepsOfStartUp();
    ASSERT_GT(last, 15U);
    for (std::uint64_t step = 1; step <= last; ++step) {
        SCOPED_TRACE(step);
        BadRig bad;
        bad.actAt = step;
        bad.act = [&bad] { bad.rig->simulate("plugged", 0); };
        bad.rig->beginConnect();
        ASSERT_TRUE(bad.rig->waitUntil([&bad, step] { return bad.steps >= step; }, 20s));
        bad.rig->advance(50ms);
        EXPECT_EQ(bad.rig->state().link, LinkState::Searching);
        bad.rig->rearm();
        bad.rig->forgetPackets();
        bad.rig->simulate("plugged", 1);
        ASSERT_TRUE(bad.comesToRun());
        expectNothingReplayed(*bad.rig);
        EXPECT_EQ(blocksIn(bad.rig->packets()).size(), static_cast<std::size_t>(kRobots));
    }
}

TEST(BadLink, ADisconnectAtAnyStepOfTheStartUpEndsIt) {
    const std::uint64_t last = stepsOfStartUp();
    for (std::uint64_t step = 1; step <= last; ++step) {
        SCOPED_TRACE(step);
        BadRig bad;
        CommandId disconnect = 0;
        bad.actAt = step;
        bad.act = [&bad, &disconnect] { disconnect = bad.rig->give(Disconnect{}, 1); };
        bad.rig->beginConnect();
        ASSERT_TRUE(bad.rig->waitUntil([&disconnect] { return disconnect != 0; }, 20s));
        bad.rig->advance(1s);
        EXPECT_EQ(bad.rig->answers(disconnect), 1U);
        EXPECT_TRUE(bad.rig->flows().snapshots.latest().value->sessions.empty());
    }
}

TEST(BadLink, AStallAtAnyEndpointIsOutlived) {
    for (const int endpoint : {0x81, 0x82, 0x84, 0x85, 0x86, 0x05, 0x06}) {
        SCOPED_TRACE(endpoint);
        BadRig bad;
        ASSERT_TRUE(bad.connect());
        bad.rig->simulate("stall", endpoint);
        ASSERT_TRUE(bad.rig->arm(0));
        ASSERT_TRUE(bad.rig->ask(SetWheels{maskOf(1), {50, 50, 50, 50}}));
        EXPECT_TRUE(bad.rig->ask(Kick{0, kKick}));
        bad.rig->simulate("ball", 1, 2);
        bad.rig->advance(3s);
        EXPECT_EQ(bad.rig->state().link, LinkState::Running);
        EXPECT_TRUE(bad.anyDriven());
        EXPECT_EQ(bad.rig->robot(0).kicks, 1U);
        EXPECT_TRUE(bad.rig->state().robots[2].readings.ball);
    }
}

/// A busy second: everything that may be on its way at once is.
void beBusy(SessionRig& rig, std::vector<CommandId>& given) {
    given.push_back(rig.give(ArmHighVoltage{kRobotsThere, true}));
    given.push_back(rig.give(SetCharger{maskOf(0), true}));
    for (int i = 0; i < 10; ++i) {
        given.push_back(rig.give(SetWheels{kRobotsThere, {10 * i, 50, -50, 100}}));
        given.push_back(rig.give(Kick{i % 4, kKick}));
        given.push_back(rig.give(SetTestMode{kRobotsThere, {wire::TestClass::Lamp, 0}}));
        rig.simulate("ball", i % 2, 2);
        rig.advance(60ms);
    }
}

TEST(BadLink, AnUnplugAtAnyStepOfABusySessionIsOutlived) {
    std::uint64_t from = 0;
    std::uint64_t to = 0;
    {
        BadRig good;
        ASSERT_TRUE(good.connect());
        from = good.steps;
        std::vector<CommandId> given;
        beBusy(*good.rig, given);
        to = good.steps;
    }
    ASSERT_GT(to, from + 100);
    for (std::uint64_t step = from + 1; step <= to; ++step) {
        SCOPED_TRACE(step);
        BadRig bad;
        bad.actAt = step;
        bad.act = [&bad] { bad.rig->simulate("plugged", 0); };
        ASSERT_TRUE(bad.connect());
        std::vector<CommandId> given;
        beBusy(*bad.rig, given);
        ASSERT_GE(bad.steps, step);
        bad.rig->advance(1100ms);
        EXPECT_FALSE(bad.anyDriven());
        expectAllAnsweredOnce(*bad.rig, given);
        EXPECT_EQ(bad.rig->flows().stop.reason(), StopReason::LinkLost);
        bad.rig->rearm();
        bad.rig->forgetPackets();
        bad.rig->simulate("plugged", 1);
        ASSERT_TRUE(bad.comesToRun());
        expectNothingReplayed(*bad.rig);
    }
}

TEST(BadLink, ARadioThatBreaksDownIsNamedAndBrakesEverything) {
    BadRig bad;
    ASSERT_TRUE(bad.connect());
    ASSERT_TRUE(bad.rig->ask(SetWheels{maskOf(0), {100, 100, 100, 100}}));
    bad.rig->advance(500ms);
    bad.rig->simulate("radio-failure", 1);
    bad.rig->advance(2200ms);
    const Snapshot now = bad.rig->state();
    EXPECT_EQ(now.link, LinkState::Failed);
    ASSERT_TRUE(now.error);
    EXPECT_EQ(now.error->code, Errc::RadioFailed);
    EXPECT_EQ(now.error->got, 1);
    EXPECT_FALSE(bad.anyDriven());
    EXPECT_EQ(bad.rig->flows().stop.reason(), StopReason::LinkLost);
}

TEST(BadLink, WhateverWasGivenABrakeReachesTheWire) {
    std::mt19937_64 random(5);
    BadRig good;
    ASSERT_TRUE(good.connect());
    for (int round = 0; round < 300; ++round) {
        for (int i = 0; i < 5; ++i)
            good.rig->give(anyCommand(random));
        good.rig->advance(20ms);
        good.rig->forgetPackets();
        ASSERT_TRUE(good.rig->ask(Brake{kRobotsThere})) << "round " << round;
        good.rig->advance(20ms);
        const Snapshot state = good.rig->state();
        for (int robot = 0; robot < kRobots; ++robot) {
            const RobotState& one = state.robots[static_cast<std::size_t>(robot)];
            EXPECT_FALSE(one.told && one.told->run) << "robot " << robot << ", round " << round;
        }
        good.rig->forget();
    }
}

TEST(BadLink, ATestModeThatNoDriveBlockCanHoldIsRefused) {
    BadRig good;
    ASSERT_TRUE(good.connect());
    for (const wire::TestClass testClass :
         {wire::TestClass::None, wire::TestClass::Lamp, wire::TestClass::Charger})
        EXPECT_EQ(good.rig->refusal(SetTestMode{kRobotsThere, {testClass, 8}, TestModeWay::DriveBlock}),
                  Errc::OutOfRange);
    EXPECT_TRUE(
        good.rig->ask(SetTestMode{kRobotsThere, {wire::TestClass::Lamp, 7}, TestModeWay::DriveBlock}));
}

TEST(BadLink, ADongleThatTakesNothingKeepsNobodyWaiting) {
    BadRig bad;
    ASSERT_TRUE(bad.connect());
    ASSERT_TRUE(bad.rig->arm(0));
    bad.link->refuseOut();
    const std::vector<CommandId> given{bad.rig->give(SetWheels{kRobotsThere, {50, 50, 50, 50}}),
                                       bad.rig->give(Kick{0, kKick}),
                                       bad.rig->give(SetTestMode{kRobotsThere, {wire::TestClass::Lamp, 0}}),
                                       bad.rig->give(SetChannels{0x0B, 0x0C})};
    bad.rig->advance(400ms);
    EXPECT_EQ(bad.rig->answers(given[1]), 1U);
    ASSERT_TRUE(bad.rig->answer(given[3]));
    EXPECT_EQ(bad.rig->answer(given[3])->error().code, Errc::TimedOut);
    // Nor is the session of no use from then on.
    EXPECT_TRUE(bad.rig->ask(Brake{kRobotsThere}));
    const CommandId disconnect = bad.rig->give(Disconnect{}, 1);
    bad.rig->advance(600ms);
    EXPECT_EQ(bad.rig->answers(disconnect), 1U);
    expectAllAnsweredOnce(*bad.rig, given);
    EXPECT_TRUE(bad.rig->flows().snapshots.latest().value->sessions.empty());
}

TEST(BadLink, ADongleThatTakesNothingDoesNotKeepTheProgramFromEnding) {
    BadRig bad;
    ASSERT_TRUE(bad.connect());
    bad.link->refuseOut();
    bool done = false;
    bad.rig->core().shutdown([&done] { done = true; });
    bad.rig->advance(600ms);
    EXPECT_TRUE(done);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
