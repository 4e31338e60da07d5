#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QSpinBox>

#include "app/kickstand/tour_maker.h"
#include "core/link/link_uri.h"
#include "ui/coach/coach_view.h"
#include "ui/coach/helm_pad.h"

namespace kickstand::app {

namespace {

using coach::CoachState;
using coach::LinkState;
using coach::Snapshot;
using coach::TowrpState;

constexpr int kBoat = 5;
/// Where the preset of a COACH stands in the list.
constexpr int kCoachPreset = 0;

/// Up and left, both gently.
constexpr coach::wire::Velocity kCourse{3, 3};

std::function<ui::HelmPad*()> helmOf(const TourMaker& tour) {
    return [window = tour.window()] { return window->findChild<ui::HelmPad*>(QStringLiteral("coachHelm")); };
}

TourMaker::Done whenCoach(ui::Bench* bench, bool (*holds)(const Snapshot&)) {
    return [bench, holds] {
        const Snapshot* const snapshot = ui::coachOf(bench->session());
        return snapshot != nullptr && holds(*snapshot);
    };
}

void connectTo(TourMaker& tour, const char* name, const char* uri, const char* panel, LinkState state) {
    ui::Bench* const bench = tour.bench();
    tour.add(
        name,
        [bench, uri, panel] {
            bench->connectTo(*parseLinkUri(uri));
            bench->goTo(QString::fromLatin1(panel));
        },
        [bench, state] {
            const Snapshot* const snapshot = ui::coachOf(bench->session());
            return snapshot != nullptr && snapshot->link == state;
        });
}

void leave(TourMaker& tour, const char* name) {
    tour.add(
        name, [bench = tour.bench()] { bench->disconnectAll(); },
        [bench = tour.bench()] { return bench->session() == nullptr; });
}

void addSteering(TourMaker& tour) {
    ui::Bench* const bench = tour.bench();
    connectTo(tour, "coach-connect", "sim:coach", "coach", LinkState::Running);
    tour.add("coach-start", tour.press("coachStart"), whenCoach(bench, [](const Snapshot& snapshot) {
                 return snapshot.coach.state == CoachState::Paired;
             }));
    // A panel shows a new state a moment after it has come.
    tour.add(
        "coach-helm", [] {}, [helm = helmOf(tour)] { return helm()->isEnabled(); });
    tour.show(
        "coach-steering",
        [helm = helmOf(tour)] {
            for (const Qt::Key key : {Qt::Key_Up, Qt::Key_Left}) {
                QKeyEvent press(QEvent::KeyPress, key, Qt::ShiftModifier);
                QApplication::sendEvent(helm(), &press);
            }
        },
        whenCoach(bench, [](const Snapshot& snapshot) {
            return snapshot.coach.answered == kCourse && snapshot.coach.sent == kCourse &&
                   snapshot.coach.morale < 0;
        }));
    // A mutiny lasts three seconds, in which a busy machine may get no further than its picture: then the
    // crew has the boat, and it is not paired in the end all the same.
    tour.show("coach-mutiny", tour.simulate("morale", kBoat, coach::wire::kMutinyMorale),
              whenCoach(bench, [](const Snapshot& snapshot) {
                  return snapshot.coach.mutiny || snapshot.coach.state == CoachState::NotPaired;
              }));
    for (const char* action : {"coachAction0", "coachAction1", "coachAction2"})
        tour.add(action, tour.press(action));
    tour.add(
        "coach-mutiny-over", [] {},
        whenCoach(bench, [](const Snapshot& snapshot) { return !snapshot.coach.mutiny; }));
    tour.add("coach-unlock", tour.press("coachMayJettison"));
    tour.show("coach-not-paired", tour.press("coachJettison"), whenCoach(bench, [](const Snapshot& snapshot) {
                  return snapshot.coach.state == CoachState::NotPaired && snapshot.coach.boats.size() == 3;
              }));
    leave(tour, "coach-disconnect");
}

void addBeingTheBoat(TourMaker& tour) {
    connectTo(tour, "towrp-connect", "sim:coach?address=0xAF05&coaches=4&towrps=", "towrp",
              LinkState::Running);
    tour.show("towrp-paired", tour.press("towrpStart"), whenCoach(tour.bench(), [](const Snapshot& snapshot) {
                  return snapshot.towrp.state == TowrpState::Paired && !snapshot.towrp.velocity.isZero() &&
                         snapshot.entries->size() > 8;
              }));
    leave(tour, "towrp-disconnect");
}

void addSettingUp(TourMaker& tour) {
    connectTo(tour, "radio-connect", "sim:coach?fresh=1", "radio", LinkState::NoModule);
    tour.add("radio-find", tour.press("radioFind"), whenCoach(tour.bench(), [](const Snapshot& snapshot) {
                 return snapshot.radio.has_value() && snapshot.link != LinkState::Setting;
             }));
    tour.show("radio-draft", [window = tour.window()] {
        window->findChild<QComboBox*>(QStringLiteral("radioPreset"))->setCurrentIndex(kCoachPreset);
        window->findChild<QSpinBox*>(QStringLiteral("radioNumber"))->setValue(kBoat);
        window->findChild<QAbstractButton*>(QStringLiteral("radioUse"))->click();
    });
    tour.show("radio-applied", tour.press("radioApply"),
              whenCoach(tour.bench(),
                        [](const Snapshot& snapshot) { return snapshot.link == LinkState::Running; }));
    leave(tour, "radio-disconnect");
}

}  // namespace

void addCoachSteps(TourMaker& tour) {
    addSteering(tour);
    addBeingTheBoat(tour);
    addSettingUp(tour);
}

}  // namespace kickstand::app
