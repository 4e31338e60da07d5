// Every command over simulated robots.

#include <csignal>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

QJsonObject last(const Ended& ended) {
    const auto values = ended.values();
    return values.empty() ? QJsonObject() : values.back().toObject();
}

/// The first value of that type in a stream.
QJsonObject first(const Ended& ended, const QString& type) {
    for (const QJsonValue& value : ended.values()) {
        EXPECT_TRUE(value.isObject()) << ended.out;
        if (value[QStringLiteral("type")] == type) return value.toObject();
    }
    return {};
}

void expectDoneAndBraked(const Ended& ended) {
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    EXPECT_TRUE(last(ended)[QStringLiteral("braked")].toBool()) << ended.out;
    EXPECT_TRUE(last(ended)[QStringLiteral("completed")].toBool()) << ended.out;
}

TEST(ProgramThunderbots, StatusTellsOfEveryRobot) {
    const QJsonObject status = runSimulated({"--json", "thunderbots", "status"}).object();
    EXPECT_EQ(status[QStringLiteral("state")].toString(), QStringLiteral("running"));
    EXPECT_EQ(status[QStringLiteral("emergency_stop")].toString(), QStringLiteral("run"));
    EXPECT_TRUE(status[QStringLiteral("simulated")].toBool());
    EXPECT_EQ(status[QStringLiteral("channels")].toArray(), (QJsonArray{14, 15}));
    const QJsonArray robots = status[QStringLiteral("robots")].toArray();
    ASSERT_EQ(robots.size(), 16);
    for (int number = 0; number < 16; ++number) {
        EXPECT_EQ(robots[number][QStringLiteral("robot")].toInt(), number);
        EXPECT_EQ(robots[number][QStringLiteral("live")].toBool(), number < 4);
        EXPECT_EQ(robots[number][QStringLiteral("readings")].isObject(), number < 4);
    }
    const double battery_V = robots[0][QStringLiteral("readings")][QStringLiteral("battery_V")].toDouble();
    EXPECT_GT(battery_V, 12);
    EXPECT_LT(battery_V, 18);
}

TEST(ProgramThunderbots, StatusForPeopleFitsTheScreen) {
    const Ended ended = runSimulated({"thunderbots", "status"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("simulated dongle"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("not heard: 4-15"), std::string::npos) << ended.out;
}

TEST(ProgramThunderbots, StatusOfACable) {
    const QJsonObject status =
        run({"--link", "sim:thunderbots?cable=7", "--json", "thunderbots", "status"}).object();
    EXPECT_TRUE(status[QStringLiteral("cable")].toBool());
    EXPECT_TRUE(status[QStringLiteral("robots")][7][QStringLiteral("live")].toBool());
}

TEST(ProgramThunderbots, MonitorStreamsEventsAndReadings) {
    Program program({"--link", "sim:thunderbots?robots=0-3", "--json", "thunderbots", "monitor"});
    ASSERT_TRUE(program.waitFor("\"battery_V\""));
    program.signal(SIGTERM);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_TRUE(first(ended, QStringLiteral("readings"))[QStringLiteral("time")].toString().endsWith(
        QLatin1Char('Z')));
    EXPECT_FALSE(first(ended, QStringLiteral("event"))[QStringLiteral("event")].toString().isEmpty());
}

TEST(ProgramThunderbots, MonitorEndsAfterItsTime) {
    const Ended ended = runSimulated({"thunderbots", "monitor", "--for", "0.1"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("connected"), std::string::npos) << ended.out;
}

TEST(ProgramThunderbots, DriveRunsForItsTimeAndBrakes) {
    const Ended ended = runSimulated({"--json", "thunderbots", "drive", "--robot", "0,2-3", "--wheels",
                                      "-40,36,0x10,0", "--for", "0.2", "--dribble"});
    expectDoneAndBraked(ended);
    const QJsonObject driving = first(ended, QStringLiteral("driving"));
    EXPECT_EQ(driving[QStringLiteral("robots")].toArray(), (QJsonArray{0, 2, 3}));
    EXPECT_EQ(driving[QStringLiteral("wheels")].toArray(), (QJsonArray{-40, 36, 16, 0}));
    EXPECT_TRUE(driving[QStringLiteral("dribble")].toBool());
}

TEST(ProgramThunderbots, DriveFasterWithALimit) {
    const Ended ended = runSimulated({"--json", "thunderbots", "drive", "--robot", "1", "--wheels",
                                      "300,-300,0,0", "--for", "0.1", "--limit", "300"});
    expectDoneAndBraked(ended);
    EXPECT_NE(ended.out.find("\"wheel-limit\""), std::string::npos) << ended.out;
}

TEST(ProgramThunderbots, KickSaysWhatReallyGoesOut) {
    const Ended ended = runSimulated({"--json", "thunderbots", "kick", "--robot", "3", "--width1", "2010",
                                      "--width2", "1024", "--offset", "320"});
    expectDoneAndBraked(ended);
    const QJsonObject kick = ended.object();
    EXPECT_TRUE(kick[QStringLiteral("given_to_dongle")].toBool());
    EXPECT_TRUE(kick[QStringLiteral("snapped")].toBool());
    EXPECT_EQ(kick[QStringLiteral("width1_us")].toInt(), 2016);
    EXPECT_EQ(kick[QStringLiteral("t1")].toInt(), 63);
    EXPECT_EQ(kick[QStringLiteral("t2")].toInt(), 42);
    EXPECT_EQ(kick[QStringLiteral("dt")].toInt(), 10);
}

TEST(ProgramThunderbots, KickIsGivenToTheDongleAndNotDelivered) {
    const Ended ended = runSimulated({"thunderbots", "kick", "--robot", "3", "--width1", "2400"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("given to the dongle: 2400 / 0 µs"), std::string::npos) << ended.out;
    EXPECT_EQ(ended.out.find("deliver"), std::string::npos);
}

TEST(ProgramThunderbots, AutokickArmsForItsTime) {
    const Ended ended = runSimulated({"--json", "thunderbots", "autokick", "--robot", "1", "--width1", "2400",
                                      "--for", "0.1", "--charge"});
    expectDoneAndBraked(ended);
    EXPECT_NE(ended.out.find("\"autokick-armed\""), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("\"charger\""), std::string::npos) << ended.out;
}

TEST(ProgramThunderbots, ChargeEndsAtItsVoltageAndWarns) {
    const Ended ended =
        runSimulated({"--json", "thunderbots", "charge", "--robot", "2", "--for", "30", "--until", "60"});
    expectDoneAndBraked(ended);
    const QJsonArray live = last(ended)[QStringLiteral("live_capacitors")].toArray();
    ASSERT_EQ(live.size(), 1) << ended.out;
    EXPECT_EQ(live[0][QStringLiteral("robot")].toInt(), 2);
    EXPECT_GE(live[0][QStringLiteral("last_V")].toDouble(), 60);
}

TEST(ProgramThunderbots, ChargeThatDoesNotGetThereFails) {
    const Ended ended =
        runSimulated({"--json", "thunderbots", "charge", "--robot", "2", "--for", "0.05", "--until", "200"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_TRUE(last(ended)[QStringLiteral("braked")].toBool()) << ended.out;
    EXPECT_FALSE(last(ended)[QStringLiteral("completed")].toBool()) << ended.out;
}

TEST(ProgramThunderbots, SweepTellsWhatEachKickDid) {
    const Ended ended =
        runSimulated({"--json", "thunderbots", "sweep", "--robot", "3", "--from", "640", "--to", "960",
                      "--step", "320", "--solenoid", "2", "--other-width", "320", "--offset", "64"});
    expectDoneAndBraked(ended);
    std::vector<QJsonObject> kicks;
    for (const QJsonValue& value : ended.values()) {
        if (value[QStringLiteral("type")] == QStringLiteral("kick")) kicks.push_back(value.toObject());
    }
    ASSERT_EQ(kicks.size(), 2U) << ended.out;
    EXPECT_EQ(kicks[0][QStringLiteral("width2_us")].toInt(), 640);
    EXPECT_EQ(kicks[1][QStringLiteral("width2_us")].toInt(), 960);
    for (const QJsonObject& kick : kicks) {
        EXPECT_EQ(kick[QStringLiteral("width1_us")].toInt(), 320);
        EXPECT_EQ(kick[QStringLiteral("offset_us")].toInt(), 64);
        EXPECT_TRUE(kick[QStringLiteral("given_to_dongle")].toBool());
        EXPECT_GT(kick[QStringLiteral("drop_V")].toDouble(), 5) << ended.out;
        EXPECT_GT(kick[QStringLiteral("recharge_s")].toDouble(), 0) << ended.out;
    }
}

TEST(ProgramThunderbots, SweepRefusesWhatNoWireHas) {
    const Ended ended = runSimulated({"thunderbots", "sweep", "--robot", "3", "--from", "640", "--to", "4064",
                                      "--step", "320", "--other-width", "320", "--offset", "-640"});
    EXPECT_EQ(ended.exitCode, 2);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find("4064"), std::string::npos) << ended.err;
}

TEST(ProgramThunderbots, SweepThatIsNotChargedInTimeFails) {
    const Ended ended = runSimulated({"--json", "thunderbots", "sweep", "--robot", "3", "--from", "640",
                                      "--to", "960", "--step", "320", "--charge-limit", "0.05"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_TRUE(last(ended)[QStringLiteral("braked")].toBool()) << ended.out;
}

TEST(ProgramThunderbots, SweepIsStoppedByASignal) {
    Program program({"--link", "sim:thunderbots?robots=0-3", "--json", "thunderbots", "sweep", "--robot", "3",
                     "--from", "320", "--to", "4064", "--step", "32"});
    ASSERT_TRUE(program.waitFor("\"sweep-started\""));
    program.signal(SIGTERM);
    const Ended ended = program.end();
    EXPECT_TRUE(last(ended)[QStringLiteral("braked")].toBool()) << ended.out;
    EXPECT_FALSE(last(ended)[QStringLiteral("completed")].toBool()) << ended.out;
}

TEST(ProgramThunderbots, DischargeEndsWhenItIsEmpty) {
    const Ended ended = runSimulated({"--json", "thunderbots", "discharge", "--robot", "1"});
    expectDoneAndBraked(ended);
    EXPECT_NE(ended.out.find("\"discharge-ended\""), std::string::npos) << ended.out;
}

TEST(ProgramThunderbots, TestModeIsGivenToTheDongle) {
    const Ended ended = runSimulated(
        {"--json", "thunderbots", "test-mode", "--robot", "1", "--class", "encoder-count", "--target", "4"});
    expectDoneAndBraked(ended);
    EXPECT_EQ(ended.object()[QStringLiteral("class")].toString(), QStringLiteral("encoder-count"));
    EXPECT_EQ(ended.object()[QStringLiteral("target")].toInt(), 4);
    expectDoneAndBraked(
        runSimulated({"--json", "thunderbots", "test-mode", "--robot", "1", "--class", "none"}));
}

TEST(ProgramThunderbots, ChannelsAreReadAndSet) {
    const QJsonObject read = runSimulated({"--json", "thunderbots", "channels"}).object();
    EXPECT_EQ(read[QStringLiteral("channels")].toArray(), (QJsonArray{14, 15}));
    const QJsonObject set = runSimulated({"--json", "thunderbots", "channels", "0x0b", "26"}).object();
    EXPECT_EQ(set[QStringLiteral("channels")].toArray(), (QJsonArray{11, 26}));
}

TEST(ProgramThunderbots, ACableHasNoChannels) {
    const Ended ended = run({"--link", "sim:thunderbots?cable=3", "thunderbots", "channels"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
}

TEST(ProgramThunderbots, StopBrakesEverything) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"--json", "stop"}, {"--json", "thunderbots", "stop"}}) {
        const Ended ended = runSimulated(arguments);
        EXPECT_EQ(ended.exitCode, 0) << ended.err;
        EXPECT_TRUE(ended.object()[QStringLiteral("stopped")][0][QStringLiteral("braked")].toBool())
            << ended.out;
    }
}

TEST(ProgramThunderbots, DoctorFindsNothingWrong) {
    const Ended ended = runSimulated({"--json", "doctor"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject report = ended.object();
    EXPECT_TRUE(report[QStringLiteral("ok")].toBool()) << ended.out;
    EXPECT_GE(report[QStringLiteral("checks")].toArray().size(), 7);
}

TEST(ProgramThunderbots, ARobotThatIsNotThereIsRefused) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"thunderbots", "drive", "--robot", "1,9", "--wheels", "1,1,1,1", "--for", "1"},
             {"thunderbots", "kick", "--robot", "9", "--width1", "1000"},
             {"thunderbots", "charge", "--robot", "9", "--for", "1"},
             {"thunderbots", "discharge", "--robot", "9"},
             {"thunderbots", "test-mode", "--robot", "9", "--class", "lamp"}}) {
        const Ended ended = runSimulated(arguments);
        EXPECT_EQ(ended.exitCode, 1);
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        EXPECT_NE(ended.err.find("Robot 9 is not heard"), std::string::npos) << ended.err;
    }
}

}  // namespace
}  // namespace kickstand::test
