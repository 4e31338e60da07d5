#include "core/thunderbots/parameter_keeper.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

using Standing = ParameterStanding;

wire::OperationalParameters blockOf(std::uint8_t number, std::uint8_t duty) {
    wire::OperationalParameters block;
    block.channel0 = 14;
    block.channel1 = 15;
    block.robotNumber = number;
    block.dribblerDuty = duty;
    return block;
}

class KeeperTest : public ::testing::Test {
  protected:
    void read(int robot, const wire::OperationalParameters& block) {
        keeper.read(robot, block, TimePoint(std::chrono::seconds(1)));
    }
    void apply(int robot, const wire::OperationalParameters& block) {
        read(robot, block);
        keeper.applied(robot);
    }
    void reboot(int robot, RobotMask others = 0) {
        keeper.willReboot(robot);
        keeper.lost(robot, others);
    }
    Standing standing(int robot = 3) const { return keeper.state(robot).standing; }

    ParameterKeeper keeper;
};

TEST_F(KeeperTest, ACommitIsProvenByAReadingAfterARebootAndByNothingElse) {
    read(3, blockOf(3, 1));
    EXPECT_EQ(standing(), Standing::AsRead);
    apply(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Applied);
    keeper.committed(3);
    EXPECT_EQ(standing(), Standing::Committed);
    read(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Committed) << "that was the volatile copy";
    reboot(3);
    EXPECT_EQ(standing(), Standing::Rebooted);
    EXPECT_TRUE(keeper.proofDue(3));
    read(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Proven);
    read(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Proven);
}

TEST_F(KeeperTest, WhatWasNotKeptIsSaid) {
    apply(3, blockOf(3, 2));
    keeper.committed(3);
    reboot(3);
    read(3, blockOf(3, 1));
    EXPECT_EQ(standing(), Standing::Disproven);
    read(3, blockOf(3, 1));
    EXPECT_EQ(standing(), Standing::AsRead);
}

TEST_F(KeeperTest, WhatWasOnlyAppliedIsGoneAfterAReboot) {
    apply(3, blockOf(3, 2));
    reboot(3);
    EXPECT_EQ(standing(), Standing::Unread);
    read(3, blockOf(3, 1));
    EXPECT_EQ(standing(), Standing::AsRead);
}

TEST_F(KeeperTest, ARobotThatIsLostWithoutBeingToldToRebootProvesNothing) {
    apply(3, blockOf(3, 2));
    keeper.committed(3);
    keeper.lost(3, 0);
    read(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Committed);
}

TEST_F(KeeperTest, WhatSomebodyElseHasChangedIsAsRead) {
    apply(3, blockOf(3, 2));
    read(3, blockOf(3, 9));
    EXPECT_EQ(standing(), Standing::AsRead);
}

TEST_F(KeeperTest, ARobotThatChangesItsNumberIsProvenUnderItsNewOne) {
    apply(3, blockOf(7, 2));
    keeper.committed(3);
    reboot(3);
    EXPECT_EQ(standing(3), Standing::Unread);
    EXPECT_EQ(keeper.state(3).movedTo, 7);
    EXPECT_TRUE(keeper.proofDue(7));
    read(7, blockOf(7, 2));
    EXPECT_EQ(standing(7), Standing::Proven);
    read(3, blockOf(3, 1));
    EXPECT_EQ(keeper.state(3).movedTo, -1) << "another robot has the number now";
}

TEST_F(KeeperTest, ARebootThatTheDongleMissedCountsAllTheSame) {
    apply(3, blockOf(3, 2));
    keeper.committed(3);
    keeper.rebootedUnseen(3);
    EXPECT_EQ(standing(), Standing::Committed) << "nobody told it to reboot";
    keeper.willReboot(3);
    keeper.rebootedUnseen(3);
    EXPECT_TRUE(keeper.proofDue(3));
    read(3, blockOf(3, 2));
    EXPECT_EQ(standing(), Standing::Proven);
    keeper.lost(3, 0);
    EXPECT_EQ(standing(), Standing::Proven) << "that was no further reboot";
}

TEST_F(KeeperTest, ARobotThatTakesAnotherNumberIsMissedUnderItsOwn) {
    apply(3, blockOf(7, 2));
    keeper.committed(3);
    keeper.willReboot(3);
    keeper.rebootedUnseen(3);
    EXPECT_EQ(standing(), Standing::Committed);
    keeper.lost(3, 0);
    EXPECT_TRUE(keeper.proofDue(7));
}

TEST_F(KeeperTest, ANumberThatAnotherRobotHasProvesNothingOfThisOne) {
    read(7, blockOf(7, 5));
    apply(3, blockOf(7, 2));
    keeper.committed(3);
    reboot(3, maskOf(7));
    EXPECT_EQ(standing(7), Standing::AsRead);
    EXPECT_EQ(standing(3), Standing::Rebooted);
}

TEST_F(KeeperTest, AnErasedFlashLeavesNothingKnown) {
    apply(3, blockOf(3, 2));
    keeper.committed(3);
    keeper.erased(3);
    EXPECT_EQ(standing(), Standing::Unread);
    EXPECT_FALSE(keeper.state(3).robot.has_value());
    reboot(3);
    EXPECT_FALSE(keeper.proofDue(3));
}

TEST_F(KeeperTest, SignaturesAreForgottenWithAReboot) {
    keeper.signaturesRead(3, {1, 2}, {});
    EXPECT_EQ(keeper.state(3).signatures->flashCrc, 2);
    reboot(3);
    EXPECT_FALSE(keeper.state(3).signatures.has_value());
}

TEST_F(KeeperTest, EveryChangeRaisesTheVersion) {
    std::uint64_t before = keeper.version();
    const auto rises = [&] { return keeper.version() > std::exchange(before, keeper.version()); };
    read(3, blockOf(3, 1));
    EXPECT_TRUE(rises());
    keeper.applied(3);
    EXPECT_TRUE(rises());
    keeper.committed(3);
    EXPECT_TRUE(rises());
    reboot(3);
    EXPECT_TRUE(rises());
    keeper.lost(3, 0);
    EXPECT_FALSE(rises());
}

}  // namespace
}  // namespace kickstand::thunderbots
