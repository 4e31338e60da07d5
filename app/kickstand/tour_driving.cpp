#include <QSize>

#include "app/kickstand/tour_maker.h"
#include "ui/shell/workbench.h"
#include "ui/widgets/set_point_slider.h"
#include "ui/widgets/signed_spin_box.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

constexpr QSize kSmall(1280, 800);
constexpr QSize kUsual(1440, 900);

TourMaker::Act set(ui::MainWindow* window, const char* slider, int value) {
    return [window, slider, value] {
        window->findChild<ui::SetPointSlider*>(QLatin1String(slider))->field()->setValue(value);
    };
}

/// A window of this size, then its panels where a new user has them.
void addSize(TourMaker& tour, const char* name, QSize size) {
    ui::MainWindow* window = tour.window();
    tour.add(name, [window, size] { window->resize(size); });
    tour.add(name, [window] { window->workbench().resetLayout(); });
}

/// All sixteen are up to something.
void addBusyRobots(TourMaker& tour) {
    ui::Bench* bench = tour.bench();
    tour.add(
        "busy",
        [bench] {
            for (const int robot : {2, 11})
                bench->submit(SimPerform{"ball", robot, 1});
            for (const auto& [robot, volts] : {std::pair{7, 14.5}, {12, 13.7}, {14, 14.9}})
                bench->submit(SimPerform{"battery", robot, volts});
            const auto ask = [bench](const thunderbots::Command& command) {
                bench->submit(SystemCommand{command});
            };
            ask(ArmHighVoltage{kAllRobots, true});
            ask(SetCharger{static_cast<RobotMask>(maskOf(2) | maskOf(11) | maskOf(12)), true});
            ask(SetAutokick{maskOf(11), true, {true, true, 75, 0, 0}});
            ask(SetDribbler{static_cast<RobotMask>(maskOf(11) | maskOf(12)), true});
            ask(SetWheels{maskOf(12), {20, 20, 20, 20}, false});
            bench->submit(SimPerform{"capacitor", 5, 212});
        },
        tour.when([](const Snapshot& snapshot) {
            return snapshot.robots[12].told && snapshot.robots[12].told->dribble &&
                   snapshot.robots[5].readings.capacitor_V > 200;
        }));
}

}  // namespace

void addDrivingSteps(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    tour.add("body-mode", tour.press("bodyMode"));
    tour.add("body-x", set(window, "bodyX", 150));
    tour.show("body", set(window, "bodyTurn", 1200), tour.whenRobot([](const RobotState& robot) {
        return robot.told && robot.told->wheels[3] > 90;
    }));
    tour.add("zero", tour.press("zero"),
             tour.whenRobot([](const RobotState& robot) { return robot.told->wheels[3] == 0; }));
    tour.add("wheel-mode", tour.press("wheelMode"));
}

void addSmallSteps(TourMaker& tour) {
    ui::Bench* bench = tour.bench();
    const auto rearmed = [bench] { return !bench->client().isStopped(); };
    tour.add(
        "small-re-arm", [bench] { bench->client().rearm(); }, rearmed);
    addSize(tour, "small-size", kSmall);
    addBusyRobots(tour);
    tour.show("small-busy", tour.goTo("drive"));
    tour.show("small-gamepad", tour.goTo("gamepad"));
    tour.show("small-checks", tour.goTo("checks"));
    tour.show("small-firmware", tour.goTo("firmware"));
    tour.show("small-parameters", tour.goTo("parameters"));
    tour.add("small-kick-panel", tour.goTo("kick"));
    tour.show("small-kick", tour.goTo("kicks"));
    tour.show("small-experiment", tour.goTo("experiment"));
    tour.add("small-voltages", tour.goTo("voltages"));
    tour.add("small-drive", tour.goTo("drive"));
    tour.show("small-lost", tour.simulate("dead", 5, 1), [bench] {
        const Snapshot* snapshot = ui::snapshotOf(bench->session());
        return bench->client().isStopped() && snapshot != nullptr && !snapshot->robots[5].live;
    });
    tour.add("small-found", tour.simulate("dead", 5, 0),
             tour.when([](const Snapshot& snapshot) { return snapshot.robots[5].live; }));
    addSize(tour, "usual-size", kUsual);
}

}  // namespace kickstand::app
