// Bench checks from the command line, over simulated robots.

#include <QByteArray>
#include <QFile>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <csignal>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

class ProgramCheck : public testing::Test {
  protected:
    std::string path(const char* name) const { return folder.filePath(QLatin1String(name)).toStdString(); }
    std::string limits(const QByteArray& json) {
        QFile file(folder.filePath(QStringLiteral("limits.json")));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(json);
        return path("limits.json");
    }
    QByteArray content(const char* name) {
        QFile file(folder.filePath(QLatin1String(name)));
        EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << name;
        return file.readAll();
    }

    QTemporaryDir folder;
};

TEST_F(ProgramCheck, PassingEveryStepIsExitZeroAndTheReportSaysSo) {
    const Ended ended =
        runSimulated({"--json", "thunderbots", "check", "--robot", "0,2", "--only", "dribbler", "--limits",
                      limits(R"({"run_s": 0.5, "least_battery_V": 13})"), "--seen", "yes", "--report",
                      path("report.json")});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject end = ended.object();
    EXPECT_TRUE(end[QStringLiteral("braked")].toBool());
    const QJsonObject report = end[QStringLiteral("report")].toObject();
    EXPECT_TRUE(report[QStringLiteral("passed")].toBool());
    EXPECT_EQ(report[QStringLiteral("limits")][QStringLiteral("least_battery_V")].toDouble(), 13);
    const QJsonArray robots = report[QStringLiteral("robots")].toArray();
    ASSERT_EQ(robots.size(), 2);
    EXPECT_EQ(robots[1][QStringLiteral("robot")].toInt(), 2);
    EXPECT_EQ(robots[1][QStringLiteral("verdict")].toString(), QStringLiteral("passed"));
    EXPECT_EQ(QJsonDocument::fromJson(content("report.json")).object(), report);
}

TEST_F(ProgramCheck, AStepThatDoesNotPassIsExitOneWithTheReportSaved) {
    const Ended ended = runSimulated({"thunderbots", "check", "--robot", "1", "--only", "battery", "--limits",
                                      limits(R"({"least_battery_V": 17.5})"), "--seen", "yes", "--report",
                                      path("report.html")});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.out.find("Battery at rest: failed"), std::string::npos) << ended.out;
    const QByteArray html = content("report.html");
    EXPECT_TRUE(html.contains("Robot 1 did not pass: Battery at rest (failed).")) << html.toStdString();
    EXPECT_TRUE(html.contains("≥ 17.50 V")) << html.toStdString();
}

TEST_F(ProgramCheck, AReportThatCannotBeSavedIsToldWithItsFile) {
    const Ended ended = runSimulated({"thunderbots", "check", "--robot", "1", "--only", "battery", "--limits",
                                      limits(R"({"least_battery_V": 13})"), "--seen", "yes", "--report",
                                      path("nowhere/report.html")});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find("nowhere/report.html” cannot be written"), std::string::npos) << ended.err;
}

TEST_F(ProgramCheck, NotSeenAndSkippedAreNotPassed) {
    for (const char* const answer : {"no", "skip"}) {
        const Ended ended =
            runSimulated({"--json", "thunderbots", "check", "--robot", "1", "--only", "dribbler", "--limits",
                          limits(R"({"run_s": 0.5})"), "--seen", answer});
        EXPECT_EQ(ended.exitCode, 1) << answer;
        const QJsonObject robot =
            ended.object()[QStringLiteral("report")][QStringLiteral("robots")][0].toObject();
        EXPECT_EQ(robot[QStringLiteral("verdict")].toString(),
                  answer[0] == 'n' ? QStringLiteral("failed") : QStringLiteral("skipped"));
    }
}

TEST_F(ProgramCheck, ARobotThatIsNotThereFailsAndTheOthersAreChecked) {
    const Ended ended = runSimulated(
        {"--json", "thunderbots", "check", "--robot", "1,9", "--only", "battery", "--seen", "yes"});
    EXPECT_EQ(ended.exitCode, 1);
    const QJsonArray robots = ended.object()[QStringLiteral("report")][QStringLiteral("robots")].toArray();
    ASSERT_EQ(robots.size(), 2) << ended.out << ended.err;
    EXPECT_EQ(robots[0][QStringLiteral("verdict")].toString(), QStringLiteral("passed"));
    EXPECT_EQ(robots[1][QStringLiteral("verdict")].toString(), QStringLiteral("failed"));
}

TEST_F(ProgramCheck, NobodyToAnswerLeavesTheRobotAlone) {
    // Standard input has ended: the question whether the robot stands free is not answered with yes.
    const Ended ended = runSimulated({"--json", "thunderbots", "check", "--robot", "1"});
    EXPECT_EQ(ended.exitCode, 1);
    const QJsonObject robot =
        ended.object()[QStringLiteral("report")][QStringLiteral("robots")][0].toObject();
    EXPECT_EQ(robot[QStringLiteral("verdict")].toString(), QStringLiteral("skipped")) << ended.out;
    EXPECT_NE(ended.err.find("stand on its stand"), std::string::npos) << ended.err;
}

TEST_F(ProgramCheck, WhatCannotBeMeantIsExitTwo) {
    const std::string wrong = limits(R"({"least_battery_V": "much"})");
    const std::vector<std::vector<std::string>> all = {
        {"thunderbots", "check", "--robot", "1", "--seen", "perhaps"},
        {"thunderbots", "check", "--robot", "1", "--only", "wings"},
        {"thunderbots", "check", "--robot", "1", "--limits", path("missing.json")},
        {"thunderbots", "check", "--robot", "1", "--limits", wrong},
        {"thunderbots", "check", "--robot", "16"},
    };
    for (const auto& arguments : all) {
        const Ended ended = runSimulated(arguments);
        EXPECT_EQ(ended.exitCode, 2) << ended.err;
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    }
}

TEST_F(ProgramCheck, AnInterruptionBrakes) {
    Program program({"--link", "sim:thunderbots?robots=0-3", "thunderbots", "check", "--robot", "1", "--seen",
                     "yes", "--only", "wheels"});
    ASSERT_TRUE(program.waitFor("Battery at rest"));
    program.signal(SIGTERM);
    const Ended ended = program.end();
    EXPECT_NE(ended.exitCode, 0);
    EXPECT_NE(ended.out.find("All robots are braked."), std::string::npos) << ended.out;
}

}  // namespace
}  // namespace kickstand::test
