// The engine against the simulated dongle through unmodified libusb: nothing between the two knows that the
// bus is emulated. Waits are for events, under a watchdog.

#include <cmath>

#include <gtest/gtest.h>

#include "core/engine/engine_core.h"
#include "core/link/usb/libusb_link.h"
#include "core/thunderbots/sim/thunderbots_sim.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/usb/umockdev_bus.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {
namespace {

using namespace thunderbots;

constexpr SessionId kSession = 1;
constexpr int kRobot = 3;

UsbMatch dongle() {
    UsbMatch match;
    match.vendor = wire::kVendorId;
    match.product = wire::kDongleProductId;
    match.interfaces = {wire::kLocalDataInterface, wire::kMainTransportInterface};
    return match;
}

/// Real links, which find what is on the emulated bus.
class UsbLinks final : public LinkProvider {
  public:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri&, Scheduler& scheduler) override {
        ProvidedUsbLink provided;
        provided.link = makeLibusbLink(scheduler, dongle());
        return provided;
    }
    void discover(Scheduler&, std::function<void(FoundHardware)>) override {}
};

class DongleOnUsb : public ::testing::Test {
  protected:
    DongleOnUsb() {
        deviceThread_.run([this] {
            sim::ThunderbotsSimOptions options;
            options.pace = sim::RadioPace::Ideal;
            sim_ = std::make_unique<sim::ThunderbotsSim>(deviceThread_, options);
            lookAgain();
        });
        bus_ = std::make_unique<UmockdevBus>(deviceThread_);
        bus_->connect(sim_->device(), "1-1");
        engineThread_.run([this] {
            listening_ = makeLibusbLink(engineThread_, dongle());
            // The beat's own thread may be held up on a machine with much else to do.
            EngineOptions options;
            options.heartbeatLimit = std::chrono::seconds(10);
            core_ = std::make_unique<EngineCore>(engineThread_, links_, options);
            core_->start();
            beat();
        });
    }
    ~DongleOnUsb() override {
        engineThread_.run([this] { engineThread_.cancel(beatTimer_); });
        bool closed = false;
        engineThread_.run([this, &closed] { core_->shutdown([&closed] { closed = true; }); });
        EXPECT_TRUE(engineThread_.waitUntil([&closed] { return closed; }));
        engineThread_.run([this] { core_.reset(); });
        bus_.reset();
        engineThread_.run([this] { listening_.reset(); });
        deviceThread_.run([this] {
            deviceThread_.cancel(lookTimer_);
            sim_.reset();
        });
    }

    /// The person's side is alive throughout.
    void beat() {
        core_->flows().heartbeat.beat(engineThread_.now());
        beatTimer_ = engineThread_.callAfter(std::chrono::milliseconds(50), [this] { beat(); });
    }

    /// A robot on its own works nothing out until somebody looks: this is what makes a wait for it look.
    void lookAgain() {
        lookTimer_ = deviceThread_.callAfter(std::chrono::milliseconds(10), [this] { lookAgain(); });
    }

    void submit(CommandBody body) {
        engineThread_.run([this, &body] {
            ASSERT_TRUE(core_->flows().commands.tryPush(
                kickstand::Command{++lastCommand_, kSession, std::move(body)}));
            core_->takeCommands();
        });
    }
    void give(const thunderbots::Command& command) { submit(SystemCommand{command}); }

    bool waitFor(const std::function<bool(const Snapshot&)>& holds) {
        return engineThread_.waitUntil([this, &holds] {
            const auto latest = core_->flows().snapshots.latest().value;
            return !latest->sessions.empty() && holds(std::get<Snapshot>(latest->sessions.front().system));
        });
    }
    bool connect() {
        submit(Connect{parseLinkUri("usb:").value()});
        return waitForRunning();
    }
    bool waitForRunning() {
        return waitFor([](const Snapshot& now) {
            return now.link == LinkState::Running && now.robots[kRobot].freshness == Freshness::Current;
        });
    }
    bool robotComesTo(const std::function<bool(const sim::RobotReport&)>& holds) {
        return deviceThread_.waitUntil([this, &holds] { return holds(sim_->robot(kRobot)); });
    }
    void simulate(const std::string& action, int unit, double value) {
        deviceThread_.run([&] { ASSERT_TRUE(sim_->control().perform(action, unit, value)) << action; });
    }
    bool isStopped() { return core_->flows().stop.isSet(); }
    void rearm() {
        engineThread_.run([this] {
            core_->flows().stop.rearm();
            core_->takeCommands();
        });
    }

  private:
    UsbLinks links_;
    WatchedScheduler deviceThread_;
    WatchedScheduler engineThread_;
    std::unique_ptr<sim::ThunderbotsSim> sim_;
    std::unique_ptr<UmockdevBus> bus_;
    /// Keeps libusb listening from the first plug to the last.
    std::unique_ptr<UsbLink> listening_;
    std::unique_ptr<EngineCore> core_;
    TimerId beatTimer_ = 0;
    TimerId lookTimer_ = 0;
    CommandId lastCommand_ = 0;
};

TEST_F(DongleOnUsb, RobotsAreHeardDrivenAndKicked) {
    ASSERT_TRUE(connect());
    give(SetWheels{maskOf(kRobot), {0, 0, 42, 0}});
    EXPECT_TRUE(robotComesTo(
        [](const auto& robot) { return robot.lastDrive.run && robot.lastDrive.wheels[2] == 42; }));
    give(ArmHighVoltage{maskOf(kRobot), true});
    give(Kick{kRobot, {true, true, 75, 0, 0}});
    EXPECT_TRUE(robotComesTo([](const auto& robot) { return robot.kicks == 1; }));
}

TEST_F(DongleOnUsb, UnpluggedInMidDriveItStopsAndComesBackBraked) {
    ASSERT_TRUE(connect());
    give(ArmHighVoltage{maskOf(kRobot), true});
    give(Kick{kRobot, {true, true, 10, 0, 0}});
    ASSERT_TRUE(robotComesTo([](const auto& robot) { return robot.kicks == 1; }));
    give(SetWheels{maskOf(kRobot), {50, 50, 50, 50}});
    ASSERT_TRUE(robotComesTo([](const auto& robot) { return robot.lastDrive.wheels[0] == 50; }));

    simulate("plugged", -1, 0);
    EXPECT_TRUE(waitFor([](const Snapshot& now) { return now.link == LinkState::Searching; }));
    EXPECT_TRUE(isStopped());
    EXPECT_TRUE(robotComesTo(
        [](const auto& robot) { return !robot.driveFresh && std::abs(robot.wheelSpeeds[0]) < 1; }));

    simulate("plugged", -1, 1);
    ASSERT_TRUE(waitForRunning());
    EXPECT_TRUE(robotComesTo([](const auto& robot) { return robot.driveFresh; }));
    EXPECT_TRUE(robotComesTo([](const auto& robot) { return !robot.lastDrive.run && robot.kicks == 1; }));

    rearm();
    give(SetWheels{maskOf(kRobot), {7, 7, 7, 7}});
    EXPECT_TRUE(robotComesTo([](const auto& robot) { return robot.lastDrive.wheels[0] == 7; }));
}

TEST_F(DongleOnUsb, AStalledEndpointIsClearedAndGoesOn) {
    ASSERT_TRUE(connect());
    simulate("stall", -1, wire::address(wire::Endpoint::StateIn));
    EXPECT_TRUE(waitFor([](const Snapshot& now) { return now.traffic.stalls >= 1; }));
    simulate("battery", kRobot, 15.2);
    EXPECT_TRUE(waitFor([](const Snapshot& now) {
        return now.link == LinkState::Running && std::abs(now.robots[kRobot].readings.battery_V - 15.2) < 0.1;
    }));
}

TEST_F(DongleOnUsb, AFailedRadioIsSaidWithItsNumber) {
    simulate("radio-failure", -1, 1);
    submit(Connect{parseLinkUri("usb:").value()});
    EXPECT_TRUE(waitFor([](const Snapshot& now) {
        return now.link == LinkState::Failed && now.error && now.error->code == Errc::RadioFailed &&
               now.error->got == 1;
    }));
}

}  // namespace
}  // namespace kickstand::testing
