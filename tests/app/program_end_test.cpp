// How commands end that somebody or something ends: braked, soon, and said.

#include <csignal>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

const std::vector<std::string> kDriveLong{"--link",
                                          "sim:thunderbots?robots=0-3",
                                          "--json",
                                          "thunderbots",
                                          "drive",
                                          "--robot",
                                          "1",
                                          "--wheels",
                                          "90,-90,90,90",
                                          "--for",
                                          "3600"};

class ProgramSignal : public testing::TestWithParam<int> {};

TEST_P(ProgramSignal, InMidDriveLeavesRobotsBraked) {
    Program program(kDriveLong);
    ASSERT_TRUE(program.waitFor("\"driving\""));
    program.signal(GetParam());
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    const QJsonObject end = ended.values().back().toObject();
    EXPECT_TRUE(end[QStringLiteral("braked")].toBool()) << ended.out;
    EXPECT_FALSE(end[QStringLiteral("completed")].toBool()) << ended.out;
    EXPECT_EQ(end[QStringLiteral("error")][QStringLiteral("code")].toString(), QStringLiteral("cancelled"));
}

const auto kNumberOf = [](const testing::TestParamInfo<int>& number) {
    return "Number" + std::to_string(number.param);
};
INSTANTIATE_TEST_SUITE_P(Signals, ProgramSignal, testing::Values(SIGINT, SIGTERM, SIGHUP, SIGQUIT),
                         kNumberOf);

TEST(ProgramEnd, SignalsThatComeTogetherDoNotCutTheBrakingShort) {
    Program program(kDriveLong);
    ASSERT_TRUE(program.waitFor("\"driving\""));
    for (int i = 0; i < 20; ++i)
        program.signal(i % 2 == 0 ? SIGTERM : SIGINT);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.values().back()[QStringLiteral("braked")].toBool()) << ended.out;
}

TEST(ProgramEnd, AReaderThatIsGoneEndsTheDrive) {
    Program program(kDriveLong);
    ASSERT_TRUE(program.waitFor("\"driving\""));
    program.closeOutput();
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
}

TEST(ProgramEnd, AReaderThatTakesNothingDoesNotHoldItUp) {
    Program program(kDriveLong);
    ASSERT_TRUE(program.waitFor("\"driving\""));
    program.fillPipe();
    program.signal(SIGTERM);
    EXPECT_EQ(program.awaitExit(), 1);
}

TEST(ProgramEnd, MonitorWithoutATimeEndsWellOnRequest) {
    Program program({"--link", "sim:thunderbots?robots=0", "--json", "thunderbots", "monitor"});
    ASSERT_TRUE(program.waitFor("\"readings\""));
    program.signal(SIGINT);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    for (const QJsonValue& value : ended.values())
        EXPECT_TRUE(value.isObject());
}

TEST(ProgramEnd, ADeviceThatIsNotThereIsSaid) {
    // No bus has such a place: nothing real is ever opened.
    const Ended ended = run({"--link", "usb:?port=99-9.9", "thunderbots", "status"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find("plugged in"), std::string::npos) << ended.err;
}

TEST(ProgramEnd, ErrorsAreJsonTooWhereJsonWasAskedFor) {
    const QJsonObject json =
        run({"--link", "usb-cable:?port=99-9.9", "--json", "thunderbots", "status"}).object();
    EXPECT_FALSE(json[QStringLiteral("error")][QStringLiteral("code")].toString().isEmpty());
    EXPECT_FALSE(json[QStringLiteral("error")][QStringLiteral("remedy")].toString().isEmpty());
}

class ProgramWithoutHardware : public testing::Test {
  protected:
    void SetUp() override {
        const auto devices = run({"--json", "devices"}).values();
        ASSERT_EQ(devices.size(), 1U);
        if (!devices[0].toArray().isEmpty())
            GTEST_SKIP() << "a real dongle is plugged in, and tests leave it alone";
    }
};

TEST_F(ProgramWithoutHardware, DevicesListsNothing) {
    const Ended ended = run({"devices"});
    EXPECT_EQ(ended.exitCode, 0);
    EXPECT_NE(ended.out.find("sim:thunderbots"), std::string::npos) << ended.out;
}

TEST_F(ProgramWithoutHardware, NothingIsChosenUnasked) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"stop"},
             {"thunderbots", "stop"},
             {"thunderbots", "status"},
             {"thunderbots", "monitor"},
             {"thunderbots", "channels"},
             {"thunderbots", "kick", "--robot", "1", "--width1", "1000"},
             {"thunderbots", "drive", "--robot", "1", "--wheels", "1,1,1,1", "--for", "1"}}) {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.exitCode, 1);
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        EXPECT_NE(ended.err.find("No dongle or cabled robot"), std::string::npos) << ended.err;
        EXPECT_EQ(ended.out, "");
    }
}

TEST_F(ProgramWithoutHardware, TheDoctorSaysSo) {
    const Ended ended = run({"--json", "doctor"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_FALSE(ended.object()[QStringLiteral("ok")].toBool(true));
}

}  // namespace
}  // namespace kickstand::test
