#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/micropacket.h"
#include "tests/support/session/session_rig.h"

namespace kickstand::thunderbots::testing {

/// A kick of 2 ms on solenoid 1.
constexpr wire::KickTimes kKick{true, true, 62, 0, 0};

/// A drive block as it went out.
struct SentBlock {
    TimePoint time{};
    int robot = 0;
    wire::DriveBlock block;
};

/// The drive blocks among packets, in order.
inline std::vector<SentBlock> blocksIn(const std::vector<kickstand::testing::TakenPacket>& packets) {
    std::vector<SentBlock> blocks;
    for (const auto& packet : packets) {
        if (packet.endpoint != wire::address(wire::Endpoint::StateOut)) continue;
        wire::MicropacketReader reader(packet.bytes, wire::Direction::Out);
        while (const auto next = reader.next()) {
            if (!*next) break;
            if (const auto block = wire::decodeDrive((*next)->payload))
                blocks.push_back({packet.time, (*next)->robot, *block});
        }
    }
    return blocks;
}

/// How many kicks are among packets.
inline std::size_t kicksIn(const std::vector<kickstand::testing::TakenPacket>& packets) {
    std::size_t kicks = 0;
    for (const auto& packet : packets) {
        if (packet.endpoint != wire::address(wire::Endpoint::MessageOut)) continue;
        const auto message = wire::decodeMessagePacket(packet.bytes, wire::Direction::Out);
        if (message && message->pipe == wire::Pipe::Kick) ++kicks;
    }
    return kicks;
}

/// A running session with robots 0-3 on a radio at its true pace.
class SafetyTest : public ::testing::Test {
  protected:
    using Errc = kickstand::Errc;

    static kickstand::testing::SessionRigOptions options() {
        kickstand::testing::SessionRigOptions made;
        made.sim.robots = 0x000F;
        made.sim.noise = false;
        return made;
    }

    explicit SafetyTest(kickstand::testing::SessionRigOptions made = options()) : rig(std::move(made)) {}
    void SetUp() override { ASSERT_TRUE(rig.connect()); }

    /// Runs the wheels of a robot and waits until they turn.
    void drive(int robot, int speed = 100) {
        ASSERT_TRUE(rig.ask(SetWheels{maskOf(robot), {speed, speed, speed, speed}}));
        ASSERT_TRUE(rig.waitUntil([this, robot] { return turns(robot); })) << "robot " << robot;
    }
    /// Whether the simulated wheels of a robot are driven, rather than braked.
    bool driven(int robot) {
        const auto report = rig.robot(robot);
        return report.driveFresh && report.lastDrive.run;
    }
    bool turns(int robot) {
        const auto speeds = rig.robot(robot).wheelSpeeds;
        return driven(robot) && std::abs(speeds[0]) > 1;
    }
    /// Charges a robot until it says so.
    void charge(int robot) {
        ASSERT_TRUE(rig.arm(robot));
        ASSERT_TRUE(rig.ask(SetCharger{maskOf(robot), true}));
        ASSERT_TRUE(rig.waitUntil([this, robot] { return rig.robot(robot).capacitor_V > 200; },
                                  std::chrono::seconds(30)));
        rig.advance(std::chrono::seconds(1));
    }
    /// What the engine has been asked to do, once it has published it.
    const RobotIntent& intent(int robot) {
        rig.advance(std::chrono::milliseconds(15));
        state_ = rig.state();
        return state_.intents.at(static_cast<std::size_t>(robot));
    }
    StopReason latched() { return rig.flows().stop.reason(); }
    /// Robots that got a braked block since the packets were forgotten.
    RobotMask brakedRobots() {
        RobotMask robots = 0;
        for (const SentBlock& sent : blocksIn(rig.packets())) {
            if (sent.block == wire::brakedBlock()) robots |= maskOf(sent.robot);
        }
        return robots;
    }

    kickstand::testing::SessionRig rig;

  private:
    Snapshot state_;
};

}  // namespace kickstand::thunderbots::testing
