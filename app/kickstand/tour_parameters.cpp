#include <QCheckBox>
#include <QMessageBox>
#include <QSpinBox>
#include <QTreeWidget>

#include "app/kickstand/tour_maker.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

/// Another one than the tour's own, whose capacitor is charged by now.
constexpr std::size_t kDischarged = 5;

TourMaker::Done stands(TourMaker& tour, ParameterStanding standing) {
    return tour.when([standing](const Snapshot& snapshot) {
        return snapshot.parameters[kDischarged].standing == standing && !snapshot.requests[kDischarged].op;
    });
}

TourMaker::Act type(ui::MainWindow* window, const char* field, int value) {
    return [window, field, value] { window->findChild<QSpinBox*>(QLatin1String(field))->setValue(value); };
}

void addDraft(TourMaker& tour) {
    tour.add("choose-another", tour.press("robot5"));
    tour.add("parameters-panel", tour.goTo("parameters"));
    tour.add("read-parameters", tour.press("parameterRead"), tour.when([](const Snapshot& snapshot) {
        return snapshot.parameters[kDischarged].signatures.has_value();
    }));
    tour.add("draft-duty", type(tour.window(), "draft_dribbler_duty", 200));
    tour.show("parameters", type(tour.window(), "draft_robot_number", 4));
}

void addQuestion(TourMaker& tour) {
    const auto question = [window = tour.window()] {
        return window->findChild<QMessageBox*>(QStringLiteral("parameterQuestion"));
    };
    tour.showOver(
        "parameters-question", tour.press("parameterApply"),
        [question] { return question() != nullptr && question()->isVisible(); }, question);
    tour.add("parameters-do-not", tour.press("parameterNo"),
             [question] { return question() == nullptr || !question()->isVisible(); });
    tour.add("parameters-untick", [window = tour.window()] {
        window->findChild<QCheckBox*>(QStringLiteral("apply_robot_number"))->setChecked(false);
    });
}

void addProof(TourMaker& tour) {
    tour.show("parameters-applied", tour.press("parameterApply"), stands(tour, ParameterStanding::Applied));
    tour.show("parameters-committed", tour.press("parameterCommit"),
              stands(tour, ParameterStanding::Committed));
    tour.add("parameters-reboot", tour.press("parameterReboot"), stands(tour, ParameterStanding::Proven));
    tour.add("parameters-reset", tour.press("parameterReset"));
    tour.add("parameters-history", tour.press("parameterHistoryPage"));
    tour.show("parameters-earlier", [window = tour.window()] {
        auto* list = window->findChild<QTreeWidget*>(QStringLiteral("parameterHistory"));
        list->setCurrentItem(list->topLevelItem(list->topLevelItemCount() - 1));
    });
    tour.show("parameters-proven", tour.press("historyCompare"));
}

}  // namespace

void addParameterSteps(TourMaker& tour) {
    addDraft(tour);
    addQuestion(tour);
    addProof(tour);
    tour.add("choose-first", tour.press("robot3"));
    tour.add("from-parameters", tour.goTo("drive"));
}

}  // namespace kickstand::app
