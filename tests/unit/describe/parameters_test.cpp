#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe_parameters.h"

namespace kickstand {
namespace {

using thunderbots::ParameterField;
using thunderbots::ParameterRisk;
using thunderbots::ParameterStanding;

TEST(DescribeParameters, EveryStandingHasWordsOfItsOwn) {
    std::set<QString> seen;
    for (int standing = 0; standing <= static_cast<int>(ParameterStanding::Disproven); ++standing) {
        thunderbots::ParameterState state;
        state.standing = static_cast<ParameterStanding>(standing);
        EXPECT_TRUE(describe(state).endsWith(u'.'));
        EXPECT_TRUE(seen.insert(describe(state)).second) << describe(state).toStdString();
    }
    thunderbots::ParameterState moved;
    moved.movedTo = 7;
    EXPECT_EQ(describe(moved).toStdString(), "Rebooted, to come back as robot 7.");
}

TEST(DescribeParameters, EveryWarningSaysWhenAndWhatAtEachStep) {
    std::set<QString> seen;
    for (int risk = 0; risk <= static_cast<int>(ParameterRisk::OtherBitstream); ++risk) {
        for (const ParameterStep step :
             {ParameterStep::Apply, ParameterStep::Commit, ParameterStep::Reboot}) {
            const QString text = describe({static_cast<ParameterRisk>(risk), 3, 7, 11, 26}, step);
            EXPECT_TRUE(text.endsWith(u'.')) << text.toStdString();
            EXPECT_FALSE(text.contains(u'%')) << text.toStdString();
            EXPECT_TRUE(seen.insert(text).second) << text.toStdString();
        }
    }
    EXPECT_EQ(describe({ParameterRisk::NumberChanges, 3, 7, 11, 26}, ParameterStep::Apply).toStdString(),
              "Once this is committed and the robot has rebooted, robot 3 answers as robot 7.");
}

TEST(DescribeParameters, ValuesAreShownWithTheirMeaning) {
    EXPECT_EQ(describeValue(ParameterField::Channel0, 14).toStdString(), "0x0e (14)");
    EXPECT_EQ(describeValue(ParameterField::Channel1, 0).toStdString(), "not configured");
    EXPECT_EQ(describeValue(ParameterField::DribblerDuty, 120).toStdString(), "120 (47 %)");
    EXPECT_EQ(describeValue(ParameterField::FlashContents, 0).toStdString(), "FPGA bitstream");
    EXPECT_EQ(describeValue(ParameterField::FlashContents, 9).toStdString(), "no data");
    EXPECT_EQ(describeValue(ParameterField::RobotNumber, 12).toStdString(), "12");
}

}  // namespace
}  // namespace kickstand
