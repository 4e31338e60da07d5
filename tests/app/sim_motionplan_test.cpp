// kickstand-sim motionplan on a pseudo-terminal, used by kickstandctl as a robot would be.

#include <QJsonObject>
#include <csignal>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

class SimNxt : public testing::Test {
  protected:
    void SetUp() override {
        std::string pattern = testing::TempDir() + "knxtXXXXXX";
        ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
        folder = pattern;
        simulator.emplace(std::vector<std::string>{"motionplan", "--pty", folder + "/nxt", "--pace", "2",
                                                   "--control", folder + "/control.sock", "--json"},
                          KICKSTAND_SIM);
        ASSERT_TRUE(simulator->waitFor("\n"));
    }
    void TearDown() override {
        simulator->signal(SIGTERM);
        EXPECT_EQ(simulator->end().exitCode, 0);
        for (const char* file : {"/control.sock", "/nxt"})
            ::unlink((folder + file).c_str());
        EXPECT_EQ(::rmdir(folder.c_str()), 0);
    }

    Ended plan(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(),
                         {"--link", "serial:" + folder + "/nxt?protocol=motionplan", "--json", "motionplan"});
        return run(std::move(arguments));
    }
    Ended ctl(std::vector<std::string> words) const {
        words.insert(words.begin(), {"ctl", "--control", folder + "/control.sock"});
        return run(words, KICKSTAND_SIM);
    }
    QJsonObject show() const { return ctl({"--json", "show"}).object(); }

    std::string folder;
    std::optional<Program> simulator;
};

TEST_F(SimNxt, KeepsWhatOneProgramHasSentForTheNext) {
    const Ended created = plan({"create", "--slot", "4", "--plan", "9", "forward 25, turn left 84"});
    EXPECT_EQ(created.exitCode, 0) << created.err;
    EXPECT_EQ(show()[QStringLiteral("slots")][4][QStringLiteral("movements")], QStringLiteral("0d 9c"));
    const Ended full = plan({"create", "--slot", "4", "--plan", "8", "forward 1"});
    EXPECT_EQ(full.exitCode, 1);
    EXPECT_NE(full.err.find("error 0"), std::string::npos) << full.err;
    // Without an ID it is that of the plan that is there.
    EXPECT_EQ(plan({"update", "--slot", "4", "forward 5"}).exitCode, 0);
    const QJsonValue slot = show()[QStringLiteral("slots")][4];
    EXPECT_EQ(slot[QStringLiteral("plan")], 9);
    EXPECT_EQ(slot[QStringLiteral("movements")], QStringLiteral("05"));
    const Ended executed = plan({"execute", "--slot", "4", "--for", "20"});
    EXPECT_EQ(executed.exitCode, 0) << executed.err;
    EXPECT_EQ(show()[QStringLiteral("executed")], 1);
    const Ended other = plan({"execute", "--slot", "4", "--plan", "1", "--for", "20"});
    EXPECT_EQ(other.exitCode, 1);
    EXPECT_NE(other.err.find("error 4"), std::string::npos) << other.err;
}

TEST_F(SimNxt, StartsItsTriggerPlanWhenTheProgramLetsGo) {
    EXPECT_EQ(plan({"trigger", "--plan", "7", "back 1000"}).exitCode, 0);
    const QJsonObject motion = show()[QStringLiteral("motion")].toObject();
    EXPECT_TRUE(motion[QStringLiteral("trigger")].toBool());
    // Connecting again leaves it alone; its status tells, and Stop stops it. Letting go starts it once more.
    const QJsonObject status = plan({"status"}).object();
    EXPECT_EQ(status[QStringLiteral("execution")][QStringLiteral("plan")], 7);
    const QJsonObject stopped = plan({"stop"}).object();
    EXPECT_TRUE(stopped[QStringLiteral("stopped")].toBool());
    EXPECT_EQ(stopped[QStringLiteral("starts_when_closed")], 7);
    const Ended adjusted = plan({"adjust", "--wheels", "both", "--change", "-10", "--for", "0.1"});
    EXPECT_EQ(adjusted.exitCode, 0) << adjusted.err;
    EXPECT_EQ(adjusted.values().back()[QStringLiteral("starts_when_closed")], 7);
}

TEST_F(SimNxt, ARefusedCommandSaysAsWellWhatLettingGoStarts) {
    EXPECT_EQ(plan({"trigger", "--plan", "7", "back 50"}).exitCode, 0);
    EXPECT_EQ(plan({"create", "--slot", "4", "--plan", "9", "forward 25"}).exitCode, 0);
    const Ended refused = plan({"create", "--slot", "4", "--plan", "8", "forward 1"});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_EQ(refused.values().back()[QStringLiteral("starts_when_closed")], 7);
    EXPECT_TRUE(refused.values().back()[QStringLiteral("error")].isObject()) << refused.out;
}

TEST_F(SimNxt, StopReachesARobotThatCannotBeHeard) {
    EXPECT_EQ(plan({"create", "--slot", "4", "--plan", "9", "forward 1000, back 1000"}).exitCode, 0);
    Program running({"--link", "serial:" + folder + "/nxt?protocol=motionplan", "--json", "motionplan",
                     "execute", "--slot", "4", "--for", "60"});
    ASSERT_TRUE(running.waitFor("executing"));
    running.signal(SIGKILL);
    static_cast<void>(running.end());
    EXPECT_EQ(ctl({"reply-loss", "1"}).exitCode, 0);
    EXPECT_EQ(show()[QStringLiteral("motion")][QStringLiteral("plan")], 9) << "it goes on";
    const Ended stopped = plan({"stop"});
    EXPECT_EQ(stopped.exitCode, 1);
    EXPECT_NE(stopped.err.find("has not confirmed that it stands"), std::string::npos) << stopped.err;
    EXPECT_FALSE(show()[QStringLiteral("motion")].isObject()) << "it heard";
}

TEST_F(SimNxt, ItsPortIsNotTakenFromIt) {
    const Ended second =
        run({"motionplan", "--pty", folder + "/nxt", "--control", folder + "/other.sock"}, KICKSTAND_SIM);
    EXPECT_EQ(second.exitCode, 1);
    EXPECT_TRUE(second.oneComplaint("kickstand-sim")) << second.err;
    EXPECT_NE(second.err.find("Another program serves a serial port"), std::string::npos) << second.err;
    EXPECT_EQ(plan({"status"}).exitCode, 0);
}

TEST_F(SimNxt, ALinkThatWasLeftBehindIsReplaced) {
    const std::string left = folder + "/left";
    ASSERT_EQ(::symlink("/dev/pts/999999", left.c_str()), 0);
    Program second({"motionplan", "--pty", left, "--control", folder + "/other.sock", "--json"},
                   KICKSTAND_SIM);
    ASSERT_TRUE(second.waitFor("\n"));
    EXPECT_EQ(run({"--link", "serial:" + left + "?protocol=motionplan", "motionplan", "status"}).exitCode, 0);
    second.signal(SIGTERM);
    EXPECT_EQ(second.end().exitCode, 0);
}

TEST_F(SimNxt, ARobotThatIsOutOfReachIsNotSaidToHaveBeenStopped) {
    EXPECT_EQ(plan({"create", "--slot", "4", "--plan", "9", "forward 1000, back 1000"}).exitCode, 0);
    Program running({"--link", "serial:" + folder + "/nxt?protocol=motionplan", "--json", "motionplan",
                     "execute", "--slot", "4", "--for", "60"});
    ASSERT_TRUE(running.waitFor("executing"));
    EXPECT_EQ(ctl({"unplug"}).exitCode, 0);
    const Ended ended = running.end();
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_EQ(ended.err.find("Everything was stopped"), std::string::npos) << ended.err;
    EXPECT_NE(ended.err.find("STOP cannot reach it"), std::string::npos) << ended.err;
    EXPECT_TRUE(show()[QStringLiteral("motion")].isObject());
}

TEST_F(SimNxt, APulledPlugIsSaid) {
    EXPECT_EQ(ctl({"unplug"}).exitCode, 0);
    const Ended ended = plan({"status"});
    EXPECT_EQ(ended.exitCode, 1);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_EQ(ctl({"replug"}).exitCode, 0);
    EXPECT_EQ(plan({"status"}).exitCode, 0);
}

}  // namespace
}  // namespace kickstand::test
