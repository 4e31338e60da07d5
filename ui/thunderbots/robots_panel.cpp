#include "ui/thunderbots/robots_panel.h"

#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <bit>
#include <chrono>

#include "ui/shell/bench.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/robot_grid.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/widgets/scrolled.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

RobotsPanel::RobotsPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent), choice_(choice), grid_(new RobotGrid(choice, this)), hint_(new QLabel(this)) {
    hint_->setWordWrap(true);
    hint_->setFont(textFont(metrics::kSmallTextSize));
    hint_->setForegroundRole(QPalette::PlaceholderText);
    hint_->setContentsMargins(4, 0, 4, 0);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kGap, metrics::kGap, metrics::kGap, metrics::kGap);
    column->setSpacing(6);
    // All sixteen fit on a screen of 800 pixels, under a title bar, while the hint is one line; below that
    // they scroll.
    QScrollArea* area = scrolled(grid_, this);
    area->setMinimumWidth(grid_->minimumSizeHint().width());
    column->addWidget(area, 1);
    column->addWidget(hint_);
    connect(&bench, &Bench::changed, this, &RobotsPanel::refresh);
    connect(&choice_, &RobotChoice::changed, this, &RobotsPanel::refresh);
    // Ages go on while nothing else happens.
    connect(&ages_, &QTimer::timeout, this, &RobotsPanel::refresh);
    ages_.start(std::chrono::seconds(1));
    refresh();
}

void RobotsPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    static const Snapshot nothing;
    const Snapshot& shown = snapshot == nullptr ? nothing : *snapshot;
    grid_->showState(shown, bench().client().now());
    const auto heard = static_cast<int>(
        std::count_if(shown.robots.begin(), shown.robots.end(), [](const auto& r) { return r.live; }));
    const int chosen = std::popcount(choice_.chosen());
    setNote(tr("%1 heard \u00b7 %2 chosen").arg(heard).arg(chosen));
    hint_->setText(hintFor(shown, heard));
}

QString RobotsPanel::hintFor(const Snapshot& snapshot, int heard) const {
    if (snapshot.link != LinkState::Running)
        return snapshot.connections == 0 ? tr("No link yet.")
                                         : tr("No link: last values before it was lost.");
    if (heard == 0) return tr("No robot is heard yet. Switch one on.");
    if (choice_.chosen() == 0) return tr("Click to choose, Ctrl-click to add, Ctrl+A for all.");
    return grid_->marks().oddOne < 0
               ? tr("Driving applies to all that are chosen.")
               : tr("Robot %1 is the only one %2.").arg(grid_->marks().oddOne).arg(grid_->marks().oddBy);
}

}  // namespace kickstand::ui
