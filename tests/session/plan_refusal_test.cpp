// What the robot refuses, what is kept from it because it would, and what STOP does.
#include <algorithm>
#include <array>
#include <cstdint>

#include <gtest/gtest.h>

#include "core/motionplan/wire/nxt_status.h"
#include "tests/session/plan_rig.h"

namespace kickstand::testing {
namespace {

using namespace motionplan;
using wire::MessageKind;
using wire::Wheels;
using namespace std::chrono_literals;

/// The robot's error code that a command was refused with, or kept from.
int codeOf(const Result<void>& result, Errc expected) {
    if (result || result.error().code != expected) return -1;
    return static_cast<int>(result.error().got.value_or(-2));
}

TEST(PlanRefusal, WhatTheRobotWouldRefuseIsNotSent) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    rig.forgetWritten();
    const auto kept = [&](const Command& command) { return codeOf(rig.ask(command), Errc::WouldBeRefused); };
    EXPECT_EQ(kept(CreatePlan{8, 4, PlanRig::kShort}), wire::kErrorSlotFull);
    EXPECT_EQ(kept(UpdatePlan{8, 4, PlanRig::kShort}), wire::kErrorUpdateOtherPlan);
    EXPECT_EQ(kept(ExecutePlan{8, 4}), wire::kErrorExecuteOtherPlan);
    EXPECT_EQ(kept(AdjustSpeed{Wheels::BothForward, 10}), wire::kErrorAdjustIdle);
    EXPECT_TRUE(rig.written().empty());
    EXPECT_EQ(kept(UpdatePlan{8, 3, PlanRig::kShort}), wire::kErrorUpdateEmptySlot);
    EXPECT_EQ(kept(ExecutePlan{8, 3}), wire::kErrorExecuteEmptySlot);
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"05 ff 03"}));
}

TEST(PlanRefusal, StoppingOrAdjustingNothingIsSaid) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    EXPECT_EQ(codeOf(rig.ask(StopPlan{}), Errc::PlanRefused), wire::kErrorStopIdle);
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    // The robot has lost its plan, and nobody has heard of it yet.
    rig.sim().program().restart();
    EXPECT_EQ(codeOf(rig.ask(AdjustSpeed{Wheels::BothForward, 10}), Errc::PlanRefused),
              wire::kErrorAdjustIdle);
    EXPECT_FALSE(rig.session().active());
}

TEST(PlanRefusal, AnUpdateThatIsRefusedForNothingExecutingIsShownToo) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    rig.simulate("strict-update", 1);
    EXPECT_EQ(codeOf(rig.ask(UpdatePlan{9, 4, PlanRig::kShort}), Errc::PlanRefused), wire::kErrorUpdateIdle);
}

TEST(PlanRefusal, ErrorsThatNobodyHasAskedForAreTold) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    for (int code = 0; code < 8; ++code)
        rig.simulate("error", code), rig.advance(1s);
    rig.simulate("error", 200);
    rig.advance(1s);
    EXPECT_EQ(rig.count(EventKind::Refused), 9U);
    EXPECT_EQ(rig.events().back().code, 200);
    EXPECT_EQ(rig.events().back().previous, 1);
}

TEST(PlanRefusal, AnErrorThatComesAgainAndAgainIsToldAgain) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    // Each time it may be the one of before, doubled on its way: but not for ever.
    for (int i = 0; i < 7; ++i)
        rig.simulate("error", 7), rig.advance(1s);
    EXPECT_GE(rig.count(EventKind::Refused), 3U);
    EXPECT_LT(rig.count(EventKind::Refused), 7U);
}

TEST(PlanRefusal, WhatCannotBeAPlanIsRefusedAtOnce) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    EXPECT_EQ(rig.refusal(CreatePlan{9, 4, {}}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(CreatePlan{9, 4, PlanRig::Movements(56, {Wheels::BothForward, 1})}),
              Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(CreatePlan{0, 4, PlanRig::kShort}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(CreatePlan{255, 4, PlanRig::kShort}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(CreatePlan{9, 5, PlanRig::kShort}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(QuerySlot{-1}), Errc::OutOfRange);
    EXPECT_EQ(rig.refusal(ExecutePlan{9, 7}), Errc::OutOfRange);
    const auto noCode = rig.ask(CreatePlan{9, 4, {{Wheels::BothForward, 25}, {Wheels::BothForward, 38}}});
    EXPECT_EQ(noCode.error().code, Errc::NoMovementCode);
    EXPECT_EQ(noCode.error().got, 1);
    EXPECT_EQ(noCode.error().detail, "forward 35, forward 3");
    EXPECT_EQ(rig.refusal(SetTrigger{9, PlanRig::Movements(56, {Wheels::BothForward, 1})}), std::nullopt);
    EXPECT_EQ(rig.refusal(SetTrigger{9, PlanRig::Movements(57, {Wheels::BothForward, 1})}), Errc::OutOfRange);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 0U);
}

TEST(PlanRefusal, ARobotThatReadsTextIsFoundOutByItsCopy) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(QuerySlot{1}));
    rig.simulate("text", 1);
    const auto result = rig.ask(CreatePlan{9, 1, PlanRig::kShort});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::EchoDiffers);
    EXPECT_EQ(result.error().detail, "sent 00 09 01 0c 9e, got nothing");
    EXPECT_EQ(rig.count(EventKind::Differs), 1U);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 1U);
}

TEST(PlanRefusal, ARobotWithoutAProgramSaysSo) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    rig.simulate("program", 0);
    const auto result = rig.ask(QuerySlot{1});
    ASSERT_FALSE(result);
    EXPECT_EQ(result.error().code, Errc::NxtRefused);
    EXPECT_EQ(result.error().got, wire::kStatusNoProgram);
    EXPECT_EQ(rig.state().nxtStatus, wire::kStatusNoProgram);
    EXPECT_EQ(rig.count(EventKind::NxtStatus), 1U);
    rig.simulate("program", 1);
    EXPECT_TRUE(rig.ask(QuerySlot{1}));
}

TEST(PlanRefusal, OnlyOnePlanIsExecutedAtATime) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.refusal(ExecutePlan{9, 4}), Errc::PlanExecuting);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
}

TEST(PlanRefusal, ASecondExecuteIsNotTakenWhileTheFirstWaits) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.create(8, 3, PlanRig::kLong));
    const CommandId before = rig.give(QuerySlot{1});
    const CommandId first = rig.give(ExecutePlan{9, 4});
    const CommandId second = rig.give(ExecutePlan{8, 3});
    ASSERT_TRUE(rig.answer(second));
    EXPECT_EQ(rig.answer(second)->error().code, Errc::PlanExecuting);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(first).has_value(); }));
    EXPECT_TRUE(*rig.answer(before));
    EXPECT_TRUE(*rig.answer(first));
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.robot().motion()->plan, 9);
}

TEST(PlanRefusal, ASecondExecuteIsNotTakenWhileTheSlotOfTheFirstIsAskedFor) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    const CommandId first = rig.give(ExecutePlan{9, 4});
    const CommandId second = rig.give(ExecutePlan{9, 4});
    EXPECT_EQ(rig.answer(second)->error().code, Errc::PlanExecuting);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(first).has_value(); }));
    EXPECT_EQ(codeOf(*rig.answer(first), Errc::WouldBeRefused), wire::kErrorExecuteEmptySlot);
    // The first is done with: the next is looked at for what it is.
    EXPECT_EQ(codeOf(rig.ask(ExecutePlan{9, 4}), Errc::WouldBeRefused), wire::kErrorExecuteEmptySlot);
}

TEST(PlanRefusal, AnExecuteThatWaitedIsNotSentIntoAPlanThatExecutesByThen) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    rig.forgetWritten();
    const CommandId before = rig.give(QuerySlot{1});
    const CommandId waiting = rig.give(ExecutePlan{9, 4});
    // Another hand starts it.
    wire::Message execute;
    execute.kind = MessageKind::Execute;
    execute.plan = 9;
    execute.slot = 4;
    rig.sim().program().command(wire::encodeMessage(execute)->view(), rig.scheduler().now());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(waiting).has_value(); }));
    EXPECT_TRUE(*rig.answer(before));
    EXPECT_EQ(rig.answer(waiting)->error().code, Errc::PlanExecuting);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 0U);
    EXPECT_EQ(rig.state().execution.state, Execution::State::Runs);
}

TEST(PlanRefusal, WhatWaitedIsLookedAtAgainBeforeItIsSent) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(QuerySlot{3}));
    const CommandId first = rig.give(CreatePlan{8, 3, PlanRig::kShort});
    const CommandId second = rig.give(CreatePlan{9, 3, PlanRig::kShort});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(second).has_value(); }));
    EXPECT_TRUE(*rig.answer(first));
    EXPECT_EQ(codeOf(*rig.answer(second), Errc::WouldBeRefused), wire::kErrorSlotFull);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 1U);
    // What was not sent leaves no doubt behind it.
    EXPECT_EQ(rig.state().slotStates[3].plan, 8);
}

TEST(PlanRefusal, AnAdjustThatWaitedIsNotSentToAPlanThatIsOver) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, {{Wheels::BothForward, 10}}));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    for (int slot = 0; slot < wire::kSlots; ++slot)
        rig.give(QuerySlot{slot});
    const CommandId adjust = rig.give(AdjustSpeed{Wheels::BothForward, 10});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(adjust).has_value(); }));
    EXPECT_EQ(codeOf(*rig.answer(adjust), Errc::WouldBeRefused), wire::kErrorAdjustIdle);
    EXPECT_EQ(rig.writtenOf(MessageKind::Adjust), 0U);
}

TEST(PlanStop, GoesOutAtOnceAndIsConfirmed) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.forgetWritten();
    rig.stop();
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"01"}));
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 1s));
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_FALSE(rig.session().active());
}

TEST(PlanStop, DropsWhatWaitsAndStaysUntilRearmed) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    const CommandId waiting = rig.give(CreatePlan{8, 3, PlanRig::kShort});
    const CommandId behind = rig.give(ExecutePlan{9, 4});
    rig.stop();
    EXPECT_EQ(rig.answer(waiting)->error().code, Errc::StopLatched);
    EXPECT_EQ(rig.answer(behind)->error().code, Errc::StopLatched);
    for (const Command& command :
         {Command(CreatePlan{8, 3, PlanRig::kShort}), Command(UpdatePlan{9, 4, PlanRig::kShort}),
          Command(ExecutePlan{9, 4}), Command(AdjustSpeed{}), Command(SetTrigger{1, PlanRig::kShort})})
        EXPECT_EQ(rig.refusal(command), Errc::StopLatched);
    EXPECT_EQ(rig.refusal(QuerySlot{4}), std::nullopt);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 0U);
    rig.latch().rearm();
    EXPECT_EQ(rig.refusal(ExecutePlan{9, 4}), std::nullopt);
}

TEST(PlanStop, SaysWhenTheRobotHasConfirmedItAndNotBefore) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    const TimePoint asked = rig.scheduler().now();
    rig.simulate("lose-next", 100);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::StopUnconfirmed) == 1; }, 20s));
    EXPECT_LT(rig.state().stopConfirmedAt, asked);
    rig.simulate("lose-next", 0);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().stopConfirmedAt >= asked; }, 5s));
}

TEST(PlanStop, ThePersonsOwnGoesBeforeWhatWaits) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.forgetWritten();
    const CommandId before = rig.give(QuerySlot{1});
    const CommandId behind = rig.give(QuerySlot{2});
    const CommandId stop = rig.give(StopPlan{});
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"01"}));
    EXPECT_EQ(rig.answer(before)->error().code, Errc::Cancelled);
    EXPECT_EQ(rig.answer(behind)->error().code, Errc::Cancelled);
    // Pressed again before the first is confirmed, it is sent again, and both are answered.
    const CommandId again = rig.give(StopPlan{});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(again).has_value(); }));
    EXPECT_EQ(rig.answers(stop), 1U);
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_FALSE(rig.session().active());
    EXPECT_EQ(rig.refusal(QuerySlot{1}), std::nullopt);
}

TEST(PlanStop, ThatTheLinkDoesNotOutliveIsAnsweredOnce) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    const CommandId id = rig.give(StopPlan{});
    rig.simulate("plugged", 0);
    rig.advance(1s);
    ASSERT_TRUE(rig.answer(id));
    EXPECT_EQ(rig.answer(id)->error().code, Errc::Disconnected);
    rig.simulate("plugged", 1);
    rig.advance(10s);
    EXPECT_EQ(rig.answers(id), 1U);
}

TEST(PlanStop, IsNotConfirmedByCopiesOfAnEarlierOne) {
    PlanRig rig;
    const auto stop = wire::encodeMessage({.kind = MessageKind::Stop});
    rig.sim().program().command(stop->view(), rig.scheduler().now());
    rig.session().start();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().link == LinkState::Running; }));
    rig.simulate("lose-next", 1);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 10s));
    // The copy of before was read after the first, lost one; another was sent to be sure.
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 2U);
}

TEST(PlanStop, IsSentAgainUntilTheRobotHasConfirmedIt) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("lose-next", 2);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 5s));
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 3U);
    EXPECT_FALSE(rig.robot().motion());
}

TEST(PlanStop, IsNotEndedByTheEmptyCopyOfWhatItHasOvertaken) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(QuerySlot{3}));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("text", 1);
    rig.simulate("delay", 300);
    rig.give(CreatePlan{8, 3, PlanRig::kShort});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Create) == 1; }));
    rig.advance(50ms);
    rig.simulate("lose-next", 1);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 20s));
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 2U);
    EXPECT_EQ(rig.count(EventKind::StopUnconfirmed), 0U);
}

TEST(PlanStop, IsNotEndedByACopyThatDiffersFromIt) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("lose-next", 1);
    rig.stop();
    const std::array<std::uint8_t, 2> longer{0x01, 0x05};
    rig.sim().put(longer);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 20s));
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 2U);
    EXPECT_EQ(rig.count(EventKind::StopUnconfirmed), 0U);
}

TEST(PlanStop, ThatHasWorkedIsNotSaidToHaveFoundNothing) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.advance(500ms);
    // The copy and the status of the first are lost: the second finds nothing that executes.
    rig.simulate("lose-next-out", 2);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 10s));
    const auto stopped = std::ranges::find(rig.events(), EventKind::Stopped, &Event::kind);
    EXPECT_EQ(stopped->code, 0);
}

TEST(PlanStop, ThatIsNeverConfirmedIsSaidAloud) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("lose-next", 100);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::StopUnconfirmed) == 1; }, 20s));
    EXPECT_TRUE(rig.session().active());
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 5U);
    // Pressed again, it is sent again.
    rig.simulate("lose-next", 0);
    rig.stop();
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.robot().motion(); }, 2s));
}

TEST(PlanStop, NobodyWhoWatchesStopsWhatWasStartedHere) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.beat(false);
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.robot().motion(); }, 1s));
    EXPECT_EQ(rig.latch().reason(), StopReason::HeartbeatStale);
}

TEST(PlanStop, AnExecuteThatWasOnItsWayIsStoppedToo) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    const CommandId id = rig.give(ExecutePlan{9, 4});
    ASSERT_TRUE(rig.waitUntil([&] { return rig.writtenOf(MessageKind::Execute) == 1; }));
    rig.stop();
    EXPECT_EQ(rig.answer(id)->error().code, Errc::StopLatched);
    EXPECT_TRUE(rig.session().active());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.count(EventKind::Stopped) == 1; }, 3s));
    EXPECT_FALSE(rig.robot().motion());
}

}  // namespace
}  // namespace kickstand::testing
