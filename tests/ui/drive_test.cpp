// Every control of the Drive panel's wheels, to the bytes on the wire.

#include <QCheckBox>
#include <QLabel>
#include <QMenu>
#include <QTest>
#include <algorithm>

#include "tests/ui/bench_rig.h"
#include "ui/widgets/center_slider.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;

class DriveTest : public BenchTest {
  protected:
    ui::SetPointSlider* wheel(int number) {
        return rig.find<ui::SetPointSlider>(QStringLiteral("wheel%1").arg(number));
    }

    /// Pulls a slider from where it is by so many pixels, without letting go.
    void pull(ui::CenterSlider* slider, int pixels) {
        const QPoint from(static_cast<int>(slider->positionOf(slider->value())), slider->height() / 2);
        QTest::mousePress(slider, Qt::LeftButton, {}, from);
        QTest::mouseMove(slider, from + QPoint(pixels, 0));
        pulledTo_ = from + QPoint(pixels, 0);
    }
    void letGo(ui::CenterSlider* slider) { QTest::mouseRelease(slider, Qt::LeftButton, {}, pulledTo_); }

  private:
    QPoint pulledTo_;
};

bool allZero(const DriveBlock& block) {
    return std::all_of(block.wheels.begin(), block.wheels.end(), [](int speed) { return speed == 0; });
}

TEST_F(DriveTest, ANumberTypedForEachWheelReachesThatWheelOfThatRobotAlone) {
    rig.clickRobot(3);
    for (int number = 1; number <= 4; ++number) {
        rig.typeWheel(number, QString::number(10 * number));
        ASSERT_TRUE(rig.waitForBlock(3, [number](const DriveBlock& block) {
            return block.run && block.wheels[static_cast<std::size_t>(number - 1)] == 10 * number;
        }));
    }
    EXPECT_EQ(rig.wire().last(3)->wheels, (std::array<std::int16_t, 4>{10, 20, 30, 40}));
    EXPECT_FALSE(rig.wire().last(2).has_value());
    EXPECT_FALSE(rig.wire().last(4).has_value());
}

TEST_F(DriveTest, NegativeNumbersAreSentAndShownWithTheirSign) {
    rig.clickRobot(1);
    rig.typeWheel(2, QStringLiteral("-36"));
    ASSERT_TRUE(rig.waitForBlock(1, [](const DriveBlock& block) { return block.wheels[1] == -36; }));
    EXPECT_EQ(wheel(2)->field()->text(), QStringLiteral("\u221236"));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(rig.find<QLabel>(QStringLiteral("told"))->text().contains(QStringLiteral("\u221236")));
}

TEST_F(DriveTest, TheEngineRampsWhatIsTyped) {
    rig.clickRobot(0);
    rig.typeWheel(1, QStringLiteral("100"));
    ASSERT_TRUE(rig.waitForBlock(0, [](const DriveBlock& block) { return block.wheels[0] == 100; }));
    const auto blocks = rig.wire().blocks(0);
    EXPECT_TRUE(std::any_of(blocks.begin(), blocks.end(), [](const DriveBlock& block) {
        return block.wheels[0] > 0 && block.wheels[0] < 100;
    }));
}

TEST_F(DriveTest, AWheelsSpeedIsToldInTheUnitThatAPersonChooses) {
    rig.clickRobot(3);
    rig.typeWheel(1, QStringLiteral("42"));
    const auto told = [this] { return wheel(1)->meaning(); };
    ASSERT_TRUE(waitUntil([&] { return told() == QStringLiteral("350 rpm"); })) << told().toStdString();
    auto* units = rig.find<QMenu>(QStringLiteral("units_wheelSpeed"));
    units->actions().at(1)->trigger();
    EXPECT_EQ(told(), QStringLiteral("5.8 turns/s"));
    units->actions().at(2)->trigger();
    EXPECT_EQ(told(), QStringLiteral("36.7 rad/s"));
    EXPECT_EQ(rig.bench().unitOf(QStringLiteral("wheelSpeed")), 2) << "remembered";
}

TEST_F(DriveTest, EverySliderDrivesItsWheelAndSpringsBackToZero) {
    rig.clickRobot(2);
    for (int number = 1; number <= 4; ++number) {
        ui::CenterSlider* slider = wheel(number)->slider();
        const auto index = static_cast<std::size_t>(number - 1);
        pull(slider, 30);
        const int pulled = slider->value();
        ASSERT_GT(pulled, 0);
        ASSERT_TRUE(
            rig.waitForBlock(2, [=](const DriveBlock& block) { return block.wheels[index] == pulled; }));
        letGo(slider);
        EXPECT_EQ(slider->value(), 0);
        ASSERT_TRUE(rig.waitForBlock(2, [](const DriveBlock& block) { return allZero(block); }));
    }
}

TEST_F(DriveTest, WithoutReleaseToZeroASliderStaysAndKeepsDriving) {
    rig.clickRobot(2);
    rig.find<QCheckBox>(QStringLiteral("releaseToZero"))->click();
    ui::CenterSlider* slider = wheel(1)->slider();
    pull(slider, -25);
    const int pulled = slider->value();
    letGo(slider);
    ASSERT_LT(pulled, 0);
    ASSERT_TRUE(rig.waitForBlock(2, [pulled](const DriveBlock& block) { return block.wheels[0] == pulled; }));
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(slider->value(), pulled);
    EXPECT_EQ(rig.wire().last(2)->wheels[0], pulled);
}

TEST_F(DriveTest, PressingASliderSetsNothingInMotion) {
    rig.clickRobot(2);
    ui::CenterSlider* slider = wheel(1)->slider();
    QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() - 10, slider->height() / 2));
    ASSERT_TRUE(rig.settle());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() - 10, slider->height() / 2));
    ASSERT_TRUE(rig.settle());
    for (const DriveBlock& block : rig.wire().blocks(2))
        EXPECT_TRUE(allZero(block));
}

TEST_F(DriveTest, DoubleClickOnASliderGoesToZero) {
    rig.clickRobot(2);
    rig.typeWheel(4, QStringLiteral("25"));
    ASSERT_TRUE(rig.waitForBlock(2, [](const DriveBlock& block) { return block.wheels[3] == 25; }));
    QTest::mouseDClick(wheel(4)->slider(), Qt::LeftButton);
    ASSERT_TRUE(rig.waitForBlock(2, [](const DriveBlock& block) { return allZero(block); }));
    EXPECT_EQ(wheel(4)->value(), 0);
}

TEST_F(DriveTest, ArrowKeysOnASliderChangeTheSetPointByOne) {
    rig.clickRobot(2);
    wheel(1)->slider()->setFocus();
    rig.press(Qt::Key_Right);
    rig.press(Qt::Key_Right);
    ASSERT_TRUE(rig.waitForBlock(2, [](const DriveBlock& block) { return block.wheels[0] == 2; }));
    rig.press(Qt::Key_Left);
    ASSERT_TRUE(rig.waitForBlock(2, [](const DriveBlock& block) { return block.wheels[0] == 1; }));
}

TEST_F(DriveTest, ZeroByButtonAndByKeyStopsAllWheels) {
    rig.clickRobot(5);
    rig.typeWheel(1, QStringLiteral("20"));
    rig.typeWheel(3, QStringLiteral("-20"));
    ASSERT_TRUE(rig.waitForBlock(5, [](const DriveBlock& block) { return block.wheels[2] == -20; }));
    rig.click(QStringLiteral("zero"));
    ASSERT_TRUE(rig.waitForBlock(5, [](const DriveBlock& block) { return block.run && allZero(block); }));
    rig.typeWheel(1, QStringLiteral("20"));
    ASSERT_TRUE(rig.waitForBlock(5, [](const DriveBlock& block) { return block.wheels[0] == 20; }));
    // Also while a number field has the focus: a letter is no number.
    rig.press(Qt::Key_Z);
    ASSERT_TRUE(rig.waitForBlock(5, [](const DriveBlock& block) { return block.run && allZero(block); }));
}

TEST_F(DriveTest, RunAndBrakeReachTheWireAndTheSegmentFollows) {
    rig.clickRobot(4);
    rig.click(QStringLiteral("run"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return block.run && allZero(block); }));
    rig.typeWheel(1, QStringLiteral("30"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return block.wheels[0] == 30; }));
    rig.click(QStringLiteral("brake"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(rig.find<QAbstractButton>(QStringLiteral("brake"))->isChecked());
    EXPECT_FALSE(rig.find<QAbstractButton>(QStringLiteral("run"))->isChecked());
    EXPECT_EQ(wheel(1)->value(), 0);
}

TEST_F(DriveTest, BrakeLeavesTheDribblerAsItIs) {
    rig.clickRobot(4);
    rig.click(QStringLiteral("dribbler"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return block.dribble; }));
    rig.typeWheel(2, QStringLiteral("15"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return block.wheels[1] == 15; }));
    rig.click(QStringLiteral("brake"));
    ASSERT_TRUE(rig.waitForBlock(4, [](const DriveBlock& block) { return !block.run; }));
    EXPECT_TRUE(rig.wire().last(4)->dribble);
}

TEST_F(DriveTest, TheDribblerIsSwitchedOnAndOff) {
    rig.clickRobot(1);
    rig.click(QStringLiteral("dribbler"));
    ASSERT_TRUE(rig.waitForBlock(1, [](const DriveBlock& block) { return block.dribble; }));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(rig.find<QAbstractButton>(QStringLiteral("dribbler"))->isChecked());
    rig.click(QStringLiteral("dribbler"));
    ASSERT_TRUE(rig.waitForBlock(1, [](const DriveBlock& block) { return !block.dribble; }));
}

TEST_F(DriveTest, AllThatAreChosenAreDrivenAndNoOther) {
    rig.clickRobot(0);
    rig.clickRobot(2, Qt::ControlModifier);
    rig.clickRobot(5, Qt::ControlModifier);
    rig.typeWheel(3, QStringLiteral("12"));
    for (const int robot : {0, 2, 5}) {
        ASSERT_TRUE(rig.waitForBlock(robot, [](const DriveBlock& block) { return block.wheels[2] == 12; }))
            << robot;
    }
    for (const int robot : {1, 3, 4})
        EXPECT_FALSE(rig.wire().last(robot).has_value()) << robot;
}

TEST_F(DriveTest, WheelsThatDifferBetweenRobotsAreLeftAsTheyAre) {
    rig.clickRobot(0);
    rig.typeWheel(1, QStringLiteral("10"));
    rig.clickRobot(1);
    rig.typeWheel(1, QStringLiteral("20"));
    ASSERT_TRUE(rig.waitForBlock(1, [](const DriveBlock& block) { return block.wheels[0] == 20; }));
    ASSERT_TRUE(rig.settle());
    rig.clickRobot(0, Qt::ControlModifier);
    ASSERT_TRUE(rig.settle());
    rig.typeWheel(2, QStringLiteral("-5"));
    ASSERT_TRUE(
        rig.waitForBlock(0, [](const DriveBlock& b) { return b.wheels[0] == 10 && b.wheels[1] == -5; }));
    ASSERT_TRUE(
        rig.waitForBlock(1, [](const DriveBlock& b) { return b.wheels[0] == 20 && b.wheels[1] == -5; }));
}

TEST_F(DriveTest, ChoosingAnotherRobotLeavesTheFirstAsItWasAndShowsTheSecond) {
    rig.clickRobot(0);
    rig.typeWheel(1, QStringLiteral("10"));
    ASSERT_TRUE(rig.waitForBlock(0, [](const DriveBlock& block) { return block.wheels[0] == 10; }));
    rig.clickRobot(1);
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(wheel(1)->value(), 0);
    EXPECT_EQ(rig.wire().last(0)->wheels[0], 10);
    EXPECT_FALSE(rig.wire().last(1).has_value());
    rig.clickRobot(0);
    ASSERT_TRUE(waitUntil([this] { return wheel(1)->value() == 10; }));
}

TEST_F(DriveTest, PastTheLimitNothingCanBeAskedForUntilItIsRaisedAndLowered) {
    rig.clickRobot(3);
    rig.typeWheel(1, QStringLiteral("250"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 100; }));
    rig.click(QStringLiteral("changeLimit"));
    rig.find<ui::SignedSpinBox>(QStringLiteral("wantedLimit"))->setValue(400);
    rig.click(QStringLiteral("raiseLimit"));
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& snapshot) { return snapshot.wheelLimit == 400; }));
    ASSERT_TRUE(waitUntil([this] { return wheel(1)->limit() == 400; }));
    rig.typeWheel(1, QStringLiteral("250"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 250; }));
    rig.click(QStringLiteral("changeLimit"));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 100; }));
    ASSERT_TRUE(waitUntil([this] { return wheel(1)->limit() == 100; }));
}

TEST_F(DriveTest, KeepingTheLimitChangesNothing) {
    rig.clickRobot(3);
    rig.click(QStringLiteral("changeLimit"));
    rig.click(QStringLiteral("keepLimit"));
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(rig.snapshot()->wheelLimit, kStartingWheelLimit);
}

TEST_F(DriveTest, ANumberThatIsNotConfirmedIsNotSent) {
    rig.clickRobot(3);
    auto* field = wheel(1)->field();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("55"));
    wheel(2)->field()->setFocus();
    ASSERT_TRUE(rig.settle());
    EXPECT_EQ(field->text(), QStringLiteral("0"));
    EXPECT_FALSE(rig.wire().last(3).has_value());
}

TEST_F(DriveTest, NothingIsDrivenWhileNoneIsChosen) {
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(wheel(1)->isEnabled());
    EXPECT_FALSE(rig.find<QAbstractButton>(QStringLiteral("dribbler"))->isEnabled());
    EXPECT_TRUE(
        rig.find<QLabel>(QStringLiteral("notice"))->text().contains(QStringLiteral("Choose a robot")));
}

TEST_F(DriveTest, ARobotThatIsNotHeardCannotBeDrivenAndThePanelSaysSo) {
    rig.clickRobot(9);
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(wheel(1)->isEnabled());
    EXPECT_TRUE(rig.find<QLabel>(QStringLiteral("notice"))->text().contains(QStringLiteral("Not heard")));
}

}  // namespace
}  // namespace kickstand::test
