#include "core/engine/session_registry.h"

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "core/smartdevice/sim/simulated_ports.h"
#include "core/smartdevice/snapshot.h"

namespace kickstand {
namespace {

/// Boards behind every link.
class Boards final : public LinkProvider {
  public:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler&) override {
        return fail(Errc::Unsupported, toString(uri));
    }
    Result<ProvidedBytePorts> makeBytePorts(const LinkUri&, Scheduler& scheduler) override {
        auto sim = std::make_shared<smartdevice::sim::SmartDeviceSim>(
            scheduler, smartdevice::sim::SmartDeviceSimOptions{});
        ProvidedBytePorts provided;
        provided.ports = smartdevice::sim::makeSimulatedPorts(scheduler, *sim);
        provided.keepAlive = std::move(sim);
        return provided;
    }
    void discover(Scheduler&, std::function<void(FoundHardware)>) override {}
};

class NoSamples final : public SampleSink {
  public:
    void sample(SignalId, TimePoint, float) override {}
    void gap(SignalId, TimePoint) override {}
};

/// Room for that many series of a store, and the memory that all of them take.
struct Room {
    std::size_t series = 0;
    std::size_t bytes = 0;
};
Room roomOf(const TelemetryLimits& limits) {
    TelemetryStore one({.series = 1, .samples = limits.samples, .pastBlocks = limits.pastBlocks});
    EXPECT_NE(one.series(SignalId{}), nullptr);
    return {limits.series, limits.series * one.bytes()};
}

TEST(SessionRegistry, ManyBoardsHaveRoomForAllTheirSeriesInTheMemoryThatRobotsTake) {
    FakeScheduler scheduler;
    StopLatch stop;
    NoSamples samples;
    Boards links;
    const SessionEnvironment environment{scheduler, stop, samples, [](const SystemEvent&) {},
                                         [](CommandId, const Result<void>&) {}};
    const auto made = makeSession(*parseLinkUri("serial:"), links, environment);
    ASSERT_TRUE(made);
    const Room boards = roomOf(made->telemetry);
    const Room robots = roomOf(TelemetryLimits{});
    // A PolarBear tells five quantities that change.
    EXPECT_GE(boards.series, 5U * smartdevice::kMostDevices);
    EXPECT_GT(boards.series, robots.series);
    EXPECT_LE(boards.bytes, robots.bytes);
}

}  // namespace
}  // namespace kickstand
