// Parameters over a whole session: what goes to the robot and comes back, what a reboot proves, and what
// keeps a robot from being rebooted.

#include "core/thunderbots/parameters.h"

#include "tests/session/safety_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using Standing = ParameterStanding;

class ParametersSession : public SafetyTest {
  protected:
    const ParameterState& known(int robot = 2) {
        rig.advance(15ms);
        state_ = rig.state();
        return state_.parameters.at(static_cast<std::size_t>(robot));
    }
    wire::OperationalParameters changed(ParameterField field, std::uint8_t value) {
        wire::OperationalParameters block = rig.robot(2).shadow;
        setValue(block, field, value);
        return block;
    }
    Result<void> read(int robot = 2) { return rig.ask(ReadParameters{robot}); }
    bool rebootTo(int number) {
        return rig.ask(RebootRobot{2}).has_value() &&
               rig.waitUntil([this] { return !rig.state().robots[2].live; }, 10s) &&
               rig.waitUntil(
                   [this, number] { return rig.state().robots.at(static_cast<std::size_t>(number)).live; },
                   20s);
    }

  private:
    Snapshot state_;
};

TEST_F(ParametersSession, AreReadAppliedCommittedAndProvenByAReboot) {
    EXPECT_EQ(known().standing, Standing::Unread);
    ASSERT_TRUE(read());
    EXPECT_EQ(known().standing, Standing::AsRead);
    EXPECT_EQ(known().robot, rig.robot(2).shadow);

    const auto block = changed(ParameterField::DribblerDuty, 77);
    ASSERT_TRUE(rig.ask(ApplyParameters{2, block}));
    EXPECT_EQ(known().standing, Standing::Applied);
    EXPECT_EQ(rig.robot(2).shadow, block);
    EXPECT_NE(rig.robot(2).committed, block);

    ASSERT_TRUE(rig.ask(CommitParameters{2}));
    EXPECT_EQ(known().standing, Standing::Committed);
    EXPECT_EQ(rig.robot(2).committed, block);

    ASSERT_TRUE(rebootTo(2));
    ASSERT_TRUE(rig.waitUntil([this] { return known().standing == Standing::Proven; }, 5s))
        << "it is read again by itself";
    EXPECT_EQ(rig.last(EventKind::ParametersProven)->code, 1);
    EXPECT_EQ(latched(), StopReason::None) << "a robot that was told to go is no surprise";
}

TEST_F(ParametersSession, EveryBlockThatIsReadIsTold) {
    ASSERT_TRUE(read());
    ASSERT_TRUE(rig.ask(ApplyParameters{2, changed(ParameterField::DribblerDuty, 0xAB)}));
    EXPECT_EQ(rig.count(EventKind::ParametersRead), 2U);
    const auto event = rig.last(EventKind::ParametersRead);
    EXPECT_EQ(event->robot, 2);
    EXPECT_NE(event->text.find(" 02 ab"), std::string::npos) << event->text;
}

TEST_F(ParametersSession, ARobotIsProvenUnderTheNumberThatItWasGiven) {
    ASSERT_TRUE(read());
    ASSERT_TRUE(rig.ask(ApplyParameters{2, changed(ParameterField::RobotNumber, 9)}));
    ASSERT_TRUE(rig.ask(CommitParameters{2}));
    ASSERT_TRUE(rebootTo(9));
    ASSERT_TRUE(rig.waitUntil([this] { return known(9).standing == Standing::Proven; }, 5s));
    EXPECT_EQ(known(2).movedTo, 9);
}

TEST_F(ParametersSession, WhatWasAppliedAndNotCommittedIsGoneAfterAReboot) {
    const auto before = rig.robot(2).committed;
    ASSERT_TRUE(read());
    ASSERT_TRUE(rig.ask(ApplyParameters{2, changed(ParameterField::DribblerDuty, 1)}));
    EXPECT_EQ(rig.refusal(RebootRobot{2}), Errc::NotCommitted);
    ASSERT_TRUE(rig.ask(RebootRobot{2, true}));
    ASSERT_TRUE(rig.waitUntil([this] { return !rig.state().robots[2].live; }, 10s));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.state().robots[2].live; }, 20s));
    ASSERT_TRUE(read());
    EXPECT_EQ(known().robot, before);
    EXPECT_EQ(known().standing, Standing::AsRead);
}

TEST_F(ParametersSession, SignaturesAreRead) {
    const CommandId id = rig.give(ReadSignatures{2});
    ASSERT_TRUE(rig.waitUntil([this, id] { return rig.answer(id).has_value(); }, 30s));
    EXPECT_TRUE(rig.answer(id)->has_value());
    ASSERT_TRUE(known().signatures.has_value());
    EXPECT_EQ(rig.last(EventKind::SignaturesRead)->code, known().signatures->microcontrollerCrc);
    EXPECT_EQ(rig.last(EventKind::SignaturesRead)->previous, known().signatures->flashCrc);
}

TEST_F(ParametersSession, NothingIsWrittenBeforeItHasBeenRead) {
    rig.forgetPackets();
    EXPECT_EQ(rig.refusal(ApplyParameters{2, rig.robot(2).shadow}), Errc::ParametersUnread);
    EXPECT_EQ(rig.refusal(CommitParameters{2}), Errc::ParametersUnread);
    for (const auto& packet : rig.packets())
        EXPECT_NE(packet.endpoint, wire::address(wire::Endpoint::MessageOut));
}

TEST_F(ParametersSession, WhatARobotCannotLiveWithIsRefused) {
    ASSERT_TRUE(read());
    EXPECT_EQ(rig.refusal(ApplyParameters{2, changed(ParameterField::Channel0, 10)}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(ApplyParameters{2, changed(ParameterField::RobotNumber, 16)}), Errc::OutOfRange);
    auto longer = rig.robot(2).shadow;
    longer.tail.append(std::uint8_t{1});
    EXPECT_EQ(rig.refusal(ApplyParameters{2, longer}), Errc::BadArgument);
    EXPECT_EQ(known().standing, Standing::AsRead);
}

TEST_F(ParametersSession, RobotsThatAreNotThereAreNotAsked) {
    EXPECT_EQ(rig.refusal(ReadParameters{12}), Errc::RobotNotAlive);
    EXPECT_EQ(rig.refusal(ReadParameters{16}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(ReadParameters{-1}), Errc::OutOfRange);
}

TEST_F(ParametersSession, OneRequestAtATimeForEachRobot) {
    const CommandId first = rig.give(ReadParameters{2});
    const CommandId second = rig.give(ReadParameters{2});
    const CommandId other = rig.give(ReadParameters{3});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(first) && rig.answer(second) && rig.answer(other); }));
    EXPECT_TRUE(rig.answer(first)->has_value());
    EXPECT_EQ(rig.answer(second)->error().code, Errc::RequestPending);
    EXPECT_TRUE(rig.answer(other)->has_value());
}

TEST_F(ParametersSession, ARobotThatMovesOrIsChargedIsNotRebooted) {
    drive(2);
    EXPECT_EQ(rig.refusal(RebootRobot{2}), Errc::NotBraked);
    ASSERT_TRUE(rig.ask(Brake{maskOf(2)}));
    charge(2);
    EXPECT_EQ(rig.refusal(RebootRobot{2}), Errc::NotBraked);
    ASSERT_TRUE(rig.ask(ArmHighVoltage{maskOf(2), false}));
    const auto refusal = rig.ask(RebootRobot{2});
    ASSERT_FALSE(refusal.has_value());
    EXPECT_EQ(refusal.error().code, Errc::CapacitorLive);
    EXPECT_GT(refusal.error().got, 50);
    EXPECT_EQ(rig.robot(2).boots, 1U);
}

TEST_F(ParametersSession, NothingIsRebootedWhileEverythingIsStopped) {
    rig.stop();
    EXPECT_EQ(rig.refusal(RebootRobot{2}), Errc::StopLatched);
    EXPECT_TRUE(read()) << "reading moves nothing";
}

TEST_F(ParametersSession, ARobotThatIsLostWhileItIsAskedIsAnAnswer) {
    rig.simulate("dead", 1, 2);
    const CommandId id = rig.give(ReadParameters{2});
    ASSERT_TRUE(rig.waitUntil([this, id] { return rig.answer(id).has_value(); }, 60s));
    ASSERT_FALSE(rig.answer(id)->has_value());
    EXPECT_EQ(rig.answer(id)->error().code, Errc::RobotNotAlive);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
