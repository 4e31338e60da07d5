#include "ui/smartdevice/parameter_editor.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <cmath>
#include <limits>

#include "ui/smartdevice/device_words.h"
#include "ui/widgets/center_slider.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using smartdevice::ParameterSpec;
namespace wire = smartdevice::wire;

namespace {

constexpr int kFieldWidth = 72;
constexpr int kTextWidth = 160;
constexpr int kSliderWidth = 96;
/// A slider has as many steps as that, or more.
constexpr double kLeastSteps = 100;
constexpr int kMostDecimals = 6;

QHBoxLayout* rowOf(QWidget* widget) {
    auto* row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    return row;
}

class SwitchEditor final : public ParameterEditor {
  public:
    SwitchEditor(const QString& name, QWidget* parent)
        : ParameterEditor(parent),
          segments_(new Segmented({ParameterEditor::tr("Off"), ParameterEditor::tr("On")}, this)) {
        auto* row = rowOf(this);
        row->addWidget(segments_);
        row->addStretch(1);
        for (int i = 0; i < 2; ++i) {
            QPushButton* button = segments_->button(i);
            button->setAccessibleName(ParameterEditor::tr("%1: %2").arg(name, button->text()));
        }
        connect(segments_, &Segmented::asked, this, [this](int index) { emit asked(index == 1); });
    }

    void showValue(const std::optional<wire::Value>& value) override {
        const bool* on = value ? std::get_if<bool>(&*value) : nullptr;
        const int now = on == nullptr ? -1 : *on ? 1 : 0;
        if (segments_->current() != now) segments_->setCurrent(now);
    }

  private:
    Segmented* segments_;
};

/// Values in whole steps, between two bounds.
class RangeEditor final : public ParameterEditor {
  public:
    RangeEditor(const ParameterSpec& spec, int decimals, const QString& name, QWidget* parent)
        : ParameterEditor(parent),
          type_(spec.type),
          scale_(std::pow(10, decimals)),
          lowest_(*spec.lowest),
          highest_(*spec.highest),
          slider_(new CenterSlider(this)),
          field_(new SignedSpinBox(this)) {
        const int from = static_cast<int>(std::ceil(lowest_ * scale_));
        const int to = static_cast<int>(std::floor(highest_ * scale_));
        slider_->setRange(from, to);
        slider_->setPageStep(std::max(1, (to - from) / 10));
        slider_->setMinimumWidth(kSliderWidth);
        slider_->setAccessibleName(ParameterEditor::tr("%1, slider").arg(name));
        slider_->setToolTip(
            ParameterEditor::tr("Pull to set. Double-click for zero. An arrow key changes it by one step."));
        field_->setRange(from, to);
        field_->setDecimals(decimals);
        field_->setFixedWidth(kFieldWidth);
        field_->setFont(numberFont(metrics::kTextSize));
        field_->setAccessibleName(name);
        field_->setToolTip(ParameterEditor::tr("Type a number and press Enter."));
        auto* row = rowOf(this);
        row->addWidget(slider_, 1);
        row->addWidget(field_);
        connect(slider_, &CenterSlider::valueChanged, this, &RangeEditor::ask);
        connect(slider_, &CenterSlider::zeroAsked, this, [this] { ask(0); });
        connect(field_, &QSpinBox::valueChanged, this, &RangeEditor::ask);
    }

    void showValue(const std::optional<wire::Value>& value) override {
        const auto number = value ? wire::toNumber(*value) : std::nullopt;
        if (!number || !std::isfinite(*number) || slider_->isSliderDown()) return;
        show(static_cast<int>(std::lround(std::clamp(*number, lowest_, highest_) * scale_)));
    }

  private:
    void show(int step) {
        const QSignalBlocker quietSlider(slider_);
        const QSignalBlocker quietField(field_);
        if (slider_->value() != step) slider_->setValue(step);
        slider_->setReached(step);
        // A line edit loses what is being typed with every setValue().
        if (field_->value() != step) field_->setValue(step);
    }

    void ask(int step) {
        const int inside = std::clamp(step, slider_->minimum(), slider_->maximum());
        show(inside);
        if (const auto value = wire::fromNumber(type_, inside / scale_)) emit asked(*value);
    }

    wire::ValueType type_;
    double scale_;
    double lowest_;
    double highest_;
    CenterSlider* slider_;
    SignedSpinBox* field_;
};

/// Any value, typed.
class TextEditor final : public ParameterEditor {
  public:
    TextEditor(const ParameterSpec& spec, const QString& name, QWidget* parent)
        : ParameterEditor(parent),
          spec_(spec),
          field_(new QLineEdit(this)),
          set_(new QPushButton(ParameterEditor::tr("Set"), this)) {
        field_->setAccessibleName(name);
        field_->setFont(numberFont(metrics::kTextSize));
        field_->setMinimumWidth(kFieldWidth);
        field_->setMaximumWidth(kTextWidth);
        field_->setPlaceholderText(withUnit(QString::fromLatin1(wire::name(spec.type)), spec));
        field_->setToolTip(spec.type == wire::ValueType::Raw
                               ? ParameterEditor::tr("Bytes in hexadecimal. Enter sends them.")
                               : ParameterEditor::tr("A number of type %1. Enter sends it.")
                                     .arg(QString::fromLatin1(wire::name(spec.type))));
        set_->setAccessibleName(ParameterEditor::tr("Set %1").arg(name));
        set_->setAutoDefault(false);
        auto* row = rowOf(this);
        row->addWidget(field_, 1);
        row->addWidget(set_);
        row->addStretch();
        connect(field_, &QLineEdit::returnPressed, this, &TextEditor::ask);
        connect(set_, &QPushButton::clicked, this, &TextEditor::ask);
    }

    // The present value stands beside it: here stands what is to be sent.
    void showValue(const std::optional<wire::Value>&) override {}

  private:
    void ask() {
        QString text = field_->text().trimmed().replace(QChar(0x2212), u'-');
        if (!wire::isInteger(spec_.type)) text.replace(u',', u'.');
        const auto value = wire::fromText(spec_.type, text.toStdString(), spec_.name);
        if (value)
            emit asked(*value);
        else
            emit refused(value.error());
    }

    const ParameterSpec spec_;
    QLineEdit* field_;
    QPushButton* set_;
};

/// How many places a slider needs for its bounds; none where they are too far apart for one, or not known.
std::optional<int> sliderDecimals(const ParameterSpec& spec) {
    if (spec.type == wire::ValueType::Raw || !spec.lowest || !spec.highest) return std::nullopt;
    const double range = *spec.highest - *spec.lowest;
    if (!(range > 0)) return std::nullopt;
    int decimals = 0;
    while (!wire::isInteger(spec.type) && decimals < kMostDecimals &&
           range * std::pow(10, decimals) < kLeastSteps)
        ++decimals;
    const double furthest = std::max(std::abs(*spec.lowest), std::abs(*spec.highest));
    if (furthest * std::pow(10, decimals) > std::numeric_limits<int>::max() / 2.0) return std::nullopt;
    return decimals;
}

}  // namespace

ParameterEditor* makeParameterEditor(const ParameterSpec& spec, const QString& name, QWidget* parent) {
    if (spec.type == wire::ValueType::Bool) return new SwitchEditor(name, parent);
    if (const auto decimals = sliderDecimals(spec)) return new RangeEditor(spec, *decimals, name, parent);
    return new TextEditor(spec, name, parent);
}

}  // namespace kickstand::ui
