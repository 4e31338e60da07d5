#include "ui/thunderbots/voltages_trigger.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr double kFarthest = 1e5;
constexpr int kLevelWidth = 92;
/// Where nothing is known better a level lies at this part of the usual range.
constexpr double kFirstLevel = 0.6;

}  // namespace

VoltagesTrigger::VoltagesTrigger(QWidget* parent)
    : QWidget(parent),
      curve_(new QComboBox(this)),
      edge_(new QComboBox(this)),
      level_(new QDoubleSpinBox(this)),
      arm_(new QPushButton(tr("Wait"), this)),
      state_(new QLabel(this)) {
    curve_->setObjectName(QStringLiteral("triggerCurve"));
    curve_->setAccessibleName(tr("Curve to wait for"));
    edge_->setObjectName(QStringLiteral("triggerEdge"));
    edge_->setAccessibleName(tr("Which way it crosses the level"));
    edge_->addItem(tr("rises to"), static_cast<int>(Edge::Rising));
    edge_->addItem(tr("falls to"), static_cast<int>(Edge::Falling));
    level_->setObjectName(QStringLiteral("triggerLevel"));
    level_->setAccessibleName(tr("Level"));
    level_->setRange(-kFarthest, kFarthest);
    level_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    level_->setFont(numberFont(metrics::kTextSize));
    level_->setFixedWidth(kLevelWidth);
    level_->setAlignment(Qt::AlignRight);
    arm_->setObjectName(QStringLiteral("triggerArm"));
    arm_->setAutoDefault(false);
    arm_->setToolTip(tr("Stands still with the next crossing in the middle. Recording goes on."));
    state_->setObjectName(QStringLiteral("triggerState"));
    state_->setForegroundRole(QPalette::PlaceholderText);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, 4, metrics::kPadding, 4);
    row->setSpacing(metrics::kGap);
    row->addWidget(new QLabel(tr("Freeze when"), this));
    for (QWidget* widget : {static_cast<QWidget*>(curve_), static_cast<QWidget*>(edge_),
                            static_cast<QWidget*>(level_), static_cast<QWidget*>(arm_)}) {
        row->addWidget(widget);
    }
    row->addWidget(state_, 1);
    connect(curve_, &QComboBox::currentIndexChanged, this, &VoltagesTrigger::chooseCurve);
    connect(arm_, &QPushButton::clicked, this, &VoltagesTrigger::arm);
    setState({}, false);
}

void VoltagesTrigger::setCurves(const std::vector<PlotCurve>& curves, const std::vector<PlotArea>& areas) {
    const QString before = curve_->currentText();
    curves_ = curves;
    areas_ = areas;
    {
        const QSignalBlocker quiet(curve_);
        curve_->clear();
        for (const PlotCurve& curve : curves_)
            curve_->addItem(curve.name);
        curve_->setCurrentIndex(std::max(curve_->findText(before), curves_.empty() ? -1 : 0));
    }
    arm_->setEnabled(!curves_.empty());
    if (curve_->currentText() != before) area_ = -1;
    chooseCurve();
}

void VoltagesTrigger::chooseCurve() {
    if (curve_->currentIndex() < 0) return;
    const PlotCurve& curve = curves_[static_cast<std::size_t>(curve_->currentIndex())];
    const PlotArea& area = areas_[static_cast<std::size_t>(curve.area)];
    level_->setSuffix(u' ' + area.unit);
    level_->setDecimals(area.decimals);
    level_->setSingleStep(area.usual.size() / 50);
    if (area_ == curve.area) return;
    // Another quantity: the level of the one before means nothing.
    area_ = curve.area;
    level_->setValue(area.usual.low + area.usual.size() * kFirstLevel);
}

void VoltagesTrigger::arm() {
    if (curve_->currentIndex() < 0) return;
    emit armed(curves_[static_cast<std::size_t>(curve_->currentIndex())].signal,
               static_cast<Edge>(edge_->currentData().toInt()), level_->value());
}

void VoltagesTrigger::setState(const QString& state, bool waiting) {
    state_->setText(state);
    arm_->setText(state.isEmpty() ? tr("Wait") : waiting ? tr("Wait anew") : tr("Wait again"));
}

}  // namespace kickstand::ui
