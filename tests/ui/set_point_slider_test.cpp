#include "ui/widgets/set_point_slider.h"

#include <QApplication>
#include <QKeyEvent>
#include <QSignalSpy>
#include <QTest>

#include <gtest/gtest.h>

#include "ui/widgets/center_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::ui {
namespace {

class SetPointSliderTest : public testing::Test {
  protected:
    SetPointSliderTest() {
        point.setLimit(100);
        point.resize(500, 30);
        point.show();
    }
    void pull(int pixels) {
        QTest::mousePress(point.slider(), Qt::LeftButton, {}, QPoint(50, 12));
        QTest::mouseMove(point.slider(), QPoint(50 + pixels, 12));
    }

    SetPointSlider point{QStringLiteral("1 front L")};
    QSignalSpy asked{&point, &SetPointSlider::asked};
};

TEST_F(SetPointSliderTest, ShowingAValueAsksForNothing) {
    point.showValue(42);
    EXPECT_EQ(point.value(), 42);
    EXPECT_EQ(point.field()->value(), 42);
    point.setLimit(30);
    EXPECT_EQ(asked.count(), 0);
}

TEST_F(SetPointSliderTest, PullingAsksAsHeldAndLettingGoAsksForZero) {
    pull(40);
    ASSERT_GE(asked.count(), 1);
    EXPECT_GT(asked.last().at(0).toInt(), 0);
    EXPECT_TRUE(asked.last().at(1).toBool());
    EXPECT_EQ(point.field()->value(), point.slider()->value());
    QTest::mouseRelease(point.slider(), Qt::LeftButton, {}, QPoint(90, 12));
    EXPECT_EQ(asked.last().at(0).toInt(), 0);
    EXPECT_TRUE(asked.last().at(1).toBool());
    EXPECT_EQ(point.value(), 0);
}

TEST_F(SetPointSliderTest, WithoutReleaseToZeroItStaysAndIsNotHeld) {
    point.setReleaseToZero(false);
    pull(40);
    const int value = point.value();
    EXPECT_FALSE(asked.last().at(1).toBool());
    const auto before = asked.count();
    QTest::mouseRelease(point.slider(), Qt::LeftButton, {}, QPoint(90, 12));
    EXPECT_EQ(point.value(), value);
    EXPECT_EQ(asked.count(), before);
}

TEST_F(SetPointSliderTest, WhatIsShownDoesNotTearASliderOutOfAHand) {
    pull(40);
    const int value = point.value();
    point.showValue(-7);
    EXPECT_EQ(point.value(), value);
}

TEST_F(SetPointSliderTest, AResetTakesItOutOfTheHandSilently) {
    pull(40);
    const auto before = asked.count();
    point.reset();
    EXPECT_EQ(point.value(), 0);
    EXPECT_FALSE(point.isHeld());
    EXPECT_EQ(asked.count(), before);
}

class HeldKey : public SetPointSliderTest {
  protected:
    void send(QEvent::Type type, bool repeated) {
        QKeyEvent event(type, Qt::Key_Right, Qt::NoModifier, QString(), repeated);
        QApplication::sendEvent(point.slider(), &event);
    }
    void hold() {
        send(QEvent::KeyPress, false);
        send(QEvent::KeyRelease, true);
        send(QEvent::KeyPress, true);
    }
};

TEST_F(HeldKey, OneThatIsTappedIsNotHeldAndItsValueStays) {
    send(QEvent::KeyPress, false);
    send(QEvent::KeyRelease, false);
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.last().at(0).toInt(), 1);
    EXPECT_FALSE(asked.last().at(1).toBool());
}

TEST_F(HeldKey, OneThatRepeatsIsHeldAndGoesToZeroWhenItIsLetGo) {
    hold();
    EXPECT_EQ(asked.last().at(0).toInt(), 2);
    EXPECT_TRUE(asked.last().at(1).toBool());
    EXPECT_TRUE(point.isHeld());
    send(QEvent::KeyRelease, false);
    EXPECT_EQ(asked.last().at(0).toInt(), 0);
    EXPECT_TRUE(asked.last().at(1).toBool());
    EXPECT_FALSE(point.isHeld());
}

TEST_F(HeldKey, ALostReleaseEndsWithTheFocus) {
    hold();
    QFocusEvent gone(QEvent::FocusOut, Qt::ActiveWindowFocusReason);
    QApplication::sendEvent(point.slider(), &gone);
    EXPECT_EQ(asked.last().at(0).toInt(), 0);
    EXPECT_FALSE(point.isHeld());
}

TEST_F(SetPointSliderTest, TypingAndEnterAsksAndIsNotHeld) {
    point.field()->setFocus();
    point.field()->selectAll();
    QTest::keyClicks(point.field(), QStringLiteral("-25"));
    EXPECT_EQ(asked.count(), 0);
    QTest::keyClick(point.field(), Qt::Key_Return);
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.last().at(0).toInt(), -25);
    EXPECT_FALSE(asked.last().at(1).toBool());
}

TEST_F(SetPointSliderTest, TheUpAndDownKeysCountAtOnce) {
    QTest::keyClick(point.field(), Qt::Key_Up);
    ASSERT_EQ(asked.count(), 1);
    EXPECT_EQ(asked.last().at(0).toInt(), 1);
    QTest::keyClick(point.field(), Qt::Key_PageDown);
    EXPECT_EQ(asked.last().at(0).toInt(), -9);
}

}  // namespace
}  // namespace kickstand::ui
