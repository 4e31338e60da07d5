// The keys of the window: Ctrl and a number go to a panel, F1 brings the help of the one that is worked in.

#include <QAbstractButton>
#include <QTabBar>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>

#include "tests/ui/bench_rig.h"
#include "ui/shell/panel.h"
#include "ui/shell/panel_dock.h"
#include "ui/shell/workbench.h"

namespace kickstand::test {
namespace {

class ShortcutsTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        rig.window().activateWindow();
        ASSERT_TRUE(waitUntil([this] { return rig.window().isActiveWindow(); }));
    }

    ui::PanelDock* dock(const char* id) { return rig.find<ui::PanelDock>(QLatin1String(id)); }
    static bool isInFront(const ui::PanelDock* dock) { return !dock->visibleRegion().isEmpty(); }
    void clickTab(const QString& title) {
        for (QTabBar* bar : rig.window().workbench().findChildren<QTabBar*>()) {
            for (int tab = 0; tab < bar->count(); ++tab) {
                if (bar->isVisible() && bar->tabText(tab) == title) {
                    QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(tab).center());
                    return;
                }
            }
        }
        ADD_FAILURE() << "no tab " << title.toStdString();
    }
    /// What is at the top of the help.
    QString helpShows() {
        QTest::keyClick(&rig.window(), Qt::Key_F1);
        const auto* help = rig.window().findChild<QWidget*>(QStringLiteral("help"));
        if (help == nullptr || !waitUntil([help] { return help->isVisible(); })) return {};
        const auto* browser = help->findChild<QTextBrowser*>();
        const QString top = browser->cursorForPosition({8, 8}).block().text();
        rig.window().activateWindow();
        EXPECT_TRUE(waitUntil([this] { return rig.window().isActiveWindow(); }));
        return top;
    }
};

TEST_F(ShortcutsTest, CtrlAndANumberGoToThatPanel) {
    const auto& docks = rig.window().workbench().docks();
    for (int number = 1; number <= 9; ++number) {
        const ui::PanelDock* wanted = docks[static_cast<std::size_t>(number - 1)];
        QTest::keyClick(&rig.window(), static_cast<Qt::Key>(Qt::Key_0 + number), Qt::ControlModifier);
        EXPECT_TRUE(waitUntil([&] { return isInFront(wanted); })) << number;
        EXPECT_EQ(rig.window().workbench().currentDock(), wanted) << number;
        const QWidget* focused = QApplication::focusWidget();
        ASSERT_NE(focused, nullptr) << number;
        EXPECT_TRUE(focused == wanted || wanted->isAncestorOf(focused)) << number;
    }
}

TEST_F(ShortcutsTest, F1BringsTheHelpOfThePanelWhoseTabWasClicked) {
    rig.clickRobot(3);
    EXPECT_EQ(helpShows(), QStringLiteral("Robots"));
    clickTab(QStringLiteral("Checks"));
    ASSERT_TRUE(waitUntil([this] { return isInFront(dock("checks")); }));
    EXPECT_EQ(helpShows(), QStringLiteral("Checks"));
}

TEST_F(ShortcutsTest, F1BringsTheHelpOfThePanelInFrontWhoseTabWasClicked) {
    clickTab(QStringLiteral("Checks"));
    ASSERT_TRUE(waitUntil([this] { return isInFront(dock("checks")); }));
    rig.clickRobot(3);
    rig.find<QWidget>(QStringLiteral("robot3"))->setFocus();
    ASSERT_EQ(rig.window().workbench().currentDock(), dock("robots"));
    clickTab(QStringLiteral("Checks"));
    EXPECT_EQ(helpShows(), QStringLiteral("Checks"));
}

TEST_F(ShortcutsTest, F1BringsTheHelpOfThePanelThatWasClickedBesideItsControls) {
    rig.clickRobot(3);
    QWidget* header = dock("events")->titleBarWidget();
    QTest::mouseClick(header, Qt::LeftButton, {}, QPoint(4, 4));
    EXPECT_EQ(helpShows(), QStringLiteral("Events"));
}

TEST_F(ShortcutsTest, F1BringsTheHelpOfAPanelInWhichNothingCanBeUsed) {
    rig.clickRobot(3);
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(rig.waitForStop());
    const auto& docks = rig.window().workbench().docks();
    const auto kick = std::find(docks.begin(), docks.end(), dock("kick"));
    const auto number = static_cast<int>(kick - docks.begin()) + 1;
    QTest::keyClick(&rig.window(), static_cast<Qt::Key>(Qt::Key_0 + number), Qt::ControlModifier);
    ASSERT_TRUE(waitUntil([this] { return isInFront(dock("kick")); }));
    EXPECT_EQ(helpShows(), QStringLiteral("Kick"));
}

}  // namespace
}  // namespace kickstand::test
