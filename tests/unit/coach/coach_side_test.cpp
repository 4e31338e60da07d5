#include <gtest/gtest.h>

#include "tests/unit/coach/side_testing.h"

namespace kickstand::coach::testing {
namespace {

struct Coach : SideRig<CoachSide> {
    void begin() {
        side.begin(kOwn, wire::TeamColor::Blue);
        wait(1);
    }
    void pairAtStart() {
        begin();
        hears(boat(kOwn), Opcode::AssertionResult, kOwn);
        ASSERT_EQ(side.state(), CoachState::Paired);
    }
    void toNotPaired() {
        begin();
        wait(5000);
        ASSERT_EQ(side.state(), CoachState::NotPaired);
    }
    /// Lets time pass with a boat that answers what it should.
    void live(int ms) {
        for (; ms > 0; ms -= 50) {
            const std::size_t before = sent.size();
            wait(50);
            for (std::size_t i = before; i < sent.size(); ++i) {
                if (sent[i].message.opcode == Opcode::Velocity) hears(boat(kOwn), Opcode::UpdateMorale, 0);
            }
        }
    }
};

// Startup.

TEST(CoachSide, StartupAsksItsOwnBoatTwiceASecondForFiveSeconds) {
    Coach coach;
    coach.begin();
    EXPECT_EQ(coach.side.state(), CoachState::Startup);
    coach.wait(4900);
    EXPECT_EQ(coach.count(Opcode::AssertCommand), 10U);
    EXPECT_EQ(coach.lastGap_ms(Opcode::AssertCommand), 500);
    EXPECT_EQ(coach.sent[0].destination, boat(kOwn));
    EXPECT_EQ(coach.sent[0].message.parameter, 1) << "the color";
    EXPECT_EQ(coach.side.state(), CoachState::Startup);
    coach.wait(150);
    EXPECT_EQ(coach.side.state(), CoachState::NotPaired);
    const std::size_t before = coach.sent.size();
    coach.wait(5000);
    EXPECT_EQ(coach.sent.size(), before) << "not paired it says nothing of itself";
}

TEST(CoachSide, StartupEndsPairedWhenAResultNamesUs) {
    Coach coach;
    coach.begin();
    coach.hears(boat(kOwn), Opcode::AssertionResult, kOther);
    EXPECT_EQ(coach.side.state(), CoachState::Startup) << "it names another";
    coach.hears(boat(kOther), Opcode::AssertionResult, kOwn);
    EXPECT_EQ(coach.side.state(), CoachState::Startup) << "another boat";
    coach.hears(boat(kOwn), Opcode::AssertionResult, kOwn);
    EXPECT_EQ(coach.side.state(), CoachState::Paired);
    EXPECT_EQ(coach.side.view().boat, kOwn);
}

// Not paired.

TEST(CoachSide, CollectsBoatsThatAreAvailable) {
    Coach coach;
    coach.toNotPaired();
    coach.hears(boat(9), Opcode::Available);
    coach.hears(boat(kOther), Opcode::Available);
    coach.wait(100);
    coach.hears(boat(9), Opcode::Available);
    coach.hears(console(3), Opcode::Available);
    coach.hears(0x1234, Opcode::Available);
    const CoachView view = coach.side.view();
    ASSERT_EQ(view.boats.size(), 2U);
    EXPECT_EQ(view.boats[0].team, kOther);
    EXPECT_EQ(view.boats[1].packets, 2U);
    EXPECT_EQ(view.boats[1].rssi_dBm, -50);
    EXPECT_EQ(view.counters.foreign, 2U);
}

TEST(CoachSide, AsksTheChosenBoatSixTimesAThirdOfASecondApart) {
    Coach coach;
    coach.toNotPaired();
    coach.hears(boat(kOther), Opcode::Available);
    coach.sent.clear();
    ASSERT_TRUE(coach.side.pair(kOther));
    EXPECT_EQ(coach.side.state(), CoachState::Asserting);
    coach.wait(1990);
    EXPECT_EQ(coach.count(Opcode::AssertCommand), 6U) << "once and five times again";
    EXPECT_EQ(coach.lastGap_ms(Opcode::AssertCommand), 333);
    EXPECT_EQ(coach.sent[0].destination, boat(kOther));
    EXPECT_EQ(coach.side.state(), CoachState::Asserting);
    coach.wait(50);
    EXPECT_EQ(coach.side.state(), CoachState::NotPaired);
    EXPECT_TRUE(coach.told(EventKind::PairingFailed));
    coach.wait(3000);
    EXPECT_EQ(coach.count(Opcode::AssertCommand), 6U);
}

TEST(CoachSide, AResultThatNamesAnotherEndsTheTry) {
    Coach coach;
    coach.toNotPaired();
    coach.hears(boat(kOther), Opcode::Available);
    ASSERT_TRUE(coach.side.pair(kOther));
    coach.hears(boat(9), Opcode::AssertionResult, 3);
    EXPECT_EQ(coach.side.state(), CoachState::Asserting) << "another boat's";
    coach.hears(boat(kOther), Opcode::AssertionResult, 3);
    EXPECT_EQ(coach.side.state(), CoachState::NotPaired);
    ASSERT_EQ(coach.events.back().kind, EventKind::PairingFailed);
    EXPECT_EQ(coach.events.back().code, static_cast<int>(Errc::PairedElsewhere));
    EXPECT_EQ(coach.events.back().previous, 3);
    EXPECT_EQ(coach.side.pair(kOther).error().code, Errc::RobotNotAlive) << "it obeys another";
    coach.hears(boat(kOther), Opcode::Available);
    EXPECT_TRUE(coach.side.pair(kOther));
}

TEST(CoachSide, PairsOnlyWithWhatItHears) {
    Coach coach;
    EXPECT_FALSE(coach.side.pair(kOther)) << "off";
    coach.begin();
    EXPECT_FALSE(coach.side.pair(kOther)) << "startup";
    coach.wait(5000);
    EXPECT_EQ(coach.side.pair(kOther).error().code, Errc::RobotNotAlive);
    coach.hears(boat(kOther), Opcode::Available);
    coach.wait(5001);
    EXPECT_EQ(coach.side.pair(kOther).error().code, Errc::RobotNotAlive) << "too long ago";
}

// Paired.

TEST(CoachSide, VelocityTwiceASecondAndAtOnceWhenTheStickMoves) {
    Coach coach;
    coach.pairAtStart();
    coach.live(3000);
    EXPECT_EQ(coach.lastGap_ms(Opcode::Velocity), 500);
    coach.live(450);
    ASSERT_TRUE(coach.side.steer({7, -3}));
    const TimePoint asked = coach.scheduler.now();
    coach.wait(0);
    EXPECT_EQ(coach.sent.back().time, asked);
    EXPECT_EQ(coach.sent.back().message.parameter, 0x7B);
    EXPECT_EQ(coach.side.view().sent, (wire::Velocity{7, -3}));
}

TEST(CoachSide, OnlyTheNewestVelocityIsKept) {
    Coach coach;
    coach.pairAtStart();
    coach.live(50);
    const std::size_t before = coach.sent.size();
    for (int level = 1; level <= 7; ++level)
        ASSERT_TRUE(coach.side.steer({level, 0}));
    coach.wait(200);
    ASSERT_EQ(coach.sent.size(), before + 1);
    EXPECT_EQ(coach.sent.back().message.parameter, 0x70);
}

TEST(CoachSide, WithoutMoraleVelocityIsRepeatedEveryFifthOfASecond) {
    Coach coach;
    coach.pairAtStart();
    coach.wait(2000);
    EXPECT_EQ(coach.lastGap_ms(Opcode::Velocity), 200);
    EXPECT_GT(coach.side.view().counters.resent, 5U);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 0);
    coach.live(1500);
    EXPECT_EQ(coach.lastGap_ms(Opcode::Velocity), 500);
}

TEST(CoachSide, FiveSecondsWithoutMoraleAndItIsNotPaired) {
    Coach coach;
    coach.pairAtStart();
    coach.live(10000);
    EXPECT_EQ(coach.side.state(), CoachState::Paired);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 3);
    coach.wait(4999);
    EXPECT_EQ(coach.side.state(), CoachState::Paired);
    coach.wait(1);
    EXPECT_EQ(coach.side.state(), CoachState::NotPaired);
    EXPECT_EQ(coach.events.back().code, static_cast<int>(Unpairing::Silence));
    const std::size_t before = coach.sent.size();
    coach.wait(3000);
    EXPECT_EQ(coach.sent.size(), before);
}

TEST(CoachSide, PairedItHearsItsOwnBoatAlone) {
    Coach coach;
    coach.pairAtStart();
    for (const std::uint16_t source : {boat(kOther), console(kOwn), console(3), std::uint16_t{0}})
        coach.hears(source, Opcode::UpdateMorale, 9);
    EXPECT_EQ(coach.side.view().morale, 0);
    EXPECT_EQ(coach.side.view().counters.foreign, 4U);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, -5);
    EXPECT_EQ(coach.side.view().morale, -5);
    coach.hears(boat(kOwn), Opcode::Velocity, 0x70);
    EXPECT_EQ(coach.side.view().counters.outOfPlace, 1U);
}

TEST(CoachSide, AVelocityIsAnsweredUntilAnAnswerIsLate) {
    Coach coach;
    coach.pairAtStart();
    const wire::Velocity ahead{7, 0};
    const auto isAnswered = [&coach] { return coach.side.view().answered == coach.side.view().sent; };
    coach.live(1000);
    ASSERT_TRUE(coach.side.steer(ahead));
    coach.wait(0);
    EXPECT_EQ(coach.side.view().sent, ahead);
    EXPECT_FALSE(isAnswered());
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 0);
    EXPECT_TRUE(isAnswered());
    coach.wait(499);
    EXPECT_TRUE(isAnswered());
    // It is repeated now, and the boat is silent from here on.
    coach.wait(201);
    for (int i = 0; i < 40; ++i) {
        ASSERT_EQ(coach.side.view().sent, ahead);
        EXPECT_FALSE(isAnswered()) << i;
        coach.wait(100);
    }
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 0);
    EXPECT_TRUE(isAnswered());
    // There and back again before any answer: the one from before tells nothing of it.
    ASSERT_TRUE(coach.side.steer({}));
    coach.wait(200);
    ASSERT_TRUE(coach.side.steer(ahead));
    coach.wait(200);
    ASSERT_EQ(coach.side.view().sent, ahead);
    EXPECT_FALSE(isAnswered());
}

TEST(CoachSide, ALateAnswerToAnEarlierVelocityIsNoneToTheLast) {
    Coach coach;
    coach.pairAtStart();
    coach.live(1000);
    ASSERT_TRUE(coach.side.steer({7, 0}));
    coach.wait(150);
    coach.side.halt();
    coach.wait(50);
    ASSERT_EQ(coach.side.view().sent, wire::Velocity{});
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 0);
    EXPECT_FALSE(coach.side.view().answered) << "that was for full ahead";
    const std::size_t before = coach.sent.size();
    coach.wait(200);
    ASSERT_EQ(coach.sent.size(), before + 1) << "zero is said again";
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 0);
    EXPECT_EQ(coach.side.view().answered, wire::Velocity{});
}

// Mutiny.

TEST(CoachSide, SuppressIsRepeatedUntilTheMoraleSaysItIsOver) {
    Coach coach;
    coach.pairAtStart();
    coach.hears(boat(kOwn), Opcode::MutinyInProgress);
    ASSERT_TRUE(coach.side.view().mutiny);
    ASSERT_TRUE(coach.side.suppress());
    coach.wait(650);
    EXPECT_EQ(coach.count(Opcode::SuppressMutiny), 3U);
    EXPECT_EQ(coach.lastGap_ms(Opcode::SuppressMutiny), 200);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, -10);
    EXPECT_TRUE(coach.side.view().mutiny) << "still a mutiny";
    coach.hears(boat(kOwn), Opcode::UpdateMorale, -5);
    EXPECT_FALSE(coach.side.view().mutiny);
    EXPECT_TRUE(coach.told(EventKind::MutinyQuelled));
    const std::size_t before = coach.count(Opcode::SuppressMutiny);
    coach.live(2000);
    EXPECT_EQ(coach.count(Opcode::SuppressMutiny), before);
}

TEST(CoachSide, AMoraleOfMinusTenIsAMutinyToo) {
    Coach coach;
    coach.pairAtStart();
    coach.hears(boat(kOwn), Opcode::UpdateMorale, -9);
    EXPECT_FALSE(coach.side.view().mutiny);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, -10);
    EXPECT_TRUE(coach.side.view().mutiny);
}

TEST(CoachSide, AMutinyThatIsNotQuelledIsOverAfterThreeSeconds) {
    Coach coach;
    coach.pairAtStart();
    coach.hears(boat(kOwn), Opcode::MutinyInProgress);
    coach.wait(2999);
    EXPECT_TRUE(coach.side.view().mutiny);
    coach.wait(1);
    EXPECT_FALSE(coach.side.view().mutiny);
    EXPECT_TRUE(coach.told(EventKind::MutinyLost));
    EXPECT_EQ(coach.side.state(), CoachState::Paired) << "that it is not paired it finds out by the silence";
}

TEST(CoachSide, TheSeriesOfActionsSuppresses) {
    Coach coach;
    coach.pairAtStart();
    EXPECT_FALSE(coach.side.act(0, 3)) << "without a mutiny";
    coach.hears(boat(kOwn), Opcode::MutinyInProgress);
    EXPECT_FALSE(coach.side.act(3, 3));
    EXPECT_TRUE(coach.side.act(0, 3));
    EXPECT_TRUE(coach.side.act(2, 3)) << "a wrong one";
    EXPECT_EQ(coach.side.view().mutiny->done, 0U);
    for (const std::size_t action : {0U, 1U, 2U})
        EXPECT_TRUE(coach.side.act(action, 3));
    coach.wait(250);
    EXPECT_EQ(coach.count(Opcode::SuppressMutiny), 1U);
}

TEST(CoachSide, ASuppressWithoutAMutinyEndsWithItsAnswerOrItsTime) {
    Coach coach;
    coach.pairAtStart();
    ASSERT_TRUE(coach.side.suppress());
    coach.wait(250);
    coach.hears(boat(kOwn), Opcode::UpdateMorale, 2);
    const std::size_t before = coach.count(Opcode::SuppressMutiny);
    coach.live(1000);
    EXPECT_EQ(coach.count(Opcode::SuppressMutiny), before);
}

// Free commands and jettison.

TEST(CoachSide, FreeCommandsGoOnceEach) {
    Coach coach;
    EXPECT_EQ(coach.side.freeDigital().error().code, Errc::NotPaired);
    coach.pairAtStart();
    coach.live(1000);
    ASSERT_TRUE(coach.side.freeDigital());
    ASSERT_TRUE(coach.side.freeAnalog(-100));
    EXPECT_EQ(coach.side.freeAnalog(101).error().code, Errc::OutOfRange);
    coach.live(3000);
    EXPECT_EQ(coach.count(Opcode::FreeDigital), 1U);
    EXPECT_EQ(coach.count(Opcode::FreeAnalog), 1U);
    for (int i = 0; i < 8; ++i)
        EXPECT_TRUE(coach.side.freeDigital());
    EXPECT_EQ(coach.side.freeDigital().error().code, Errc::QueueFull);
}

TEST(CoachSide, VelocityThatHasWaitedSixTenthsGoesBeforeFreeCommands) {
    Coach coach;
    coach.pairAtStart();
    coach.live(1150);
    ASSERT_TRUE(coach.side.steer({1, 0}));
    coach.wait(0);
    ASSERT_EQ(coach.sent.back().message.opcode, Opcode::Velocity);
    const std::size_t before = coach.sent.size();
    for (int i = 0; i < 8; ++i)
        ASSERT_TRUE(coach.side.freeDigital());
    ASSERT_TRUE(coach.side.steer({2, 0}));
    coach.live(1400);
    std::vector<Opcode> order;
    for (std::size_t i = before; i < coach.sent.size(); ++i)
        order.push_back(coach.sent[i].message.opcode);
    ASSERT_GE(order.size(), 6U);
    const auto velocity = std::find(order.begin(), order.end(), Opcode::Velocity);
    EXPECT_EQ(velocity - order.begin(), 2) << "free commands first, but not for ever";
}

TEST(CoachSide, AMutinyThatCannotBeSuppressedDoesNotKeepVelocityBack) {
    Coach coach;
    coach.pairAtStart();
    coach.hears(boat(kOwn), Opcode::MutinyInProgress);
    ASSERT_TRUE(coach.side.suppress());
    TimePoint last = coach.scheduler.now();
    for (int i = 0; i < 290; ++i) {
        const std::size_t before = coach.sent.size();
        coach.wait(10);
        if (coach.sent.size() == before || coach.sent.back().message.opcode != Opcode::Velocity) continue;
        EXPECT_LT(coach.sent.back().time - last, std::chrono::seconds(1));
        last = coach.sent.back().time;
    }
    EXPECT_LT(coach.scheduler.now() - last, std::chrono::seconds(1));
    EXPECT_GE(coach.count(Opcode::SuppressMutiny), 8U);
}

TEST(CoachSide, JettisonIsNotPairedAtOnce) {
    Coach coach;
    coach.pairAtStart();
    coach.live(1000);
    ASSERT_TRUE(coach.side.freeDigital());
    ASSERT_TRUE(coach.side.jettison());
    EXPECT_EQ(coach.side.state(), CoachState::NotPaired);
    EXPECT_FALSE(coach.side.view().sent);
    const std::size_t before = coach.sent.size();
    coach.wait(3000);
    ASSERT_EQ(coach.sent.size(), before + 1);
    EXPECT_EQ(coach.sent.back().message.opcode, Opcode::Jettison);
    EXPECT_EQ(coach.sent.back().destination, boat(kOwn));
    EXPECT_EQ(coach.side.jettison().error().code, Errc::NotPaired);
}

// STOP.

TEST(CoachSide, StopTakesTheNextSlotBeforeEverythingElse) {
    Coach coach;
    coach.pairAtStart();
    coach.live(1000);
    coach.hears(boat(kOwn), Opcode::MutinyInProgress);
    ASSERT_TRUE(coach.side.steer({7, 7}));
    coach.wait(0);
    ASSERT_TRUE(coach.side.suppress());
    ASSERT_TRUE(coach.side.freeDigital());
    const std::size_t before = coach.sent.size();
    coach.side.halt();
    EXPECT_TRUE(coach.side.stopWaits());
    coach.wait(200);
    ASSERT_EQ(coach.sent.size(), before + 1);
    EXPECT_EQ(coach.sent.back().message, (wire::Message{Opcode::Velocity, 0}));
    EXPECT_FALSE(coach.side.stopWaits());
    EXPECT_EQ(coach.side.steer({1, 0}).error().code, Errc::StopLatched);
    EXPECT_EQ(coach.side.freeDigital().error().code, Errc::StopLatched);
    coach.live(5000);
    EXPECT_EQ(coach.side.state(), CoachState::Paired) << "it goes on saying zero";
    EXPECT_EQ(coach.count(Opcode::FreeDigital), 0U);
    for (std::size_t i = before; i < coach.sent.size(); ++i) {
        const bool velocity = coach.sent[i].message.opcode == Opcode::Velocity;
        EXPECT_TRUE(!velocity || coach.sent[i].message.parameter == 0) << i;
    }
    coach.side.release();
    EXPECT_TRUE(coach.side.steer({1, 0}));
}

TEST(CoachSide, AStopIsSaidAlsoWhenTheBoatIsJettisonedMeanwhile) {
    Coach coach;
    coach.pairAtStart();
    coach.live(50);
    coach.side.halt();
    ASSERT_TRUE(coach.side.jettison());
    const std::size_t before = coach.sent.size();
    coach.wait(1000);
    ASSERT_EQ(coach.sent.size(), before + 2);
    EXPECT_EQ(coach.sent[before].message, (wire::Message{Opcode::Velocity, 0}));
    EXPECT_EQ(coach.sent[before + 1].message.opcode, Opcode::Jettison);
}

TEST(CoachSide, TheFirstPacketIsAGapFromTheOpeningOfTheRadio) {
    Coach coach;
    coach.side.linkOpened();
    coach.side.begin(5, wire::TeamColor::Red);
    coach.wait(199);
    EXPECT_TRUE(coach.sent.empty());
    coach.wait(1);
    EXPECT_EQ(coach.sent.size(), 1U);
}

TEST(CoachSide, EndsWithAZeroAndThenSilently) {
    Coach coach;
    coach.pairAtStart();
    ASSERT_TRUE(coach.side.steer(wire::Velocity{7, 0}));
    coach.wait(1000);
    coach.side.end(Unpairing::RoleEnded);
    const std::size_t before = coach.sent.size();
    EXPECT_TRUE(coach.side.stopWaits());
    coach.wait(10000);
    ASSERT_EQ(coach.sent.size(), before + 1);
    EXPECT_EQ(coach.sent.back().message, (wire::Message{Opcode::Velocity, 0}));
    EXPECT_FALSE(coach.side.stopWaits());
    EXPECT_EQ(coach.side.view().timers.size(), 0U);
    EXPECT_EQ(coach.scheduler.pending(), 0U);
}

TEST(CoachSide, AStopThatWaitsOutlivesTheRole) {
    Coach coach;
    coach.pairAtStart();
    ASSERT_TRUE(coach.side.steer(wire::Velocity{7, 0}));
    coach.wait(1000);
    const std::size_t before = coach.sent.size();
    coach.side.halt();
    coach.side.end(Unpairing::RoleEnded);
    coach.wait(10000);
    ASSERT_EQ(coach.sent.size(), before + 1);
    EXPECT_EQ(coach.sent.back().message, (wire::Message{Opcode::Velocity, 0}));
}

TEST(CoachSide, ALinkLostAfterTheRoleLeavesNothingWaiting) {
    Coach coach;
    coach.pairAtStart();
    coach.side.end(Unpairing::RoleEnded);
    ASSERT_TRUE(coach.side.stopWaits());
    coach.side.end(Unpairing::LinkLost);
    EXPECT_FALSE(coach.side.stopWaits());
}

TEST(CoachSide, OverALostLinkNothingWaits) {
    Coach coach;
    coach.pairAtStart();
    ASSERT_TRUE(coach.side.steer(wire::Velocity{7, 0}));
    coach.wait(1000);
    const std::size_t before = coach.sent.size();
    coach.side.halt();
    coach.side.end(Unpairing::LinkLost);
    coach.wait(10000);
    EXPECT_EQ(coach.sent.size(), before);
    EXPECT_EQ(coach.side.view().timers.size(), 0U);
    EXPECT_EQ(coach.scheduler.pending(), 0U);
}

}  // namespace
}  // namespace kickstand::coach::testing
