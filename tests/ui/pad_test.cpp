// What a gamepad's states come to: curves, maps, neutral first, learning by pressing.

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "ui/gamepad/pad_learner.h"
#include "ui/gamepad/pad_reader.h"

namespace kickstand::ui {
namespace {

constexpr StickCurve kStraight{0.1, 0};

TEST(StickCurve, TheDeadZoneIsNothingAndTheEndsStayTheEnds) {
    for (const double dead : {0.0, 0.12, 0.5}) {
        for (const double bend : {0.0, 0.4, 1.0}) {
            const StickCurve curve{dead, bend};
            EXPECT_EQ(shaped(dead, curve), 0);
            EXPECT_EQ(shaped(-dead, curve), 0);
            EXPECT_NEAR(shaped(1, curve), 1, 1e-12);
            EXPECT_NEAR(shaped(-1, curve), -1, 1e-12);
            EXPECT_NEAR(shaped(3, curve), 1, 1e-12);
        }
    }
}

TEST(StickCurve, ItGrowsWithoutAJumpAndIsTheSameBothWays) {
    const StickCurve curve{0.2, 0.7};
    double before = 0;
    for (double way = 0; way <= 1; way += 0.001) {
        const double value = shaped(way, curve);
        ASSERT_GE(value, before);
        ASSERT_LT(value - before, 0.01);
        ASSERT_EQ(shaped(-way, curve), -value);
        before = value;
    }
}

TEST(StickCurve, WhatIsNoNumberIsTheMiddle) {
    EXPECT_EQ(shaped(std::numeric_limits<double>::quiet_NaN(), {}), 0);
    EXPECT_EQ(shaped(std::numeric_limits<double>::infinity(), {}), 0);
}

TEST(PadMap, ItIsRememberedAsText) {
    PadMap map;
    map.setInput(PadAction::Turn, {PadInput::Kind::Axis, 4, false});
    map.setInput(PadAction::Kick, {PadInput::Kind::Button, 7, false});
    PadMap back;
    ASSERT_TRUE(back.setText(map.toText()));
    EXPECT_EQ(back, map);
}

TEST(PadMap, TextThatIsNoMapChangesNothing) {
    PadMap map;
    const QString good = map.toText();
    for (const char* text : {"", "a1+", "x y z a b c d e f", "a1 a1 a1 a1 a1 b1 b2 b3 b4",
                             "a99+ a0- a2- a1- a3- b0 b10 b9 b1", "a-1+ a0- a2- a1- a3- b0 b10 b9 b1"}) {
        EXPECT_FALSE(map.setText(QString::fromLatin1(text))) << text;
        EXPECT_EQ(map.toText(), good);
    }
}

TEST(PadMap, AButtonDoesOneThing) {
    PadMap map;
    map.setInput(PadAction::Kick, map.input(PadAction::Chip));
    EXPECT_EQ(map.input(PadAction::Chip).kind, PadInput::Kind::None);
    EXPECT_EQ(inputText(map.input(PadAction::Chip), true), QStringLiteral("nothing"));
}

TEST(PadMap, NothingTakesTheButtonOfStop) {
    PadMap map;
    const PadInput stop = map.input(PadAction::Stop);
    map.setInput(PadAction::Kick, stop);
    EXPECT_EQ(map.input(PadAction::Stop), stop);
    EXPECT_EQ(map.input(PadAction::Kick), PadMap().input(PadAction::Kick));
    map.setInput(PadAction::Stop, map.input(PadAction::Kick));
    EXPECT_EQ(map.input(PadAction::Kick).kind, PadInput::Kind::None) << "STOP takes what it is given";
}

TEST(PadState, WhatAPadDoesNotHaveIsNothing) {
    const PadState state{{0.5}, {true}};
    EXPECT_EQ(valueOf(state, {PadInput::Kind::Axis, 0, true}), -0.5);
    EXPECT_EQ(valueOf(state, {PadInput::Kind::Axis, 1, false}), 0);
    EXPECT_EQ(valueOf(state, {PadInput::Kind::Button, 0, false}), 1);
    EXPECT_EQ(valueOf(state, {PadInput::Kind::Button, 9, false}), 0);
    EXPECT_EQ(valueOf(state, {}), 0);
}

class PadReaderTest : public testing::Test {
  protected:
    PadReading read(bool wheels = false) { return reader.read(state, map, kStraight, wheels); }

    PadMap map;
    PadReader reader;
    PadState state{std::vector<double>(6, 0.0), std::vector<bool>(15, false)};
};

TEST_F(PadReaderTest, UpIsForwardLeftIsLeft) {
    read();
    state.axes = {-1, -1, -1, 0, 0, 0};
    const PadReading reading = read();
    EXPECT_EQ(reading.of(PadAction::Forward), 1);
    EXPECT_EQ(reading.of(PadAction::Left), 1);
    EXPECT_EQ(reading.of(PadAction::Turn), 1);
}

TEST_F(PadReaderTest, SticksHeldFromBeforeCountOnlyAfterTheyHaveBeenLetGo) {
    state.axes[1] = -1;
    EXPECT_TRUE(read().awaitsNeutral);
    EXPECT_EQ(read().of(PadAction::Forward), 0);
    state.axes[1] = -0.05;
    EXPECT_FALSE(read().awaitsNeutral);
    state.axes[1] = -1;
    EXPECT_EQ(read().of(PadAction::Forward), 1);
    reader.awaitNeutral();
    EXPECT_EQ(read().of(PadAction::Forward), 0);
}

TEST_F(PadReaderTest, SticksOfTheOtherWayOfDrivingNeedNotRest) {
    state.axes[3] = 1;
    EXPECT_FALSE(read().awaitsNeutral);
    reader.awaitNeutral();
    EXPECT_TRUE(read(true).awaitsNeutral);
}

TEST_F(PadReaderTest, AButtonIsPressedOnceAndOneHeldFromBeforeIsNot) {
    state.buttons[10] = true;
    EXPECT_FALSE(read().wasPressed(PadAction::Kick));
    state.buttons[10] = false;
    read();
    state.buttons[10] = true;
    EXPECT_TRUE(read().wasPressed(PadAction::Kick));
    EXPECT_FALSE(read().wasPressed(PadAction::Kick));
}

TEST_F(PadReaderTest, AButtonThatGoesDownBeforeTheSticksWereLetGoIsNoPress) {
    state.axes[1] = -1;
    EXPECT_FALSE(read().wasPressed(PadAction::Kick));
    state.buttons[10] = state.buttons[1] = true;
    const PadReading awaiting = read();
    EXPECT_TRUE(awaiting.awaitsNeutral);
    EXPECT_FALSE(awaiting.wasPressed(PadAction::Kick));
    EXPECT_TRUE(awaiting.wasPressed(PadAction::Stop));
    state.axes[1] = 0;
    EXPECT_FALSE(read().wasPressed(PadAction::Kick)) << "it has been down since before";
    state.buttons[10] = false;
    read();
    state.buttons[10] = true;
    EXPECT_TRUE(read().wasPressed(PadAction::Kick));
}

TEST_F(PadReaderTest, StopCountsWheneverItIsSeenFirst) {
    state.buttons[1] = true;
    EXPECT_TRUE(read().wasPressed(PadAction::Stop));
    reader.awaitNeutral();
    EXPECT_FALSE(read().wasPressed(PadAction::Stop));
    state.buttons[1] = false;
    read();
    state.axes[1] = 1;
    state.buttons[1] = true;
    EXPECT_TRUE(read().wasPressed(PadAction::Stop));
}

TEST_F(PadReaderTest, ATriggerIsAButtonTooAndItsRestIsNone) {
    map.setInput(PadAction::Kick, {PadInput::Kind::Axis, 5, false});
    read();
    state.axes[5] = 0.4;
    EXPECT_FALSE(read().wasPressed(PadAction::Kick));
    state.axes[5] = 0.8;
    EXPECT_TRUE(read().wasPressed(PadAction::Kick));
}

TEST(PadLearner, TheFirstThatMovesFarIsTaken) {
    const PadState rest{{0, -1, 0.2}, {false, true}};
    const PadLearner stick(rest, true);
    EXPECT_EQ(stick.look(rest), std::nullopt);
    EXPECT_EQ(stick.look({{0.4, -1, 0.2}, {true, true}}), std::nullopt);
    EXPECT_EQ(stick.look({{-0.9, -1, 0.2}, {}}), (PadInput{PadInput::Kind::Axis, 0, true}));
    const PadLearner button(rest, false);
    EXPECT_EQ(button.look({{0, -1, 0.2}, {true, true}}), (PadInput{PadInput::Kind::Button, 0, false}));
    EXPECT_EQ(button.look({{0, 0.5, 0.2}, {false, true}}), (PadInput{PadInput::Kind::Axis, 1, false}));
    EXPECT_EQ(button.look({{}, {}}), std::nullopt);
}

}  // namespace
}  // namespace kickstand::ui
