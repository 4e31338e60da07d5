#include "core/thunderbots/kick_log.h"

#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "tests/unit/thunderbots/model_testing.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;

constexpr wire::KickTimes kTimes{true, false, 75, 0, 0};

class KickLogTest : public ::testing::Test {
  protected:
    void reading(double volts, int robot = 3) {
        log.sample({static_cast<std::uint16_t>(robot), static_cast<std::uint16_t>(Signal::Capacitor_V)}, now,
                   static_cast<float>(volts));
    }
    void readings(std::initializer_list<double> volts, Duration every) {
        for (const double one : volts) {
            now += every;
            reading(one);
        }
    }
    void unknown(int robot = 3) {
        log.gap({static_cast<std::uint16_t>(robot), static_cast<std::uint16_t>(Signal::Capacitor_V)}, now);
    }
    void hear(EventKind kind, std::int64_t code = 0, int robot = 3) {
        Event event;
        event.kind = kind;
        event.time = now;
        event.robot = robot;
        event.code = code;
        RobotState state;
        state.lastKick = kTimes;
        state.readings.charged = charged;
        log.heard(event, state);
    }
    void kick(int robot = 3) { hear(EventKind::KickGiven, 0, robot); }
    KickRecord newest() { return log.records()->back(); }

    testing::SampleRecorder onward;
    std::vector<Event> events;
    KickLog log{onward, [this](const Event& event) { events.push_back(event); }};
    TimePoint now{10s};
    bool charged = false;
};

TEST_F(KickLogTest, MeasuresTheDropAndTheTimeUntilChargedAgain) {
    reading(219);
    kick();
    EXPECT_TRUE(log.measuring(3));
    readings({219, 160, 148, 170, 200, 214}, 140ms);
    EXPECT_TRUE(log.measuring(3));
    readings({216}, 140ms);
    ASSERT_FALSE(log.measuring(3));
    const KickRecord record = newest();
    EXPECT_EQ(record.measure, KickMeasure::Recharged);
    EXPECT_EQ(record.robot, 3);
    EXPECT_EQ(record.cause, KickCause::Asked);
    EXPECT_EQ(record.times, kTimes);
    EXPECT_DOUBLE_EQ(*record.before_V, 219);
    EXPECT_DOUBLE_EQ(*record.after_V, 148);
    EXPECT_DOUBLE_EQ(*record.drop_V(), 71);
    EXPECT_EQ(record.recharge, 7 * 140ms);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].kind, EventKind::KickMeasured);
    EXPECT_EQ(events[0].code, 980);
    EXPECT_EQ(events[0].previous, 219000);
    EXPECT_DOUBLE_EQ(events[0].value, 148);
}

TEST_F(KickLogTest, TheRobotsOwnWordThatItIsChargedEndsTheRecharge) {
    reading(230);
    kick();
    readings({150, 200, 216}, 200ms);
    hear(EventKind::Charged);
    log.tick(now += 10ms);
    EXPECT_EQ(newest().measure, KickMeasure::Recharged) << "216 V is less than 98 % of 230 V";
    EXPECT_EQ(newest().recharge, 600ms);
}

TEST_F(KickLogTest, TheChargerMayGoOnUntilTheKickComes) {
    reading(180);
    kick();
    readings({182, 184, 130}, 50ms);
    EXPECT_DOUBLE_EQ(*newest().before_V, 184);
    EXPECT_DOUBLE_EQ(*newest().after_V, 130);
}

TEST_F(KickLogTest, NoiseIsNeitherADropNorARecharge) {
    reading(200);
    kick();
    readings({199.8, 200.1, 199.7}, 100ms);
    EXPECT_EQ(newest().measure, KickMeasure::Waiting);
    readings({199, 199.1, 199, 199.1, 199}, 200ms);
    EXPECT_EQ(newest().measure, KickMeasure::Recharging) << "of a drop of 1.1 V half is to be regained";
    readings({199.7}, 200ms);
    EXPECT_EQ(newest().measure, KickMeasure::Recharged);
}

TEST_F(KickLogTest, AKickThatDoesNothingIsMeasuredAsThat) {
    reading(200);
    kick();
    now += KickLog::kDropLimit - 1ms;
    log.tick(now);
    EXPECT_TRUE(log.measuring(3)) << "an unchanged reading is not sent again: silence is no gap";
    log.tick(now += 1ms);
    EXPECT_EQ(newest().measure, KickMeasure::NoDrop);
    EXPECT_DOUBLE_EQ(*newest().after_V, 200);
    EXPECT_FALSE(newest().recharge);
    ASSERT_EQ(events.size(), 1U);
    EXPECT_EQ(events[0].code, -1);
}

TEST_F(KickLogTest, WithoutAChargerTheDropIsKnownAndTheRechargeIsNot) {
    reading(200);
    kick();
    readings({150}, 100ms);
    log.tick(now += KickLog::kRechargeLimit);
    EXPECT_EQ(newest().measure, KickMeasure::NotRecharged);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 50);
    EXPECT_FALSE(newest().recharge);
}

TEST_F(KickLogTest, WithoutAKnownVoltageNothingIsMeasured) {
    kick();
    EXPECT_EQ(newest().measure, KickMeasure::Lost);
    EXPECT_FALSE(newest().before_V);
    EXPECT_FALSE(newest().drop_V());
    EXPECT_FALSE(log.measuring(3));
    EXPECT_TRUE(events.empty());
}

TEST_F(KickLogTest, ALossBeforeTheLowestIsSureLeavesNoNumber) {
    reading(219);
    kick();
    readings({170}, 100ms);
    now += 100ms;
    unknown();
    EXPECT_EQ(newest().measure, KickMeasure::Lost);
    EXPECT_FALSE(newest().after_V);
    EXPECT_FALSE(newest().drop_V());
    EXPECT_TRUE(events.empty());
    reading(219);
    log.tick(now += 1h);
    EXPECT_EQ(newest().measure, KickMeasure::Lost) << "what comes later belongs to no kick";
}

TEST_F(KickLogTest, ALossDuringRechargeKeepsTheDrop) {
    reading(219);
    kick();
    readings({148, 160, 170, 180}, 200ms);
    unknown();
    EXPECT_EQ(newest().measure, KickMeasure::Lost);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 71);
    EXPECT_FALSE(newest().recharge);
}

TEST_F(KickLogTest, TheNextKickEndsTheMeasurementOfTheOneBefore) {
    reading(219);
    kick();
    readings({148, 150, 160}, 200ms);
    kick();
    EXPECT_EQ(log.records()->at(0).measure, KickMeasure::Overtaken);
    EXPECT_DOUBLE_EQ(*log.records()->at(0).after_V, 148);
    EXPECT_FALSE(log.records()->at(0).recharge);
    EXPECT_DOUBLE_EQ(*newest().before_V, 160);
    readings({120}, 200ms);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 40);
}

TEST_F(KickLogTest, KicksThatCannotBeToldApartAreNotMeasured) {
    reading(219);
    kick();
    now += 100ms;
    kick();
    now += 100ms;
    kick();
    readings({80, 90}, 100ms);
    for (const KickRecord& record : *log.records()) {
        EXPECT_EQ(record.measure, KickMeasure::Overtaken);
        EXPECT_FALSE(record.drop_V()) << "the fall is of all three";
    }
    EXPECT_TRUE(log.measuring(3)) << "nor is anything known yet";
    log.tick(now += KickLog::kDropLimit);
    EXPECT_FALSE(log.measuring(3));
    kick();
    readings({60}, 100ms);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 30);
}

TEST_F(KickLogTest, AnAutokickRightAfterAKickLeavesNoNumberForEither) {
    reading(219);
    kick();
    readings({121}, 150ms);
    now += 50ms;
    hear(EventKind::Autokick, 1);
    EXPECT_FALSE(log.records()->at(0).drop_V()) << "part of the fall may be the autokick's";
    EXPECT_FALSE(newest().drop_V());
    EXPECT_TRUE(events.empty());
}

TEST_F(KickLogTest, AnAutokickDuringRechargeIsMeasuredFromWhatWasReachedByThen) {
    reading(219);
    kick();
    readings({121, 140, 160, 180, 130}, 400ms);
    now += 50ms;
    hear(EventKind::Autokick, 1);
    EXPECT_DOUBLE_EQ(*log.records()->at(0).drop_V(), 98);
    EXPECT_DOUBLE_EQ(*newest().before_V, 180);
    EXPECT_DOUBLE_EQ(*newest().after_V, 130);
}

TEST_F(KickLogTest, AnAutokickThatIsToldOfAfterItsDropIsMeasuredAllTheSame) {
    log.autokickSet(3, kTimes);
    reading(219);
    readings({148, 152}, 140ms);
    now += 20ms;
    hear(EventKind::Autokick, 1);
    EXPECT_EQ(newest().cause, KickCause::Autokick);
    EXPECT_EQ(newest().times, kTimes);
    EXPECT_DOUBLE_EQ(*newest().before_V, 219);
    EXPECT_DOUBLE_EQ(*newest().after_V, 148);
    readings({200, 218}, 300ms);
    EXPECT_EQ(newest().measure, KickMeasure::Recharged);
}

TEST_F(KickLogTest, AnAutokickThatIsToldOfBeforeItsDropIsToo) {
    reading(100);
    now += 10s;
    reading(219);
    now += 10s;
    hear(EventKind::Autokick, 1);
    EXPECT_FALSE(newest().times) << "nobody armed it here";
    EXPECT_DOUBLE_EQ(*newest().before_V, 219);
    readings({150}, 50ms);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 69);
}

TEST_F(KickLogTest, WhatIsChargedAfterAnAutokickIsNoDrop) {
    reading(48);
    now += 5s;
    hear(EventKind::Autokick, 1);
    readings({70, 95, 120, 140}, 400ms);
    log.tick(now);
    EXPECT_EQ(newest().measure, KickMeasure::NoDrop);
    EXPECT_DOUBLE_EQ(*newest().before_V, 48);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 0);
}

TEST_F(KickLogTest, WhatIsChargedWhileAKickDoesNotComeIsNoDrop) {
    reading(150);
    kick();
    readings({160, 170, 180, 190}, 400ms);
    log.tick(now);
    EXPECT_EQ(newest().measure, KickMeasure::NoDrop);
    EXPECT_DOUBLE_EQ(*newest().drop_V(), 0);
}

TEST_F(KickLogTest, AHighReadingOfLongAgoIsNotBeforeAnAutokick) {
    reading(219);
    now += 1s;
    reading(150);
    now += 5s;
    hear(EventKind::Autokick, 1);
    EXPECT_DOUBLE_EQ(*newest().before_V, 150);
}

TEST_F(KickLogTest, PulsesOfADischargeAreNoKicks) {
    reading(219);
    log.expect(std::nullopt);
    kick();
    EXPECT_TRUE(log.records()->empty());
    log.expect(KickCause::Sweep);
    kick();
    EXPECT_EQ(newest().cause, KickCause::Sweep);
}

TEST_F(KickLogTest, KeepsTheNewestAndNumbersThemAll) {
    reading(200, 5);
    kick(5);
    for (std::size_t i = 0; i < KickLog::kMost + 10; ++i)
        kick(3);
    EXPECT_EQ(log.records()->size(), KickLog::kMost);
    EXPECT_EQ(newest().number, KickLog::kMost + 11);
    EXPECT_FALSE(log.measuring(5)) << "its record has given way";
    reading(100, 5);
    log.tick(now += 1h);
    EXPECT_EQ(log.records()->front().number, 12U);
}

TEST_F(KickLogTest, WhatWasGivenOutDoesNotChangeAnyMore) {
    reading(219);
    kick();
    const auto before = log.records();
    const std::uint64_t version = log.version();
    readings({148}, 100ms);
    EXPECT_EQ(before->back().measure, KickMeasure::Waiting);
    EXPECT_EQ(newest().measure, KickMeasure::Recharging);
    EXPECT_GT(log.version(), version);
}

TEST_F(KickLogTest, PassesEveryReadingAndGapOn) {
    reading(219);
    log.sample({3, static_cast<std::uint16_t>(Signal::Battery_V)}, now, 15);
    unknown();
    ASSERT_EQ(onward.entries.size(), 3U);
    EXPECT_EQ(onward.entries[0].value, 219.F);
    EXPECT_EQ(onward.entries[1].value, 15.F);
    EXPECT_FALSE(onward.entries[2].value);
}

TEST_F(KickLogTest, MeasuresChargingFromSwitchingOnToCharged) {
    reading(0);
    hear(EventKind::Charger, 1);
    EXPECT_EQ(log.charges()[3].since, now);
    now += 3500ms;
    hear(EventKind::Charged);
    EXPECT_EQ(log.charges()[3].toCharged, 3500ms);
    EXPECT_FALSE(log.charges()[3].since);
}

TEST_F(KickLogTest, ChargingThatIsDisturbedIsNotMeasured) {
    const std::vector<std::function<void()>> disturbances = {[this] { hear(EventKind::Charger, 0); },
                                                             [this] { kick(); }, [this] { unknown(); }};
    for (const auto& disturb : disturbances) {
        reading(0);
        hear(EventKind::Charger, 1);
        disturb();
        hear(EventKind::Charged);
        EXPECT_FALSE(log.charges()[3].toCharged);
    }
    charged = true;
    reading(219);
    hear(EventKind::Charger, 1);
    EXPECT_FALSE(log.charges()[3].since) << "there is nothing to charge";
}

TEST_F(KickLogTest, HostileNumbersOfRobotsAreIgnored) {
    log.sample({40000, static_cast<std::uint16_t>(Signal::Capacitor_V)}, now, 1);
    hear(EventKind::KickGiven, 0, -1);
    EXPECT_TRUE(log.records()->empty());
    EXPECT_EQ(onward.entries.size(), 1U);
}

}  // namespace
}  // namespace kickstand::thunderbots
