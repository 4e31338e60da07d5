#pragma once

#include <algorithm>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/framing/crc16.h"
#include "core/thunderbots/flash_plan.h"
#include "core/thunderbots/wire/firmware.h"
#include "core/thunderbots/wire/message_packet.h"
#include "tests/support/session/message_faults.h"
#include "tests/support/session/session_rig.h"

namespace kickstand::thunderbots::testing {

/// An image of these bytes.
inline image::FlashImage imageOf(std::vector<std::uint8_t> bytes, image::FlashTarget target) {
    image::FlashImage image;
    image.target = target;
    image.data = {{0, static_cast<std::uint32_t>(bytes.size()), 0}};
    image.bytes = std::move(bytes);
    return image;
}

/// A plan of an image of so many pages of dense data, another one for every seed.
inline SharedFlashPlan densePlan(std::size_t pages, image::FlashTarget target, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<std::uint8_t> bytes(pages * wire::kFlashPageBytes);
    std::ranges::generate(bytes, [&random] { return static_cast<std::uint8_t>(random()); });
    return std::make_shared<const FlashPlan>(imageOf(std::move(bytes), target));
}

/// A running session with robots 0-3 on an ideal radio, with room for faults on the firmware pipes.
class FlashTest : public ::testing::Test {
  protected:
    using Errc = kickstand::Errc;
    using Judge = kickstand::testing::MessageFaults::Judge;

    /// Of the whole test; unless it says otherwise nothing goes wrong.
    std::function<kickstand::testing::MessageFate(const kickstand::testing::PassingMessage&)> judge;

    kickstand::testing::SessionRigOptions options() {
        kickstand::testing::SessionRigOptions made;
        made.sim.robots = 0x000F;
        made.sim.noise = false;
        made.sim.pace = sim::RadioPace::Ideal;
        made.decorate = [this](std::unique_ptr<UsbLink> link, Scheduler& scheduler) {
            return std::make_unique<kickstand::testing::MessageFaults>(
                std::move(link), scheduler, [this](const kickstand::testing::PassingMessage& message) {
                    return judge ? judge(message) : kickstand::testing::MessageFate{};
                });
        };
        return made;
    }

    FlashTest() : rig(options()) {}
    void SetUp() override { ASSERT_TRUE(rig.connect()); }

    Result<void> start(RobotMask robots, std::vector<SharedFlashPlan> plans, FlashOptions options = {}) {
        return rig.ask(StartFlash{robots, std::move(plans), options});
    }
    FlashProgress progress(int robot) {
        rig.advance(std::chrono::milliseconds(15));
        return rig.state().flash.at(static_cast<std::size_t>(robot)).value_or(FlashProgress{});
    }
    bool waitForStage(int robot, FlashStage stage) {
        // Looked at now and then: a snapshot is too large to be looked at after every call.
        for (int i = 0; i < 20000; ++i) {
            const auto now = rig.state().flash.at(static_cast<std::size_t>(robot));
            if (now && now->stage == stage) return true;
            if (now && !now->running()) return false;
            rig.advance(std::chrono::milliseconds(10));
        }
        return false;
    }
    /// How it ended.
    FlashProgress waitForEnd(int robot) {
        for (int i = 0; i < 6000; ++i) {
            const auto now = rig.state().flash.at(static_cast<std::size_t>(robot));
            if (now && !now->running()) return *now;
            rig.advance(std::chrono::milliseconds(50));
        }
        ADD_FAILURE() << "robot " << robot << "'s upload does not end";
        return {};
    }
    /// Whether a robot's flash holds the image and nothing else.
    bool holds(int robot, const FlashPlan& plan) {
        std::vector<std::uint8_t> flash(wire::kFlashBytes);
        return rig.sim().readFlash(robot, 0, flash) && crc16(flash) == plan.signatures().flash &&
               std::equal(plan.image().bytes.begin(), plan.image().bytes.end(), flash.begin());
    }
    std::uint8_t contents(int robot) { return rig.robot(robot).committed.flashContents; }
    /// The firmware requests that the link took for a robot, in order.
    std::vector<wire::FirmwareRequest> requestsTo(int robot) {
        std::vector<wire::FirmwareRequest> requests;
        for (const auto& packet : rig.packets()) {
            if (packet.endpoint != wire::address(wire::Endpoint::MessageOut)) continue;
            const auto message = wire::decodeMessagePacket(packet.bytes, wire::Direction::Out);
            if (!message || message->robot != robot || message->pipe != wire::Pipe::FirmwareRequest) continue;
            if (const auto request = wire::decodeFirmwareRequest(message->payload))
                requests.push_back(*request);
        }
        return requests;
    }
    std::size_t countOf(int robot, wire::FirmwareOp op) {
        return static_cast<std::size_t>(std::ranges::count(
            requestsTo(robot), op, [](const auto& request) { return wire::opOf(request); }));
    }
    std::size_t countNotes(const FlashProgress& progress, FlashNote note) {
        return static_cast<std::size_t>(std::ranges::count(*progress.log, note, &FlashLogLine::note));
    }

    kickstand::testing::SessionRig rig;
};

inline constexpr auto kFpga = image::FlashTarget::Fpga;
inline constexpr auto kMicrocontroller = image::FlashTarget::Microcontroller;
inline constexpr auto kNoDataByte = static_cast<std::uint8_t>(wire::FlashContents::NoData);

}  // namespace kickstand::thunderbots::testing
