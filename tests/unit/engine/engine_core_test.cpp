#include "core/engine/engine_core.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/telemetry/store.h"
#include "tests/support/session/session_rig.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using testing::SessionRig;
using testing::SessionRigOptions;

LinkUri uriOf(const char* text) {
    return parseLinkUri(text).value();
}

class EngineCoreTest : public ::testing::Test {
  protected:
    static SessionRigOptions options() {
        SessionRigOptions made;
        made.sim.robots = 0x0003;
        made.sim.pace = thunderbots::sim::RadioPace::Ideal;
        return made;
    }

    std::shared_ptr<const EngineSnapshot> snapshot() { return rig.flows().snapshots.latest().value; }
    std::vector<EngineNote> notes(EngineNote::Kind kind) {
        std::vector<EngineNote> found;
        for (;;) {
            const auto read = rig.flows().events.read(cursor_);
            if (read.events.empty()) break;
            for (const auto& event : read.events) {
                if (const auto* note = std::get_if<EngineNote>(&event.value.body)) notes_.push_back(*note);
            }
        }
        std::ranges::copy_if(notes_, std::back_inserter(found),
                             [kind](const EngineNote& note) { return note.kind == kind; });
        return found;
    }
    Errc codeOf(CommandId id) {
        const auto answer = rig.answer(id);
        return answer && !*answer ? answer->error().code : Errc::Io;
    }

    SessionRig rig{options()};

  private:
    EventRing<EngineEvent>::Cursor cursor_ = 0;
    std::vector<EngineNote> notes_;
};

TEST_F(EngineCoreTest, PublishesASnapshotBeforeAnythingHappened) {
    ASSERT_TRUE(snapshot());
    EXPECT_TRUE(snapshot()->sessions.empty());
    EXPECT_FALSE(snapshot()->discovered);
    EXPECT_EQ(snapshot()->stop, StopReason::None);
}

TEST_F(EngineCoreTest, PublishesOnlyWhatHasChanged) {
    ASSERT_TRUE(rig.connect());
    rig.simulate("loss", 0);
    rig.advance(3s);
    const auto version = rig.flows().snapshots.version();
    rig.advance(10ms);
    const auto steady = rig.flows().snapshots.version();
    EXPECT_LE(steady - version, 1U);
    rig.stop();
    rig.advance(1ms);
    EXPECT_GT(rig.flows().snapshots.version(), steady);
    EXPECT_EQ(snapshot()->stop, StopReason::Person);
}

TEST_F(EngineCoreTest, PublishesWhatTheSimulatorsQuantitiesAre) {
    ASSERT_TRUE(rig.connect());
    const auto reading = [this](const char* action, int unit) {
        for (const SimReading& one : snapshot()->sessions[0].simReadings) {
            if (one.action == action && one.unit == unit) return one.value;
        }
        return -1.0;
    };
    EXPECT_EQ(snapshot()->sessions[0].simUnits, (std::vector<int>{0, 1}));
    rig.simulate("loss", 0.25);
    rig.simulate("capacitor", 120, 1);
    rig.advance(150ms);
    EXPECT_EQ(reading("loss", -1), 0.25);
    EXPECT_NEAR(reading("capacitor", 1), 120, 1);
    EXPECT_EQ(reading("experiment", 0), -1) << "it has no quantity";
}

TEST_F(EngineCoreTest, OpensASessionAndClosesIt) {
    const CommandId connect = rig.give(Connect{uriOf("sim:thunderbots")}, 7);
    rig.advance(20ms);
    ASSERT_EQ(rig.answers(connect), 1U);
    EXPECT_TRUE(*rig.answer(connect));
    ASSERT_EQ(snapshot()->sessions.size(), 1U);
    EXPECT_EQ(snapshot()->sessions[0].id, 7U);
    EXPECT_FALSE(snapshot()->sessions[0].simActions.empty());
    ASSERT_EQ(notes(EngineNote::Kind::SessionOpened).size(), 1U);
    EXPECT_EQ(notes(EngineNote::Kind::SessionOpened)[0].text, "sim:thunderbots");
    const CommandId disconnect = rig.give(Disconnect{}, 7);
    rig.advance(100ms);
    EXPECT_EQ(rig.answers(disconnect), 1U);
    EXPECT_TRUE(*rig.answer(disconnect));
    EXPECT_TRUE(snapshot()->sessions.empty());
    EXPECT_EQ(notes(EngineNote::Kind::SessionClosed).size(), 1U);
}

TEST_F(EngineCoreTest, RefusesLinksThatItDoesNotKnow) {
    const CommandId unknown = rig.give(Connect{uriOf("serial:/dev/ttyS0")}, 1);
    const CommandId refused = rig.give(Connect{uriOf("usb:")}, 2);
    rig.advance(20ms);
    EXPECT_EQ(codeOf(unknown), Errc::Unsupported);
    EXPECT_EQ(codeOf(refused), Errc::BadUri) << "the provider's own error";
    EXPECT_TRUE(snapshot()->sessions.empty());
}

TEST_F(EngineCoreTest, GivesNoTwoSessionsOneNumber) {
    const CommandId first = rig.give(Connect{uriOf("sim:thunderbots")}, 3);
    const CommandId second = rig.give(Connect{uriOf("sim:thunderbots")}, 3);
    const CommandId none = rig.give(Connect{uriOf("sim:thunderbots")}, 0);
    rig.advance(20ms);
    EXPECT_TRUE(*rig.answer(first));
    EXPECT_EQ(codeOf(second), Errc::BadArgument);
    EXPECT_EQ(codeOf(none), Errc::BadArgument);
    EXPECT_EQ(snapshot()->sessions.size(), 1U);
}

TEST_F(EngineCoreTest, AnswersEveryKindOfCommandForASessionThatIsNotThere) {
    const std::vector<CommandBody> bodies{Disconnect{}, SimPerform{"ball", 0, 1},
                                          SystemCommand{thunderbots::Command{thunderbots::Brake{1}}}};
    std::vector<CommandId> given;
    given.reserve(bodies.size());
    for (const CommandBody& body : bodies)
        given.push_back(rig.give(body, 99));
    rig.advance(20ms);
    for (const CommandId id : given) {
        EXPECT_EQ(rig.answers(id), 1U);
        EXPECT_EQ(codeOf(id), Errc::NotConnected);
    }
}

TEST_F(EngineCoreTest, AnswersEveryCommandExactlyOnce) {
    using namespace thunderbots;
    const std::vector<thunderbots::Command> commands{SetWheels{1, {10, 10, 10, 10}},
                                                     Brake{1},
                                                     SetWheelLimit{200},
                                                     SetDribbler{1, true},
                                                     ArmHighVoltage{1, true},
                                                     SetCharger{1, true},
                                                     Kick{0, {true, true, 9, 0, 0}},
                                                     SetAutokick{1, true, {true, true, 9, 0, 0}},
                                                     SetTestMode{1, {wire::TestClass::Lamp, 0}},
                                                     Discharge{0, true},
                                                     SetWheels{0, {}},
                                                     SetWheels{kAllRobots, {1, 1, 1, 1}},
                                                     Kick{77, {}},
                                                     SetChannels{0x0B, 0x0C}};
    std::vector<CommandId> given;
    const auto giveAll = [&] {
        for (const auto& command : commands)
            given.push_back(rig.give(command));
    };
    rig.beginConnect();
    giveAll();
    ASSERT_TRUE(rig.waitUntil([this] { return rig.isRunning(); }, 20s));
    giveAll();
    rig.advance(20s);
    rig.stop();
    giveAll();
    rig.advance(20s);
    for (const CommandId id : given)
        EXPECT_EQ(rig.answers(id), 1U) << "command " << id;
    EXPECT_TRUE(rig.unanswered().empty());
}

TEST_F(EngineCoreTest, PerformsOnTheSimulatorWhatItKnows) {
    ASSERT_TRUE(rig.connect());
    const CommandId ball = rig.give(SimPerform{"ball", 1, 1}, 1);
    const CommandId unknown = rig.give(SimPerform{"miracle", 1, 1}, 1);
    rig.advance(300ms);
    EXPECT_TRUE(*rig.answer(ball));
    EXPECT_TRUE(rig.robot(1).ball);
    EXPECT_TRUE(rig.state().robots[1].readings.ball);
    EXPECT_EQ(codeOf(unknown), Errc::UnknownName);
}

TEST_F(EngineCoreTest, LooksForHardware) {
    const CommandId discover = rig.give(Discover{}, 0);
    rig.advance(20ms);
    EXPECT_EQ(rig.answers(discover), 1U);
    EXPECT_TRUE(snapshot()->discovered);
}

TEST_F(EngineCoreTest, RefusesCommandsBeyondItsQueueAndSaysSo) {
    auto& queue = rig.flows().commands;
    std::size_t taken = 0;
    while (queue.tryPush(Command{1000 + taken, 5, Disconnect{}}))
        ++taken;
    EXPECT_EQ(taken, EngineFlows::kCommands);
    EXPECT_EQ(queue.refused(), 1U);
    rig.advance(20ms);
    EXPECT_EQ(queue.size(), 0U);
    EXPECT_EQ(rig.answers(1000), 1U);
    EXPECT_EQ(rig.answers(1000 + taken - 1), 1U);
}

TEST_F(EngineCoreTest, AFloodOfCommandsHoldsUpNeitherTheOthersNorAStop) {
    ASSERT_TRUE(rig.connect());
    const std::size_t before = rig.scheduler().pending();
    std::vector<CommandId> given;
    for (std::size_t i = 0; i < EngineFlows::kCommands; ++i)
        given.push_back(rig.give(thunderbots::Command{thunderbots::SetWheels{1, {50, 50, 50, 50}}}));
    EXPECT_LE(rig.scheduler().pending(), before + 1) << "one look for all of them";
    rig.core().takeCommands();
    EXPECT_GT(rig.flows().commands.size(), EngineFlows::kCommands / 2) << "a part at a time";
    rig.flows().stop.set(StopReason::Person);
    rig.forgetPackets();
    rig.advance(20ms);
    for (const CommandId id : given)
        EXPECT_EQ(rig.answers(id), 1U);
    EXPECT_EQ(codeOf(given.back()), Errc::StopLatched);
    ASSERT_GE(rig.packets().size(), 4U);
    EXPECT_FALSE(rig.robot(0).lastDrive.run && rig.robot(0).driveFresh);
}

TEST_F(EngineCoreTest, TellsHowManyAnswersNobodyTook) {
    constexpr std::size_t kMore = 10;
    CommandId id = 10'000;
    for (std::size_t left = EngineFlows::kAnswers + kMore; left > 0; --left) {
        ASSERT_TRUE(rig.flows().commands.tryPush(Command{++id, 5, Disconnect{}}));
        while (left % 512 == 0 && rig.flows().commands.size() > 0)
            rig.core().takeCommands();
    }
    rig.advance(20ms);
    const auto lost = notes(EngineNote::Kind::AnswersLost);
    std::uint64_t sum = 0;
    for (const EngineNote& note : lost)
        sum += note.count;
    EXPECT_EQ(sum, kMore);
    EXPECT_EQ(rig.flows().answers.size(), EngineFlows::kAnswers);
}

TEST_F(EngineCoreTest, NumbersEventsWithoutABreakAndCountsWhatAReaderMissed) {
    ASSERT_TRUE(rig.connect());
    for (std::size_t i = 0; i < EngineFlows::kEvents; ++i) {
        rig.stop();
        rig.advance(1ms);
        rig.rearm();
        rig.advance(1ms);
    }
    EventRing<EngineEvent>::Cursor cursor = 0;
    std::uint64_t expected = 0;
    for (;;) {
        const auto read = rig.flows().events.read(cursor);
        if (read.events.empty()) break;
        expected += read.lost;
        for (const auto& event : read.events)
            EXPECT_EQ(event.sequence, expected++);
    }
    EXPECT_EQ(expected, rig.flows().events.end());
    EXPECT_GT(expected, 2 * EngineFlows::kEvents);
}

TEST_F(EngineCoreTest, TellsEachStopAndEachReArmingOnce) {
    rig.stop(StopReason::FocusLost);
    rig.stop(StopReason::Person);
    rig.advance(1s);
    rig.rearm();
    rig.rearm();
    rig.advance(1s);
    ASSERT_EQ(notes(EngineNote::Kind::Stopped).size(), 1U);
    EXPECT_EQ(notes(EngineNote::Kind::Stopped)[0].reason, StopReason::FocusLost);
    EXPECT_EQ(notes(EngineNote::Kind::Rearmed).size(), 1U);
}

TEST_F(EngineCoreTest, TellsOfAStopThatWasReArmedBeforeItLooked) {
    rig.flows().stop.set(StopReason::Suspend);
    rig.flows().stop.rearm();
    rig.advance(20ms);
    ASSERT_EQ(notes(EngineNote::Kind::Stopped).size(), 1U);
    EXPECT_EQ(notes(EngineNote::Kind::Stopped)[0].reason, StopReason::Suspend);
    EXPECT_EQ(notes(EngineNote::Kind::Rearmed).size(), 1U);
}

TEST_F(EngineCoreTest, PutsReadingsAndGapsIntoTheTelemetry) {
    ASSERT_TRUE(rig.connect());
    rig.advance(1s);
    const auto store = snapshot()->sessions[0].telemetry;
    ASSERT_TRUE(store);
    const TimeSeries* battery = store->find({1, 0});
    ASSERT_NE(battery, nullptr);
    const auto now = battery->at(rig.scheduler().now());
    ASSERT_TRUE(now);
    EXPECT_NEAR(now->value, rig.state().robots[1].readings.battery_V, 0.001);
    EXPECT_EQ(store->find({9, 0}), nullptr) << "a robot that nobody heard";
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    const auto lost = battery->at(rig.scheduler().now());
    EXPECT_TRUE(!lost || std::isnan(lost->value)) << "nobody knows it any more";
}

TEST_F(EngineCoreTest, KeepsSessionsApart) {
    const CommandId one = rig.give(Connect{uriOf("sim:thunderbots")}, 1);
    const CommandId gone = rig.give(Disconnect{}, 1);
    const CommandId two = rig.give(Connect{uriOf("sim:thunderbots")}, 2);
    rig.advance(1s);
    EXPECT_TRUE(*rig.answer(one));
    EXPECT_TRUE(*rig.answer(gone));
    EXPECT_TRUE(*rig.answer(two));
    ASSERT_EQ(snapshot()->sessions.size(), 1U);
    EXPECT_EQ(snapshot()->sessions[0].id, 2U);
}

TEST_F(EngineCoreTest, EndsWithinItsLimitAndTakesNoCommandsAfterwards) {
    ASSERT_TRUE(rig.connect());
    bool done = false;
    rig.core().shutdown([&done] { done = true; });
    rig.advance(100ms);
    EXPECT_TRUE(done);
    const CommandId late = rig.give(Connect{uriOf("sim:thunderbots")}, 8);
    const CommandId later = rig.give(thunderbots::Command{thunderbots::SetWheels{1, {9, 9, 9, 9}}});
    rig.advance(100ms);
    EXPECT_EQ(codeOf(late), Errc::NotConnected);
    EXPECT_EQ(codeOf(later), Errc::NotConnected);
}

TEST_F(EngineCoreTest, EndsAtOnceWithoutASession) {
    bool done = false;
    rig.core().shutdown([&done] { done = true; });
    EXPECT_TRUE(done);
}

TEST_F(EngineCoreTest, WaitsForASessionThatIsBeingDisconnected) {
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(thunderbots::SetWheels{1, {50, 50, 50, 50}}));
    rig.advance(1s);
    rig.forgetPackets();
    const CommandId disconnect = rig.give(Disconnect{}, 1);
    bool done = false;
    rig.scheduler().post([this, &done] { rig.core().shutdown([&done] { done = true; }); });
    rig.waitUntil([&done] { return done; }, 1s);
    EXPECT_EQ(rig.answers(disconnect), 1U);
    EXPECT_GE(rig.packets().size(), 4U) << "the last blocks have been taken";
}

TEST_F(EngineCoreTest, LeavesNothingOfItselfOnTheScheduler) {
    FakeScheduler scheduler;
    class NoLinks final : public LinkProvider {
        Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
            return fail(Errc::BadUri, toString(uri));
        }
        void discover(Scheduler&, std::function<void(FoundHardware)>) override {}
    } links;
    {
        EngineCore core(scheduler, links, {});
        core.start();
        EXPECT_GT(scheduler.pending(), 0U);
    }
    EXPECT_EQ(scheduler.pending(), 0U);
}

}  // namespace
}  // namespace kickstand
