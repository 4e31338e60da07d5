// What a motion-plan session does with a robot that hears and answers.
#include <gtest/gtest.h>

#include "tests/session/plan_rig.h"

namespace kickstand::testing {
namespace {

using namespace motionplan;
using wire::MessageKind;
using wire::Wheels;
using namespace std::chrono_literals;

TEST(Plan, ConnectingOnlyReads) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    rig.advance(5s);
    EXPECT_TRUE(rig.written().empty());
    EXPECT_EQ(rig.count(EventKind::Connected), 1U);
    EXPECT_FALSE(rig.state().active());
}

TEST(Plan, TheSampleGoesToTheRobotToTheByte) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4,
                           {{Wheels::BothForward, 25},
                            {Wheels::LeftForward, 84},
                            {Wheels::BothForward, 50},
                            {Wheels::LeftBack, 90},
                            {Wheels::BothBack, 100}}));
    // Its slot was asked for first, because nothing was known of it, and then whether it was taken.
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"05 ff 04", "00 09 04 0d 5c 12 7e 37", "05 ff 04"}));
    EXPECT_EQ(rig.robot().kept()[4].id, 9);
    EXPECT_EQ(rig.robot().kept()[4].movements, (std::vector<std::uint8_t>{0x0D, 0x5C, 0x12, 0x7E, 0x37}));
    const SlotState slot = rig.state().slotStates[4];
    EXPECT_TRUE(slot.known);
    EXPECT_EQ(slot.plan, 9);
    EXPECT_EQ(slot.movements, rig.robot().kept()[4].movements);
}

TEST(Plan, ASlotIsAskedForWithTheDummyAndAnswered) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(QuerySlot{0}));
    EXPECT_EQ(rig.state().slotStates[0].plan, 0);
    EXPECT_TRUE(rig.state().slotStates[0].known);
    ASSERT_TRUE(rig.create(17, 0));
    rig.forgetWritten();
    ASSERT_TRUE(rig.ask(QuerySlot{0}));
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"05 ff 00"}));
    EXPECT_EQ(rig.state().slotStates[0].plan, 17);
    EXPECT_FALSE(rig.state().slotStates[0].movements.empty());
}

TEST(Plan, APlanExecutesStepByStepAndEnds) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.state().execution.state, Execution::State::Runs);
    EXPECT_EQ(rig.state().execution.movements.size(), 2U);
    EXPECT_TRUE(rig.session().active());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().execution.step == 2; }));
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.session().active(); }));
    EXPECT_EQ(rig.robot().executed(), 1U);
    EXPECT_EQ(rig.count(EventKind::Executing), 1U);
    EXPECT_EQ(rig.count(EventKind::Step), 2U);
    EXPECT_EQ(rig.count(EventKind::Ended), 1U);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
}

TEST(Plan, StopEndsWhatExecutes) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    ASSERT_TRUE(rig.ask(StopPlan{}));
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_FALSE(rig.session().active());
    EXPECT_EQ(rig.count(EventKind::Stopped), 1U);
    EXPECT_EQ(rig.count(EventKind::Ended), 0U);
}

TEST(Plan, SpeedsAreAdjustedWhileAPlanExecutes) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    ASSERT_TRUE(rig.ask(AdjustSpeed{Wheels::LeftForward, -50}));
    EXPECT_EQ(rig.robot().speeds(), (std::array<double, 2>{0.5, 1}));
    ASSERT_TRUE(rig.ask(AdjustSpeed{Wheels::BothForward, 50}));
    EXPECT_EQ(rig.robot().speeds(), (std::array<double, 2>{1, 1.5}));
    EXPECT_EQ(rig.written().back(), "06 09 04 00 32");
    EXPECT_EQ(rig.count(EventKind::Adjusted), 2U);
}

TEST(Plan, AnUpdateReplacesThePlanOfItsId) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create());
    ASSERT_TRUE(rig.ask(UpdatePlan{9, 4, {{Wheels::BothBack, 1000}}}));
    EXPECT_EQ(rig.robot().kept()[4].movements, (std::vector<std::uint8_t>{0x20}));
    EXPECT_EQ(rig.state().slotStates[4].movements, (std::vector<std::uint8_t>{0x20}));
    EXPECT_EQ(rig.count(EventKind::PlanUpdated), 1U);
}

TEST(Plan, TheTriggerPlanIsConfirmedByItsOwnOutbox) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(ReadTrigger{}));
    EXPECT_TRUE(rig.state().trigger.known);
    EXPECT_EQ(rig.state().trigger.plan, 0);
    ASSERT_TRUE(rig.ask(SetTrigger{7, {{Wheels::BothBack, 50}}}));
    EXPECT_EQ(rig.written(), (std::vector<std::string>{"08 07 32"}));
    EXPECT_EQ(rig.robot().trigger().id, 7);
    EXPECT_EQ(rig.state().trigger.plan, 7);
    ASSERT_TRUE(rig.ask(ReadTrigger{}));
    EXPECT_EQ(rig.state().trigger.movements, (std::vector<std::uint8_t>{0x32}));
}

TEST(Plan, ALostConnectionStartsTheTriggerPlanAndIsSaidToBeOutOfReach) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kLong}));
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    EXPECT_TRUE(rig.robot().motion()->trigger);
    EXPECT_TRUE(rig.state().outOfReach);
    EXPECT_EQ(rig.state().link, LinkState::Searching);
    EXPECT_EQ(rig.count(EventKind::LinkLost), 1U);
    EXPECT_EQ(rig.events()[rig.events().size() - 2].code, 1);
    EXPECT_EQ(rig.latch().reason(), StopReason::LinkLost);
}

TEST(Plan, ALostConnectionStopsEverythingWhereATriggerPlanIsKnownToStart) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kLong}));
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    ASSERT_TRUE(rig.robot().motion());
    EXPECT_EQ(rig.latch().reason(), StopReason::LinkLost);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.robot().motion(); }));
}

TEST(Plan, TheTriggerPlanIsReadWithoutBeingAskedForOnEachConnection) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().trigger.known; }));
    EXPECT_EQ(rig.state().trigger.plan, wire::kNoPlan);
    EXPECT_TRUE(rig.written().empty());
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kLong}));
    rig.simulate("plugged", 0);
    rig.advance(1s);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().connections == 2; }));
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().trigger.known; }));
    EXPECT_EQ(rig.state().trigger.plan, 7);
}

TEST(Plan, ATriggerPlanIsReadAsSoonAsTheProgramThatKnowsItRuns) {
    PlanRig rig;
    rig.simulate("program", 0);
    ASSERT_TRUE(rig.connect());
    rig.advance(5s);
    EXPECT_FALSE(rig.state().trigger.known);
    rig.simulate("program", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().trigger.known; }));
}

TEST(Plan, AStopBeforeTheTriggerPlanIsReadOnlyPutsThatOff) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().request.has_value(); }));
    rig.stop();
    EXPECT_FALSE(rig.state().trigger.known);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().trigger.known; }));
}

TEST(Plan, WhatIsNoTriggerPlanIsReadOnceAndStaysUnknown) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    rig.simulate("text", 1);
    EXPECT_EQ(rig.refusal(SetTrigger{7, {{Wheels::BothForward, 1000}}}), Errc::EchoDiffers);
    rig.simulate("plugged", 0);
    rig.advance(1s);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().connections == 2; }));
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().request && rig.state().request->readsTrigger; }));
    rig.advance(1s);
    for (int look = 0; look < 100; ++look) {
        rig.advance(10ms);
        ASSERT_FALSE(rig.state().request) << look;
    }
    EXPECT_FALSE(rig.state().trigger.known);
}

TEST(Plan, ALostConnectionStopsEverythingWhereNobodyKnowsWhetherAPlanStarts) {
    PlanRig rig;
    rig.simulate("program", 0);
    ASSERT_TRUE(rig.connect());
    ASSERT_FALSE(rig.state().trigger.known);
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    EXPECT_EQ(rig.latch().reason(), StopReason::LinkLost);
}

TEST(Plan, HowStopStandsIsSaidAndNothingMore) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    EXPECT_EQ(rig.state().stop, StopState::None);
    rig.simulate("lose-next", 100);
    rig.stop();
    EXPECT_EQ(rig.state().stop, StopState::UnderWay);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().stop != StopState::UnderWay; }));
    EXPECT_EQ(rig.state().stop, StopState::Unconfirmed);
    EXPECT_TRUE(rig.robot().motion());
    rig.simulate("lose-next", 0);
    ASSERT_TRUE(rig.ask(StopPlan{}));
    EXPECT_EQ(rig.state().stop, StopState::Confirmed);
    EXPECT_FALSE(rig.robot().motion());
}

TEST(Plan, AStopThatALossHasMadeIsConfirmedOnTheNextConnection) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(SetTrigger{7, PlanRig::kLong}));
    ASSERT_TRUE(rig.ask(StopPlan{}).error().code == Errc::PlanRefused);
    rig.simulate("plugged", 0);
    rig.advance(1s);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().connections == 2; }));
    EXPECT_EQ(rig.state().stop, StopState::UnderWay);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().stop == StopState::Confirmed; }));
    EXPECT_FALSE(rig.robot().motion());
}

TEST(Plan, ALostConnectionWithNothingToStartStopsNothing) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.ask(ReadTrigger{}));
    rig.simulate("plugged", 0);
    rig.advance(100ms);
    EXPECT_EQ(rig.latch().reason(), StopReason::None);
}

TEST(Plan, AfterALossTheLineIsOpenedAgainAndAStopThatIsLatchedGoesOut) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    rig.simulate("plugged", 0);
    rig.advance(2s);
    ASSERT_TRUE(rig.robot().motion());
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().link == LinkState::Running; }));
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.robot().motion(); }));
    EXPECT_FALSE(rig.state().outOfReach);
    // Nothing that was known of the slots is taken to be so still.
    EXPECT_FALSE(rig.state().slotStates[4].known);
}

TEST(Plan, APlanThatExecutesAlreadyIsHeardOfAndLeftAlone) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.waitUntil([&] { return rig.state().trigger.known; }));
    // Another hand has set it since: nothing here knows of it.
    rig.sim().program().triggerPlan(
        wire::encodeMessage({.kind = MessageKind::Trigger, .plan = 7, .movements = {0x1E, 0x1E}})->view());
    rig.simulate("plugged", 0);
    rig.advance(1s);
    rig.simulate("plugged", 1);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.session().active(); }));
    EXPECT_EQ(rig.state().execution.plan, 7);
    bool closed = false;
    rig.session().shutdown([&] { closed = true; });
    ASSERT_TRUE(rig.waitUntil([&] { return closed; }));
    EXPECT_EQ(rig.writtenOf(MessageKind::Stop), 0U);
}

TEST(Plan, ShuttingDownStopsWhatWasStartedHere) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.create(9, 4, PlanRig::kLong));
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    bool closed = false;
    const TimePoint begin = rig.scheduler().now();
    rig.session().shutdown([&] { closed = true; });
    ASSERT_TRUE(rig.waitUntil([&] { return closed; }));
    EXPECT_FALSE(rig.robot().motion());
    EXPECT_LE(rig.scheduler().now() - begin, 400ms);
    EXPECT_EQ(rig.count(EventKind::Disconnected), 1U);
}

TEST(Plan, WhatWaitsIsAnsweredOnceWhenTheLinkGoes) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    const CommandId first = rig.give(QuerySlot{1});
    const CommandId second = rig.give(QuerySlot{2});
    rig.simulate("plugged", 0);
    rig.advance(1s);
    EXPECT_EQ(rig.answer(first)->error().code, Errc::Disconnected);
    EXPECT_EQ(rig.answer(second)->error().code, Errc::Disconnected);
    rig.simulate("plugged", 1);
    rig.advance(10s);
    EXPECT_EQ(rig.answers(first), 1U);
    EXPECT_EQ(rig.answers(second), 1U);
    EXPECT_EQ(rig.refusal(QuerySlot{1}), std::nullopt);
}

TEST(Plan, TooMuchAtOnceIsRefused) {
    PlanRig rig;
    ASSERT_TRUE(rig.connect());
    std::vector<CommandId> ids;
    for (int i = 0; i < 100; ++i)
        ids.push_back(rig.give(QuerySlot{i % 5}));
    EXPECT_EQ(rig.answer(ids.back())->error().code, Errc::QueueFull);
    ASSERT_TRUE(rig.waitUntil([&] { return rig.answer(ids.front()).has_value(); }));
    ASSERT_TRUE(rig.waitUntil([&] { return !rig.state().request; }, 60s));
    for (const CommandId id : ids)
        EXPECT_EQ(rig.answers(id), 1U);
}

}  // namespace
}  // namespace kickstand::testing
