// coach commands from outside: over simulated radios in the same process, and two programs that talk through
// pseudo-terminals.

#include <csignal>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

constexpr const char* kSim = KICKSTAND_SIM;

Ended coach(std::vector<std::string> arguments, const std::string& link = "sim:coach?fall=0") {
    arguments.insert(arguments.begin(), {"--link", link, "--json", "coach"});
    return run(arguments);
}

/// The last value of a stream.
QJsonObject endOf(const Ended& ended) {
    const auto values = ended.values();
    return values.empty() ? QJsonObject() : values.back().toObject();
}

bool hasEvent(const Ended& ended, const char* name) {
    for (const QJsonValue& value : ended.values()) {
        if (value[QStringLiteral("event")].toString() == QLatin1String(name)) return true;
    }
    return false;
}

TEST(ProgramCoach, FramesBothWays) {
    const Ended decoded = run({"--json", "decode", "coach.frame", "7e 00 07 01 01 af 05 00 03 70 d6"});
    EXPECT_EQ(decoded.exitCode, 0);
    EXPECT_EQ(decoded.object()[QStringLiteral("forward")].toInt(), 7);
    EXPECT_EQ(decoded.object()[QStringLiteral("destination")].toInt(), 0xAF05);
    const Ended encoded =
        run({"encode", "coach.frame", "frame_id=1", "destination=0xaf05", "message=velocity", "forward=7"});
    EXPECT_EQ(encoded.out, "7e 00 07 01 01 af 05 00 03 70 d6\n");
    const Ended damaged = run({"decode", "coach.frame", "7e 00 07 01 01 af 05 00 03 70 d7"});
    EXPECT_EQ(damaged.exitCode, 2);
    EXPECT_TRUE(damaged.oneComplaint());
}

TEST(ProgramCoach, ScansWithoutSending) {
    const Ended ended = coach({"scan", "--for", "1.5"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.object()[QStringLiteral("towrps")].toArray().size(), 3);
}

TEST(ProgramCoach, DrivesAndStops) {
    const Ended ended = coach({"drive", "--forward", "60", "--turn", "-14", "--for", "0.5"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_TRUE(hasEvent(ended, "paired"));
    EXPECT_TRUE(endOf(ended)[QStringLiteral("stopped")].toBool());
    EXPECT_TRUE(endOf(ended)[QStringLiteral("completed")].toBool());
}

TEST(ProgramCoach, SendsOneThingAndSaysThatItArrived) {
    for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
             {"free-digital"}, {"free-analog", "--percent", "-40"}, {"suppress"}, {"jettison"}}) {
        const Ended ended = coach(command);
        EXPECT_EQ(ended.exitCode, 0) << command[0] << ended.err;
        EXPECT_NE(ended.out.find("\"acknowledged\":true"), std::string::npos) << ended.out;
    }
}

TEST(ProgramCoach, SetsUpAFreshModule) {
    const Ended ended = coach({"radio", "set", "--preset", "coach", "--team", "9"}, "sim:coach?fresh=1");
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.object()[QStringLiteral("address")].toInt(), 0xBC09);
    EXPECT_EQ(ended.object()[QStringLiteral("api_mode")].toInt(), 1);
    const Ended get = coach({"radio", "get"});
    EXPECT_EQ(get.object()[QStringLiteral("address")].toInt(), 0xBC05);
}

/// Their speed is none of those that have names.
TEST(ProgramCoach, SetsUpTheRadioOfAThunderbotsDongleOverASerialPort) {
    std::string folder = testing::TempDir() + "kscoachXXXXXX";
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string port = folder + "/radio";
    const std::string control = folder + "/control.sock";
    {
        Program simulator({"coach", "--pty", port, "--control", control, "--json"}, kSim);
        ASSERT_TRUE(simulator.waitFor("\n"));
        const std::string link = "serial:" + port + "?protocol=coach";
        const Ended ended = coach({"radio", "set", "--preset", "dongle", "--radio", "0"}, link);
        EXPECT_EQ(ended.exitCode, 0) << ended.err;
        EXPECT_EQ(ended.object()[QStringLiteral("baud")].toInt(), 250000);
        EXPECT_EQ(ended.object()[QStringLiteral("address")].toInt(), 0x7B40);
        const Ended found = coach({"radio", "get"}, link);
        EXPECT_EQ(found.exitCode, 0) << found.err;
        EXPECT_EQ(found.object()[QStringLiteral("baud")].toInt(), 250000);
        const Ended back = coach({"radio", "set", "--preset", "coach", "--team", "5"}, link);
        EXPECT_EQ(back.exitCode, 0) << back.err;
        EXPECT_EQ(back.object()[QStringLiteral("baud")].toInt(), 9600);
    }
    for (const std::string& file : {port, control})
        ::unlink(file.c_str());
    ::rmdir(folder.c_str());
}

TEST(ProgramCoach, PlaysTheBoat) {
    const Ended ended = coach({"towrp", "--for", "3"}, "sim:coach?address=0xAF05&towrps=&coaches=4");
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_TRUE(hasEvent(ended, "paired"));
    EXPECT_NE(ended.out.find("forward_percent"), std::string::npos);
}

TEST(ProgramCoach, SaysWhatIsWrong) {
    const auto exitOf = [](std::vector<std::string> arguments, const std::string& link = "sim:coach") {
        const Ended ended = coach(std::move(arguments), link);
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        return ended.exitCode;
    };
    EXPECT_EQ(exitOf({"drive", "--forward", "101", "--for", "1"}), 2);
    EXPECT_EQ(exitOf({"drive", "--forward", "50"}), 2) << "without --for";
    EXPECT_EQ(exitOf({"free-analog", "--percent", "101"}), 2);
    EXPECT_EQ(exitOf({"pair", "--boat", "256", "--for", "1"}), 2);
    EXPECT_EQ(exitOf({"pair", "--color", "green", "--for", "1"}), 2);
    EXPECT_EQ(exitOf({"radio", "set", "--preset", "boat"}), 2);
    EXPECT_EQ(exitOf({"radio", "set", "--channel", "0x1B"}), 2);
    EXPECT_EQ(exitOf({"scan"}, "sim:coach?towrps=256"), 2);
    EXPECT_EQ(exitOf({"scan"}, "sim:coach?lossy=4:0.3"), 2) << "there is no boat 4";
    EXPECT_EQ(exitOf({"radio", "set", "--preset", "robot", "--robot", "16", "--radio", "0"}), 2);
    EXPECT_EQ(exitOf({"scan"}, "sim:thunderbots"), 2);
    EXPECT_EQ(exitOf({"scan"}, "sim:coach?fresh=1"), 1) << "no module in API mode";
    EXPECT_EQ(exitOf({"pair", "--for", "1"}, "sim:coach?address=0x1234"), 1) << "another radio";
}

/// Of a line that is lost while a boat is driven over it, nobody can say that the boat was told to stop.
TEST(ProgramCoach, ALineThatIsLostLeavesTheBoatToItsOwnTimer) {
    std::string folder = testing::TempDir() + "kscoachXXXXXX";
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string console = folder + "/console";
    const std::string control = folder + "/control.sock";
    {
        Program simulator({"coach", "--pty", console, "--towrps", "5", "--control", control, "--json"}, kSim);
        ASSERT_TRUE(simulator.waitFor("\n"));
        Program drive({"--link", "serial:" + console + "?protocol=coach", "--json", "coach", "drive",
                       "--forward", "100", "--for", "60"});
        ASSERT_TRUE(drive.waitFor("\"driving\""));
        Program unplug({"ctl", "--control", control, "unplug"}, kSim);
        EXPECT_EQ(unplug.end().exitCode, 0);
        const Ended ended = drive.end();
        EXPECT_EQ(ended.exitCode, 1) << ended.out;
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        EXPECT_FALSE(endOf(ended)[QStringLiteral("stopped")].toBool(true)) << ended.out;
    }
    for (const std::string& file : {console, control})
        ::unlink(file.c_str());
    ::rmdir(folder.c_str());
}

/// Drives a boat that falls silent meanwhile.
Ended driveABoatThatFallsSilent(bool interrupted) {
    std::string folder = testing::TempDir() + "kscoachXXXXXX";
    EXPECT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string console = folder + "/console";
    const std::string control = folder + "/control.sock";
    Ended ended;
    {
        Program simulator({"coach", "--pty", console, "--towrps", "5", "--control", control, "--json"}, kSim);
        EXPECT_TRUE(simulator.waitFor("\n"));
        Program drive({"--link", "serial:" + console + "?protocol=coach", "--json", "coach", "drive",
                       "--forward", "100", "--for", "60"});
        EXPECT_TRUE(drive.waitFor("\"driving\""));
        Program deafen({"ctl", "--control", control, "boat-loss", "5", "1"}, kSim);
        EXPECT_EQ(deafen.end().exitCode, 0);
        const QJsonValue shown = run({"ctl", "--control", control, "--json", "show", "5"}, kSim)
                                     .object()[QStringLiteral("teams")][0];
        EXPECT_EQ(shown[QStringLiteral("team")], 5);
        EXPECT_EQ(shown[QStringLiteral("loss")], 1);
        if (interrupted) drive.signal(SIGINT);
        ended = drive.end();
    }
    for (const std::string& file : {console, control})
        ::unlink(file.c_str());
    ::rmdir(folder.c_str());
    return ended;
}

/// A zero velocity that no boat answers is not told as a boat that stands.
TEST(ProgramCoach, ABoatThatIsNotHeardAnyMoreIsNotSaidToHaveStopped) {
    for (const bool interrupted : {true, false}) {
        const Ended ended = driveABoatThatFallsSilent(interrupted);
        EXPECT_NE(ended.exitCode, 0) << ended.out;
        EXPECT_FALSE(endOf(ended)[QStringLiteral("stopped")].toBool(true)) << ended.out;
        EXPECT_EQ(hasEvent(ended, "unpaired"), !interrupted) << ended.out;
    }
}

/// Two radio modules in one simulator, each on a pseudo-terminal.
TEST(ProgramCoach, TwoProgramsPlayThroughPseudoTerminalsThoughAFifthIsLost) {
    std::string folder = testing::TempDir() + "kscoachXXXXXX";
    ASSERT_NE(::mkdtemp(folder.data()), nullptr);
    const std::string console = folder + "/console";
    const std::string boat = folder + "/boat";
    {
        Program simulator({"coach", "--pty", console + "," + boat, "--address", "0xBC05,0xAF05", "--towrps",
                           "", "--loss", "0.2", "--control", folder + "/control.sock", "--json"},
                          kSim);
        ASSERT_TRUE(simulator.waitFor("\n"));
        const auto link = [](const std::string& path) { return "serial:" + path + "?protocol=coach"; };
        Program towrp({"--link", link(boat), "--json", "coach", "towrp", "--for", "8"});
        ASSERT_TRUE(towrp.waitFor("towrp-started"));
        const Ended drive = run({"--link", link(console), "--json", "coach", "drive", "--forward", "100",
                                 "--turn", "-45", "--for", "2"});
        EXPECT_EQ(drive.exitCode, 0) << drive.out << drive.err;
        EXPECT_TRUE(endOf(drive)[QStringLiteral("stopped")].toBool());
        const Ended boats = towrp.end();
        EXPECT_EQ(boats.exitCode, 0) << boats.err;
        EXPECT_TRUE(hasEvent(boats, "paired"));
        EXPECT_NE(boats.out.find("\"forward_percent\":100"), std::string::npos) << boats.out;
        EXPECT_NE(boats.out.find("\"turn_percent\":-45"), std::string::npos);
    }
    for (const std::string& file : {console, boat, folder + "/control.sock"})
        ::unlink(file.c_str());
    ::rmdir(folder.c_str());
}

}  // namespace
}  // namespace kickstand::test
