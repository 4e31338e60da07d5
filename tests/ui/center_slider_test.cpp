#include "ui/widgets/center_slider.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

class CenterSliderTest : public testing::Test {
  protected:
    CenterSliderTest() {
        slider.setRange(-100, 100);
        slider.resize(216, 24);  // Two hundred pixels between the ends: one for each step.
        slider.show();
    }

    CenterSlider slider;
};

TEST_F(CenterSliderTest, ZeroIsInTheMiddle) {
    EXPECT_DOUBLE_EQ(slider.positionOf(0), 108);
    EXPECT_DOUBLE_EQ(slider.positionOf(-100), 8);
    EXPECT_DOUBLE_EQ(slider.positionOf(100), 208);
    EXPECT_DOUBLE_EQ(slider.positionOf(500), 208);
}

TEST_F(CenterSliderTest, AWholeStepFollowsThePointerFromWhereverItIsPressed) {
    QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(20, 12));
    EXPECT_EQ(slider.value(), 0);
    EXPECT_TRUE(slider.isSliderDown());
    QTest::mouseMove(&slider, QPoint(45, 12));
    EXPECT_EQ(slider.value(), 25);
    QTest::mouseMove(&slider, QPoint(10, 12));
    EXPECT_EQ(slider.value(), -10);
    QTest::mouseRelease(&slider, Qt::LeftButton, {}, QPoint(10, 12));
    EXPECT_FALSE(slider.isSliderDown());
}

TEST_F(CenterSliderTest, AnotherButtonDoesNotPull) {
    QTest::mousePress(&slider, Qt::RightButton, {}, QPoint(108, 12));
    EXPECT_FALSE(slider.isSliderDown());
}

TEST_F(CenterSliderTest, TheWheelIsLeftToThePage) {
    QWheelEvent turn(QPointF(108, 12), slider.mapToGlobal(QPointF(108, 12)), {}, QPoint(0, 120), Qt::NoButton,
                     Qt::NoModifier, Qt::NoScrollPhase, false);
    turn.accept();
    QCoreApplication::sendEvent(&slider, &turn);
    EXPECT_EQ(slider.value(), 0);
    EXPECT_FALSE(turn.isAccepted());
}

TEST_F(CenterSliderTest, BeingDisabledOrHiddenLetsGo) {
    QSignalSpy released(&slider, &CenterSlider::sliderReleased);
    QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(108, 12));
    slider.setEnabled(false);
    EXPECT_EQ(released.count(), 1);
    slider.setEnabled(true);
    QTest::mousePress(&slider, Qt::LeftButton, {}, QPoint(108, 12));
    slider.hide();
    EXPECT_EQ(released.count(), 2);
}

TEST_F(CenterSliderTest, DoubleClickAsksForZero) {
    QSignalSpy zero(&slider, &CenterSlider::zeroAsked);
    QTest::mouseDClick(&slider, Qt::LeftButton);
    EXPECT_EQ(zero.count(), 1);
}

}  // namespace
}  // namespace kickstand::ui
