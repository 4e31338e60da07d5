#include <QComboBox>
#include <QLineEdit>
#include <QTableView>

#include "app/kickstand/tour_maker.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

/// Chooses an entry of a list as a person does.
TourMaker::Act choose(ui::MainWindow* window, const char* list, int index) {
    return [window, list, index] {
        auto* box = window->findChild<QComboBox*>(QLatin1String(list));
        box->setCurrentIndex(index);
        emit box->activated(index);
    };
}

void addLeds(TourMaker& tour) {
    tour.add("led-class", choose(tour.window(), "ledClass", static_cast<int>(wire::TestClass::Encoder)),
             tour.whenRobot([](const RobotState& robot) {
                 return robot.toldTestMode && robot.toldTestMode->testClass == wire::TestClass::Encoder;
             }));
    tour.show("leds", choose(tour.window(), "ledTarget", 1), tour.whenRobot([](const RobotState& robot) {
        return robot.toldTestMode == wire::TestMode{wire::TestClass::Encoder, 2};
    }));
}

void addExperiment(TourMaker& tour) {
    tour.add("experiment-panel", tour.goTo("experiment"));
    tour.show("experiment", tour.simulate("experiment", TourMaker::kRobot, 1),
              tour.whenRobot([](const RobotState& robot) { return robot.experiment.known.all(); }));
}

/// Clears what has arrived while the rest is still on its way: what came first is missing then. Once more
/// where that was too late.
TourMaker::Done withTheFirstPiecesCleared(TourMaker& tour) {
    const auto clear = tour.press("experimentClear");
    const auto send = tour.simulate("experiment", TourMaker::kRobot, 1);
    return tour.whenRobot([clear, send](const RobotState& robot) {
        const auto& known = robot.experiment.known;
        const bool early = known.test(0) && known.count() <= 2 * wire::kExperimentPieceBytes;
        if (early || known.all()) clear();
        if (known.all()) send();
        return !known.test(0) && known.test(known.size() - 1);
    });
}

void addExperimentGap(TourMaker& tour) {
    tour.add("experiment-clear", tour.press("experimentClear"),
             tour.whenRobot([](const RobotState& robot) { return robot.experiment.known.none(); }));
    tour.show("experiment-gap", tour.simulate("experiment", TourMaker::kRobot, 1),
              withTheFirstPiecesCleared(tour));
}

void addFaults(TourMaker& tour) {
    tour.add("dongle-error", tour.simulate("error", -1, 44),
             tour.when([](const Snapshot& snapshot) { return snapshot.traffic.dongleErrors > 0; }));
    tour.show("fault-code", tour.goTo("faults#dongle-44"));
}

void addSimulated(TourMaker& tour) {
    tour.show("simulated-robots", tour.goTo("simulated"));
}

QWidget* doctorOf(ui::MainWindow* window) {
    return window->findChild<QWidget*>(QStringLiteral("doctor"));
}

void addDoctor(TourMaker& tour) {
    tour.showWindow(
        "doctor", [window = tour.window()] { window->showDoctor(); }, TourMaker::always,
        [window = tour.window()] { return doctorOf(window); });
    tour.add("close-doctor", [window = tour.window()] { doctorOf(window)->close(); });
    tour.add("normal-lights", tour.press("ledNormal"));
    tour.add("drive-panel", tour.goTo("drive"));
}

}  // namespace

void addForbiddenSteps(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    TourBus* bus = tour.bus();
    tour.add("forbidden-dongle", [bus] { bus->forbiddenDongle = true; });
    tour.showWindow(
        "doctor-remedy", tour.press("startDoctor"),
        [window] {
            const auto* line = doctorOf(window)->findChild<QWidget*>(QStringLiteral("doctor-permission"));
            return line != nullptr &&
                   line->findChild<QAbstractButton*>(QStringLiteral("copyCommand"))->isVisible();
        },
        [window] { return doctorOf(window); });
    tour.add("close-doctor-remedy", [window, bus] {
        bus->forbiddenDongle = false;
        doctorOf(window)->close();
    });
}

void addLookingSteps(TourMaker& tour) {
    addLeds(tour);
    addExperiment(tour);
    addExperimentGap(tour);
    addFaults(tour);
    addSimulated(tour);
    addDoctor(tour);
}

}  // namespace kickstand::app
