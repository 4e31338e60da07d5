#pragma once

#include <QStringList>

#include "ui/thunderbots/flash_wizard_state.h"

namespace kickstand::ui {

// The words of the firmware wizard that are not a page's own.

/// "Robots", "Files", …
QString flashStepText(FlashStep step);

/// What keeps a robot from being flashed, in a few words: "its wheels run". Empty for none.
QString obstacleText(FlashObstacle obstacle, const thunderbots::Snapshot& snapshot, int robot);
/// What a button that does away with it says: "Brake". Empty where no button does.
QString remedyText(FlashObstacle obstacle);
/// Why a page cannot be passed, and what to do, in one sentence.
QString holdText(const FlashHold& hold, const FlashWizardState& state, const thunderbots::Snapshot* snapshot);

/// What there is to know of a file: its format and part; what will be sent and what is left out; its
/// signatures.
QStringList fileFacts(const FlashFile& file);
/// Why it cannot be used, and what to do; empty where it can.
QString fileProblem(const FlashFile& file);
/// What follows from which files there are; empty where nothing does.
QString filesNotice(const FlashWizardState& state);

/// What a robot has, beside what it is to get: "0x1c2d → 0x77aa".
QString signatureText(const FlashWizardState& state, int robot);
/// "already there", "the microcontroller's is already there", or empty.
QString thereText(const FlashWizardState& state, int robot);
/// What will happen to a robot, in order, a line for each step.
QStringList orderOfThings(const std::vector<thunderbots::SharedFlashPlan>& plans);

/// How a robot's upload goes: what it does now, in a few words.
QString stageText(const FlashRunRobot& robot);
/// "84 of 340 KiB · 7.1 KiB/s · 40 s left · attempt 2".
QString figuresText(const FlashRunRobot& robot);
/// How it ended, and how the robot is left, in a plain sentence; after a failure what to do, too.
QString outcomeText(int robot, const FlashRunRobot& entry);
/// What is saved as the log of one robot's upload.
QString logText(int robot, const FlashRunRobot& entry);

}  // namespace kickstand::ui
