#include <map>

#include <gtest/gtest.h>

#include "core/engine/describe.h"

namespace kickstand {
namespace {

using thunderbots::Event;
using thunderbots::EventKind;

constexpr int kKinds = static_cast<int>(EventKind::Channels) + 1;

EventText textOf(const Event& event) {
    return describe(EngineEvent{1, SystemEvent(event)});
}

Event eventOf(EventKind kind, std::int64_t code = 0, std::int64_t previous = 0, double value = 0) {
    Event event;
    event.kind = kind;
    event.code = code;
    event.previous = previous;
    event.value = value;
    return event;
}

std::string wordsOf(const Event& event) {
    return textOf(event).text.toStdString();
}

TEST(DescribeEvent, EveryKindHasItsOwnWords) {
    std::map<std::string, int> seen;
    const std::string noWords = wordsOf(eventOf(static_cast<EventKind>(kKinds)));
    for (int kind = 0; kind < kKinds; ++kind) {
        const std::string words = wordsOf(eventOf(static_cast<EventKind>(kind), 1, 0, 10));
        EXPECT_FALSE(words.empty()) << kind;
        EXPECT_NE(words, noWords) << kind;
        EXPECT_EQ(words.find('%'), std::string::npos) << words;
        EXPECT_TRUE(seen.emplace(words, kind).second) << words;
    }
}

TEST(DescribeEvent, NumbersThatDoNotExistAreShownAndNotTrusted) {
    for (const std::int64_t code :
         {std::int64_t{-1}, std::int64_t{6}, std::int64_t{300}, INT64_MAX, INT64_MIN}) {
        for (int kind = 0; kind < kKinds; ++kind)
            EXPECT_FALSE(wordsOf(eventOf(static_cast<EventKind>(kind), code, code, 1e300)).empty()) << kind;
    }
    EXPECT_EQ(wordsOf(eventOf(EventKind::Radios, 300)), "radios: 300");
}

TEST(DescribeEvent, WhatAKickDidIsSaidAsFarAsItWasMeasured) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::KickMeasured, 1900, 219000, 148)),
              "kick measured: capacitor 219 → 148 V, charged again in 1.9 s");
    EXPECT_EQ(wordsOf(eventOf(EventKind::KickMeasured, -1, 219000, 148)),
              "kick measured: capacitor 219 → 148 V");
}

TEST(DescribeEvent, ASweepThatEndsEarlySaysWhy) {
    EXPECT_EQ(textOf(eventOf(EventKind::SweepEnded, 0, 12)).severity, Severity::Information);
    const EventText early =
        textOf(eventOf(EventKind::SweepEnded, static_cast<std::int64_t>(Errc::NotCharging), 3));
    EXPECT_EQ(early.severity, Severity::Warning);
    EXPECT_EQ(early.text.toStdString(),
              "sweep ended early, kicks given: 3: The capacitor was not full in time");
}

TEST(DescribeEvent, AKickIsGivenToTheDongleAndNeverDelivered) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::KickGiven, 2400, 0)), "kick given to the dongle: 2400 / 0 µs");
    EXPECT_EQ(wordsOf(eventOf(EventKind::KickGiven, 2016, 1024, 320)),
              "kick given to the dongle: 2016 / 1024 µs, solenoid 2 later by 320 µs");
    EXPECT_EQ(wordsOf(eventOf(EventKind::KickGiven, 2016, 1024, -320)),
              "kick given to the dongle: 2016 / 1024 µs, solenoid 1 later by 320 µs");
}

TEST(DescribeEvent, ALiveCapacitorOnALostRobotIsLoud) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::RobotLost, 0, 0, 212.3)),
              "lost with 212 V on its capacitor: treat as live");
    EXPECT_EQ(textOf(eventOf(EventKind::RobotLost, 0, 0, 212.3)).severity, Severity::Danger);
    EXPECT_EQ(wordsOf(eventOf(EventKind::RobotLost)), "lost");
    EXPECT_EQ(textOf(eventOf(EventKind::RobotLost)).severity, Severity::Warning);
}

TEST(DescribeEvent, AnUnfinishedDischargeStaysLoud) {
    const auto code = static_cast<std::int64_t>(Errc::NotDischarging);
    EXPECT_EQ(textOf(eventOf(EventKind::DischargeEnded, 0, 0, 24)).severity, Severity::Information);
    EXPECT_EQ(textOf(eventOf(EventKind::DischargeEnded, code, 0, 180)).severity, Severity::Danger);
    EXPECT_TRUE(textOf(eventOf(EventKind::DischargeEnded, code, 0, 180))
                    .text.endsWith(QStringLiteral("treat as live")));
    EXPECT_EQ(textOf(eventOf(EventKind::DischargeEnded, code, 0, 40)).severity, Severity::Warning);
}

TEST(DescribeEvent, TheBatteryLowAndAtItsEnd) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::BatteryLow, 1, 0, 13.84)), "battery low: 13.8 V");
    EXPECT_EQ(wordsOf(eventOf(EventKind::BatteryLow, 2, 0, 13.4)), "battery at its end: 13.4 V");
}

TEST(DescribeEvent, TheEmergencyStop) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::EmergencyStop, 2, 3)), "emergency stop: stop, before: run");
    EXPECT_EQ(textOf(eventOf(EventKind::EmergencyStop, 2, 3)).severity, Severity::Warning);
    EXPECT_EQ(textOf(eventOf(EventKind::EmergencyStop, 3, 2)).severity, Severity::Information);
}

TEST(DescribeEvent, TestLightsByTheirNames) {
    EXPECT_EQ(wordsOf(eventOf(EventKind::TestMode, 2, 5)), "test LEDs: hall 5");
    EXPECT_EQ(wordsOf(eventOf(EventKind::TestMode, 1, 0)), "test LEDs: lamp");
    EXPECT_EQ(wordsOf(eventOf(EventKind::TestMode, 0, 0)), "test LEDs: normal lights");
}

TEST(DescribeEvent, ALinkThatFailedSaysWhy) {
    Event event = eventOf(EventKind::LinkFailed, static_cast<std::int64_t>(Errc::Io));
    event.text = "resource busy";
    EXPECT_EQ(wordsOf(event), "link failed: The operating system reports a failure: resource busy");
    EXPECT_EQ(textOf(event).severity, Severity::Danger);
}

TEST(DescribeEvent, DongleTextCannotBreakTheLine) {
    Event event = eventOf(EventKind::DongleText);
    event.text = "boot\n\x1b[2Jok";
    for (const QChar c : textOf(event).text)
        EXPECT_TRUE(c.isPrint());
}

TEST(DescribeEvent, EveryNoteOfTheEngineHasItsOwnWords) {
    std::map<std::string, int> seen;
    for (int kind = 0; kind <= static_cast<int>(EngineNote::Kind::SessionClosed); ++kind) {
        EngineNote note;
        note.kind = static_cast<EngineNote::Kind>(kind);
        note.reason = StopReason::Person;
        const std::string words = describe(EngineEvent{0, note}).text.toStdString();
        EXPECT_FALSE(words.empty()) << kind;
        EXPECT_TRUE(seen.emplace(words, kind).second) << words;
    }
}

TEST(EventFacts, RobotAndTimeOfBothSorts) {
    Event event = eventOf(EventKind::RobotFound);
    event.robot = 7;
    event.time = TimePoint(Duration(5));
    EXPECT_EQ(robotOf(EngineEvent{1, SystemEvent(event)}), 7);
    EXPECT_EQ(timeOf(EngineEvent{1, SystemEvent(event)}), TimePoint(Duration(5)));
    EngineNote note;
    note.time = TimePoint(Duration(9));
    EXPECT_EQ(robotOf(EngineEvent{0, note}), -1);
    EXPECT_EQ(timeOf(EngineEvent{0, note}), TimePoint(Duration(9)));
}

TEST(DescribeEvent, WhomItConcernsIsARobotsNumberOrABoardsName) {
    thunderbots::Event robot;
    robot.robot = 7;
    EXPECT_EQ(aboutOf(EngineEvent{1, SystemEvent(robot)}), QStringLiteral("robot 7"));
    smartdevice::Event board;
    EXPECT_TRUE(aboutOf(EngineEvent{1, SystemEvent(board)}).isEmpty());
    board.robot = 3;
    board.device = "PolarBear";
    EXPECT_EQ(aboutOf(EngineEvent{1, SystemEvent(board)}), QStringLiteral("PolarBear 3"));
    EXPECT_TRUE(aboutOf(EngineEvent{0, EngineNote{}}).isEmpty());
}

}  // namespace
}  // namespace kickstand
