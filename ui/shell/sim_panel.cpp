#include "ui/shell/sim_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/shell/sim_action_control.h"
#include "ui/shell/system_view.h"
#include "ui/widgets/flow_layout.h"
#include "ui/widgets/tokens.h"
#include "ui/widgets/wide_scroll.h"

namespace kickstand::ui {

namespace {

QLabel* heading(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setFont(textFont(metrics::kSmallTextSize));
    label->setForegroundRole(QPalette::PlaceholderText);
    return label;
}

/// Takes away everything that a widget shows.
void clean(QWidget* place) {
    qDeleteAll(place->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly));
    delete place->layout();
}

FlowLayout* makeFlow(QWidget* place) {
    auto* flow = new FlowLayout(place);
    flow->setContentsMargins(0, 0, 0, 0);
    flow->setSpacing(metrics::kGap);
    return flow;
}

}  // namespace

SimPanel::SimPanel(Bench& bench, QWidget* parent)
    : Panel(bench, parent),
      units_(new QWidget(this)),
      shared_(new QWidget(this)),
      hint_(new QLabel(this)),
      notice_(new QLabel(this)) {
    hint_->setForegroundRole(QPalette::PlaceholderText);
    hint_->setObjectName(QStringLiteral("simHint"));
    notice_->setObjectName(QStringLiteral("simNotice"));
    notice_->setWordWrap(true);
    auto* area = new QScrollArea(this);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->viewport()->setAutoFillBackground(false);
    auto* content = new QWidget(area);
    auto* inside = new QVBoxLayout(content);
    inside->setContentsMargins(0, 0, 0, 0);
    inside->setSpacing(metrics::kGap);
    inside->addWidget(hint_);
    inside->addWidget(units_);
    inside->addWidget(shared_);
    inside->addStretch(1);
    area->setWidget(content);
    content->setAutoFillBackground(false);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kGap, 4);
    column->addWidget(area, 1);
    column->addWidget(notice_);
    connect(&bench, &Bench::changed, this, &SimPanel::refresh);
    refresh();
}

SimPanel::Shape SimPanel::shapeNow() const {
    Shape shape;
    const SessionSnapshot* session = bench().session();
    if (session == nullptr || !session->uri.isSimulated() || bench().view() == nullptr) return shape;
    shape.session = session->id;
    shape.actions = session->simActions;
    for (const int unit : bench().view()->chosenUnits()) {
        if (std::find(session->simUnits.begin(), session->simUnits.end(), unit) != session->simUnits.end())
            shape.units.push_back(unit);
    }
    for (const int unit : shape.units) {
        std::vector<bool>& has = shape.has.emplace_back();
        for (const SimAction& action : shape.actions)
            has.push_back(hasAction(*session, action, unit));
    }
    return shape;
}

void SimPanel::refresh() {
    Shape now = shapeNow();
    if (now != shape_) {
        shape_ = std::move(now);
        build();
    }
    if (shape_.session == 0 || !isVisible()) return;
    for (const auto& [key, control] : controls_) {
        std::optional<double> value;
        for (const SimReading& reading : bench().session()->simReadings) {
            if (reading.action == key.first && reading.unit == key.second) value = reading.value;
        }
        control->showValue(value);
    }
}

void SimPanel::build() {
    controls_.clear();
    notice_->clear();
    notice_->hide();
    const bool simulated = shape_.session != 0;
    hint_->setVisible(shape_.units.empty());
    hint_->setText(simulated ? tr("Choose at the left whom to do something to: each gets a row here.")
                             : tr("There is nothing to do by hand where robots are real."));
    setNote(simulated ? tr("from outside the wire") : QString());
    addUnits();
    addShared();
}

void SimPanel::addUnits() {
    clean(units_);
    units_->setVisible(!shape_.units.empty());
    if (shape_.units.size() == 1) addOneUnit();
    if (shape_.units.size() > 1) addTable();
}

/// One has the panel's whole width, in as many lines as that takes.
void SimPanel::addOneUnit() {
    FlowLayout* flow = makeFlow(units_);
    flow->addWidget(unitName(shape_.units.front()));
    for (std::size_t at = 0; at < shape_.actions.size(); ++at) {
        if (shape_.actions[at].perUnit && shape_.has.front()[at])
            flow->addWidget(addField(shape_.actions[at], shape_.units.front()));
    }
}

/// Several are compared: a row each, a column for each action.
void SimPanel::addTable() {
    auto* table = new QWidget;
    auto* grid = new QGridLayout(table);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(metrics::kPadding);
    grid->setVerticalSpacing(6);
    int column = 1;
    for (std::size_t at = 0; at < shape_.actions.size(); ++at) {
        const SimAction& action = shape_.actions[at];
        const bool any =
            std::any_of(shape_.has.begin(), shape_.has.end(), [at](const auto& has) { return has[at]; });
        if (!action.perUnit || !any) continue;
        grid->addWidget(heading(bench().view()->actionText(action), units_), 0, column);
        for (std::size_t unit = 0; unit < shape_.units.size(); ++unit) {
            if (shape_.has[unit][at])
                grid->addWidget(add(action, shape_.units[unit]), static_cast<int>(unit) + 1, column);
        }
        ++column;
    }
    int row = 1;
    for (const int unit : shape_.units)
        grid->addWidget(unitName(unit), row++, 0);
    grid->setColumnStretch(column, 1);
    auto* around = new QVBoxLayout(units_);
    around->setContentsMargins(0, 0, 0, 0);
    around->addWidget(new WideScroll(table, units_));
}

void SimPanel::addShared() {
    clean(shared_);
    shared_->setVisible(shape_.session != 0);
    FlowLayout* flow = makeFlow(shared_);
    for (const SimAction& action : shape_.actions) {
        if (!action.perUnit) flow->addWidget(addField(action, -1));
    }
}

QLabel* SimPanel::unitName(int unit) const {
    auto* name = new QLabel(bench().view()->unitText(unit), units_);
    name->setFont(textFont(metrics::kTextSize, QFont::DemiBold));
    return name;
}

QWidget* SimPanel::addField(const SimAction& action, int unit) {
    auto* field = new QWidget(unit < 0 ? shared_ : units_);
    auto* column = new QVBoxLayout(field);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(heading(bench().view()->actionText(action), field));
    column->addWidget(add(action, unit));
    return field;
}

SimActionControl* SimPanel::add(const SimAction& action, int unit) {
    const SystemView& view = *bench().view();
    const QString what = view.actionText(action);
    const QString name = unit < 0 ? what : tr("%1, %2").arg(what, view.unitText(unit));
    auto* control =
        new SimActionControl(action, view.actionChoices(action), name, unit < 0 ? shared_ : units_);
    const QString id = QLatin1String("sim-") + QString::fromStdString(action.name);
    control->setObjectName(unit < 0 ? id : QStringLiteral("%1-%2").arg(id).arg(unit));
    connect(control, &SimActionControl::asked, this,
            [this, action, unit](double value) { perform(action, unit, value); });
    controls_[{action.name, unit}] = control;
    return control;
}

void SimPanel::perform(const SimAction& action, int unit, double value) {
    bench().submit(SimPerform{action.name, unit, value}, this,
                   [this](const Result<void>& result) { showAnswer(result); });
}

void SimPanel::showAnswer(const Result<void>& result) {
    notice_->setVisible(!result.has_value());
    notice_->setText(result ? QString() : describe(result.error()).line());
}

}  // namespace kickstand::ui
