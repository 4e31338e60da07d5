#include "ui/shell/sim_menu.h"

#include <QInputDialog>
#include <QMenu>
#include <algorithm>

#include "ui/shell/bench.h"
#include "ui/shell/sim_action_control.h"
#include "ui/shell/system_view.h"

namespace kickstand::ui {

SimMenu::SimMenu(Bench& bench, QWidget* parent) : QPushButton(parent), bench_(bench), menu_(new QMenu(this)) {
    setObjectName(QStringLiteral("simMenu"));
    setText(tr("Si&mulate"));
    setToolTip(tr("Do something to the simulated robots: a ball, a battery, a pulled plug."));
    setAutoDefault(false);
    setMenu(menu_);
    connect(menu_, &QMenu::aboutToShow, this, &SimMenu::fill);
}

void SimMenu::fill() {
    menu_->clear();
    const SessionSnapshot* session = bench_.session();
    if (session == nullptr) return;
    const std::vector<int> units = bench_.view()->chosenUnits();
    const bool chosen = !units.empty();
    menu_->addSection(chosen ? tr("Those that are chosen") : tr("Choose one first"));
    for (const SimAction& action : session->simActions) {
        const bool has = std::any_of(units.begin(), units.end(),
                                     [&](int unit) { return hasAction(*session, action, unit); });
        if (action.perUnit && (has || !chosen)) addAction(action);
    }
    for (QAction* action : menu_->actions())
        action->setEnabled(chosen);
    menu_->addSection(tr("Everything"));
    for (const SimAction& action : session->simActions) {
        if (!action.perUnit) addAction(action);
    }
}

void SimMenu::addAction(const SimAction& action) {
    const SystemView& view = *bench_.view();
    const auto choices = view.actionChoices(action);
    if (choices.empty()) {
        menu_->addAction(tr("%1\u2026").arg(view.actionText(action)), this, [this, action] { ask(action); });
        return;
    }
    QMenu* values = menu_->addMenu(view.actionText(action));
    for (const auto& [name, value] : choices) {
        values->addAction(name, this, [this, action, chosen = value] { perform(action, chosen); });
    }
}

void SimMenu::ask(const SimAction& action) {
    auto* dialog = new QInputDialog(window());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setInputMode(QInputDialog::DoubleInput);
    dialog->setDoubleRange(action.lowest, action.highest);
    dialog->setDoubleDecimals(2);
    dialog->setWindowTitle(bench_.view()->actionText(action));
    dialog->setLabelText(tr("%1 (%2), %3 to %4")
                             .arg(bench_.view()->actionText(action), QString::fromStdString(action.unit))
                             .arg(action.lowest)
                             .arg(action.highest));
    connect(dialog, &QInputDialog::doubleValueSelected, this,
            [this, action](double value) { perform(action, value); });
    dialog->open();
}

void SimMenu::perform(const SimAction& action, double value) {
    if (!action.perUnit) {
        bench_.submit(SimPerform{action.name, -1, value});
        return;
    }
    const SessionSnapshot* session = bench_.session();
    if (session == nullptr || bench_.view() == nullptr) return;
    for (const int unit : bench_.view()->chosenUnits()) {
        if (hasAction(*session, action, unit)) bench_.submit(SimPerform{action.name, unit, value});
    }
}

}  // namespace kickstand::ui
