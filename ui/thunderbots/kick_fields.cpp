#include "ui/thunderbots/kick_fields.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScopedValueRollback>
#include <QVBoxLayout>

#include "ui/thunderbots/kick_diagram.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kFieldFontSize = 15;
constexpr int kLeastWidth = 76;

}  // namespace

KickFields::KickFields(QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    width1_ = addField("kickWidth1", tr("Width 1, \u00b5s"), 0);
    width2_ = addField("kickWidth2", tr("Width 2, \u00b5s"), 0);
    offset_ = addField("kickOffset", tr("Solenoid 2 later by, \u00b5s"), -wire::kKickMax_us);
    offset_->setToolTip(tr("Negative: solenoid 1 is later. Goes to the nearest step of 32 \u00b5s."));
}

SignedSpinBox* KickFields::addField(const char* name, const QString& label, int lowest) {
    auto* field = new SignedSpinBox(this);
    field->setObjectName(QString::fromLatin1(name));
    field->setAccessibleName(label);
    field->setRange(lowest, wire::kKickMax_us);
    field->setSingleStep(wire::kKickStep_us);
    field->setFont(numberFont(kFieldFontSize));
    field->setMinimumWidth(kLeastWidth);
    field->setToolTip(tr("Goes to the nearest step of 32 \u00b5s."));
    auto* words = new QLabel(label, this);
    words->setBuddy(field);
    words->setFont(textFont(metrics::kSmallTextSize));
    words->setForegroundRole(QPalette::PlaceholderText);
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    column->addWidget(words);
    column->addWidget(field);
    static_cast<QHBoxLayout*>(layout())->addLayout(column, 1);
    connect(field, &QSpinBox::valueChanged, this, [this, field](int value) { changed(field, value); });
    return field;
}

void KickFields::showPulses(const wire::KickPulses& pulses) {
    const QScopedValueRollback telling(telling_, true);
    width1_->showValue(pulses.width1_us);
    width2_->showValue(pulses.width2_us);
    offset_->showValue(pulses.offset_us);
}

void KickFields::changed(SignedSpinBox* field, int value) {
    if (telling_) return;
    const int snapped_us = onGrid(value);
    emit snapped(snapped_us == value
                     ? QString()
                     : tr("%1 \u2192 %2 \u00b5s").arg(signedNumber(value), signedNumber(snapped_us)));
    {
        const QScopedValueRollback telling(telling_, true);
        field->setValue(snapped_us);
    }
    emit asked({width1_->value(), width2_->value(), offset_->value()});
}

}  // namespace kickstand::ui
