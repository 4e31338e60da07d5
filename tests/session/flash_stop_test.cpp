// STOP and Cancel at the moments of an upload at which something is on its way that cannot be taken back.

#include "tests/session/flash_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using kickstand::testing::MessageFate;
using kickstand::testing::PassingMessage;
using wire::Direction;
using wire::FirmwareOp;

class FlashStop : public FlashTest {};

TEST_F(FlashStop, SendsNoSecondRebootAfterStop) {
    // The first is lost, and STOP comes while the robot is waited for.
    int reboots = 0;
    judge = [this, &reboots](const PassingMessage& message) {
        MessageFate fate;
        const bool reboot = message.direction == Direction::Out &&
                            message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::Reboot);
        if (reboot) {
            ++reboots;
            fate.copies = 0;
            rig.scheduler().post([this] { rig.stop(); });
        }
        return fate;
    };
    const auto plan = densePlan(3, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.flows().stop.isSet(); }, 60s));
    rig.advance(60s);
    EXPECT_EQ(reboots, 1);
    EXPECT_TRUE(progress(0).paused);
    judge = nullptr;
    rig.rearm();
    ASSERT_TRUE(rig.ask(ResumeFlash{maskOf(0)}));
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
}

TEST_F(FlashStop, ACancelWaitsUntilBothCopiesNameTheImage) {
    int sets = 0;
    judge = [this, &sets](const PassingMessage& message) {
        const bool set = message.direction == Direction::Out &&
                         message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::SetParameters);
        // The first says that there is no data.
        if (set && ++sets == 2) rig.scheduler().post([this] { rig.give(CancelFlash{maskOf(0)}); });
        return MessageFate{};
    };
    ASSERT_TRUE(start(maskOf(0), {densePlan(3, kFpga)}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Cancelled);
    EXPECT_EQ(end.left, FlashLeft::Activated);
    EXPECT_EQ(contents(0), static_cast<std::uint8_t>(wire::FlashContents::FpgaBitstream));
    EXPECT_EQ(countOf(0, FirmwareOp::Reboot), 0U);
}

TEST_F(FlashStop, ACancelWaitsLessThanASecondForARobotThatDoesNotAnswer) {
    int sets = 0;
    TimePoint cancelledAt{};
    judge = [&](const PassingMessage& message) {
        MessageFate fate;
        const bool set = message.direction == Direction::Out &&
                         message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::SetParameters);
        if (set && ++sets == 2) {
            cancelledAt = rig.scheduler().now();
            rig.scheduler().post([this] { rig.give(CancelFlash{maskOf(0)}); });
        }
        if (sets >= 2) fate.copies = 0;
        return fate;
    };
    ASSERT_TRUE(start(maskOf(0), {densePlan(3, kFpga)}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Cancelled);
    EXPECT_EQ(end.left, FlashLeft::NoData);
    EXPECT_LE(end.endedAt - cancelledAt, 1s);
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
