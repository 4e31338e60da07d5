#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe.h"

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

}  // namespace
}  // namespace kickstand
