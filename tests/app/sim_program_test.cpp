// kickstand-sim from outside: served on a free port, told what to do through its control socket, used by
// kickstandctl, and ended.

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

constexpr const char* kSim = KICKSTAND_SIM;
const std::string kName = "kickstand-sim";

/// A simulator with a control socket in a folder of its own.
class SimProgram : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = testing::TempDir() + "ksimXXXXXX";
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder = pattern;
        socket = folder + "/control.sock";
    }
    void TearDown() override {
        simulator.reset();
        for (const char* file : {"/control.sock", "/flash.bin"})
            ::unlink((folder + file).c_str());
        ::rmdir(folder.c_str());
    }

    void serve(std::vector<std::string> more = {"--robots", "0,3"}) {
        std::vector<std::string> arguments{"thunderbots", "--usbip",   "--port", "0",     "--radio",
                                           "ideal",       "--control", socket,   "--json"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        simulator.emplace(arguments, kSim);
        ASSERT_TRUE(simulator->waitFor("\n"));
        Ended sofar;
        sofar.out = simulator->out();
        facts = sofar.values().at(0).toObject();
        link = facts[QStringLiteral("carrier")][QStringLiteral("link")].toString().toStdString();
    }
    Ended ctl(std::vector<std::string> words) const {
        words.insert(words.begin(), {"ctl", "--control", socket});
        return run(words, kSim);
    }
    QJsonObject show(const std::string& robot) const { return ctl({"--json", "show", robot}).object(); }
    QJsonObject robot(const std::string& number) const {
        return show(number)[QStringLiteral("robots")][0].toObject();
    }
    bool socketIsThere() const {
        struct stat file = {};
        return ::lstat(socket.c_str(), &file) == 0;
    }

    std::string folder;
    std::string socket;
    std::string link;
    QJsonObject facts;
    std::optional<Program> simulator;
};

TEST_F(SimProgram, SaysWhereItIsAndEndsWellOnEverySignal) {
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        serve();
        EXPECT_EQ(facts[QStringLiteral("system")], QStringLiteral("thunderbots"));
        EXPECT_GT(facts[QStringLiteral("carrier")][QStringLiteral("port")].toInt(), 0);
        EXPECT_EQ(facts[QStringLiteral("robots")].toArray(), (QJsonArray{0, 3}));
        EXPECT_TRUE(socketIsThere());
        simulator->signal(number);
        const Ended ended = simulator->end();
        EXPECT_EQ(ended.exitCode, 0);
        EXPECT_EQ(ended.err, "");
        EXPECT_FALSE(socketIsThere());
    }
}

TEST_F(SimProgram, TellsAPersonHowToReachIt) {
    Program program({"thunderbots", "--usbip", "--port", "0", "--control", socket, "--cable", "3"}, kSim);
    ASSERT_TRUE(program.waitFor("Ctrl+C"));
    program.signal(SIGINT);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 0);
    for (const char* part :
         {"kickstandctl --link usbip:127.0.0.1:", "/1-1", "modprobe vhci-hcd", "--tcp-port",
          "attach -r 127.0.0.1 -b 1-1", "kickstand-sim ctl --control ", "robot 3 on a cable"})
        EXPECT_NE(ended.out.find(part), std::string::npos) << part << '\n' << ended.out;
}

TEST_F(SimProgram, IsToldWhatToDo) {
    serve();
    EXPECT_EQ(ctl({"ball", "3", "1"}).exitCode, 0);
    EXPECT_TRUE(robot("3")[QStringLiteral("ball")].toBool());
    EXPECT_EQ(ctl({"battery", "all", "14.25"}).exitCode, 0);
    EXPECT_NEAR(robot("0")[QStringLiteral("battery_V")].toDouble(), 14.25, 0.1);
    EXPECT_EQ(ctl({"kill", "0"}).exitCode, 0);
    EXPECT_EQ(robot("0")[QStringLiteral("power")], QStringLiteral("off"));
    EXPECT_EQ(ctl({"e-stop", "stop"}).exitCode, 0);
    EXPECT_EQ(show("3")[QStringLiteral("device")][QStringLiteral("emergency_stop")], QStringLiteral("stop"));
    EXPECT_EQ(ctl({"radio-failure", "-1"}).exitCode, 0);
    EXPECT_EQ(ctl({"stall", "0x85"}).exitCode, 0);
    EXPECT_EQ(ctl({"unplug"}).exitCode, 0);
    EXPECT_FALSE(show("3")[QStringLiteral("device")][QStringLiteral("attached")].toBool(true));
    EXPECT_EQ(ctl({"replug"}).exitCode, 0);
    EXPECT_TRUE(show("3")[QStringLiteral("device")][QStringLiteral("attached")].toBool());
    for (const char* words : {"actions", "show"}) {
        const Ended ended = ctl({words});
        EXPECT_EQ(ended.exitCode, 0);
        EXPECT_FALSE(ended.out.empty());
    }
}

TEST_F(SimProgram, SavesAFlashMemory) {
    serve();
    const Ended ended = ctl({"--json", "flash", "3", folder + "/flash.bin"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_EQ(ended.object()[QStringLiteral("bytes")], 2097152);
    std::ifstream file(folder + "/flash.bin", std::ios::binary | std::ios::ate);
    EXPECT_EQ(file.tellg(), 2097152);
    const Ended nowhere = ctl({"flash", "3", folder + "/no/such/folder"});
    EXPECT_EQ(nowhere.exitCode, 1);
    EXPECT_TRUE(nowhere.oneComplaint(kName)) << nowhere.err;
}

TEST_F(SimProgram, RefusalsAreOneLineAndAnExitCode) {
    serve();
    for (const auto& [words, code] :
         std::vector<std::pair<std::vector<std::string>, int>>{{{"explode"}, 2},
                                                               {{"ball", "3"}, 2},
                                                               {{"ball", "3", "2"}, 2},
                                                               {{"ball", "4", "1"}, 1},
                                                               {{"e-stop", "maybe"}, 2},
                                                               {{"stall", "0x11"}, 2},
                                                               {{"show", "3", "4"}, 2},
                                                               {{"flash", "3"}, 2}}) {
        const Ended ended = ctl(words);
        EXPECT_EQ(ended.exitCode, code) << testing::PrintToString(words) << ended.err;
        EXPECT_TRUE(ended.oneComplaint(kName)) << ended.err;
        EXPECT_EQ(ended.out, "");
    }
    const Ended json = ctl({"--json", "ball", "3", "2"});
    EXPECT_EQ(json.object()[QStringLiteral("error")][QStringLiteral("code")], QStringLiteral("out-of-range"));
}

TEST_F(SimProgram, WhatIsTakenAlreadyIsSaid) {
    serve();
    const std::string port = std::to_string(facts[QStringLiteral("carrier")][QStringLiteral("port")].toInt());
    const Ended samePort =
        run({"thunderbots", "--usbip", "--port", port, "--control", folder + "/other.sock"}, kSim);
    EXPECT_EQ(samePort.exitCode, 1);
    EXPECT_TRUE(samePort.oneComplaint(kName)) << samePort.err;
    EXPECT_NE(samePort.err.find("--port"), std::string::npos) << samePort.err;
    const Ended sameSocket = run({"thunderbots", "--usbip", "--port", "0", "--control", socket}, kSim);
    EXPECT_EQ(sameSocket.exitCode, 1);
    EXPECT_TRUE(sameSocket.oneComplaint(kName)) << sameSocket.err;
    EXPECT_NE(sameSocket.err.find("--control"), std::string::npos) << sameSocket.err;
    EXPECT_EQ(ctl({"show"}).exitCode, 0);
}

TEST_F(SimProgram, NobodyThereIsSaid) {
    const Ended ended = ctl({"show"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint(kName)) << ended.err;
    EXPECT_NE(ended.err.find("kickstand-sim thunderbots"), std::string::npos) << ended.err;
}

TEST_F(SimProgram, SurvivesHostileClientsOfTheControlSocket) {
    serve();
    sockaddr_un address = {};
    address.sun_family = AF_UNIX;
    ASSERT_LT(socket.size(), sizeof address.sun_path);
    std::ranges::copy(socket, address.sun_path);
    std::vector<int> clients;
    for (int i = 0; i < 40; ++i) {
        const int client = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
        ASSERT_GE(client, 0);
        clients.push_back(client);
        if (::connect(client, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) continue;
        const std::string garbage = std::string(100000, 'x') + "\n{\"request\":";
        (void)!::send(client, garbage.data(), garbage.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    }
    for (const int client : clients)
        ::close(client);
    // Those that are gone make room as soon as the simulator has heard of it.
    Ended ended;
    for (int tries = 0; tries < 100 && ended.exitCode != 0; ++tries)
        ended = ctl({"show"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
}

TEST(SimUsage, WhatCannotBeMeantIsExitTwo) {
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {},
             {"thunderbots"},
             {"thunderbots", "--usbip", "--port", "65536"},
             {"thunderbots", "--usbip", "--port", "x"},
             {"thunderbots", "--usbip", "--robots", "16"},
             {"thunderbots", "--usbip", "--loss", "2"},
             {"thunderbots", "--usbip", "--radio", "loud"},
             {"thunderbots", "--usbip", "--seed", "-1"},
             {"thunderbots", "--usbip", "--cable", "3", "--robots", "3"},
             {"thunderbots", "--usbip", "--control", ""},
             {"thunderbots", "--usbip", "--port", "0", "--address", "0.0.0.0", "--control", "unused.sock"},
             {"ctl"}}) {
        const Ended ended = run(arguments, kSim);
        EXPECT_EQ(ended.exitCode, 2) << testing::PrintToString(arguments);
        EXPECT_TRUE(ended.oneComplaint(kName)) << ended.err;
        EXPECT_EQ(ended.out, "");
    }
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"--help"}, {"--version"}, {"thunderbots", "--help"}, {"ctl", "-h"}}) {
        const Ended ended = run(arguments, kSim);
        EXPECT_EQ(ended.exitCode, 0);
        EXPECT_NE(ended.out.find("kickstand-sim"), std::string::npos);
    }
}

TEST_F(SimProgram, AHostProgramDrivesIt) {
    serve();
    const Ended charge = run({"--link", link, "thunderbots", "charge", "--robot", "3", "--for", "1"});
    EXPECT_EQ(charge.exitCode, 0) << charge.err;
    const Ended kick = run({"--link", link, "thunderbots", "kick", "--robot", "3", "--width1", "2016",
                            "--width2", "1024", "--offset", "320"});
    EXPECT_EQ(kick.exitCode, 0) << kick.err;
    const Ended test = run(
        {"--link", link, "thunderbots", "test-mode", "--robot", "0", "--class", "encoder", "--target", "2"});
    EXPECT_EQ(test.exitCode, 0) << test.err;

    const QJsonObject kicked = robot("3");
    EXPECT_EQ(kicked[QStringLiteral("kicks")][QStringLiteral("count")], 1);
    const QJsonObject pulses = kicked[QStringLiteral("kicks")][QStringLiteral("last")][0].toObject();
    EXPECT_EQ(pulses[QStringLiteral("width1_us")], 2016);
    EXPECT_EQ(pulses[QStringLiteral("width2_us")], 1024);
    EXPECT_EQ(pulses[QStringLiteral("start2_us")], 320);
    EXPECT_GT(pulses[QStringLiteral("before_V")].toDouble(), 50);
    EXPECT_FALSE(kicked[QStringLiteral("drive")][QStringLiteral("run")].toBool(true));
    EXPECT_EQ(robot("0")[QStringLiteral("test_mode")][QStringLiteral("class")], QStringLiteral("encoder"));
    EXPECT_EQ(robot("0")[QStringLiteral("kicks")][QStringLiteral("count")], 0);
    EXPECT_TRUE(simulator->waitFor("imported 1-1")) << "the log says who came";
}

}  // namespace
}  // namespace kickstand::test
