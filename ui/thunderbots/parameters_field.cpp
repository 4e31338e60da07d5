#include "ui/thunderbots/parameters_field.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QSpinBox>

#include "core/engine/describe_parameters.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

QString objectNameOf(ParameterField field) {
    const std::string_view text = name(field);
    return QStringLiteral("draft_") + QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

}  // namespace

ParametersField::ParametersField(ParameterField field, QWidget* parent) : QWidget(parent), field_(field) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap / 2);
    const bool isNumber = field == ParameterField::RobotNumber || field == ParameterField::DribblerDuty;
    if (isNumber) {
        makeNumber();
    } else {
        makeList();
    }
}

void ParametersField::makeList() {
    list_ = new QComboBox(this);
    list_->setObjectName(objectNameOf(field_));
    list_->setAccessibleName(describe(field_));
    const auto add = [this](std::uint8_t value) { list_->addItem(describeValue(field_, value), value); };
    if (field_ == ParameterField::FlashContents) {
        for (const wire::FlashContents contents :
             {wire::FlashContents::FpgaBitstream, wire::FlashContents::Microcontroller,
              wire::FlashContents::NoData})
            add(static_cast<std::uint8_t>(contents));
    } else {
        add(0);
        for (int channel = wire::kLowestChannel; channel <= wire::kHighestChannel; ++channel)
            add(static_cast<std::uint8_t>(channel));
    }
    connect(list_, &QComboBox::activated, this, [this](int index) {
        emit asked(static_cast<std::uint8_t>(list_->itemData(index).toInt()), false);
    });
    layout()->addWidget(list_);
}

QSpinBox* ParametersField::addSpin(const char* suffix, int highest, const QString& unit) {
    auto* spin = new QSpinBox(this);
    spin->setObjectName(objectNameOf(field_) + QString::fromLatin1(suffix));
    // One below the lowest stands for nothing known.
    spin->setRange(-1, highest);
    spin->setSpecialValueText(QStringLiteral("\u2013"));
    spin->setSuffix(unit);
    spin->setFont(numberFont(metrics::kTextSize));
    spin->setAccessibleName(describe(field_));
    spin->installEventFilter(this);
    layout()->addWidget(spin);
    return spin;
}

void ParametersField::makeNumber() {
    const bool isDuty = field_ == ParameterField::DribblerDuty;
    number_ = addSpin("", isDuty ? 255 : kRobots - 1, {});
    connect(number_, &QSpinBox::valueChanged, this, [this](int value) {
        if (value >= 0) emit asked(static_cast<std::uint8_t>(value), true);
    });
    if (!isDuty) return;
    percent_ = addSpin("_percent", 100, tr(" %"));
    connect(percent_, &QSpinBox::valueChanged, this, [this](int percent) {
        if (percent >= 0) emit asked(dutyOfPercent(percent), true);
    });
}

void ParametersField::showValue(std::optional<std::uint8_t> value) {
    if (list_ != nullptr) {
        const QSignalBlocker blocker(list_);
        int index = value ? list_->findData(*value) : -1;
        if (value && index < 0 && field_ == ParameterField::FlashContents) index = list_->count() - 1;
        list_->setCurrentIndex(index);
        // A robot may have what nobody would choose: it is shown, and not offered.
        list_->setPlaceholderText(value && index < 0 ? describeValue(field_, *value) : QString());
        return;
    }
    const QSignalBlocker blocker(number_);
    // What is half typed stays as it is.
    const int shown = value ? *value : -1;
    if (number_->value() != shown) number_->setValue(shown);
    if (percent_ == nullptr) return;
    const QSignalBlocker blockPercent(percent_);
    // What is being typed as a percentage is not to be corrected by the duty that it makes.
    const int percent = value ? static_cast<int>(dutyPercent(*value) + 0.5) : -1;
    if (percent < 0 || percent_->value() < 0 || dutyOfPercent(percent_->value()) != *value)
        percent_->setValue(percent);
}

bool ParametersField::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

}  // namespace kickstand::ui
