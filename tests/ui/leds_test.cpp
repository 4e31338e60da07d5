// Test modes: every control to the bytes on the wire, and what the robots were told back into words.

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/leds_lights.h"
#include "ui/thunderbots/leds_words.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::TestClass;
using wire::TestMode;

using Told = std::array<int, 3>;

class LedsTest : public BenchTest {
  protected:
    QComboBox* classes() { return rig.find<QComboBox>(QStringLiteral("ledClass")); }
    QComboBox* targets() { return rig.find<QComboBox>(QStringLiteral("ledTarget")); }
    /// As a person chooses from a list: by its keys.
    static void choose(QComboBox* list, int index) {
        list->setFocus();
        while (list->currentIndex() != index)
            QTest::keyClick(list, list->currentIndex() < index ? Qt::Key_Down : Qt::Key_Up);
    }
    bool waitForMessages(const std::vector<Told>& expected) {
        return waitUntil([this, &expected] { return rig.wire().testModes() == expected; });
    }
    QString told() { return rig.find<QLabel>(QStringLiteral("ledTold"))->text(); }
    bool waitForTold(const QString& text) {
        return waitUntil([this, &text] { return told().contains(text); });
    }
};

TEST_F(LedsTest, AClassIsSentAsAMessageToEveryChosenRobot) {
    rig.clickRobot(1);
    rig.clickRobot(4, Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    choose(classes(), 1);
    ASSERT_TRUE(waitForMessages({Told{1, 1, 0}, Told{4, 1, 0}}));
    EXPECT_TRUE(waitForTold(QStringLiteral("By message, shown now: All four on")));
}

TEST_F(LedsTest, OnlyTargetsThatExistAreOfferedAndTheyAreNamedAsOnTheRobot) {
    rig.clickRobot(2);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    EXPECT_TRUE(targets()->isHidden());
    for (int index = 0; index < classes()->count(); ++index) {
        choose(classes(), index);
        const auto range = wire::targetsOf(static_cast<TestClass>(classes()->currentData().toInt()));
        EXPECT_EQ(targets()->count(), range.any() ? range.last - range.first + 1 : 0) << index;
        EXPECT_EQ(targets()->isVisible(), range.any()) << index;
        if (classes()->currentData().toInt() != static_cast<int>(TestClass::Hall)) continue;
        EXPECT_EQ(targets()->itemText(1), QStringLiteral("Motor 2, back left"));
        EXPECT_EQ(targets()->itemText(4), QStringLiteral("Motor 5, dribbler"));
    }
}

TEST_F(LedsTest, TheEncoderLinesOfWheelTwo) {
    rig.clickRobot(3);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    choose(classes(), classes()->findData(static_cast<int>(TestClass::Encoder)));
    choose(targets(), 1);
    ASSERT_TRUE(waitUntil([this] {
        const auto sent = rig.wire().testModes();
        return !sent.empty() && sent.back() == Told{3, 3, 2};
    }));
    EXPECT_TRUE(waitForTold(QStringLiteral("Encoder lines: wheel 2, back left, for")));
    auto* lights = rig.find<ui::LedLights>(QStringLiteral("lights"));
    EXPECT_TRUE(lights->accessibleName().contains(QStringLiteral("LED 1: Encoder line B; LED 2: not used")));
}

TEST_F(LedsTest, TheDriveBlockCarriesItWhereAskedToAndIsToldApart) {
    rig.clickRobot(3);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    choose(classes(), 1);
    ASSERT_TRUE(waitForTold(QStringLiteral("\u25cf By message, shown now: All four on")));
    rig.click(QStringLiteral("ledInBlock"));
    choose(classes(), classes()->findData(static_cast<int>(TestClass::Hall)));
    choose(targets(), 4);
    ASSERT_TRUE(rig.waitForBlock(3, [](const wire::DriveBlock& block) {
        return block.testClass == 2 && block.testTarget == 5 && !block.run;
    }));
    ASSERT_TRUE(
        waitForTold(QStringLiteral("\u25cf In the drive block, shown now: Hall sensors: motor 5, dribbler")));
    EXPECT_TRUE(told().contains(QStringLiteral("\u25cb By message: All four on")));
}

TEST_F(LedsTest, NormalLightsEndsBothWays) {
    rig.clickRobot(0);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    choose(classes(), 1);
    rig.click(QStringLiteral("ledInBlock"));
    ASSERT_TRUE(rig.waitForBlock(0, [](const wire::DriveBlock& block) { return block.testClass == 1; }));
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    rig.click(QStringLiteral("ledNormal"));
    ASSERT_TRUE(rig.waitForBlock(0, [](const wire::DriveBlock& block) { return block.testClass == 0; }));
    ASSERT_TRUE(waitForMessages({Told{0, 0, 0}}));
    EXPECT_EQ(classes()->currentIndex(), 0);
}

TEST_F(LedsTest, AStopEndsTheDriveBlocksModeAndAMessageStillGoes) {
    rig.clickRobot(1);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    rig.click(QStringLiteral("ledInBlock"));
    choose(classes(), 1);
    ASSERT_TRUE(rig.waitForBlock(1, [](const wire::DriveBlock& block) { return block.testClass == 1; }));
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(rig.waitForBlock(1, [](const wire::DriveBlock& block) { return block.testClass == 0; }));
    ASSERT_TRUE(waitUntil([this] {
        return rig.find<QLabel>(QStringLiteral("ledNotice"))->text().contains(QStringLiteral("Re-arm"));
    }));
    rig.wire().clear();
    rig.click(QStringLiteral("ledByMessage"));
    EXPECT_TRUE(waitForMessages({Told{1, 1, 0}}));
    EXPECT_TRUE(
        waitUntil([this] { return rig.find<QLabel>(QStringLiteral("ledNotice"))->text().isEmpty(); }));
}

TEST_F(LedsTest, WithoutAHeardRobotItSaysWhy) {
    auto* notice = rig.find<QLabel>(QStringLiteral("ledNotice"));
    EXPECT_TRUE(notice->text().contains(QStringLiteral("Choose a robot")));
    EXPECT_FALSE(classes()->isEnabled());
    rig.clickRobot(9);
    EXPECT_TRUE(notice->text().contains(QStringLiteral("robot 9 is not heard")));
    EXPECT_FALSE(rig.find<QAbstractButton>(QStringLiteral("ledNormal"))->isEnabled());
}

TEST_F(LedsTest, RobotsThatDifferAreToldApart) {
    rig.clickRobot(0);
    ASSERT_TRUE(waitUntil([this] { return classes()->isEnabled(); }));
    choose(classes(), 1);
    ASSERT_TRUE(waitForTold(QStringLiteral("All four on")));
    rig.clickRobot(1, Qt::ControlModifier);
    ASSERT_TRUE(waitForTold(QStringLiteral("robot 0\n\u25cf By message, shown now: All four on")));
    EXPECT_TRUE(told().contains(QStringLiteral("robot 1\n\u25cb By message: none on this connection")));
}

TEST(LedWords, EveryLightOfEveryModeHasItsMeaning) {
    const auto count = [](const TestMode& mode) {
        const auto meanings = ui::ledMeanings(mode);
        return std::count_if(meanings.begin(), meanings.end(), [](const ui::LedMeaning& led) {
            return led.kind != ui::LedMeaning::Kind::Unused;
        });
    };
    EXPECT_EQ(count({TestClass::None, 0}), 0);
    EXPECT_EQ(count({TestClass::Lamp, 0}), 4);
    EXPECT_EQ(count({TestClass::Hall, 5}), 3);
    EXPECT_EQ(count({TestClass::Encoder, 1}), 2);
    EXPECT_EQ(count({TestClass::EncoderCount, 1}), 4);
    EXPECT_EQ(count({TestClass::Charger, 0}), 2);
    for (const TestClass testClass : ui::ledClasses())
        EXPECT_FALSE(ui::ledAdvice({testClass, 1}).isEmpty());
}

TEST(LedWords, AnUndefinedClassInADriveBlockIsNamedAsSuch) {
    RobotState robot;
    robot.told = wire::DriveBlock{};
    robot.told->testClass = 7;
    EXPECT_TRUE(ui::ledModeText(ui::ledStateOf(robot).block).contains(QStringLiteral("class 7")));
}

}  // namespace
}  // namespace kickstand::test
