#include <QSpinBox>
#include <algorithm>

#include "app/kickstand/tour_maker.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

constexpr int kRobot = TourMaker::kRobot;

TourMaker::Act type(ui::MainWindow* window, const char* field, int value) {
    return [window, field, value] { window->findChild<QSpinBox*>(QLatin1String(field))->setValue(value); };
}

bool isMeasured(const KickRecord& kick, KickCause cause) {
    return kick.cause == cause && kick.measure == KickMeasure::Recharged;
}

bool isLastMeasured(const Snapshot& snapshot, KickCause cause) {
    return !snapshot.kicks->empty() && isMeasured(snapshot.kicks->back(), cause);
}

bool isSweepUnderWay(const Snapshot& snapshot) {
    return snapshot.sweep && snapshot.sweep->given >= 3 &&
           std::ranges::any_of(*snapshot.kicks,
                               [](const KickRecord& kick) { return isMeasured(kick, KickCause::Sweep); });
}

void addKick(TourMaker& tour) {
    tour.add("kick-panel", tour.goTo("kick"));
    tour.add("kicks-panel", tour.goTo("kicks"));
    tour.add("kick-width-1", type(tour.window(), "kickWidth1", 2400));
    tour.add("kick-width-2", type(tour.window(), "kickWidth2", 1280));
    tour.add("kick-offset", type(tour.window(), "kickOffset", 384));
    tour.show("kick", tour.press("kickFirst"),
              tour.when([](const Snapshot& snapshot) { return isLastMeasured(snapshot, KickCause::Asked); }));
}

void addSweep(TourMaker& tour) {
    tour.add("sweep-without-chip", type(tour.window(), "kickWidth2", 0));
    tour.show("sweep", tour.press("sweepStart"), tour.when(isSweepUnderWay));
    tour.add("sweep-stop", tour.press("sweepStop"), tour.when([](const Snapshot& snapshot) {
        return !snapshot.sweep->running() && isLastMeasured(snapshot, KickCause::Sweep);
    }));
}

void addAutokick(TourMaker& tour) {
    // The ball lies in the beam.
    tour.show("autokick", tour.press("autokick"), tour.when([](const Snapshot& snapshot) {
        return snapshot.intents[kRobot].autokick && isLastMeasured(snapshot, KickCause::Autokick);
    }));
    tour.add("autokick-off", tour.press("autokick"),
             tour.when([](const Snapshot& snapshot) { return !snapshot.intents[kRobot].autokick; }));
    tour.add("voltages-panel", tour.goTo("voltages"));
    tour.add("back-to-drive", tour.goTo("drive"));
}

}  // namespace

void addKickingSteps(TourMaker& tour) {
    addKick(tour);
    addSweep(tour);
    addAutokick(tour);
}

}  // namespace kickstand::app
