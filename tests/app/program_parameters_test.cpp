// Parameters, signatures and reboots over simulated robots.

#include <QFile>
#include <QTemporaryDir>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

QJsonObject parametersOf(const Ended& ended) {
    return ended.object()[QStringLiteral("parameters")].toObject();
}

std::string path(const QTemporaryDir& folder, const char* name) {
    return folder.filePath(QString::fromLatin1(name)).toStdString();
}

TEST(ProgramParameters, AreReadAndWrittenDown) {
    const QTemporaryDir folder;
    const std::string file = path(folder, "robot2.json");
    const Ended ended =
        runSimulated({"--json", "thunderbots", "params", "get", "--robot", "2", "--file", file});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject parameters = parametersOf(ended);
    EXPECT_EQ(parameters[QStringLiteral("robot_number")].toInt(), 2);
    EXPECT_EQ(parameters[QStringLiteral("channel0")].toInt(), 14);
    EXPECT_EQ(parameters[QStringLiteral("flash_contents")].toString(), QStringLiteral("fpga"));
    EXPECT_EQ(ended.object()[QStringLiteral("standing")].toString(), QStringLiteral("as-read"));
    EXPECT_TRUE(ended.object()[QStringLiteral("block")].toString().startsWith(QStringLiteral("00 0e 0f 02")));
    QFile written(QString::fromStdString(file));
    ASSERT_TRUE(written.open(QIODevice::ReadOnly));
    EXPECT_TRUE(written.readAll().contains("\"robot_number\": 2"));
}

TEST(ProgramParameters, ForPeopleHaveTheirMeaning) {
    const Ended ended = runSimulated({"thunderbots", "params", "get", "--robot", "1"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("FPGA bitstream"), std::string::npos) << ended.out;
    EXPECT_NE(ended.out.find("0x0e (14)"), std::string::npos) << ended.out;
}

TEST(ProgramParameters, AreAppliedUntilTheReboot) {
    const Ended ended =
        runSimulated({"--json", "thunderbots", "params", "set", "--robot", "2", "dribbler_duty=100%"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(parametersOf(ended)[QStringLiteral("dribbler_duty")].toInt(), 255);
    EXPECT_EQ(ended.object()[QStringLiteral("standing")].toString(), QStringLiteral("applied"));
}

TEST(ProgramParameters, AFileIsTakenAndWhatIsTypedStandsOverIt) {
    const QTemporaryDir folder;
    const std::string file = path(folder, "duty.json");
    QFile out(QString::fromStdString(file));
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(R"({"kickstand": "parameters", "version": 1, "parameters": {"dribbler_duty": 7}})");
    out.close();
    EXPECT_EQ(parametersOf(runSimulated({"--json", "thunderbots", "params", "set", "--robot", "0", "--file",
                                         file}))[QStringLiteral("dribbler_duty")]
                  .toInt(),
              7);
    EXPECT_EQ(parametersOf(runSimulated({"--json", "thunderbots", "params", "set", "--robot", "0", "--file",
                                         file, "dribbler_duty=9"}))[QStringLiteral("dribbler_duty")]
                  .toInt(),
              9);
}

TEST(ProgramParameters, AreCommittedAndProvenUnderANewNumber) {
    const Ended ended = runSimulated(
        {"--json", "thunderbots", "params", "commit", "--robot", "2", "--reboot", "robot_number=9"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.object()[QStringLiteral("robot")].toInt(), 9);
    EXPECT_EQ(ended.object()[QStringLiteral("standing")].toString(), QStringLiteral("proven"));
}

TEST(ProgramParameters, WhatWouldLoseTheRobotNeedsToBeMeant) {
    for (const char* change :
         {"channel0=none", "channel1=0x10", "robot_number=3", "flash_contents=microcontroller"}) {
        const Ended refused =
            runSimulated({"--json", "thunderbots", "params", "set", "--robot", "2", change});
        EXPECT_EQ(refused.exitCode, 1) << change;
        EXPECT_EQ(refused.object()[QStringLiteral("error")][QStringLiteral("code")].toString(),
                  QStringLiteral("needs-yes"))
            << refused.out;
        EXPECT_TRUE(refused.oneComplaint()) << refused.err;
        EXPECT_NE(refused.err.find("--yes"), std::string::npos) << refused.err;
    }
    const Ended meant =
        runSimulated({"--json", "thunderbots", "params", "set", "--robot", "2", "channel1=0x10", "--yes"});
    EXPECT_EQ(meant.exitCode, 0) << meant.err;
    EXPECT_EQ(parametersOf(meant)[QStringLiteral("channel1")].toInt(), 16);
}

TEST(ProgramParameters, SignaturesAreRead) {
    const Ended ended = runSimulated({"--json", "thunderbots", "signatures", "--robot", "1"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_TRUE(ended.object()[QStringLiteral("microcontroller")].isDouble());
    EXPECT_TRUE(ended.object()[QStringLiteral("flash")].isDouble());
}

TEST(ProgramParameters, ARebootIsWaitedFor) {
    const Ended ended = runSimulated({"--json", "thunderbots", "reboot", "--robot", "1"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_TRUE(ended.object()[QStringLiteral("rebooted")].toBool());
    EXPECT_TRUE(ended.object()[QStringLiteral("braked")].toBool());
}

TEST(ProgramParameters, ARobotThatIsNotThereFails) {
    const Ended ended = runSimulated({"thunderbots", "params", "get", "--robot", "9"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
}

TEST(ProgramParameters, WhatCannotBeMeantIsBadUsage) {
    const std::vector<std::vector<std::string>> cases{
        {"params", "set", "--robot", "2"},
        {"params", "set", "--robot", "2", "duty=3"},
        {"params", "set", "--robot", "2", "dribbler_duty"},
        {"params", "set", "--robot", "2", "dribbler_duty=256"},
        {"params", "set", "--robot", "2", "channel0=10"},
        {"params", "set", "--robot", "2", "channel0=11", "channel0=12"},
        {"params", "set", "--robot", "2", "--file", "/nowhere/at/all.json"},
        {"params", "commit", "--robot", "16"},
        {"params", "forget", "--robot", "2"},
        {"signatures"},
    };
    for (std::vector<std::string> words : cases) {
        words.insert(words.begin(), "thunderbots");
        const Ended ended = runSimulated(words);
        EXPECT_EQ(ended.exitCode, 2) << words[1] << ' ' << words.back();
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    }
}

}  // namespace
}  // namespace kickstand::test
