#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <algorithm>
#include <chrono>

#include "app/kickstand/tour_maker.h"
#include "ui/plot/time_plot.h"
#include "ui/thunderbots/voltages_panel.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

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

/// Whether all curves have values for so long, up to now.
TourMaker::Done knownFor(const TourMaker& tour, Duration time) {
    return [window = tour.window(), bench = tour.bench(), time] {
        const ui::TimePlot& plot = window->findChild<ui::VoltagesPanel*>()->plot();
        const TimePoint now = bench->client().now();
        return std::ranges::all_of(plot.state().curves, [&](const ui::PlotCurve& curve) {
            return plot.valueAt(curve, now - time) && plot.valueAt(curve, plot.state().view.now());
        });
    };
}

void addCursors(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    tour.add("voltages-30-s", choose(window, "plotSpanMenu", QStringLiteral("30 s")));
    tour.show("voltages", tour.press("plotFollow"));
    // Data lie between the cursors.
    tour.add("voltages-10-s", choose(window, "plotSpanMenu", QStringLiteral("10 s")), knownFor(tour, 10s));
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
    // It has fired, and what came after it is drawn too.
    tour.show("voltages-trigger", tour.simulate("battery", kRobot, kAfter_V), [window, bench = tour.bench()] {
        const auto& trigger = window->findChild<ui::VoltagesPanel*>()->plot().state().trigger;
        return trigger->state == ui::PlotTrigger::State::Caught &&
               bench->client().now() > trigger->caughtAt + 2s;
    });
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
    for (const int robot : {2, 4, 5, 6, 8, 9, 11, 13, 14, 15})
        tour.add("pin", choose(window, "plotRobotsMenu", QStringLiteral("Robot %1").arg(robot)));
    tour.show("voltages-sixteen", choose(window, "plotSpanMenu", QStringLiteral("30 s")));
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

void addGapSteps(TourMaker& tour) {
    ui::Bench* bench = tour.bench();
    tour.add("gap-span", choose(tour.window(), "plotSpanMenu", QStringLiteral("30 s")));
    tour.add(
        "gap-lasts", [] {}, tour.whenRobot([bench](const RobotState& robot) {
            return robot.freshness == Freshness::Stale && bench->client().now() > robot.currentUntil + 3s;
        }));
    tour.add("gap-ends", tour.simulate("dead", kRobot, 0),
             tour.whenRobot([](const RobotState& robot) { return robot.freshness == Freshness::Current; }));
    tour.show("voltages-gap", tour.press("plotFollow"), knownFor(tour, 2s));
}

}  // namespace kickstand::app
