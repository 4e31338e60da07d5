// The window at the sizes it is made for: everything there, nothing cut, everything with a name.

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/robot_tile.h"
#include "ui/thunderbots/tile_layout.h"

namespace kickstand::test {
namespace {

class LayoutTest : public BenchTest {
  protected:
    bool resizeTo(QSize size) {
        rig.window().resize(size);
        return rig.settle();
    }
    /// A panel behind another one of its place is not laid out until it comes to the front.
    static bool isSeen(const QWidget* widget) {
        return widget->isVisible() && !widget->visibleRegion().isEmpty();
    }
};

TEST_F(LayoutTest, AllSixteenTilesAreVisibleAtTheSmallestSizeWithBannersAndDoNotOverlap) {
    ASSERT_TRUE(resizeTo({1280, 800}));
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(rig.settle());
    ASSERT_TRUE(rig.find<QWidget>(QStringLiteral("stoppedBanner"))->isVisible());
    ASSERT_TRUE(rig.find<QWidget>(QStringLiteral("simulatedBanner"))->isVisible());
    const QRect window = rig.window().rect();
    std::vector<QRect> places;
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        auto* tile = rig.find<ui::RobotTile>(QStringLiteral("robot%1").arg(robot));
        const QRect place(tile->mapTo(&rig.window(), QPoint()), tile->size());
        EXPECT_TRUE(window.contains(place)) << robot;
        // None of it is scrolled away.
        EXPECT_EQ(tile->visibleRegion().boundingRect(), tile->rect()) << robot;
        EXPECT_GE(place.width(), ui::kLeastTileWidth) << robot;
        EXPECT_GE(place.height(), ui::RobotTile::kLeastHeight) << robot;
        for (const QRect& other : places)
            EXPECT_FALSE(place.intersects(other)) << robot;
        places.push_back(place);
    }
}

TEST_F(LayoutTest, NoButtonOrSingleLineIsCut) {
    for (const QSize size : {QSize(1280, 800), QSize(1440, 900)}) {
        ASSERT_TRUE(resizeTo(size));
        for (const auto* button : rig.window().findChildren<QAbstractButton*>()) {
            if (!isSeen(button) || button->text().isEmpty()) continue;
            EXPECT_GE(button->width(), button->minimumSizeHint().width()) << button->text().toStdString();
        }
        for (const auto* label : rig.window().findChildren<QLabel*>()) {
            if (!isSeen(label) || label->wordWrap()) continue;
            EXPECT_GE(label->width(), label->minimumSizeHint().width()) << label->text().toStdString();
        }
    }
}

TEST_F(LayoutTest, EveryControlHasAnAccessibleNameOrText) {
    for (const auto* widget : rig.window().findChildren<QWidget*>()) {
        const auto* button = qobject_cast<const QAbstractButton*>(widget);
        const bool control = button != nullptr || qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
                             qobject_cast<const QComboBox*>(widget) != nullptr ||
                             qobject_cast<const QAbstractSpinBox*>(widget) != nullptr;
        if (!control || !widget->isVisible() || widget->focusPolicy() == Qt::NoFocus) continue;
        if (button != nullptr && !button->text().isEmpty()) continue;
        EXPECT_FALSE(widget->accessibleName().isEmpty())
            << widget->metaObject()->className() << " " << widget->objectName().toStdString();
    }
}

TEST_F(LayoutTest, ClickingCtrlAAndShiftChooseAsInAList) {
    auto& view = *static_cast<const ui::ThunderbotsView*>(rig.bench().view());
    rig.clickRobot(1);
    EXPECT_EQ(view.choice().chosen(), 0b10);
    rig.clickRobot(4, Qt::ShiftModifier);
    EXPECT_EQ(view.choice().chosen(), 0b11110);
    rig.clickRobot(2, Qt::ControlModifier);
    EXPECT_EQ(view.choice().chosen(), 0b11010);
    rig.find<QWidget>(QStringLiteral("robot1"))->setFocus();
    rig.press(Qt::Key_A, Qt::ControlModifier);
    EXPECT_EQ(view.choice().chosen(), 0b111111);
}

TEST_F(LayoutTest, TilesAreWalkedWithArrowsAndChosenWithEnter) {
    auto& view = *static_cast<const ui::ThunderbotsView*>(rig.bench().view());
    rig.find<QWidget>(QStringLiteral("robot0"))->setFocus();
    rig.press(Qt::Key_Down);
    EXPECT_TRUE(rig.find<QWidget>(QStringLiteral("robot2"))->hasFocus());
    rig.press(Qt::Key_Return);
    EXPECT_EQ(view.choice().chosen(), 0b100);
    rig.press(Qt::Key_Right);
    rig.press(Qt::Key_Return, Qt::ControlModifier);
    EXPECT_EQ(view.choice().chosen(), 0b1100);
}

}  // namespace
}  // namespace kickstand::test
