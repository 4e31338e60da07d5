#include <gtest/gtest.h>

#include "tests/unit/coach/side_testing.h"

namespace kickstand::coach::testing {
namespace {

struct Boat : SideRig<TowrpSide> {
    Boat() {
        side.begin(kOwn);
        wait(1);
    }
    void pair() {
        hears(console(kOther), Opcode::AssertCommand, 1);
        wait(250);
        ASSERT_EQ(side.state(), TowrpState::Paired);
    }
    /// Lets time pass with a COACH that sends a velocity twice a second.
    void live(int ms, std::uint8_t parameter = 0) {
        for (; ms > 0; ms -= 500) {
            hears(console(kOther), Opcode::Velocity, parameter);
            wait(500);
        }
    }
};

TEST(TowrpSide, SaysThatItIsAvailableTwiceASecondToAll) {
    Boat boat;
    boat.wait(2990);
    EXPECT_EQ(boat.count(Opcode::Available), 6U);
    EXPECT_EQ(boat.lastGap_ms(Opcode::Available), 500);
    EXPECT_EQ(boat.sent[0].destination, 0xFFFF);
    EXPECT_EQ(boat.side.view().morale, 0);
}

TEST(TowrpSide, AnAssertionPairsAndItTellsAll) {
    Boat boat;
    boat.wait(200);
    boat.sent.clear();
    boat.hears(console(kOther), Opcode::AssertCommand, 1);
    EXPECT_EQ(boat.side.state(), TowrpState::Paired);
    boat.wait(1);
    ASSERT_EQ(boat.sent.size(), 1U);
    EXPECT_EQ(boat.sent[0].destination, 0xFFFF);
    EXPECT_EQ(boat.sent[0].message, (wire::Message{Opcode::AssertionResult, kOther}));
    EXPECT_EQ(boat.side.view().color, wire::TeamColor::Blue);
    boat.wait(900);
    EXPECT_EQ(boat.count(Opcode::Available), 0U);
}

TEST(TowrpSide, ItsOwnCoachIsToldAgainWhenItAsksAgain) {
    Boat boat;
    boat.pair();
    boat.sent.clear();
    boat.hears(console(kOther), Opcode::AssertCommand, 0);
    boat.wait(200);
    EXPECT_EQ(boat.count(Opcode::AssertionResult), 1U);
    boat.hears(console(3), Opcode::AssertCommand, 0);
    boat.wait(200);
    EXPECT_EQ(boat.count(Opcode::AssertionResult), 1U) << "another one is not";
    EXPECT_EQ(boat.side.view().counters.foreign, 1U);
    EXPECT_EQ(boat.side.view().coach, kOther);
}

TEST(TowrpSide, NotPairedItTakesNothingButAnAssertion) {
    Boat boat;
    for (const Opcode opcode : {Opcode::Velocity, Opcode::SuppressMutiny, Opcode::Jettison,
                                Opcode::FreeDigital, Opcode::FreeAnalog, Opcode::UpdateMorale})
        boat.hears(console(kOther), opcode, 0x77);
    boat.hears(0xAF09, Opcode::AssertCommand, 0);
    EXPECT_EQ(boat.side.state(), TowrpState::NotPaired);
    EXPECT_EQ(boat.side.view().velocity, wire::Velocity{});
    EXPECT_EQ(boat.side.view().freeDigital, 0U);
    EXPECT_EQ(boat.side.view().counters.outOfPlace, 6U);
    EXPECT_EQ(boat.side.view().counters.foreign, 1U);
    boat.wait(600);
    EXPECT_EQ(boat.count(Opcode::UpdateMorale), 0U);
}

TEST(TowrpSide, AVelocityDrivesAndIsAnsweredByTheMorale) {
    Boat boat;
    boat.pair();
    ASSERT_TRUE(boat.side.setMorale(4));
    boat.sent.clear();
    boat.wait(300);
    boat.hears(console(kOther), Opcode::Velocity, 0xA1);
    boat.wait(1);
    EXPECT_EQ(boat.side.view().velocity, (wire::Velocity{-2, 1}));
    ASSERT_EQ(boat.sent.size(), 1U);
    EXPECT_EQ(boat.sent[0].destination, console(kOther));
    EXPECT_EQ(boat.sent[0].message, (wire::Message{Opcode::UpdateMorale, 4}));
}

TEST(TowrpSide, ASecondWithoutVelocityStopsAndFiveUnpair) {
    Boat boat;
    boat.pair();
    boat.live(3000, 0x77);
    EXPECT_TRUE(boat.side.moves());
    boat.hears(console(kOther), Opcode::Velocity, 0x77);
    boat.wait(999);
    EXPECT_TRUE(boat.side.moves());
    boat.wait(1);
    EXPECT_FALSE(boat.side.moves());
    EXPECT_TRUE(boat.side.view().stoppedItself);
    boat.wait(3999);
    EXPECT_EQ(boat.side.state(), TowrpState::Paired);
    boat.sent.clear();
    boat.wait(1);
    EXPECT_EQ(boat.side.state(), TowrpState::NotPaired);
    boat.wait(1);
    EXPECT_EQ(boat.count(Opcode::Available), 1U);
    EXPECT_EQ(boat.side.view().morale, 0);
}

TEST(TowrpSide, PairedAndNeverDrivenItUnpairsAfterFiveSeconds) {
    Boat boat;
    boat.hears(console(kOther), Opcode::AssertCommand, 0);
    boat.wait(4999);
    EXPECT_EQ(boat.side.state(), TowrpState::Paired);
    boat.wait(2);
    EXPECT_EQ(boat.side.state(), TowrpState::NotPaired);
}

TEST(TowrpSide, TheMoraleChangesOnceASecondAndSendsNothing) {
    Boat boat;
    EXPECT_EQ(boat.side.setMorale(3).error().code, Errc::NotPaired);
    boat.pair();
    boat.sent.clear();
    ASSERT_TRUE(boat.side.setMorale(3));
    ASSERT_TRUE(boat.side.setMorale(5));
    EXPECT_EQ(boat.side.view().morale, 3);
    EXPECT_EQ(boat.side.view().moraleWanted, 5);
    EXPECT_EQ(boat.side.setMorale(-11).error().code, Errc::OutOfRange);
    EXPECT_EQ(boat.side.setMorale(128).error().code, Errc::OutOfRange);
    boat.wait(999);
    EXPECT_EQ(boat.side.view().morale, 3);
    boat.wait(1);
    EXPECT_EQ(boat.side.view().morale, 5);
    EXPECT_TRUE(boat.sent.empty());
}

TEST(TowrpSide, AMutinyIsToldInEverySlotThatNoReplyTakes) {
    Boat boat;
    boat.pair();
    boat.live(1000);
    boat.sent.clear();
    ASSERT_TRUE(boat.side.setMorale(-10));
    EXPECT_EQ(boat.side.state(), TowrpState::Mutiny);
    boat.wait(1010);
    EXPECT_EQ(boat.count(Opcode::MutinyInProgress), 6U);
    EXPECT_EQ(boat.lastGap_ms(Opcode::MutinyInProgress), 200);
    EXPECT_EQ(boat.sent[0].destination, console(kOther));
    EXPECT_EQ(boat.side.setMorale(0).error().code, Errc::BadArgument);
}

TEST(TowrpSide, AMutinyIsToldOnceASecondThoughRepliesTakeEverySlot) {
    Boat boat;
    boat.pair();
    boat.live(1000);
    ASSERT_TRUE(boat.side.setMorale(-10));
    boat.sent.clear();
    for (int i = 0; i < 14; ++i) {
        boat.hears(console(kOther), Opcode::Velocity, 0);
        boat.wait(200);
    }
    EXPECT_EQ(boat.side.state(), TowrpState::Mutiny);
    EXPECT_GE(boat.count(Opcode::MutinyInProgress), 2U);
    EXPECT_GE(boat.count(Opcode::UpdateMorale), 8U);
    TimePoint last = boat.sent.front().time;
    for (const SentPacket& packet : boat.sent) {
        if (packet.message.opcode != Opcode::MutinyInProgress) continue;
        EXPECT_LE(packet.time - last, std::chrono::seconds(1));
        last = packet.time;
    }
}

TEST(TowrpSide, SuppressWithinThreeSecondsIsMoraleMinusFive) {
    Boat boat;
    boat.pair();
    boat.live(1000);
    ASSERT_TRUE(boat.side.setMorale(-10));
    boat.wait(2500);
    boat.hears(console(kOther), Opcode::SuppressMutiny);
    EXPECT_EQ(boat.side.state(), TowrpState::Paired);
    boat.sent.clear();
    boat.wait(400);
    ASSERT_FALSE(boat.sent.empty());
    EXPECT_EQ(boat.sent[0].message, (wire::Message{Opcode::UpdateMorale, 0xFB}));
    boat.hears(console(kOther), Opcode::SuppressMutiny);
    boat.wait(400);
    EXPECT_EQ(boat.count(Opcode::UpdateMorale), 2U) << "asked again it answers again";
    boat.live(2000);
    EXPECT_EQ(boat.side.state(), TowrpState::Paired);
}

TEST(TowrpSide, AMutinyThatIsNotSuppressedTakesTheBoat) {
    Boat boat;
    boat.pair();
    boat.live(1000);
    ASSERT_TRUE(boat.side.setMorale(-10));
    boat.hears(console(kOther), Opcode::Velocity, 0x70);
    boat.wait(2999);
    EXPECT_EQ(boat.side.state(), TowrpState::Mutiny);
    boat.wait(1);
    EXPECT_EQ(boat.side.state(), TowrpState::NotPaired);
    EXPECT_EQ(boat.side.view().morale, 0);
    EXPECT_FALSE(boat.side.moves());
}

TEST(TowrpSide, FreeCommandsAreShown) {
    Boat boat;
    boat.pair();
    boat.hears(console(kOther), Opcode::FreeDigital);
    boat.hears(console(kOther), Opcode::FreeAnalog, 0x9C);
    boat.hears(console(3), Opcode::FreeDigital);
    EXPECT_EQ(boat.side.view().freeDigital, 1U);
    EXPECT_EQ(boat.side.view().freeAnalog, -100);
}

TEST(TowrpSide, JettisonUnpairs) {
    Boat boat;
    boat.pair();
    ASSERT_TRUE(boat.side.setMorale(9));
    boat.hears(console(kOther), Opcode::Velocity, 0x70);
    boat.hears(console(kOther), Opcode::Jettison);
    EXPECT_EQ(boat.side.state(), TowrpState::NotPaired);
    EXPECT_EQ(boat.side.view().morale, 0);
    EXPECT_FALSE(boat.side.moves());
    EXPECT_FALSE(boat.side.view().coach);
}

TEST(TowrpSide, StoppedItStandsStillWhateverComes) {
    Boat boat;
    boat.pair();
    boat.hears(console(kOther), Opcode::Velocity, 0x70);
    boat.side.halt();
    EXPECT_FALSE(boat.side.moves());
    boat.hears(console(kOther), Opcode::Velocity, 0x70);
    EXPECT_FALSE(boat.side.moves());
    boat.side.release();
    boat.hears(console(kOther), Opcode::Velocity, 0x70);
    EXPECT_TRUE(boat.side.moves());
}

}  // namespace
}  // namespace kickstand::coach::testing
