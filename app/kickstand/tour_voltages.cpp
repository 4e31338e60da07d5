#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>

#include "app/kickstand/tour_maker.h"
#include "ui/plot/time_plot.h"
#include "ui/thunderbots/voltages_panel.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

constexpr int kRobot = TourMaker::kRobot;
/// Of the trigger: robot 3's battery falls past it.
constexpr double kLevel_V = 15;
constexpr double kBefore_V = 15.8;
constexpr double kAfter_V = 14.4;

/// Chooses the entry of a menu that begins so.
TourMaker::Act choose(ui::MainWindow* window, const char* menu, const QString& words) {
    return [window, menu, words] {
        auto* shown = window->findChild<QMenu*>(QLatin1String(menu));
        emit shown->aboutToShow();
        for (QAction* action : shown->actions()) {
            if (!action->text().remove(u'&').startsWith(words)) continue;
            action->trigger();
            return;
        }
    };
}

TourMaker::Done batteryIs(const TourMaker& tour, bool low) {
    return tour.whenRobot(
        [low](const RobotState& robot) { return (robot.readings.battery_V < kLevel_V) == low; });
}

void addCursors(TourMaker& tour) {
    tour.add("voltages-30-s", choose(tour.window(), "plotSpanMenu", QStringLiteral("30 s")));
    tour.show("voltages", tour.press("plotFollow"));
    tour.add("voltages-pause", tour.press("plotPause"));
    tour.show("voltages-cursors", tour.press("plotCursors"));
    tour.add("voltages-no-cursors", tour.press("plotCursors"));
    tour.add("voltages-follow", tour.press("plotFollow"));
}

void addTrigger(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    tour.add("battery-full", tour.simulate("battery", kRobot, kBefore_V), batteryIs(tour, false));
    tour.add("trigger-row", tour.press("plotTrigger"));
    tour.add("trigger-wait", [window] {
        window->findChild<QComboBox*>(QStringLiteral("triggerCurve"))->setCurrentIndex(0);
        window->findChild<QComboBox*>(QStringLiteral("triggerEdge"))->setCurrentIndex(1);
        window->findChild<QDoubleSpinBox*>(QStringLiteral("triggerLevel"))->setValue(kLevel_V);
        window->findChild<QAbstractButton*>(QStringLiteral("triggerArm"))->click();
    });
    tour.show("voltages-trigger", tour.simulate("battery", kRobot, kAfter_V),
              [window] { return !window->findChild<ui::VoltagesPanel*>()->plot().isFollowing(); });
    tour.add("trigger-off", tour.press("plotTrigger"));
    tour.add("battery-full-again", tour.simulate("battery", kRobot, kBefore_V), batteryIs(tour, false));
}

void addAllRobots(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    const auto signal = [window](const char* words) {
        return choose(window, "plotSignalsMenu", QString::fromLatin1(words));
    };
    for (const char* robot : {"Robot 0", "Robot 1", "Robot 7", "Robot 10", "Robot 12"})
        tour.add("pin", choose(window, "plotRobotsMenu", QString::fromLatin1(robot)));
    tour.add("dribbler-signal", signal("Dribbler"));
    tour.add("voltages-60-s", choose(window, "plotSpanMenu", QStringLiteral("60 s")));
    tour.show("voltages-many", tour.press("plotFollow"));
    tour.add("no-dribbler-signal", signal("Dribbler"));
    tour.add("unpin", choose(window, "plotRobotsMenu", QStringLiteral("Those")));
}

}  // namespace

void addVoltagesSteps(TourMaker& tour) {
    tour.add("go-to-voltages", tour.goTo("voltages"));
    addCursors(tour);
    addTrigger(tour);
    addAllRobots(tour);
    tour.add("drive-again", tour.goTo("drive"));
}

}  // namespace kickstand::app
