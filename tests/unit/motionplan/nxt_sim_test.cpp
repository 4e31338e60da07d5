#include "core/motionplan/sim/nxt_sim.h"

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/base/hex.h"

namespace kickstand::motionplan::sim {
namespace {

using namespace std::chrono_literals;

/// Speaks to an NXT in telegrams, without a station.
class Host final : public ByteDeviceListener {
  public:
    explicit Host(const NxtOptions& options = {}) : sim(scheduler, options) {
        sim.setListener(this);
        sim.lineOpened(115200);
    }
    ~Host() override { sim.setListener(nullptr); }

    void send(const char* hex) {
        sim.hostSent(*parseHex(hex));
        scheduler.advance(100ms);
    }
    /// What the command outbox gives next: its status, or the message it held.
    std::string read() {
        came.clear();
        send("05 00 00 13 11 07 01");
        if (came.size() != 66) return "nothing";
        if (came[4] != 0) return "status " + toHex({&came[4], 1});
        return toHex(ByteView(came).subspan(7, came[6] - 1U));
    }
    void deviceSent(ByteView bytes) override { came.assign(bytes.begin(), bytes.end()); }
    void attachedChanged(bool) override {}

    FakeScheduler scheduler;
    NxtSim sim;
    std::vector<std::uint8_t> came;
};

TEST(NxtSim, KeepsThePlanOfTheSample) {
    Host host;
    host.send("0d 00 80 09 07 09 00 09 04 0d 5c 12 7e 37 00");
    EXPECT_EQ(host.read(), "00 09 04 0d 5c 12 7e 37");
    EXPECT_EQ(host.read(), "status 40");
    EXPECT_EQ(host.sim.program().kept()[4].id, 9);
}

TEST(NxtSim, AnswersAWriteThatAsksForIt) {
    Host host;
    host.send("06 00 00 09 07 02 01 00");
    EXPECT_EQ(toHex(host.came), "03 00 02 09 00");
    host.sim.setProgramRuns(false);
    host.send("06 00 00 09 07 02 01 00");
    EXPECT_EQ(toHex(host.came), "03 00 02 09 ec");
    EXPECT_EQ(host.read(), "status ec");
}

TEST(NxtSim, TheOutboxHoldsFiveAndLosesTheOldest) {
    Host host;
    for (int code = 0; code < 7; ++code)
        host.sim.program().putError(code);
    EXPECT_EQ(host.read(), "07 02");
    EXPECT_EQ(host.sim.report().overflows, 2U);
}

TEST(NxtSim, LosesTheOneMessageThatItIsToldTo) {
    Host host;
    host.sim.loseOne(2);
    for (int code = 0; code < 3; ++code)
        host.sim.program().putError(code);
    EXPECT_EQ(host.read(), "07 00");
    EXPECT_EQ(host.read(), "07 02");
    EXPECT_EQ(host.read(), "status 40");
    EXPECT_EQ(host.sim.loseOneFromRobot(), 0);
}

TEST(NxtSim, MovesAtItsPace) {
    Host host;
    host.send("09 00 80 09 07 05 00 09 04 0c 00");  // 20 cm
    host.send("08 00 80 09 07 04 03 09 04 00");
    ASSERT_TRUE(host.sim.program().motion());
    host.scheduler.advance(800ms);
    ASSERT_TRUE(host.sim.program().motion());
    host.scheduler.advance(200ms);
    EXPECT_FALSE(host.sim.program().motion());
    EXPECT_EQ(host.sim.program().executed(), 1U);
}

TEST(NxtSim, RubbishOnTheLineIsCountedAndHarmsNothing) {
    Host host;
    host.send("ff ff 41 00 00 40 00 13 00 99 03");
    host.scheduler.advance(1s);
    host.sim.lineClosed();
    host.sim.lineOpened(115200);
    EXPECT_EQ(host.read(), "status 40");
    EXPECT_GT(host.sim.report().skipped, 0U);
}

TEST(NxtSim, ActionsAreBounded) {
    Host host;
    SimControl& control = host.sim.control();
    EXPECT_EQ(control.actions().size(), 13U);
    for (const SimAction& action : control.actions()) {
        EXPECT_EQ(control.perform(action.name, -1, action.highest + 1).error().code, Errc::OutOfRange);
        EXPECT_EQ(control.perform(action.name, 0, action.lowest).error().code, Errc::BadArgument);
        EXPECT_TRUE(control.perform(action.name, -1, action.lowest)) << action.name;
        if (action.name == "error") continue;
        EXPECT_EQ(control.value(action.name, -1), action.lowest);
    }
    EXPECT_EQ(control.perform("sing", -1, 0).error().code, Errc::UnknownName);
    EXPECT_EQ(control.perform("text", -1, 0.5).error().code, Errc::OutOfRange);
}

TEST(NxtOptions, AreReadStrictly) {
    const auto options =
        parseNxtOptions({{"loss", "0.25"}, {"delay_ms", "50"}, {"text", "on"}, {"pace", "4"}});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->weather.loss, 0.25);
    EXPECT_EQ(options->weather.delay, Duration(50ms));
    EXPECT_TRUE(options->text);
    EXPECT_EQ(parseNxtOptions({{"los", "0.25"}}).error().code, Errc::UnknownName);
    EXPECT_EQ(parseNxtOptions({{"loss", "1.5"}}).error().code, Errc::OutOfRange);
    EXPECT_EQ(parseNxtOptions({{"loss", "much"}}).error().code, Errc::BadArgument);
    EXPECT_EQ(parseNxtOptions({{"text", "yes"}}).error().code, Errc::BadArgument);
}

}  // namespace
}  // namespace kickstand::motionplan::sim
