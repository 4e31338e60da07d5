#include <set>

#include <gtest/gtest.h>

#include "core/engine/describe_flash.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using thunderbots::EventKind;
using thunderbots::FlashLeft;
using thunderbots::FlashLog;
using thunderbots::FlashNote;
using thunderbots::FlashProgress;
using thunderbots::FlashStage;

FlashProgress progressAt(FlashStage stage) {
    FlashProgress progress;
    progress.stage = stage;
    progress.remaining = 83s;
    progress.endedAt = TimePoint(21s);
    return progress;
}

TEST(DescribeFlash, EveryStageAndEveryStateThatIsLeftHasWordsOfItsOwn) {
    std::set<QString> seen;
    for (int stage = 0; stage <= static_cast<int>(FlashStage::Cancelled); ++stage)
        EXPECT_TRUE(seen.insert(describe(static_cast<FlashStage>(stage))).second);
    for (int left = 0; left <= static_cast<int>(FlashLeft::Complete); ++left) {
        const QString text = describe(static_cast<FlashLeft>(left));
        EXPECT_TRUE(text.endsWith(u'.'));
        EXPECT_TRUE(seen.insert(text).second);
    }
    EXPECT_FALSE(seen.contains(QString()));
}

TEST(DescribeFlash, SaysHowFarItIs) {
    FlashProgress progress = progressAt(FlashStage::Writing);
    progress.done_B = 25;
    progress.total_B = 100;
    EXPECT_EQ(describeFlash(3, progress).line().toStdString(),
              "Robot 3, FPGA: writing, 25 %, about 1 min 23 s left.");
    progress.paused = true;
    EXPECT_EQ(describeFlash(3, progress).line().toStdString(),
              "Robot 3, FPGA: paused by STOP while writing. Re-arm and resume, or cancel it.");
}

TEST(DescribeFlash, SaysHowItEndedAndWhatIsLeft) {
    EXPECT_EQ(describeFlash(0, progressAt(FlashStage::Done)).line().toStdString(),
              "Robot 0 has its new firmware, verified and running, after 21 s.");
    FlashProgress cancelled = progressAt(FlashStage::Cancelled);
    EXPECT_EQ(describeFlash(0, cancelled).line().toStdString(),
              "The upload to robot 0 was cancelled. Nothing in it has changed.");
    FlashProgress failed = progressAt(FlashStage::Failed);
    failed.error = Error{.code = Errc::RobotNotAlive, .robot = 7};
    failed.left = FlashLeft::Activated;
    EXPECT_EQ(describeFlash(7, failed).line().toStdString(),
              "The upload to robot 7 failed: Robot 7 is not heard. What it has in its flash was verified; it "
              "takes effect at its next reboot. Switch it on, and check its number, its channels and its "
              "battery.");
}

TEST(DescribeFlash, EveryNoteHasALineOfItsOwn) {
    auto log = std::make_shared<FlashLog>();
    for (int note = 0; note <= static_cast<int>(FlashNote::Ended); ++note)
        log->push_back({TimePoint(1500ms), static_cast<FlashNote>(note), 0, 2});
    FlashProgress progress;
    progress.log = log;
    const QStringList lines = flashLogLines(progress);
    EXPECT_EQ(std::set<QString>(lines.begin(), lines.end()).size(), log->size());
    for (const QString& line : lines) {
        EXPECT_TRUE(line.startsWith(QStringLiteral("   1.500  "))) << line.toStdString();
        EXPECT_FALSE(line.contains(u'%')) << line.toStdString();
    }
}

TEST(DescribeFlash, TheLogBeginsWithTheParametersThatThereWere) {
    FlashProgress progress;
    progress.parametersBefore.emplace();
    progress.parametersBefore->robotNumber = 7;
    const QStringList lines = flashLogLines(progress);
    ASSERT_EQ(lines.size(), 1);
    EXPECT_EQ(lines[0], QStringLiteral("parameters before it began: ff 00 00 07 00"));
}

TEST(DescribeFlash, TellsItsEvents) {
    const auto textOf = [](EventKind kind, std::int64_t code, std::int64_t previous) {
        const auto text = describeFlashEvent({kind, {}, 3, code, previous, 20.2, {}});
        return text ? text->text.toStdString() : "";
    };
    EXPECT_EQ(textOf(EventKind::FlashStarted, 40, 1), "upload begun, pages to send: 40");
    EXPECT_EQ(textOf(EventKind::FlashEnded, 0, 0), "upload done after 21 s");
    EXPECT_EQ(textOf(EventKind::FlashEnded, static_cast<int>(Errc::RobotNotAlive), 0),
              "upload ended: The robot is not heard. Nothing in it has changed.");
    EXPECT_EQ(textOf(EventKind::KickGiven, 0, 0), "");
    EXPECT_TRUE(
        describe(EngineEvent{1, SystemEvent(thunderbots::Event{EventKind::FlashPaused, {}, 3, 0, 0, 0, {}})})
            .text.contains(QStringLiteral("paused")));
}

}  // namespace
}  // namespace kickstand
