// A simulated board on a pseudo-terminal, used by kickstandctl as if it were real.

#include <QDeadlineTimer>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

namespace fs = std::filesystem;

class SimSmartDevice : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = testing::TempDir() + "ksdevXXXXXX";
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder_ = pattern;
        port_ = folder_ / "bear";
        simulator_.emplace(
            std::vector<std::string>{"smartdevice", "--type", "PolarBear", "--boot", "50", "--pty",
                                     port_.string(), "--control", control(), "--json"},
            KICKSTAND_SIM);
        ASSERT_TRUE(simulator_->waitFor("\n"));
    }
    void TearDown() override {
        simulator_.reset();
        fs::remove_all(folder_);
    }
    std::string control() const { return (folder_ / "control.sock").string(); }
    Ended onPort(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"--link", "serial:" + port_.string() + "?protocol=smartdevice"});
        return run(std::move(arguments));
    }
    /// The board as the simulator has it.
    QJsonObject board() const {
        return ctl({"--json", "show", "0"}).object()[QStringLiteral("devices")][0].toObject();
    }
    int stops() const { return board()[QStringLiteral("disables")].toInt(); }
    double dutyCycle() const { return board()[QStringLiteral("values")][0].toDouble(); }
    static bool eventually(const std::function<bool()>& met) {
        QDeadlineTimer watchdog(20'000);
        while (!met()) {
            if (watchdog.hasExpired()) return false;
        }
        return true;
    }
    std::vector<std::string> driving() const {
        return {"--link",
                "serial:" + port_.string() + "?protocol=smartdevice",
                "--json",
                "smartdevice",
                "write",
                "PolarBear",
                "duty_cycle=0.5",
                "--for",
                "60"};
    }
    Ended ctl(std::vector<std::string> words) const {
        words.insert(words.begin(), {"ctl", "--control", control()});
        return run(std::move(words), KICKSTAND_SIM);
    }

    fs::path folder_;
    fs::path port_;
    std::optional<Program> simulator_;
};

TEST_F(SimSmartDevice, IsListedReadAndWrittenOverASerialPort) {
    EXPECT_TRUE(fs::is_symlink(port_));
    const Ended list = onPort({"--json", "smartdevice", "list"});
    EXPECT_EQ(list.exitCode, 0) << list.err;
    const QJsonArray devices = list.object()[QStringLiteral("devices")].toArray();
    ASSERT_EQ(devices.size(), 1);
    EXPECT_EQ(devices[0][QStringLiteral("name")].toString(), QStringLiteral("PolarBear"));
    EXPECT_EQ(devices[0][QStringLiteral("port")].toString().toStdString(), port_.string());
    const Ended asked = onPort({"smartdevice", "read", port_.string(), "enc_pos"});
    EXPECT_EQ(asked.exitCode, 0) << asked.err;
    const Ended driven = onPort({"smartdevice", "write", "PolarBear", "duty_cycle=0.5", "--for", "0.3"});
    EXPECT_EQ(driven.exitCode, 0) << driven.err;
    const QJsonObject shown = ctl({"--json", "show", "0"}).object();
    const QJsonObject board = shown[QStringLiteral("devices")][0].toObject();
    EXPECT_GE(board[QStringLiteral("writes")].toInt(), 2) << "the duty cycle, and zero at the end";
    EXPECT_GE(board[QStringLiteral("disables")].toInt(), 1);
    EXPECT_EQ(board[QStringLiteral("values")][0].toDouble(), 0);
}

TEST_F(SimSmartDevice, ABusyPortIsSaidToBeBusyWithTheRemedy) {
    Program holder({"--link", "serial:" + port_.string() + "?protocol=smartdevice", "--json", "smartdevice",
                    "subscribe", port_.string()});
    ASSERT_TRUE(holder.waitFor("\"update\""));
    for (const char* command : {"ping", "read"}) {
        for (const std::string& name : {port_.string(), std::string("PolarBear")}) {
            const Ended busy = onPort({"smartdevice", command, name});
            EXPECT_EQ(busy.exitCode, 1) << command;
            EXPECT_TRUE(busy.oneComplaint()) << busy.err;
            EXPECT_NE(busy.err.find(port_.string()), std::string::npos) << busy.err;
            EXPECT_NE(busy.err.find("Close"), std::string::npos) << busy.err;
        }
    }
    holder.signal(SIGINT);
    EXPECT_EQ(holder.end().exitCode, 0);
}

TEST_F(SimSmartDevice, APolarBearWhosePortIsClosedDisablesItself) {
    Program program(driving());
    ASSERT_TRUE(eventually([this] { return dutyCycle() == 0.5; }));
    program.signal(SIGKILL);
    program.end();
    EXPECT_TRUE(eventually([this] { return board()[QStringLiteral("disabled")].toBool(); }));
    EXPECT_EQ(dutyCycle(), 0);
}

TEST_F(SimSmartDevice, StopReachesTheBoardAndSaysWhich) {
    const int before = stops();
    const Ended ended = onPort({"stop"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("told to stop: PolarBear at " + port_.string()), std::string::npos) << ended.out;
    EXPECT_EQ(stops(), before + 1);
}

TEST_F(SimSmartDevice, AStopThatReachesNobodyFailsWithTheReason) {
    const auto expectFailed = [this](const Ended& ended, const std::string& reason) {
        EXPECT_EQ(ended.exitCode, 1) << ended.out;
        EXPECT_TRUE(ended.oneComplaint()) << ended.err;
        EXPECT_NE(ended.err.find(reason), std::string::npos) << ended.err;
        EXPECT_NE(ended.err.find(port_.string()), std::string::npos) << ended.err;
        EXPECT_EQ(ended.out.find("told to stop"), std::string::npos) << ended.out;
    };
    const int before = stops();
    ASSERT_EQ(ctl({"silent", "0", "1"}).exitCode, 0);
    expectFailed(onPort({"stop"}), "Nobody answers");
    ASSERT_EQ(ctl({"silent", "0", "0"}).exitCode, 0);
    {
        Program holder(driving());
        ASSERT_TRUE(eventually([this] { return dutyCycle() == 0.5; }));
        expectFailed(onPort({"stop"}), "Close that program");
        EXPECT_EQ(stops(), before);
        holder.signal(SIGINT);
        holder.end();
    }
    ASSERT_EQ(ctl({"unplug", "0"}).exitCode, 0);
    expectFailed(onPort({"stop"}), "no serial port");
}

TEST_F(SimSmartDevice, AWriteFailsWhenItsBoardIsLost) {
    Program program(driving());
    ASSERT_TRUE(eventually([this] { return dutyCycle() == 0.5; }));
    ASSERT_EQ(ctl({"unplug", "0"}).exitCode, 0);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1) << ended.out;
    EXPECT_NE(ended.err.find("gone"), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out.find("told to stop"), std::string::npos) << ended.out;
}

TEST_F(SimSmartDevice, AWriteFailsWhenItsBoardBeginsAnew) {
    Program program(driving());
    ASSERT_TRUE(eventually([this] { return dutyCycle() == 0.5; }));
    ASSERT_EQ(ctl({"reset", "0", "1"}).exitCode, 0);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1) << ended.out;
    EXPECT_NE(ended.err.find("began anew"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("PolarBear"), std::string::npos) << ended.err;
}

TEST_F(SimSmartDevice, AWriteFailsWhenItsBoardStopsByItself) {
    Program program(driving());
    ASSERT_TRUE(eventually([this] { return dutyCycle() == 0.5; }));
    ASSERT_EQ(ctl({"silent", "0", "1"}).exitCode, 0);
    // Nobody answers its heartbeat requests, for it hears nothing.
    ASSERT_TRUE(eventually([this] { return dutyCycle() == 0; }));
    ASSERT_EQ(ctl({"silent", "0", "0"}).exitCode, 0);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 1) << ended.out;
    EXPECT_NE(ended.err.find("stopped by itself"), std::string::npos) << ended.err;
}

TEST_F(SimSmartDevice, WhySubscribedUpdatesStayAwayIsTold) {
    Program watching({"--link", "serial:" + port_.string() + "?protocol=smartdevice", "--json", "smartdevice",
                      "subscribe", "PolarBear", "enc_pos"});
    ASSERT_TRUE(watching.waitFor("\"update\""));
    ASSERT_EQ(ctl({"unplug", "0"}).exitCode, 0);
    ASSERT_TRUE(watching.waitFor("\"device-lost\""));
    ASSERT_EQ(ctl({"replug", "0"}).exitCode, 0);
    ASSERT_TRUE(watching.waitFor("\"device-back\""));
    watching.signal(SIGINT);
    EXPECT_EQ(watching.end().exitCode, 0);
}

TEST_F(SimSmartDevice, ABoardThatIsPulledOutIsSaidToBeGone) {
    EXPECT_EQ(ctl({"unplug", "0"}).exitCode, 0);
    EXPECT_FALSE(fs::exists(port_));
    const Ended gone = onPort({"smartdevice", "read", "PolarBear"});
    EXPECT_EQ(gone.exitCode, 1);
    EXPECT_TRUE(gone.oneComplaint()) << gone.err;
    EXPECT_EQ(ctl({"replug", "0"}).exitCode, 0);
    EXPECT_EQ(onPort({"smartdevice", "read", "PolarBear"}).exitCode, 0);
}

}  // namespace
}  // namespace kickstand::test
