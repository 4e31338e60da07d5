#include <QComboBox>
#include <QSpinBox>
#include <chrono>

#include "app/kickstand/tour_maker.h"
#include "core/link/link_uri.h"
#include "ui/motionplan/motionplan_view.h"

namespace kickstand::app {

namespace {

using motionplan::Snapshot;

struct TourMovement {
    const char* name;  ///< Of the step of the tour.
    int way;           ///< The entry of the editor's list.
    int amount;
};
constexpr TourMovement kMovements[] = {
    {"plan-1", 0, 50}, {"plan-2", 2, 90}, {"plan-3", 0, 200}, {"plan-4", 3, 84}, {"plan-5", 1, 38}};
constexpr int kPlan = 9;

TourMaker::Done whenPlan(ui::Bench* bench, bool (*holds)(const Snapshot&)) {
    return [bench, holds] {
        const Snapshot* const snapshot = ui::planSnapshotOf(bench->session());
        return snapshot != nullptr && holds(*snapshot);
    };
}

void addEditing(TourMaker& tour) {
    for (const TourMovement& movement : kMovements) {
        tour.add(movement.name, [window = tour.window(), movement] {
            window->findChild<QComboBox*>(QStringLiteral("planWay"))->setCurrentIndex(movement.way);
            window->findChild<QSpinBox*>(QStringLiteral("planAmount"))->setValue(movement.amount);
            window->findChild<QAbstractButton*>(QStringLiteral("planAdd"))->click();
        });
    }
    tour.show("plan-editor", [window = tour.window()] {
        window->findChild<QSpinBox*>(QStringLiteral("planId"))->setValue(kPlan);
    });
}

/// Well within the third step.
bool isUnderWay(const Snapshot& snapshot) {
    constexpr Duration kWithin = std::chrono::seconds(3);
    const motionplan::Execution& execution = snapshot.execution;
    return execution.step > 3 || (execution.step == 3 && snapshot.time - execution.stepAt >= kWithin);
}

void addRunning(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    tour.add("plan-query", tour.press("planQuery"), whenPlan(bench, [](const Snapshot& snapshot) {
                 return snapshot.trigger.known && snapshot.slotStates[4].known;
             }));
    tour.add("plan-send", tour.press("planSend4"),
             whenPlan(bench, [](const Snapshot& snapshot) { return snapshot.slotStates[4].plan == kPlan; }));
    tour.show("plan-executing", tour.press("planExecute4"), whenPlan(bench, isUnderWay));
    tour.add("plan-stop", tour.press("planStop"), whenPlan(bench, [](const Snapshot& snapshot) {
                 return !snapshot.active() && snapshot.stopConfirmedAt != TimePoint{};
             }));
    tour.show("plan-out-of-reach", tour.simulate("plugged", -1, 0),
              whenPlan(bench, [](const Snapshot& snapshot) { return snapshot.outOfReach; }));
}

}  // namespace

void addMotionplanSteps(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    tour.add(
        "plan-re-arm", [bench] { bench->client().rearm(); },
        [bench] { return !bench->client().isStopped(); });
    tour.add(
        "plan-connect", [bench] { bench->connectTo(*parseLinkUri("sim:motionplan")); },
        whenPlan(bench, [](const Snapshot& snapshot) { return snapshot.answers; }));
    addEditing(tour);
    addRunning(tour);
    tour.add(
        "plan-disconnect", [bench] { bench->disconnectAll(); },
        [bench] { return bench->session() == nullptr; });
}

}  // namespace kickstand::app
