#include "ui/widgets/set_point_slider.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScopedValueRollback>

#include "ui/widgets/center_slider.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kNameWidth = 72;
constexpr int kFieldWidth = 64;
constexpr int kMeaningWidth = 76;

}  // namespace

SetPointSlider::SetPointSlider(const QString& name, QWidget* parent)
    : QWidget(parent),
      slider_(new CenterSlider(this)),
      field_(new SignedSpinBox(this)),
      meaning_(new QLabel(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    auto* label = new QLabel(name, this);
    label->setMinimumWidth(kNameWidth);
    label->setBuddy(field_);
    slider_->setAccessibleName(tr("%1, slider").arg(name));
    slider_->setToolTip(
        tr("Pull to drive. Double-click for zero. An arrow key changes it by one; held down, it pulls the "
           "slider."));
    field_->setAccessibleName(name);
    field_->setToolTip(tr("Type a number and press Enter. Double-click the slider for zero."));
    field_->setFixedWidth(kFieldWidth);
    field_->setLeavingGivesBack(true);
    field_->setFont(numberFont(metrics::kTextSize));
    meaning_->setMinimumWidth(kMeaningWidth);
    meaning_->setForegroundRole(QPalette::PlaceholderText);
    meaning_->setFont(numberFont(metrics::kTextSize));
    row->addWidget(label);
    row->addWidget(slider_, 1);
    row->addWidget(field_);
    row->addWidget(meaning_);

    connect(slider_, &CenterSlider::valueChanged, this, &SetPointSlider::sliderMoved);
    connect(slider_, &CenterSlider::sliderReleased, this, &SetPointSlider::sliderReleased);
    connect(slider_, &CenterSlider::zeroAsked, this, [this] {
        showValue(0);
        emit asked(0, false);
    });
    connect(field_, &QSpinBox::valueChanged, this, [this](int value) {
        if (!telling_) ask(value, false);
    });
}

void SetPointSlider::setLimit(int limit) {
    if (limit == this->limit()) return;
    const QScopedValueRollback telling(telling_, true);
    slider_->setRange(-limit, limit);
    slider_->setPageStep(qMax(1, limit / 10));
    field_->setRange(-limit, limit);
}

int SetPointSlider::limit() const {
    return slider_->maximum();
}

void SetPointSlider::showValue(int value) {
    if (isHeld()) return;
    const QScopedValueRollback telling(telling_, true);
    slider_->setValue(value);
    if (field_->value() != value) field_->setValue(value);
}

void SetPointSlider::setReached(int value) {
    slider_->setReached(value);
}

QString SetPointSlider::meaning() const {
    return meaning_->text();
}

void SetPointSlider::setMeaning(const QString& text) {
    if (meaning_->text() != text) meaning_->setText(text);
}

void SetPointSlider::setDecimals(int decimals) {
    field_->setDecimals(decimals);
}

int SetPointSlider::value() const {
    return slider_->value();
}

bool SetPointSlider::isHeld() const {
    return slider_->isSliderDown();
}

void SetPointSlider::reset() {
    {
        const QScopedValueRollback telling(telling_, true);
        slider_->letGo();
    }
    showValue(0);
}

void SetPointSlider::sliderMoved(int value) {
    if (telling_) return;
    ask(value, slider_->isSliderDown() && releaseToZero_);
}

void SetPointSlider::sliderReleased() {
    if (telling_ || !releaseToZero_) return;
    showValue(0);
    emit asked(0, true);
}

void SetPointSlider::ask(int value, bool held) {
    {
        const QScopedValueRollback telling(telling_, true);
        slider_->setValue(value);
        field_->setValue(value);
    }
    emit asked(value, held);
}

}  // namespace kickstand::ui
