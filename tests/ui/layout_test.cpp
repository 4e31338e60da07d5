// The window at the sizes it is made for: everything there, nothing cut, everything with a name.

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QScrollBar>
#include <QTabBar>
#include <map>

#include "core/link/link_uri.h"
#include "tests/ui/bench_rig.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/workbench.h"
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
    // A screen of 1280 × 800 less a title bar.
    ASSERT_TRUE(resizeTo({1280, 776}));
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

/// Something that a person operates.
bool isControl(const QWidget* widget) {
    // The parts that such a thing is made of are its own affair.
    const QWidget* parent = widget->parentWidget();
    if (widget->objectName().startsWith(QStringLiteral("qt_")) ||
        qobject_cast<const QScrollBar*>(widget) != nullptr ||
        qobject_cast<const QHeaderView*>(widget) != nullptr ||
        qobject_cast<const QTabBar*>(parent) != nullptr ||
        qobject_cast<const QComboBox*>(parent) != nullptr ||
        qobject_cast<const QAbstractItemView*>(parent) != nullptr)
        return false;
    return qobject_cast<const QAbstractButton*>(widget) != nullptr ||
           qobject_cast<const QAbstractSlider*>(widget) != nullptr ||
           qobject_cast<const QComboBox*>(widget) != nullptr ||
           qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
           qobject_cast<const QLineEdit*>(widget) != nullptr ||
           qobject_cast<const QAbstractItemView*>(widget) != nullptr;
}

bool isNamed(const QWidget* widget) {
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
}

/// Whether the Tab key comes to it, or the arrow keys do from one of its group.
bool isReachedByKeys(const QWidget* widget) {
    if ((widget->focusPolicy() & Qt::TabFocus) != 0) return true;
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return button != nullptr && button->group() != nullptr;
}

TEST_F(LayoutTest, EveryControlOfEveryPanelHasANameAndIsReachedByKeys) {
    int controls = 0;
    for (const ui::PanelDock* dock : rig.window().workbench().docks()) {
        rig.bench().goTo(dock->objectName());
        ASSERT_TRUE(waitUntil([dock] { return dock->isVisible() && !dock->visibleRegion().isEmpty(); }));
        for (const QWidget* widget : dock->findChildren<QWidget*>()) {
            if (!isControl(widget) || !widget->isVisibleTo(dock)) continue;
            ++controls;
            const std::string who = dock->objectName().toStdString() + ": " +
                                    widget->metaObject()->className() + ' ' +
                                    widget->objectName().toStdString();
            EXPECT_TRUE(isNamed(widget)) << who << " has neither text nor accessible name";
            EXPECT_TRUE(isReachedByKeys(widget)) << who << " is not reached by the Tab key";
        }
    }
    EXPECT_GT(controls, 100);
}

TEST_F(LayoutTest, NoTwoControlsOfTheWindowHaveTheSameName) {
    std::map<QString, int> names;
    for (const QWidget* widget : rig.window().findChildren<QWidget*>()) {
        if (isControl(widget) && !widget->objectName().isEmpty()) ++names[widget->objectName()];
    }
    for (const auto& [name, count] : names)
        EXPECT_EQ(count, 1) << name.toStdString();
}

/// As forges make a heading's anchor.
QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber()) anchor += c;
        if (c.isSpace() || c == u'-') anchor += u'-';
    }
    return anchor;
}

TEST_F(LayoutTest, EveryPanelHasItsOwnSectionOfTheHelp) {
    for (const ui::PanelDock* dock : rig.window().workbench().docks()) {
        const QStringList place = dock->helpPage().split(u'#');
        ASSERT_EQ(place.size(), 2) << dock->objectName().toStdString() << ": no section";
        QFile page(QStringLiteral(KICKSTAND_SOURCE_DIR "/resources/help/%1").arg(place[0]));
        ASSERT_TRUE(page.open(QIODevice::ReadOnly)) << place[0].toStdString();
        bool found = false;
        while (!page.atEnd()) {
            const QString line = QString::fromUtf8(page.readLine()).trimmed();
            const qsizetype level = line.indexOf(u' ');
            if (!line.startsWith(u'#') || level < 0) continue;
            found = found || anchorOf(line.mid(level + 1)) == place[1];
        }
        EXPECT_TRUE(found) << dock->objectName().toStdString() << ": " << dock->helpPage().toStdString();
    }
}

TEST_F(LayoutTest, TheNextWindowStandsAsThisOneDid) {
    ASSERT_TRUE(resizeTo({1360, 840}));
    rig.find<ui::PanelDock>(QStringLiteral("faults"))->close();
    rig.find<ui::PanelDock>(QStringLiteral("leds"))->setFloating(true);
    rig.window().close();
    ui::MainWindow next(rig.bench(), rig.theme());
    next.show();
    const auto dock = [&next](const char* id) { return next.findChild<ui::PanelDock*>(QLatin1String(id)); };
    EXPECT_EQ(next.size(), QSize(1360, 840));
    EXPECT_TRUE(dock("faults")->isHidden());
    EXPECT_TRUE(dock("leds")->isFloating());
    EXPECT_FALSE(dock("drive")->isHidden());
}

TEST_F(LayoutTest, ALargerWindowLeavesTheTilesAsWideAsTheyWere) {
    ASSERT_TRUE(resizeTo({1280, 800}));
    const auto* robots = rig.find<ui::PanelDock>(QStringLiteral("robots"));
    const auto* drive = rig.find<ui::PanelDock>(QStringLiteral("drive"));
    const int tiles = robots->width();
    const int work = drive->width();
    ASSERT_TRUE(resizeTo({1680, 1000}));
    EXPECT_TRUE(waitUntil([&] { return robots->width() == tiles && drive->width() > work; }))
        << tiles << " became " << robots->width();
}

TEST_F(LayoutTest, AfterAStopEveryPanelIsAsHighAsBefore) {
    ASSERT_TRUE(resizeTo({1280, 800}));
    std::map<const ui::PanelDock*, QSize> before;
    for (const ui::PanelDock* dock : rig.window().workbench().docks()) {
        if (!dock->isHidden() && dock->geometry().right() >= 0) before[dock] = dock->size();
    }
    ASSERT_GT(before.size(), 4U);
    for (int time = 0; time < 3; ++time) {
        rig.client().stop(StopReason::Person);
        ASSERT_TRUE(rig.waitForStop());
        ASSERT_TRUE(
            waitUntil([this] { return rig.find<QWidget>(QStringLiteral("stoppedBanner"))->isVisible(); }));
        ASSERT_TRUE(rig.settle());
        ASSERT_TRUE(rig.rearm());
        for (const auto& [dock, was] : before) {
            EXPECT_TRUE(waitUntil([dock = dock, was = was] { return dock->size() == was; }))
                << dock->objectName().toStdString() << " is " << dock->height() << " high and was "
                << was.height();
        }
    }
}

TEST_F(LayoutTest, TheNextWindowsPanelsAreAsLargeAsTheyWereLeft) {
    ASSERT_TRUE(resizeTo({1440, 1000}));
    ui::Workbench& bench = rig.window().workbench();
    auto* robots = rig.find<ui::PanelDock>(QStringLiteral("robots"));
    auto* events = rig.find<ui::PanelDock>(QStringLiteral("events"));
    bench.resizeDocks({robots, events}, {360, bench.width() - 360}, Qt::Horizontal);
    ASSERT_TRUE(waitUntil([robots] { return robots->width() > 340; })) << robots->width();
    std::map<QString, QSize> left;
    for (const ui::PanelDock* dock : bench.docks()) {
        if (!dock->isHidden() && dock->geometry().right() >= 0) left[dock->objectName()] = dock->size();
    }
    ASSERT_GT(left.size(), 4u);
    rig.window().close();
    ui::MainWindow next(rig.bench(), rig.theme());
    next.show();
    next.workbench().makePanels();
    for (const ui::PanelDock* dock : next.workbench().docks()) {
        if (left.count(dock->objectName()) == 0) continue;
        const QSize was = left[dock->objectName()];
        EXPECT_TRUE(waitUntil([dock, was] { return dock->size() == was; }))
            << dock->objectName().toStdString() << " is " << dock->width() << " x " << dock->height()
            << " and was " << was.width() << " x " << was.height();
    }
}

TEST_F(LayoutTest, AWindowThatOnlyShowedTheStartPageLeavesTheLayoutAsItWas) {
    ASSERT_TRUE(resizeTo({1440, 900}));
    rig.window().close();
    const QVariant layout = rig.settings().value(QStringLiteral("window/docks"));
    rig.bench().disconnectAll();
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    ui::MainWindow next(rig.bench(), rig.theme());
    next.show();
    ASSERT_FALSE(next.workbench().isVisible());
    next.close();
    EXPECT_EQ(rig.settings().value(QStringLiteral("window/docks")), layout);
}

TEST_F(LayoutTest, AWindowEnlargedOnTheStartPageLeavesTheTilesAsWideAsTheyWere) {
    ASSERT_TRUE(resizeTo({1280, 800}));
    const int tiles = rig.find<ui::PanelDock>(QStringLiteral("robots"))->width();
    rig.window().close();
    rig.bench().disconnectAll();
    ASSERT_TRUE(waitUntil([this] { return rig.bench().session() == nullptr; }));
    ui::MainWindow next(rig.bench(), rig.theme());
    next.show();
    next.resize(1920, 1080);
    ASSERT_TRUE(rig.connectTo());
    const auto* robots = next.findChild<ui::PanelDock*>(QStringLiteral("robots"));
    EXPECT_TRUE(waitUntil([&] { return robots->isVisible() && robots->width() == tiles; }))
        << tiles << " became " << robots->width();
}

TEST_F(LayoutTest, TheLastLinkIsOfferedAgain) {
    ui::Connector* connector = &rig.window().connector();
    connector->connectTo(*parseLinkUri("sim:thunderbots?robots=0-2"));
    EXPECT_EQ(rig.settings().value(QStringLiteral("links/recent")).toStringList().value(0),
              QStringLiteral("sim:thunderbots?robots=0-2"));
    connector->askForLink();
    auto* dialog = rig.find<QInputDialog>(QStringLiteral("linkDialog"));
    EXPECT_EQ(dialog->textValue(), QStringLiteral("sim:thunderbots?robots=0-2"));
    dialog->close();
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
