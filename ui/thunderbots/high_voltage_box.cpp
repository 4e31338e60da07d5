#include "ui/thunderbots/high_voltage_box.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/thunderbots/capacitor_readout.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

QString nameOf(const QString& owner, const QString& name) {
    return owner.isEmpty() ? name : owner + name.at(0).toUpper() + name.mid(1);
}

QPushButton* toggle(const QString& text, const QString& name, const QString& tip, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(name);
    button->setCheckable(true);
    button->setAutoDefault(false);
    button->setToolTip(tip);
    return button;
}

}  // namespace

HighVoltageBox::HighVoltageBox(const QString& owner, QWidget* parent)
    : QWidget(parent),
      readout_(new CapacitorReadout(this)),
      arm_(toggle(
          tr("Arm high voltage"), nameOf(owner, QStringLiteral("arm")),
          tr("Charging, kicking and discharging need this. Disarming switches the charger and autokick off."),
          this)),
      charger_(toggle(tr("Charger"), nameOf(owner, QStringLiteral("charger")),
                      tr("Charges the kicker's capacitor to 219 V."), this)),
      discharge_(toggle(
          tr("Discharge"), nameOf(owner, QStringLiteral("discharge")),
          tr("Empties the capacitor with pulses of 96 \u00b5s until 25 V. Take the ball away first."), this)),
      why_(new QLabel(this)) {
    why_->setObjectName(nameOf(owner, QStringLiteral("highVoltageWhy")));
    why_->setForegroundRole(QPalette::PlaceholderText);
    why_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    column->addWidget(readout_);
    column->addSpacing(4);
    column->addWidget(arm_);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    row->addWidget(charger_, 1);
    row->addWidget(discharge_, 1);
    column->addLayout(row);
    column->addWidget(why_);
    column->addStretch(1);
    connect(arm_, &QPushButton::clicked, this, &HighVoltageBox::armAsked);
    connect(charger_, &QPushButton::clicked, this, &HighVoltageBox::chargerAsked);
    connect(discharge_, &QPushButton::clicked, this, &HighVoltageBox::dischargeAsked);
    refreshUsable();
}

void HighVoltageBox::showState(const ChoiceSummary& summary, TimePoint now, bool buttons) {
    readout_->showState(summary, now);
    armed_ = summary.armed == All::Every;
    arm_->setText(armed_                       ? tr("High voltage armed")
                  : summary.armed == All::Some ? tr("Arm high voltage (some are)")
                                               : tr("Arm high voltage"));
    discharge_->setText(summary.discharging == All::None ? tr("Discharge") : tr("Discharging\u2026"));
    if (buttons) {
        arm_->setChecked(armed_);
        charger_->setChecked(summary.charger == All::Every);
        discharge_->setChecked(summary.discharging != All::None);
    }
    refreshUsable();
}

void HighVoltageBox::setObstacle(const QString& reason) {
    obstacle_ = reason;
    refreshUsable();
}

void HighVoltageBox::refreshUsable() {
    const bool usable = obstacle_.isEmpty();
    arm_->setEnabled(usable);
    charger_->setEnabled(usable && armed_);
    discharge_->setEnabled(usable && armed_);
    why_->setText(!usable   ? obstacle_
                  : !armed_ ? tr("To charge, kick or discharge, arm the high voltage first.")
                            : QString());
    why_->setVisible(!why_->text().isEmpty());
}

}  // namespace kickstand::ui
