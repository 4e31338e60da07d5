#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe.h"
#include "core/engine/describe_motionplan.h"
#include "core/engine/describe_stop.h"

namespace kickstand {
namespace {

/// Every one of `last + 1` states says something of its own, and the number after the last says nothing.
template <class State>
void expectOwnTexts(State last) {
    std::set<QString> texts;
    const int count = static_cast<int>(last) + 1;
    for (int number = 0; number < count; ++number) {
        const QString text = describe(static_cast<State>(number));
        EXPECT_FALSE(text.isEmpty()) << number;
        EXPECT_TRUE(texts.insert(text).second) << text.toStdString();
    }
    EXPECT_TRUE(describe(static_cast<State>(count)).isEmpty());
}

TEST(DescribeState, EveryStateHasItsOwnWords) {
    expectOwnTexts(StopReason::Suspend);
    expectOwnTexts(thunderbots::LinkState::Failed);
    expectOwnTexts(thunderbots::wire::EStop::Run);
    expectOwnTexts(thunderbots::wire::RadioState::Radio1Failed);
}

TEST(DescribeState, SaysWhatAPersonSees) {
    EXPECT_EQ(describe(thunderbots::wire::EStop::Disconnected).toStdString(), "not plugged in");
    EXPECT_EQ(describe(StopReason::Person).toStdString(), "by hand");
}

TEST(DescribeState, OfAStopThatARobotHasNotConfirmedNothingIsPromised) {
    using motionplan::StopState;
    motionplan::Snapshot robot;
    std::set<QString> texts;
    for (const StopState stop :
         {StopState::None, StopState::UnderWay, StopState::Confirmed, StopState::Unconfirmed}) {
        robot.stop = stop;
        const QString text = stoppedText(robot, StopReason::Person);
        EXPECT_EQ(text.contains(QStringLiteral("The robot stands")), stop == StopState::Confirmed);
        // What has ended since the link was lost is told by how Stop stands, not by what has set it.
        EXPECT_EQ(text, stoppedText(robot, StopReason::LinkLost));
        EXPECT_TRUE(texts.insert(text).second) << text.toStdString();
    }
    robot.stop = StopState::Confirmed;
    robot.execution.state = motionplan::Execution::State::Runs;
    EXPECT_TRUE(texts.insert(stoppedText(robot, StopReason::Person)).second);
    robot.outOfReach = true;
    EXPECT_EQ(stoppedText(robot, StopReason::Person), outOfReachText());
}

}  // namespace
}  // namespace kickstand
