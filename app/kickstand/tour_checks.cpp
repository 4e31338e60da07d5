#include <QAbstractButton>
#include <QSpinBox>

#include "app/kickstand/tour_maker.h"

namespace kickstand::app {

using namespace thunderbots;

namespace {

/// The tour's other robot is left as it is.
constexpr int kChecked = 6;

bool isAsked(const Snapshot& snapshot, CheckKind kind) {
    const CheckProgress& check = *snapshot.check;
    return check.stage == CheckStage::Asking && !check.rows.empty() &&
           check.rows[check.current].step.kind == kind;
}

/// Says yes to everything, as it is asked, until the check is through.
TourMaker::Done throughWithYes(ui::MainWindow* window, const TourMaker::Done& ended) {
    return [window, ended] {
        auto* yes = window->findChild<QAbstractButton*>(QStringLiteral("checksYes"));
        if (yes->isEnabled()) yes->click();
        return ended();
    };
}

}  // namespace

void addCheckSteps(TourMaker& tour) {
    ui::MainWindow* window = tour.window();
    tour.add("checks-panel", tour.goTo("checks"));
    tour.add("checks-choose", tour.press("robot6"));
    tour.add("checks-quick", [window] {
        window->findChild<QSpinBox*>(QStringLiteral("checks_run_s"))->setValue(5);
        for (const char* const part : {"checks_leds", "checks_kicker"})
            window->findChild<QAbstractButton*>(QLatin1String(part))->setChecked(false);
    });
    tour.show("check-begins", tour.press("checksStart"),
              tour.when([](const Snapshot& snapshot) { return isAsked(snapshot, CheckKind::Ready); }));
    tour.show("check-asks", tour.press("checksYes"),
              tour.when([](const Snapshot& snapshot) { return isAsked(snapshot, CheckKind::Wheel); }));
    const auto ended = tour.when([](const Snapshot& snapshot) { return !snapshot.check->running(); });
    tour.show(
        "check-report", [] {}, throughWithYes(window, ended));
    tour.add("checks-back", tour.press("robot3"));
    tour.add("checks-drive", tour.goTo("drive"));
}

}  // namespace kickstand::app
