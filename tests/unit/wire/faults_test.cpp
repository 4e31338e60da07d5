#include "core/thunderbots/wire/faults.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace kickstand::thunderbots::wire {
namespace {

TEST(Faults, EveryRobotCodeIsExplainedOnceAndNoOtherIs) {
    std::set<std::string> texts;
    for (int code = 0; code < 256; ++code) {
        const Fault fault = robotFault(static_cast<std::uint8_t>(code));
        EXPECT_EQ(fault.code, code);
        EXPECT_EQ(fault.known, code < 48) << code;
        if (fault.known) {
            EXPECT_TRUE(texts.insert(describe(fault)).second) << describe(fault);
        }
    }
    EXPECT_EQ(texts.size(), 48U);
}

TEST(Faults, EveryDongleCodeIsExplainedOnceAndNoOtherIs) {
    std::set<std::string> texts;
    for (int code = 0; code < 256; ++code) {
        const Fault fault = dongleFault(static_cast<std::uint8_t>(code));
        EXPECT_EQ(fault.known, code < 112) << code;
        if (fault.known) {
            EXPECT_TRUE(texts.insert(describe(fault)).second) << describe(fault);
        }
    }
    EXPECT_EQ(texts.size(), 112U);
}

TEST(Faults, RobotCodesStandWhereTheReferenceHasThem) {
    EXPECT_EQ(describe(robotFault(0)), "Capacitor charge timed out");
    EXPECT_STREQ(robotFault(8).id, "oscillator-stopped");
    EXPECT_EQ(describe(robotFault(9)), "Motor 1: Hall sensors read 000");
    EXPECT_EQ(describe(robotFault(13)), "Motor 5: Hall sensors read 000");
    EXPECT_EQ(describe(robotFault(18)), "Motor 5: Hall sensors read 111");
    EXPECT_EQ(describe(robotFault(22)), "Motor 4: Hall sensors stuck while the encoder moves");
    EXPECT_EQ(describe(robotFault(23)), "Motor 1: Encoder stuck while the Hall sensors move");
    EXPECT_STREQ(robotFault(27).id, "dribbler-hot");
    EXPECT_EQ(describe(robotFault(31)), "Radio 1: Serial framing error");
    EXPECT_STREQ(robotFault(47).id, "parameters-corrupt");
}

TEST(Faults, DongleCodesStandWhereTheReferenceHasThem) {
    EXPECT_EQ(describe(dongleFault(0)), "Radio 0: Serial framing error");
    EXPECT_EQ(describe(dongleFault(35)), "Radio 1: Address could not be set");
    EXPECT_STREQ(dongleFault(40).id, "error-queue-overflow");
    EXPECT_EQ(describe(dongleFault(41)), "Robot 0: Message could not be sent");
    EXPECT_EQ(describe(dongleFault(56)), "Robot 15: Message could not be sent");
    EXPECT_EQ(dongleFault(104).index, 15);
    EXPECT_STREQ(dongleFault(104).id, "in-length");
    EXPECT_STREQ(dongleFault(111).id, "usb-stall");
}

TEST(Faults, SendFailedNamesItsRobot) {
    for (int code = 0; code < 256; ++code) {
        const auto robot = sendFailedRobot(static_cast<std::uint8_t>(code));
        const bool sendFailed = std::string(dongleFault(static_cast<std::uint8_t>(code)).id) == "send-failed";
        ASSERT_EQ(robot.has_value(), sendFailed) << code;
        if (robot) {
            EXPECT_EQ(*robot, dongleFault(static_cast<std::uint8_t>(code)).index);
        }
    }
}

TEST(Faults, UnknownCodesSaySo) {
    EXPECT_EQ(describe(robotFault(48)), "Unknown fault code 48");
    EXPECT_EQ(describe(dongleFault(255)), "Unknown fault code 255");
}

}  // namespace
}  // namespace kickstand::thunderbots::wire
