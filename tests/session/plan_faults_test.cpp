// Every command while messages are lost, doubled and late.
#include <gtest/gtest.h>

#include "tests/session/plan_rig.h"

namespace kickstand::testing {
namespace {

using namespace motionplan;
using wire::MessageKind;
using wire::Wheels;
using namespace std::chrono_literals;

/// A rig that runs, with plan 9 in slot 4, and that knows slots 3 and 4.
struct Ready : PlanRig {
    explicit Ready(const Movements& movements = kShort) {
        EXPECT_TRUE(connect());
        EXPECT_TRUE(create(9, 4, movements));
        EXPECT_TRUE(ask(QuerySlot{3}));
        forgetWritten();
    }
};

TEST(PlanFaults, ACreateThatWasLostIsSentAgainAfterAQuery) {
    Ready rig;
    rig.simulate("lose-next", 1);
    ASSERT_TRUE(rig.ask(CreatePlan{8, 3, PlanRig::kShort}));
    EXPECT_EQ(rig.written(),
              (std::vector<std::string>{"00 08 03 0c 9e", "05 ff 03", "00 08 03 0c 9e", "05 ff 03"}));
    EXPECT_EQ(rig.robot().kept()[3].id, 8);
}

TEST(PlanFaults, ACreateWhoseCopyWasLostIsNotSentAgain) {
    Ready rig;
    rig.simulate("lose-next-out", 1);
    ASSERT_TRUE(rig.ask(CreatePlan{8, 3, PlanRig::kShort}));
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"00 08 03 0c 9e", "05 ff 03"}));
    EXPECT_EQ(rig.state().slotStates[3].plan, 8);
    EXPECT_EQ(rig.state().slotStates[3].movements.size(), 2U);
}

TEST(PlanFaults, AnUpdateWhoseCopyWasLostIsAskedForAndSentAgain) {
    Ready rig;
    rig.simulate("lose-next-out", 1);
    ASSERT_TRUE(rig.ask(UpdatePlan{9, 4, {{Wheels::BothBack, 5}}}));
    EXPECT_EQ(rig.written(),
              (std::vector<std::string>{"02 09 04 25", "05 ff 04", "02 09 04 25", "05 ff 04"}));
    EXPECT_EQ(rig.robot().kept()[4].movements, (std::vector<std::uint8_t>{0x25}));
}

TEST(PlanFaults, AnExecuteThatWasLostIsNeverSentAgainAndThePersonIsAsked) {
    Ready rig;
    rig.simulate("lose-next", 1);
    EXPECT_EQ(rig.refusal(ExecutePlan{9, 4}), Errc::Unconfirmed);
    rig.advance(30s);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.count(EventKind::Unconfirmed), 1U);
    EXPECT_EQ(rig.state().execution.state, Execution::State::Unsure);
    EXPECT_TRUE(rig.session().active());
    // Stop settles it: the robot says that nothing executes.
    EXPECT_EQ(rig.refusal(StopPlan{}), Errc::PlanRefused);
    EXPECT_FALSE(rig.session().active());
}

TEST(PlanFaults, AnExecuteWhoseCopyWasLostIsConfirmedByItsStatus) {
    Ready rig(PlanRig::kLong);
    rig.simulate("lose-next-out", 2);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.state().execution.state, Execution::State::Runs);
}

TEST(PlanFaults, AnExecuteWhoseStatusWasLostIsConfirmedByItsSlot) {
    Ready rig(PlanRig::kLong);
    rig.simulate("lose-one-out", 2);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"03 09 04", "05 ff 04"}));
    EXPECT_EQ(rig.state().execution.state, Execution::State::Runs);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().execution.step == 1; }));
}

TEST(PlanFaults, APlanThatHasEndedBeforeItsFirstStatusCameIsKnownToHaveEnded) {
    Ready rig(PlanRig::Movements{{Wheels::BothForward, 1}});
    rig.simulate("lose-one-out", 2);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.robot().executed(), 1U);
    EXPECT_FALSE(rig.session().active());
    EXPECT_EQ(rig.count(EventKind::Executing), 1U);
    EXPECT_EQ(rig.count(EventKind::Ended), 1U);
}

TEST(PlanFaults, AnAdjustThatWasLostIsNeverSentAgain) {
    Ready rig(PlanRig::kLong);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("lose-next", 1);
    EXPECT_EQ(rig.refusal(AdjustSpeed{Wheels::BothForward, 50}), Errc::Unconfirmed);
    rig.advance(10s);
    EXPECT_EQ(rig.writtenOf(MessageKind::Adjust), 1U);
    EXPECT_TRUE(rig.session().active());
}

TEST(PlanFaults, AnAdjustWhoseStatusWasLostIsConfirmedByTheNext) {
    Ready rig(PlanRig::kLong);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("lose-one-out", 2);
    EXPECT_TRUE(rig.ask(AdjustSpeed{Wheels::BothForward, 50}));
    EXPECT_EQ(rig.robot().speeds(), (std::array<double, 2>{1.5, 1.5}));
}

TEST(PlanFaults, OfAnAdjustThatArrivedItIsNotSaidThatNothingCameBack) {
    Ready rig(PlanRig::kLong);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    const CommandId id = rig.give(AdjustSpeed{Wheels::BothForward, 50});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Adjust) == 1; }));
    ASSERT_TRUE(rig.waitUntil([&] { return rig.robot().speeds()[0] == 1.5; }));
    rig.simulate("lose-next-out", 100);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }));
    ASSERT_FALSE(*rig.answer(id));
    EXPECT_EQ(rig.answer(id)->error().code, Errc::Unconfirmed);
    EXPECT_EQ(rig.answer(id)->error().subject, "adjust-arrived");
    EXPECT_EQ(rig.writtenOf(MessageKind::Adjust), 1U);
}

TEST(PlanFaults, AQueryIsAskedAgain) {
    Ready rig;
    rig.simulate("lose-next", 2);
    EXPECT_TRUE(rig.ask(QuerySlot{4}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Query), 3U);
    rig.simulate("lose-next", 3);
    EXPECT_EQ(rig.refusal(QuerySlot{4}), Errc::TimedOut);
}

TEST(PlanFaults, AQueryWhoseCopyWasLostIsStillAnswered) {
    Ready rig;
    rig.simulate("lose-next-out", 1);
    EXPECT_TRUE(rig.ask(QuerySlot{4}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Query), 1U);
    EXPECT_EQ(rig.state().slotStates[4].plan, 9);
}

TEST(PlanFaults, ATriggerPlanIsSentAgain) {
    Ready rig;
    rig.simulate("lose-next", 2);
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kShort}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Trigger), 3U);
    rig.simulate("lose-next", 3);
    const auto result = rig.ask(SetTrigger{6, PlanRig::kShort});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::EchoDiffers);
    EXPECT_EQ(result.error().detail, "sent 08 06 0c 9e, got 08 07 0c 9e");
}

TEST(PlanFaults, ATriggerPlanThatWasNotConfirmedIsTakenToBeThere) {
    Ready rig;
    rig.simulate("reply-loss", 1);
    EXPECT_EQ(rig.refusal(SetTrigger{7, PlanRig::kShort}), Errc::Unconfirmed);
    EXPECT_FALSE(rig.state().trigger.known);
    EXPECT_EQ(rig.state().trigger.plan, 7);
    // What its outbox says instead is believed.
    rig.simulate("reply-loss", 0);
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kShort}));
    rig.simulate("lose-next", 3);
    EXPECT_EQ(rig.refusal(SetTrigger{6, PlanRig::kShort}), Errc::EchoDiffers);
    EXPECT_TRUE(rig.state().trigger.known);
    EXPECT_EQ(rig.state().trigger.plan, 7);
}

TEST(PlanFaults, ATriggerPlanIsReadAgainWhereNoAnswerComes) {
    Ready rig;
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kShort}));
    rig.simulate("reply-loss", 1);
    const CommandId id = rig.give(ReadTrigger{});
    rig.advance(1500ms);
    rig.simulate("reply-loss", 0);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }));
    EXPECT_TRUE(*rig.answer(id));
    rig.simulate("reply-loss", 1);
    EXPECT_EQ(rig.refusal(ReadTrigger{}), Errc::TimedOut);
}

TEST(PlanFaults, ATriggerPlanThatTheRobotHasCutIsNotConfirmed) {
    Ready rig;
    rig.simulate("text", 1);
    const auto result = rig.ask(SetTrigger{7, {{Wheels::BothForward, 1000}}});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::EchoDiffers);
    EXPECT_EQ(result.error().detail, "sent 08 07 00, got 08 07");
    // And what lies there is not said to be nothing.
    const auto read = rig.ask(ReadTrigger{});
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, Errc::Malformed);
    EXPECT_FALSE(rig.state().trigger.known);
}

TEST(PlanFaults, AnUpdateThatTheRobotHasCutIsNotConfirmed) {
    Ready rig;
    rig.simulate("text", 1);
    EXPECT_EQ(rig.refusal(UpdatePlan{9, 4, {{Wheels::BothForward, 1000}}}), Errc::EchoDiffers);
    EXPECT_FALSE(rig.state().slotStates[4].known);
}

/// What a robot puts out that has understood something else.
void puts(PlanRig& rig, const wire::Message& message) {
    rig.sim().put(wire::encodeMessage(message)->view());
}

TEST(PlanFaults, ACopyOfAnotherCommandIsShownWhenNoOtherComes) {
    Ready rig;
    rig.simulate("lose-next", 3);
    const CommandId id = rig.give(CreatePlan{8, 3, PlanRig::kShort});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Create) == 1; }));
    puts(rig, {.kind = MessageKind::Update, .plan = 8, .slot = 3, .movements = {0x0C, 0x9E}});
    rig.simulate("loss", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }, 60s));
    ASSERT_FALSE(*rig.answer(id));
    EXPECT_EQ(rig.answer(id)->error().code, Errc::EchoDiffers);
    EXPECT_EQ(rig.answer(id)->error().detail, "sent 00 08 03 0c 9e, got 02 08 03 0c 9e");
    EXPECT_EQ(rig.count(EventKind::Differs), 1U);
}

TEST(PlanFaults, ACopyOfAnotherCommandDoesNotStandInTheWayOfTheRightOne) {
    Ready rig;
    rig.simulate("lose-next", 1);
    const CommandId id = rig.give(CreatePlan{8, 3, PlanRig::kShort});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Create) == 1; }));
    puts(rig, {.kind = MessageKind::Update, .plan = 8, .slot = 3, .movements = {0x0C, 0x9E}});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }));
    EXPECT_TRUE(*rig.answer(id));
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 2U);
}

TEST(PlanFaults, AnAnswerForAnotherSlotIsShownWhenNoOtherComes) {
    Ready rig;
    rig.simulate("lose-next", 100);
    const CommandId id = rig.give(QuerySlot{2});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Query) == 1; }));
    puts(rig, {.kind = MessageKind::Query, .plan = wire::kDummyPlan, .slot = 1});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }));
    ASSERT_FALSE(*rig.answer(id));
    EXPECT_EQ(rig.answer(id)->error().code, Errc::EchoDiffers);
    EXPECT_EQ(rig.answer(id)->error().detail, "sent 05 ff 02, got 05 ff 01");
    EXPECT_EQ(rig.writtenOf(MessageKind::Query), 3U);
}

TEST(PlanFaults, ALateAnswerForASlotOfBeforeIsNotTakenForAnotherOne) {
    Ready rig;
    rig.simulate("lose-next", 100);
    const CommandId id = rig.give(QuerySlot{2});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Query) == 1; }));
    // Slot 3 was asked for before.
    puts(rig, {.kind = MessageKind::Query, .plan = 0, .slot = 3});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(id).has_value(); }));
    ASSERT_FALSE(*rig.answer(id));
    EXPECT_EQ(rig.answer(id)->error().code, Errc::TimedOut);
}

TEST(PlanFaults, WhatAStopHasOvertakenIsNotKnownAnyMore) {
    Ready rig;
    const CommandId id = rig.give(CreatePlan{8, 3, PlanRig::kShort});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Create) == 1; }));
    rig.stop();
    EXPECT_EQ(rig.answer(id)->error().code, Errc::StopLatched);
    EXPECT_FALSE(rig.state().slotStates[3].known);
}

TEST(PlanFaults, AStopIsSentAgainAndAnErrorForTheSecondOneMeansThatTheFirstHasWorked) {
    Ready rig(PlanRig::kLong);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.advance(500ms);
    rig.simulate("lose-next-out", 2);
    EXPECT_TRUE(rig.ask(StopPlan{}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 2U);
    EXPECT_FALSE(rig.session().active());
}

TEST(PlanFaults, WhatWasLeftInTheOutboxIsProcessedBeforeAnythingIsSent) {
    Ready rig;
    rig.simulate("error", 7);
    rig.simulate("error", 200);
    // A copy of the very message that is about to be sent, left from another time.
    wire::Message stale;
    stale.kind = MessageKind::Create;
    stale.plan = 8;
    stale.slot = 3;
    stale.movements = {0x0C, 0x9E};
    rig.sim().program().command(wire::encodeMessage(stale)->view(), rig.scheduler().now());
    rig.simulate("program", 0);
    rig.simulate("program", 1);
    rig.simulate("error", 7);
    rig.simulate("lose-next", 1);
    ASSERT_TRUE(rig.ask(CreatePlan{8, 3, PlanRig::kShort}));
    EXPECT_EQ(rig.robot().kept()[3].id, 8);
    EXPECT_EQ(rig.count(EventKind::Refused), 1U);
}

TEST(PlanFaults, DoubledMessagesChangeNothing) {
    sim::NxtOptions options;
    options.weather.duplicate = 1;
    PlanRig rig(options);
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    ASSERT_TRUE(rig.create(8, 3));
    ASSERT_TRUE(rig.ask(UpdatePlan{9, 4, PlanRig::kLong}));
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kShort}));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    ASSERT_TRUE(rig.ask(AdjustSpeed{Wheels::BothForward, 10}));
    ASSERT_TRUE(rig.ask(StopPlan{}));
    EXPECT_EQ(rig.count(EventKind::Differs), 0U);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 2U);
    EXPECT_EQ(rig.count(EventKind::Executing), 1U);
    EXPECT_GT(rig.state().traffic.unexpected, 0U);
}

TEST(PlanFaults, LateMessagesAreWaitedFor) {
    sim::NxtOptions options;
    options.weather.delay = 700ms;
    PlanRig rig(options);
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 1U);
}

TEST(PlanFaults, ARobotThatFallsSilentIsSaidToAndComesBack) {
    Ready rig;
    rig.simulate("reply-loss", 1);
    EXPECT_EQ(rig.refusal(QuerySlot{4}), Errc::TimedOut);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Silent) == 1; }));
    EXPECT_FALSE(rig.state().answers);
    rig.advance(60s);
    EXPECT_EQ(rig.count(EventKind::Silent), 1U);
    rig.simulate("reply-loss", 0);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Answers) == 1; }));
    EXPECT_TRUE(rig.ask(QuerySlot{4}));
}

TEST(PlanFaults, AnExecutionThatFallsSilentIsSaidToBeStale) {
    Ready rig(PlanRig::kLong);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("loss", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().execution.stale; }));
    EXPECT_TRUE(rig.session().active());
    EXPECT_EQ(rig.count(EventKind::Stale), 1U);
    rig.simulate("loss", 0);
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.state().execution.stale; }));
}

TEST(PlanFaults, NoTimersAreLeftBehind) {
    Ready rig;
    rig.advance(10s);
    const std::size_t pending = rig.scheduler().pending();
    for (int i = 0; i < 20; ++i)
        ASSERT_TRUE(rig.ask(QuerySlot{i % 5}));
    rig.advance(10s);
    EXPECT_LE(rig.scheduler().pending(), pending + 2);
}

}  // namespace
}  // namespace kickstand::testing
