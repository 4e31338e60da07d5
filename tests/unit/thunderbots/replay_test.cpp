// Model and controller are apart: what was seen on a link, fed to another model, gives the same knowledge.

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/session/session_rig.h"
#include "tests/unit/thunderbots/model_testing.h"

namespace kickstand::thunderbots {
namespace {

using namespace std::chrono_literals;
using testing::OwnedRecord;
using testing::SampleRecorder;

class Recording final : public UsbTapObserver {
  public:
    void observe(const UsbTapRecord& record) override {
        records.push_back({record, {record.data.begin(), record.data.end()}});
    }
    std::vector<OwnedRecord> records;
};

struct Watched {
    SampleRecorder samples;
    std::vector<Event> events;
    FleetModel model{samples, [this](const Event& event) { events.push_back(event); }};
};

void expectSame(const RobotState& a, const RobotState& b, int robot) {
    SCOPED_TRACE(robot);
    EXPECT_EQ(a.live, b.live);
    EXPECT_EQ(a.freshness, b.freshness);
    EXPECT_EQ(a.currentUntil, b.currentUntil);
    EXPECT_EQ(a.feedback, b.feedback);
    EXPECT_EQ(a.told, b.told);
    EXPECT_EQ(a.toldAt, b.toldAt);
    EXPECT_EQ(a.toldTestMode, b.toldTestMode);
    EXPECT_EQ(a.kicks, b.kicks);
    EXPECT_EQ(a.lastKick, b.lastKick);
    EXPECT_EQ(a.autokicks, b.autokicks);
    EXPECT_EQ(a.experiment.data, b.experiment.data);
    EXPECT_EQ(a.experiment.known, b.experiment.known);
    EXPECT_EQ(a.capacitor.has_value(), b.capacitor.has_value());
    if (a.capacitor && b.capacitor) {
        EXPECT_EQ(a.capacitor->last_V, b.capacitor->last_V);
        EXPECT_EQ(a.capacitor->at, b.capacitor->at);
    }
}

TEST(Replay, ARecordingTeachesAnotherModelTheSame) {
    Recording recording;
    kickstand::testing::SessionRigOptions options;
    options.sim.weather.loss = 0.05;
    options.observer = &recording;
    kickstand::testing::SessionRig rig(options);
    ASSERT_TRUE(rig.connect());
    ASSERT_TRUE(rig.arm(3));
    ASSERT_TRUE(rig.ask(SetCharger{maskOf(3), true}));
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(5), {50, 50, -50, -50}}));
    ASSERT_TRUE(rig.ask(SetTestMode{maskOf(2), {wire::TestClass::Lamp, 0}}));
    rig.advance(4s);
    ASSERT_TRUE(rig.ask(Kick{3, {true, true, 60, 0, 0}}));
    rig.simulate("experiment", 1, 7);
    rig.advance(3s);
    rig.simulate("dead", 1, 5);
    ASSERT_TRUE(rig.waitUntil([&rig] { return rig.count(EventKind::RobotLost) > 0; }, 30s));
    rig.advance(100ms);
    const Snapshot live = rig.state();

    Watched replayed;
    for (const OwnedRecord& owned : recording.records)
        replayed.model.observe(owned.view());
    ASSERT_GT(recording.records.size(), 500U);
    EXPECT_EQ(live.robots[3].kicks, 1U);
    EXPECT_EQ(live.robots[7].experiment.known.count(), 256U);
    EXPECT_EQ(live.robots[5].freshness, Freshness::Stale);
    for (int robot = 0; robot < kRobots; ++robot)
        expectSame(live.robots.at(static_cast<std::size_t>(robot)), replayed.model.robot(robot), robot);
    EXPECT_EQ(live.traffic.packetsIn, replayed.model.traffic().packetsIn);
    EXPECT_EQ(live.traffic.packetsOut, replayed.model.traffic().packetsOut);
    EXPECT_EQ(live.channels, replayed.model.channels());
    EXPECT_EQ(live.radioVersions, replayed.model.radioVersions());
    EXPECT_EQ(live.eStop, replayed.model.status().eStop);
}

}  // namespace
}  // namespace kickstand::thunderbots
