// The body's motion and hold-to-drive by keyboard, to the bytes on the wire and back.

#include <QAbstractButton>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <algorithm>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/body_motion.h"
#include "ui/widgets/center_slider.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;
using Wheels = std::array<std::int16_t, 4>;

bool allZero(const DriveBlock& block) {
    return block.wheels == Wheels{};
}

class BodyTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.clickRobot(3);
        ASSERT_TRUE(rig.settle());
    }
    ui::SetPointSlider* axis(const char* name) { return rig.find<ui::SetPointSlider>(QLatin1String(name)); }
    void type(const char* name, const char* number) {
        auto* field = axis(name)->field();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, QLatin1String(number));
        QTest::keyClick(field, Qt::Key_Return);
    }
    bool waitForWheels(int robot, const Wheels& wheels) {
        return rig.waitForBlock(robot, [wheels](const DriveBlock& block) { return block.wheels == wheels; });
    }
    QString made() { return rig.find<QLabel>(QStringLiteral("madeWheels"))->text(); }
};

TEST_F(BodyTest, EveryWayOfTheBodyReachesTheWheelsByTheReferencesMatrix) {
    rig.click(QStringLiteral("bodyMode"));
    type("bodyX", "1");
    EXPECT_TRUE(waitForWheels(3, {-43, -36, 36, 43}));
    type("bodyX", "0");
    type("bodyY", "1");
    EXPECT_TRUE(waitForWheels(3, {28, -36, -36, 28}));
    type("bodyY", "0");
    type("bodyTurn", "-10");
    EXPECT_TRUE(waitForWheels(3, {-43, -43, -43, -43}));
}

TEST_F(BodyTest, TheWheelsThatItMakesAreShownAndItsOwnNumberStays) {
    rig.click(QStringLiteral("bodyMode"));
    type("bodyX", "1.00");
    ASSERT_TRUE(waitForWheels(3, {-43, -36, 36, 43}));
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(made().contains(QStringLiteral("\u221243  \u221236  36  43"))) << made().toStdString();
    EXPECT_EQ(axis("bodyX")->field()->text(), QStringLiteral("1.00"));
    rig.click(QStringLiteral("wheelMode"));
    EXPECT_EQ(rig.find<ui::SetPointSlider>(QStringLiteral("wheel4"))->value(), 43);
}

TEST_F(BodyTest, WhatIsTooFastIsSlowedDownAndSaysSo) {
    rig.click(QStringLiteral("bodyMode"));
    type("bodyX", "2");
    type("bodyTurn", "15");
    const ui::MadeWheels wanted = ui::wheelsOf({2, 0, 15}, kStartingWheelLimit);
    ASSERT_LT(wanted.scale, 1);
    Wheels wheels{};
    std::copy(wanted.wheels.begin(), wanted.wheels.end(), wheels.begin());
    EXPECT_TRUE(waitForWheels(3, wheels));
    EXPECT_TRUE(made().contains(QStringLiteral("slowed"))) << made().toStdString();
}

TEST_F(BodyTest, WheelsSetOtherwiseAreShownAsTheMotionThatTheyMake) {
    for (int wheel = 1; wheel <= 4; ++wheel)
        rig.typeWheel(wheel, QStringLiteral("43"));
    ASSERT_TRUE(waitForWheels(3, {43, 43, 43, 43}));
    rig.click(QStringLiteral("bodyMode"));
    ASSERT_TRUE(waitUntil([this] { return axis("bodyTurn")->value() == 996; })) << axis("bodyTurn")->value();
    EXPECT_EQ(axis("bodyX")->value(), 0);
}

TEST_F(BodyTest, ASliderSpringsBackToZero) {
    rig.click(QStringLiteral("bodyMode"));
    ui::CenterSlider* slider = axis("bodyX")->slider();
    const QPoint from(static_cast<int>(slider->positionOf(0)), slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    QTest::mouseMove(slider, from + QPoint(25, 0));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[3] > 0; }));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, from + QPoint(25, 0));
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.run && allZero(block); }));
    EXPECT_EQ(slider->value(), 0);
}

TEST_F(BodyTest, SeveralRobotsMoveTogether) {
    rig.clickRobot(1, Qt::ControlModifier);
    rig.click(QStringLiteral("bodyMode"));
    type("bodyX", "-1");
    EXPECT_TRUE(waitForWheels(3, {43, 36, -36, -43}));
    EXPECT_TRUE(waitForWheels(1, {43, 36, -36, -43}));
    EXPECT_FALSE(rig.wire().last(2).has_value());
}

class KeysTest : public BodyTest {
  protected:
    void SetUp() override {
        BodyTest::SetUp();
        rig.click(QStringLiteral("driveByKeys"));
        rig.find<QWidget>(QStringLiteral("driveByKeys"))->setFocus();
    }
    void send(QEvent::Type type, Qt::Key key, bool repeated = false) {
        QWidget* focus = QApplication::focusWidget();
        QKeyEvent event(type, key, Qt::NoModifier, QString(), repeated);
        QApplication::sendEvent(focus == nullptr ? &rig.window() : focus, &event);
    }
    void down(Qt::Key key) { send(QEvent::KeyPress, key); }
    void up(Qt::Key key) { send(QEvent::KeyRelease, key); }
    bool waitForward() {
        return rig.waitForBlock(3, [](const DriveBlock& b) { return b.wheels[3] > 0 && b.wheels[0] < 0; });
    }
    bool waitZero() { return rig.waitForBlock(3, allZero); }
    QAbstractButton* cap(int number) {
        return rig.find<QAbstractButton>(QStringLiteral("driveKey%1").arg(number));
    }
};

TEST_F(KeysTest, AKeyDrivesForAsLongAsItIsHeld) {
    down(Qt::Key_W);
    EXPECT_TRUE(cap(1)->isChecked());
    ASSERT_TRUE(waitForward());
    up(Qt::Key_W);
    EXPECT_TRUE(waitZero());
    EXPECT_FALSE(cap(1)->isChecked());
}

TEST_F(KeysTest, EveryKeyDrivesItsWay) {
    const std::array<std::pair<Qt::Key, std::array<int, 4>>, 6> ways{{
        {Qt::Key_W, {-1, -1, 1, 1}},
        {Qt::Key_S, {1, 1, -1, -1}},
        {Qt::Key_A, {1, -1, -1, 1}},
        {Qt::Key_D, {-1, 1, 1, -1}},
        {Qt::Key_Q, {1, 1, 1, 1}},
        {Qt::Key_E, {-1, -1, -1, -1}},
    }};
    for (const auto& [key, signs] : ways) {
        down(key);
        EXPECT_TRUE(rig.waitForBlock(3, [signs = signs](const DriveBlock& block) {
            for (std::size_t i = 0; i < signs.size(); ++i) {
                if (block.wheels.at(i) * signs.at(i) <= 0) return false;
            }
            return true;
        })) << static_cast<char>(key);
        up(key);
        ASSERT_TRUE(waitZero());
    }
}

TEST_F(KeysTest, WithoutTheSwitchKeysDriveNothing) {
    rig.click(QStringLiteral("driveByKeys"));
    down(Qt::Key_W);
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.wire().last(3).has_value());
    up(Qt::Key_W);
}

TEST_F(KeysTest, AKeyIsTextWhereTextIsTyped) {
    auto* text = rig.find<QLineEdit>(QStringLiteral("eventText"));
    text->setFocus();
    QTest::keyClicks(text, QStringLiteral("wasd"));
    EXPECT_EQ(text->text(), QStringLiteral("wasd"));
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.wire().last(3).has_value());
}

TEST_F(KeysTest, AKeyDrivesWithTheFocusInANumber) {
    rig.find<ui::SetPointSlider>(QStringLiteral("wheel1"))->field()->setFocus();
    down(Qt::Key_W);
    EXPECT_TRUE(waitForward());
    up(Qt::Key_W);
    EXPECT_TRUE(waitZero());
}

TEST_F(KeysTest, TheFocusGoingWhereTextIsTypedLetsGo) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    rig.find<QLineEdit>(QStringLiteral("eventText"))->setFocus();
    EXPECT_TRUE(waitZero());
}

TEST_F(KeysTest, TheWindowLosingTheKeyboardBrakes) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    emit qApp->applicationStateChanged(Qt::ApplicationInactive);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
}

TEST_F(KeysTest, AReleaseThatIsLostEndsWithTheRepeats) {
    down(Qt::Key_W);
    send(QEvent::KeyPress, Qt::Key_W, true);
    ASSERT_TRUE(rig.waitForAnyBlock(3, [](const DriveBlock& block) { return block.wheels[3] > 0; }));
    // Nobody repeats it any more.
    EXPECT_TRUE(waitZero());
    EXPECT_TRUE(rig.find<QLabel>(QStringLiteral("notice"))->text().contains(QStringLiteral("not repeated")));
}

TEST_F(KeysTest, AfterStopAHeldKeyCountsOnlyWhenItIsPressedAnew) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    rig.press(Qt::Key_Space);
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
    ASSERT_TRUE(rig.rearm());
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    for (int i = 0; i < 5; ++i)
        send(QEvent::KeyPress, Qt::Key_W, true);
    ASSERT_TRUE(rig.settle());
    for (const DriveBlock& block : rig.wire().blocks(3))
        EXPECT_TRUE(allZero(block));
    up(Qt::Key_W);
    down(Qt::Key_W);
    EXPECT_TRUE(waitForward());
}

TEST_F(KeysTest, ChoosingAnotherRobotStopsTheOneThatAKeyDrove) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    rig.clickRobot(1);
    EXPECT_TRUE(waitZero());
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.wire().last(1).has_value());
}

TEST_F(KeysTest, SpaceStaysStop) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    rig.press(Qt::Key_Space);
    EXPECT_TRUE(rig.client().isStopped());
}

TEST_F(KeysTest, ZStaysZero) {
    down(Qt::Key_W);
    ASSERT_TRUE(waitForward());
    rig.press(Qt::Key_Z);
    EXPECT_TRUE(waitZero());
    send(QEvent::KeyPress, Qt::Key_W, true);
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(allZero(*rig.wire().last(3)));
}

TEST_F(KeysTest, AnotherLetterCanBeChosenAndIsRemembered) {
    cap(1)->click();
    EXPECT_EQ(cap(1)->text(), QStringLiteral("?"));
    rig.press(Qt::Key_I);
    EXPECT_EQ(cap(1)->text(), QStringLiteral("I"));
    EXPECT_EQ(rig.settings().value(QStringLiteral("drive/keys")).toString(), QStringLiteral("ISADQE"));
    ASSERT_TRUE(rig.settle());
    EXPECT_FALSE(rig.wire().last(3).has_value());
    down(Qt::Key_I);
    EXPECT_TRUE(waitForward());
    up(Qt::Key_I);
    EXPECT_TRUE(waitZero());
}

TEST_F(KeysTest, TheShareOfTheLimitSetsTheSpeed) {
    auto* share = rig.find<ui::SignedSpinBox>(QStringLiteral("keySpeed"));
    share->setValue(10);
    down(Qt::Key_Q);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) {
        return block.wheels == Wheels{10, 10, 10, 10};
    }));
    up(Qt::Key_Q);
    EXPECT_TRUE(waitZero());
}

}  // namespace
}  // namespace kickstand::test
