#include "ui/thunderbots/tile_content.h"

#include <gtest/gtest.h>

#include "core/thunderbots/wire/readings.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {
namespace {

using namespace thunderbots;

constexpr TimePoint kNow{std::chrono::seconds(1000)};

RobotState robot(double battery_V, double capacitor_V) {
    RobotState state;
    state.live = true;
    state.freshness = Freshness::Current;
    wire::FeedbackBlock block;
    block.valid = true;
    block.battery_adc = wire::battery_adc(battery_V);
    block.capacitor_adc = wire::capacitor_adc(capacitor_V);
    state.feedback = block;
    state.readings.battery_V = battery_V;
    state.readings.capacitor_V = capacitor_V;
    state.capacitor = CapacitorMemory{capacitor_V, kNow};
    state.told = wire::brakedBlock();
    return state;
}

RobotState lost(double capacitor_V, Duration ago) {
    RobotState state = robot(15.9, capacitor_V);
    state.live = false;
    state.freshness = Freshness::Stale;
    state.currentUntil = kNow - ago;
    return state;
}

TEST(TileContent, ARobotNeverHeardSaysSoAndShowsNoNumbers) {
    const TileContent tile = tileContent(8, RobotState{}, false, kNow);
    EXPECT_EQ(tile.state, QStringLiteral("not heard"));
    EXPECT_FALSE(tile.known);
    EXPECT_TRUE(tile.battery.isEmpty());
}

TEST(TileContent, ReadingsThatAreUnknownAreNotZero) {
    RobotState state;
    state.live = true;
    state.freshness = Freshness::Waiting;
    const TileContent tile = tileContent(8, state, false, kNow);
    EXPECT_FALSE(tile.known);
    EXPECT_TRUE(tile.state.contains(QStringLiteral("no readings")));
}

TEST(TileContent, TheBatteryHasAWordBesideItsColour) {
    EXPECT_EQ(tileContent(0, robot(15.0, 0), false, kNow).batteryWeight, TileContent::Weight::Plain);
    const TileContent low = tileContent(0, robot(14.9, 0), false, kNow);
    EXPECT_EQ(low.batteryWeight, TileContent::Weight::Warning);
    EXPECT_EQ(low.battery, QStringLiteral("14.9 V"));
    EXPECT_EQ(low.batteryWord, QStringLiteral("low"));
    EXPECT_EQ(tileContent(0, robot(13.9, 0), false, kNow).batteryWord, QStringLiteral("empty"));
}

TEST(TileContent, ACapacitorIsLiveFromFiftyVoltsOn) {
    EXPECT_FALSE(tileContent(0, robot(15.9, 49.9), false, kNow).capacitorLive);
    EXPECT_TRUE(tileContent(0, robot(15.9, 50), false, kNow).capacitorLive);
}

TEST(TileContent, ALostRobotStaysLoudForEverIfItsCapacitorWasLive) {
    const TileContent tile = tileContent(8, lost(212, std::chrono::seconds(40)), false, kNow);
    EXPECT_TRUE(tile.stale);
    EXPECT_TRUE(tile.capacitorLive);
    EXPECT_EQ(tile.capacitor, QStringLiteral("212 V?"));
    ASSERT_EQ(tile.chips.size(), 1U);
    EXPECT_EQ(tile.chips[0].text, QStringLiteral("last seen 40 s ago: treat as live"));
    EXPECT_EQ(tile.chips[0].weight, TileContent::Weight::Danger);
    EXPECT_TRUE(tileContent(8, lost(212, std::chrono::hours(3)), false, kNow).capacitorLive);
}

TEST(TileContent, ALostRobotWithAnEmptyCapacitorIsQuietAndTellsItsAge) {
    const TileContent tile = tileContent(8, lost(12, std::chrono::minutes(3)), false, kNow);
    EXPECT_FALSE(tile.capacitorLive);
    EXPECT_TRUE(tile.chips.empty());
    EXPECT_EQ(tile.state, QStringLiteral("last seen 3 min ago"));
}

TEST(TileContent, WhatTheRobotWasToldIsItsState) {
    RobotState state = robot(15.9, 0);
    EXPECT_EQ(tileContent(0, state, false, kNow).motion, QStringLiteral("braked"));
    state.told->run = true;
    EXPECT_EQ(tileContent(0, state, false, kNow).motion, QStringLiteral("holding"));
    EXPECT_FALSE(tileContent(0, state, false, kNow).moving);
    state.told->wheels[2] = 5;
    state.told->charge = state.told->dribble = true;
    const TileContent tile = tileContent(0, state, false, kNow);
    EXPECT_EQ(tile.motion, QStringLiteral("moving"));
    EXPECT_TRUE(tile.moving);
    ASSERT_EQ(tile.chips.size(), 2U);
    EXPECT_EQ(tile.chips[0].text, QStringLiteral("charging"));
    EXPECT_EQ(tile.chips[1].text, QStringLiteral("dribbler"));
}

TEST(TileContent, WhatIsDangerousComesBeforeTheBall) {
    RobotState state = robot(15.9, 100);
    state.readings.ball = true;
    state.told->charge = state.told->autokickArmed = true;
    const TileContent tile = tileContent(0, state, false, kNow);
    ASSERT_EQ(tile.chips.size(), 3U);
    EXPECT_EQ(tile.chips[0].text, QStringLiteral("charging"));
    EXPECT_EQ(tile.chips[1].text, QStringLiteral("autokick"));
    EXPECT_EQ(tile.chips[2].text, QStringLiteral("ball"));
    state.readings.charged = true;
    EXPECT_EQ(tileContent(0, state, false, kNow).chips[0].text, QStringLiteral("kept full"));
    state.told->charge = false;
    EXPECT_EQ(tileContent(0, state, false, kNow).chips[0].text, QStringLiteral("charged"));
}

TEST(TileContent, MarksAreForTheRobotThatTheyName) {
    const TileMarks marks{3, 4, QStringLiteral("charging")};
    EXPECT_EQ(tileContent(3, robot(15.9, 0), false, kNow, marks).batteryWord, QStringLiteral("lowest"));
    EXPECT_EQ(tileContent(3, robot(14.9, 0), false, kNow, marks).batteryWord, QStringLiteral("low"));
    EXPECT_TRUE(tileContent(3, robot(14.9, 0), false, kNow, marks).lowestBattery);
    EXPECT_FALSE(tileContent(2, robot(14.9, 0), false, kNow, marks).lowestBattery);
    EXPECT_TRUE(tileContent(3, robot(15.9, 0), false, kNow, marks).oddBy.isEmpty());
    EXPECT_TRUE(tileContent(4, robot(15.9, 0), false, kNow, marks)
                    .accessible.contains(QStringLiteral("the only one charging")));
}

TEST(TileContent, WhatALostRobotWasToldIsNotShownAsIfItWereSo) {
    EXPECT_TRUE(tileContent(0, lost(12, std::chrono::seconds(3)), false, kNow).motion.isEmpty());
}

TEST(TileContent, NoiseBelowWhatIsShownRepaintsNothing) {
    EXPECT_EQ(tileContent(0, robot(15.91, 0.1), false, kNow), tileContent(0, robot(15.92, 0.2), false, kNow));
    EXPECT_NE(tileContent(0, robot(15.91, 0), false, kNow), tileContent(0, robot(15.81, 0), false, kNow));
}

TEST(TileContent, ItIsReadAsASentence) {
    RobotState state = robot(15.9, 212);
    state.readings.ball = true;
    const TileContent tile = tileContent(3, state, true, kNow);
    EXPECT_EQ(tile.accessible, QStringLiteral("Robot 3, battery 15.9 V, capacitor 212 V, live, ball, braked, "
                                              "radio ok \u00b7 now, chosen"));
}

TEST(TileContent, ARobotThatIsHeardSaysByWhatAndThatItsReadingsAreOfNow) {
    RobotState state = robot(15.9, 0);
    state.capacitor->at = kNow - std::chrono::minutes(5);
    EXPECT_EQ(tileContent(0, state, false, kNow).state, QStringLiteral("radio ok \u00b7 now"));
    EXPECT_EQ(tileContent(0, state, false, kNow).stateShort, QStringLiteral("now"));
    TileMarks cable;
    cable.cable = true;
    EXPECT_EQ(tileContent(0, state, false, kNow, cable).state, QStringLiteral("cable ok \u00b7 now"));
}

TEST(TileContent, ARobotThatIsHeardWithoutValidReadingsIsNotCalledLost) {
    RobotState state = lost(12, std::chrono::seconds(3));
    state.live = true;
    EXPECT_EQ(tileContent(0, state, false, kNow).state, QStringLiteral("heard, readings 3 s old"));
}

TEST(ReadingsTip, SaysHowTheRobotIsHeardAndHowOldTheReadingsAre) {
    RobotState state = robot(15.9, 212);
    state.capacitor->at = kNow - std::chrono::seconds(7);
    EXPECT_TRUE(readingsTip(3, state, kNow).contains(QStringLiteral("radio now")));
    EXPECT_TRUE(readingsTip(3, state, kNow).contains(QStringLiteral("last changed 7 s ago")));
    TileMarks cable;
    cable.cable = true;
    EXPECT_TRUE(readingsTip(3, state, kNow, cable).contains(QStringLiteral("cable now")));
    EXPECT_TRUE(readingsTip(3, lost(12, std::chrono::seconds(9)), kNow).contains(QStringLiteral("Lost 9 s")));
    RobotState waiting;
    waiting.live = true;
    waiting.freshness = Freshness::Waiting;
    EXPECT_TRUE(readingsTip(3, waiting, kNow).contains(QStringLiteral("no readings yet")));
}

TEST(ReadingsTip, SaysWhatSetsTheRobotApart) {
    const TileMarks marks{-1, 3, QStringLiteral("charging")};
    EXPECT_TRUE(
        readingsTip(3, robot(15.9, 212), kNow, marks).contains(QStringLiteral("The only one charging.")));
    EXPECT_FALSE(readingsTip(4, robot(15.9, 212), kNow, marks).contains(QStringLiteral("only one")));
}

TEST(ReadingsTip, HasTheRawNumbers) {
    const RobotState state = robot(15.9, 212);
    EXPECT_TRUE(
        readingsTip(3, state, kNow).contains(QStringLiteral("ADC %1").arg(state.feedback->battery_adc)));
    EXPECT_TRUE(
        readingsTip(3, state, kNow).contains(QStringLiteral("ADC %1").arg(state.feedback->capacitor_adc)));
}

TEST(Words, RobotsAreListedInRuns) {
    EXPECT_EQ(robotsText(0), QString());
    EXPECT_EQ(robotsText(0b1000), QStringLiteral("robot 3"));
    EXPECT_EQ(robotsText(0b11), QStringLiteral("robots 0, 1"));
    EXPECT_EQ(robotsText(0b1000000000111101), QStringLiteral("robots 0, 2\u20135, 15"));
    EXPECT_EQ(robotsText(kAllRobots), QStringLiteral("all robots"));
}

TEST(Words, AgesGrowCoarser) {
    EXPECT_EQ(ageText(std::chrono::seconds(-1)), QStringLiteral("0 s"));
    EXPECT_EQ(ageText(std::chrono::seconds(119)), QStringLiteral("119 s"));
    EXPECT_EQ(ageText(std::chrono::seconds(120)), QStringLiteral("2 min"));
    EXPECT_EQ(ageText(std::chrono::hours(2)), QStringLiteral("2 h"));
}

TEST(Words, WhatWasToldIsSaidInFull) {
    wire::DriveBlock block;
    EXPECT_EQ(toldText(block), QStringLiteral("brake"));
    block.run = true;
    block.wheels = {42, -36, 0, 1};
    block.charge = true;
    EXPECT_EQ(toldText(block), QStringLiteral("run 42 \u221236 0 1 \u00b7 charge"));
}

}  // namespace
}  // namespace kickstand::ui
