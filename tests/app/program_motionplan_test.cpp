// kickstandctl motionplan, over a simulated NXT in the program itself.

#include <QJsonObject>
#include <fstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

const std::string kNxt = "sim:motionplan";

Ended plan(std::vector<std::string> arguments, const std::string& link = kNxt) {
    arguments.insert(arguments.begin(), {"--link", link, "--json", "motionplan"});
    return run(std::move(arguments));
}

TEST(ProgramMotionplan, TheSampleIsEncodedAndDecoded) {
    const std::string sample = "0d 00 80 09 07 09 00 09 04 0d 5c 12 7e 37 00";
    const Ended encoded =
        run({"encode", "motionplan.telegram.create", "plan=9", "slot=4",
             "movements=forward 25, turn right 84, forward 50, turn left back 90, back 100"});
    EXPECT_EQ(encoded.exitCode, 0) << encoded.err;
    EXPECT_EQ(encoded.out, sample + '\n');
    const QJsonObject decoded = run({"--json", "decode", "motionplan.telegram", sample}).object();
    EXPECT_EQ(decoded[QStringLiteral("plan")], 9);
    EXPECT_EQ(decoded[QStringLiteral("slot")], 4);
    EXPECT_EQ(decoded[QStringLiteral("movements")], QStringLiteral("0d 5c 12 7e 37"));
    EXPECT_EQ(run({"decode", "motionplan.telegram", "0d 00"}).exitCode, 2);
    EXPECT_EQ(run({"encode", "motionplan.telegram.sing"}).exitCode, 2);
}

TEST(ProgramMotionplan, CreatesAndSaysWhatIsThere) {
    const Ended ended = plan({"create", "--slot", "4", "--plan", "9", "forward 25, turn left 84"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject slot = ended.object()[QStringLiteral("slots")][4].toObject();
    EXPECT_EQ(slot[QStringLiteral("plan")], 9);
    EXPECT_EQ(slot[QStringLiteral("movements")], QStringLiteral("forward 25, turn left 84"));
    EXPECT_EQ(slot[QStringLiteral("bytes")], QStringLiteral("0d 9c"));
}

TEST(ProgramMotionplan, AsksForAllSlots) {
    const QJsonObject answer = plan({"query"}).object();
    for (int slot = 0; slot < 5; ++slot)
        EXPECT_TRUE(answer[QStringLiteral("slots")][slot][QStringLiteral("known")].toBool());
}

TEST(ProgramMotionplan, ExecutesToTheEndOfThePlan) {
    const Ended ended =
        plan({"execute", "--slot", "2", "--for", "20", "forward 10, turn left 30"}, kNxt + "?pace=4");
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject last = ended.values().back().toObject();
    EXPECT_EQ(last[QStringLiteral("type")], QStringLiteral("end"));
    EXPECT_TRUE(last[QStringLiteral("plan_ended")].toBool());
    EXPECT_TRUE(last[QStringLiteral("stopped")].toBool());
}

TEST(ProgramMotionplan, StopsWhenTheTimeIsOver) {
    const Ended ended = plan({"execute", "--slot", "2", "--for", "0.2", "forward 1000"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    const QJsonObject last = ended.values().back().toObject();
    EXPECT_FALSE(last[QStringLiteral("plan_ended")].toBool());
    EXPECT_TRUE(last[QStringLiteral("stopped")].toBool());
}

TEST(ProgramMotionplan, SetsAndReadsTheTriggerPlan) {
    const QJsonObject set = plan({"trigger", "--plan", "7", "back 50"}).object();
    EXPECT_EQ(set[QStringLiteral("trigger")][QStringLiteral("plan")], 7);
    const QJsonObject read = plan({"trigger"}).object();
    EXPECT_TRUE(read[QStringLiteral("trigger")][QStringLiteral("plan")].isNull());
}

TEST(ProgramMotionplan, StatusAndStop) {
    EXPECT_EQ(plan({"status"}).object()[QStringLiteral("execution")][QStringLiteral("state")],
              QStringLiteral("idle"));
    EXPECT_TRUE(plan({"stop"}).object()[QStringLiteral("stopped")].toBool());
    const Ended all = run({"--link", kNxt, "stop"});
    EXPECT_EQ(all.exitCode, 0) << all.err;
    EXPECT_NE(all.out.find("the robot stands, as it says itself"), std::string::npos) << all.out;
    EXPECT_EQ(all.out.find("dribblers"), std::string::npos) << all.out;
}

TEST(ProgramMotionplan, AStopThatIsNotConfirmedIsNotSaidToBe) {
    const Ended ended = plan({"stop"}, kNxt + "?loss=1");
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find("has not confirmed that it stands"), std::string::npos) << ended.err;
    EXPECT_FALSE(ended.object()[QStringLiteral("stopped")].toBool(true));
    EXPECT_EQ(run({"--link", kNxt + "?loss=1", "stop"}).exitCode, 1);
}

TEST(ProgramMotionplan, LettingGoOfARobotWithATriggerPlanIsSaidToStartIt) {
    const QString closing = QStringLiteral("starts_when_closed");
    EXPECT_EQ(plan({"trigger", "--plan", "7", "back 50"}).object()[closing], 7);
    const Ended text = run({"--link", kNxt, "motionplan", "trigger", "--plan", "7", "back 50"});
    EXPECT_NE(text.out.find("Closing the connection starts its trigger plan 7"), std::string::npos)
        << text.out;
    for (const Ended& ended :
         {plan({"status"}), plan({"stop"}), plan({"create", "--slot", "1", "--plan", "3", "forward 5"})}) {
        EXPECT_TRUE(ended.object().contains(closing)) << ended.out;
        EXPECT_TRUE(ended.object()[closing].isNull());
    }
}

TEST(ProgramMotionplan, TheDoctorLooksAtWhatAnNxtHas) {
    const auto doctor = [](const std::string& link) { return run({"--link", link, "--json", "doctor"}); };
    const auto stateOf = [](const Ended& ended, const char* check) {
        for (const QJsonValue line : ended.object()[QStringLiteral("checks")].toArray()) {
            if (line[QStringLiteral("check")].toString() == QLatin1String(check))
                return line[QStringLiteral("state")].toString().toStdString();
        }
        return std::string("no line");
    };
    const Ended well = doctor(kNxt);
    EXPECT_EQ(well.exitCode, 0) << well.err;
    EXPECT_EQ(stateOf(well, "link"), "ok");
    EXPECT_EQ(stateOf(well, "answers"), "ok");
    EXPECT_EQ(stateOf(well, "radios"), "no line");
    const Ended missing = doctor("serial:/nowhere/nxt?protocol=motionplan");
    EXPECT_EQ(missing.exitCode, 1);
    EXPECT_TRUE(missing.oneComplaint()) << missing.err;
    EXPECT_EQ(stateOf(missing, "device"), "problem");
    EXPECT_EQ(stateOf(missing, "answers"), "not-checked");
    const Ended silent = doctor(kNxt + "?reply-loss=1");
    EXPECT_EQ(silent.exitCode, 1);
    EXPECT_EQ(stateOf(silent, "answers"), "problem");
    for (const char* link : {"sim:coach", "sim:smartdevice?devices=PolarBear&boot_ms=50"}) {
        const Ended other = doctor(link);
        EXPECT_EQ(other.exitCode, 0) << link << other.err;
        EXPECT_EQ(stateOf(other, "answers"), "ok") << link;
        EXPECT_EQ(stateOf(other, "e-stop"), "no line") << link;
    }
}

TEST(ProgramMotionplan, PlansComeFromFiles) {
    std::string name = testing::TempDir() + "planXXXXXX";
    const int descriptor = ::mkstemp(name.data());
    ASSERT_GE(descriptor, 0);
    ::close(descriptor);
    std::ofstream(name) << "# out and back\nforward 50\nback 50\n";
    const Ended ended = plan({"create", "--slot", "0", "--plan", "1", "--file", name});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    std::ofstream(name, std::ios::binary) << std::string(
        "\x7f"
        "ELF\x02\x01\x00",
        7);
    const Ended foreign = plan({"create", "--slot", "0", "--plan", "1", "--file", name});
    EXPECT_EQ(foreign.exitCode, 2);
    EXPECT_TRUE(foreign.oneComplaint());
    ::unlink(name.c_str());
    EXPECT_EQ(plan({"create", "--slot", "0", "--plan", "1", "--file", name}).exitCode, 2);
}

TEST(ProgramMotionplan, BadInputIsExitTwoWithOneLine) {
    const std::vector<std::pair<std::vector<std::string>, const char*>> bad{
        {{"create", "--slot", "0", "--plan", "1", "jump 3"}, "jump"},
        {{"create", "--slot", "0", "--plan", "1", "turn left 85"}, "turn left 84 or turn left 87"},
        {{"create", "--slot", "0", "--plan", "1", "forward 38"}, "forward 35, forward 3"},
        {{"create", "--slot", "0", "--plan", "1"}, "No plan"},
        {{"create", "--slot", "5", "--plan", "1", "forward 1"}, "--slot"},
        {{"create", "--slot", "0", "--plan", "255", "forward 1"}, "--plan"},
        {{"execute", "--slot", "0"}, "--for"},
        {{"adjust", "--wheels", "all", "--change", "3", "--for", "1"}, "both, left, right"},
        {{"adjust", "--wheels", "both", "--change", "101", "--for", "1"}, "--change"},
    };
    for (const auto& [arguments, said] : bad) {
        const Ended ended = plan(arguments);
        EXPECT_EQ(ended.exitCode, 2) << said;
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
    }
    const Ended pace = plan({"status"}, kNxt + "?pace=0");
    EXPECT_EQ(pace.exitCode, 2);
    EXPECT_NE(pace.err.find("0.1 to 100"), std::string::npos) << pace.err;
    std::string tooLong;
    for (int i = 0; i < 56; ++i)
        tooLong += "forward 1,";
    EXPECT_EQ(plan({"create", "--slot", "0", "--plan", "1", tooLong}).exitCode, 2);
}

TEST(ProgramMotionplan, RefusalsAreExitOne) {
    const Ended adjust = plan({"adjust", "--wheels", "both", "--change", "10", "--for", "1"});
    EXPECT_EQ(adjust.exitCode, 1);
    EXPECT_NE(adjust.err.find("error 7"), std::string::npos) << adjust.err;
    const Ended update = plan({"update", "--slot", "3", "forward 1"});
    EXPECT_EQ(update.exitCode, 1);
    EXPECT_NE(update.err.find("error 2"), std::string::npos) << update.err;
    const Ended text = plan({"create", "--slot", "1", "--plan", "9", "forward 25"}, kNxt + "?text=on");
    EXPECT_EQ(text.exitCode, 1);
    EXPECT_NE(text.err.find("sent 00 09 01 0d, got nothing"), std::string::npos) << text.err;
    EXPECT_EQ(run({"--link", "sim:thunderbots?robots=0", "motionplan", "status"}).exitCode, 2);
    EXPECT_EQ(run({"--link", "serial:/nowhere/nxt?protocol=motionplan", "motionplan", "status"}).exitCode, 1);
}

}  // namespace
}  // namespace kickstand::test
