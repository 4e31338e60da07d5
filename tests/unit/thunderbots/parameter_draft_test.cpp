#include "core/thunderbots/parameter_draft.h"

#include <gtest/gtest.h>

namespace kickstand::thunderbots {
namespace {

using Field = ParameterField;

wire::OperationalParameters robotBlock() {
    wire::OperationalParameters block;
    block.flashContents = 0;
    block.channel0 = 14;
    block.channel1 = 15;
    block.robotNumber = 3;
    block.dribblerDuty = 120;
    block.tail.append(std::uint8_t{0x5A});
    return block;
}

ParameterDraft draftOfRobot() {
    ParameterDraft draft;
    draft.setRobot(robotBlock());
    return draft;
}

TEST(ParameterDraft, KnowsNothingBeforeTheRobotIsRead) {
    ParameterDraft draft;
    EXPECT_FALSE(draft.value(Field::RobotNumber).has_value());
    EXPECT_EQ(draft.changes(), 0);
    EXPECT_FALSE(draft.blockWith(kAllParameters).has_value());
    draft.set(Field::RobotNumber, 5);
    EXPECT_EQ(draft.value(Field::RobotNumber), 5);
    EXPECT_EQ(draft.changes(), 0) << "nobody knows what it would change";
    draft.setRobot(robotBlock());
    EXPECT_EQ(draft.changes(), maskOf(Field::RobotNumber));
}

TEST(ParameterDraft, FollowsTheRobotButForWhatWasEdited) {
    ParameterDraft draft = draftOfRobot();
    draft.set(Field::DribblerDuty, 200);
    wire::OperationalParameters other = robotBlock();
    other.channel0 = 20;
    other.dribblerDuty = 10;
    draft.setRobot(other);
    EXPECT_EQ(draft.value(Field::Channel0), 20);
    EXPECT_EQ(draft.value(Field::DribblerDuty), 200);
    other.dribblerDuty = 200;
    draft.setRobot(other);
    EXPECT_EQ(draft.changes(), 0) << "it has been applied";
}

TEST(ParameterDraft, EveryStepCanBeUndoneAndDoneAgain) {
    ParameterDraft draft = draftOfRobot();
    draft.set(Field::DribblerDuty, 1);
    draft.set(Field::RobotNumber, 9);
    draft.take(ParameterValues{std::nullopt, std::uint8_t{11}, std::uint8_t{12}, std::nullopt, std::nullopt});
    draft.reset();
    EXPECT_EQ(draft.changes(), 0);
    draft.undo();
    EXPECT_EQ(draft.value(Field::Channel1), 12);
    draft.undo();
    EXPECT_EQ(draft.value(Field::Channel1), 15);
    EXPECT_EQ(draft.value(Field::RobotNumber), 9);
    draft.undo();
    draft.undo();
    EXPECT_FALSE(draft.canUndo());
    EXPECT_EQ(draft.changes(), 0);
    for (int i = 0; i < 3; ++i)
        draft.redo();
    EXPECT_EQ(draft.value(Field::Channel1), 12);
    draft.set(Field::DribblerDuty, 2);
    EXPECT_FALSE(draft.canRedo()) << "another way was taken";
    draft.redo();
    EXPECT_EQ(draft.value(Field::DribblerDuty), 2);
}

TEST(ParameterDraft, WhatChangesNothingIsNoStep) {
    ParameterDraft draft = draftOfRobot();
    draft.reset();
    draft.take({});
    EXPECT_FALSE(draft.canUndo());
    draft.set(Field::DribblerDuty, 5);
    draft.set(Field::DribblerDuty, 5);
    draft.undo();
    EXPECT_FALSE(draft.canUndo());
}

TEST(ParameterDraft, TypingAValueIsOneStep) {
    ParameterDraft draft = draftOfRobot();
    draft.set(Field::DribblerDuty, 2, true);
    draft.set(Field::DribblerDuty, 20, true);
    draft.set(Field::DribblerDuty, 200, true);
    draft.set(Field::RobotNumber, 1, true);
    draft.undo();
    EXPECT_EQ(draft.value(Field::DribblerDuty), 200);
    draft.undo();
    EXPECT_EQ(draft.value(Field::DribblerDuty), 120);
    EXPECT_FALSE(draft.canUndo());
}

TEST(ParameterDraft, AfterAnUndoTypingBeginsAStepOfItsOwn) {
    ParameterDraft draft = draftOfRobot();
    draft.set(Field::DribblerDuty, 2, true);
    draft.set(Field::RobotNumber, 1, true);
    draft.undo();
    draft.set(Field::DribblerDuty, 3, true);
    draft.undo();
    EXPECT_EQ(draft.value(Field::DribblerDuty), 2);
}

TEST(ParameterDraft, OnlyChosenFieldsAreAppliedAndTheTailStays) {
    ParameterDraft draft = draftOfRobot();
    draft.set(Field::DribblerDuty, 200);
    draft.set(Field::RobotNumber, 9);
    wire::OperationalParameters expected = robotBlock();
    expected.dribblerDuty = 200;
    EXPECT_EQ(draft.blockWith(maskOf(Field::DribblerDuty)), expected);
    expected.robotNumber = 9;
    EXPECT_EQ(draft.blockWith(kAllParameters), expected);
    EXPECT_EQ(draft.blockWith(0), robotBlock());
}

TEST(ParameterDraft, OnlyChosenFieldsAreTakenFromAFile) {
    ParameterDraft draft = draftOfRobot();
    ParameterValues file = valuesOf(robotBlock());
    file[static_cast<std::size_t>(Field::RobotNumber)] = 9;
    file[static_cast<std::size_t>(Field::DribblerDuty)] = 9;
    draft.take(file, static_cast<ParameterMask>(kAllParameters & ~maskOf(Field::RobotNumber)));
    EXPECT_EQ(draft.changes(), maskOf(Field::DribblerDuty));
}

TEST(ParameterDraft, RemembersABoundedNumberOfSteps) {
    ParameterDraft draft = draftOfRobot();
    for (std::size_t i = 0; i < ParameterDraft::kMostSteps + 10; ++i)
        draft.set(Field::DribblerDuty, static_cast<std::uint8_t>(i % 2));
    std::size_t steps = 0;
    for (; draft.canUndo(); ++steps)
        draft.undo();
    EXPECT_EQ(steps, ParameterDraft::kMostSteps);
}

}  // namespace
}  // namespace kickstand::thunderbots
