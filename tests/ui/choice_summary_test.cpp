#include "ui/thunderbots/choice_summary.h"

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

using namespace thunderbots;

class ChoiceSummaryTest : public testing::Test {
  protected:
    void makeLive(int robot) {
        auto& state = snapshot.robots[static_cast<std::size_t>(robot)];
        state.live = true;
        state.freshness = Freshness::Current;
        snapshot.intents[static_cast<std::size_t>(robot)].mustPassZero = false;
    }

    Snapshot snapshot;
};

TEST_F(ChoiceSummaryTest, NobodyChosenIsNothing) {
    makeLive(3);
    const ChoiceSummary summary = summarize(snapshot, 0);
    EXPECT_EQ(summary.live, 0);
    EXPECT_FALSE(summary.target[0].has_value());
    EXPECT_FALSE(summary.capacitor_V.has_value());
}

TEST_F(ChoiceSummaryTest, OnlyThoseHeardTakeCommands) {
    makeLive(3);
    const ChoiceSummary summary = summarize(snapshot, maskOf(3) | maskOf(4));
    EXPECT_EQ(summary.chosen, maskOf(3) | maskOf(4));
    EXPECT_EQ(summary.live, maskOf(3));
}

TEST_F(ChoiceSummaryTest, SetPointsAreSharedOrDifferWheelByWheel) {
    makeLive(1);
    makeLive(2);
    snapshot.intents[1].target = {10, 20, 30, 40};
    snapshot.intents[2].target = {10, 21, 30, -40};
    const ChoiceSummary summary = summarize(snapshot, maskOf(1) | maskOf(2));
    EXPECT_EQ(summary.target[0], 10);
    EXPECT_FALSE(summary.target[1].has_value());
    EXPECT_EQ(summary.target[2], 30);
    EXPECT_FALSE(summary.target[3].has_value());
}

TEST_F(ChoiceSummaryTest, SwitchesAreNoneSomeOrEvery) {
    makeLive(1);
    makeLive(2);
    snapshot.intents[1].dribbler = true;
    snapshot.intents[1].charger = snapshot.intents[2].charger = true;
    const ChoiceSummary summary = summarize(snapshot, maskOf(1) | maskOf(2));
    EXPECT_EQ(summary.dribbler, All::Some);
    EXPECT_EQ(summary.charger, All::Every);
    EXPECT_EQ(summary.run, All::None);
}

TEST_F(ChoiceSummaryTest, TheHighestCapacitorCountsAlsoWhenItsRobotIsLost) {
    makeLive(1);
    snapshot.robots[1].capacitor = CapacitorMemory{30, {}};
    snapshot.robots[7].capacitor = CapacitorMemory{212, {}};
    snapshot.robots[7].freshness = Freshness::Stale;
    const ChoiceSummary summary = summarize(snapshot, maskOf(1) | maskOf(7));
    EXPECT_EQ(summary.capacitorRobot, 7);
    EXPECT_DOUBLE_EQ(*summary.capacitor_V, 212);
    EXPECT_TRUE(summary.capacitorStale);
}

TEST_F(ChoiceSummaryTest, WhatWasToldIsSharedOrNot) {
    makeLive(1);
    makeLive(2);
    wire::DriveBlock run;
    run.run = true;
    snapshot.robots[1].told = snapshot.robots[2].told = run;
    EXPECT_EQ(summarize(snapshot, maskOf(1) | maskOf(2)).told, run);
    EXPECT_FALSE(summarize(snapshot, maskOf(1) | maskOf(2)).toldDiffers);
    snapshot.robots[2].told = wire::brakedBlock();
    EXPECT_TRUE(summarize(snapshot, maskOf(1) | maskOf(2)).toldDiffers);
}

}  // namespace
}  // namespace kickstand::ui
