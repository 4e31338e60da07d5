#include "ui/shell/sim_action_control.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QWheelEvent>
#include <cmath>

#include "core/engine/messages.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr std::size_t kMostSegments = 4;
constexpr int kNumberWidth = 100;
/// A range wider than this needs no decimals, one wider than the other needs one.
constexpr double kWholeRange = 100;
constexpr double kTenthRange = 2;
constexpr double kPercent = 100;

/// A spin box that takes the whole of what is typed at once, and leaves what is being typed alone.
class NumberBox final : public QDoubleSpinBox {
  public:
    using QDoubleSpinBox::QDoubleSpinBox;
    bool isBeingTyped() const { return hasFocus() && lineEdit()->isModified(); }

  protected:
    void wheelEvent(QWheelEvent* event) override {
        // Whoever scrolls the panel past it means the panel.
        if (hasFocus()) {
            QDoubleSpinBox::wheelEvent(event);
        } else {
            event->ignore();
        }
    }
};

int decimalsFor(double range) {
    if (range > kWholeRange) return 0;
    return range > kTenthRange ? 1 : 2;
}

}  // namespace

bool hasAction(const SessionSnapshot& session, const SimAction& action, int unit) {
    bool others = false;
    for (const SimReading& reading : session.simReadings) {
        if (reading.action != action.name) continue;
        if (reading.unit == unit) return true;
        others = true;
    }
    return !others;
}

SimActionControl::SimActionControl(const SimAction& action,
                                   const std::vector<std::pair<QString, double>>& choices,
                                   const QString& name, QWidget* parent)
    : QWidget(parent), choices_(choices) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap / 2);
    if (choices_.empty()) {
        addNumber(action, name);
    } else if (choices_.size() == 1) {
        addButton(choices_.front().first, name, choices_.front().second);
    } else if (choices_.size() <= kMostSegments) {
        addSegments(name);
    } else {
        addList(name);
    }
    row->addStretch(1);
}

void SimActionControl::addButton(const QString& text, const QString& name, double value) {
    auto* button = new QPushButton(text, this);
    button->setAutoDefault(false);
    button->setAccessibleName(name);
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this, value] { emit asked(value); });
}

void SimActionControl::addSegments(const QString& name) {
    QStringList labels;
    for (const auto& [label, value] : choices_)
        labels << label;
    segments_ = new Segmented(labels, this);
    for (int i = 0; i < labels.size(); ++i)
        segments_->button(i)->setAccessibleName(tr("%1: %2").arg(name, labels[i]));
    layout()->addWidget(segments_);
    connect(segments_, &Segmented::asked, this,
            [this](int index) { emit asked(choices_[static_cast<std::size_t>(index)].second); });
}

void SimActionControl::addList(const QString& name) {
    auto* list = new QComboBox(this);
    for (const auto& [label, value] : choices_)
        list->addItem(label, value);
    list->setAccessibleName(name);
    layout()->addWidget(list);
    auto* button = new QPushButton(tr("Do it"), this);
    button->setAutoDefault(false);
    button->setAccessibleName(tr("Do it: %1").arg(name));
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this,
            [this, list] { emit asked(list->currentData().toDouble()); });
}

void SimActionControl::addNumber(const SimAction& action, const QString& name) {
    auto* box = new NumberBox(this);
    number_ = box;
    const bool share = action.unit == "probability";
    const bool measured = share || action.unit.size() <= 3;
    scale_ = share ? kPercent : 1;
    const double range = (action.highest - action.lowest) * scale_;
    box->setDecimals(measured ? decimalsFor(range) : 0);
    box->setRange(action.lowest * scale_, action.highest * scale_);
    box->setSingleStep(measured && range <= kWholeRange ? (range > kTenthRange ? 0.5 : 0.1) : 1);
    // A plain number has the unit 1.
    if (measured && action.unit != "1")
        box->setSuffix(u' ' + (share ? QStringLiteral("%") : QString::fromStdString(action.unit)));
    box->setKeyboardTracking(false);
    box->setFocusPolicy(Qt::StrongFocus);
    box->setFont(numberFont(metrics::kTextSize));
    box->setFixedWidth(kNumberWidth);
    box->setAccessibleName(name);
    layout()->addWidget(box);
    if (measured) {
        connect(box, &QDoubleSpinBox::valueChanged, this,
                [this](double value) { emit asked(value / scale_); });
        return;
    }
    // A code is sent when it is meant, not while it is looked for.
    auto* button = new QPushButton(tr("Do it"), this);
    button->setAutoDefault(false);
    button->setAccessibleName(tr("Do it: %1").arg(name));
    layout()->addWidget(button);
    connect(button, &QPushButton::clicked, this, [this] { emit asked(number_->value()); });
}

void SimActionControl::showValue(std::optional<double> value) {
    if (segments_ != nullptr) {
        int current = -1;
        for (std::size_t i = 0; i < choices_.size(); ++i) {
            if (value && choices_[i].second == *value) current = static_cast<int>(i);
        }
        segments_->setCurrent(current);
    }
    if (number_ == nullptr || !value || static_cast<NumberBox*>(number_)->isBeingTyped()) return;
    const QSignalBlocker quiet(number_);
    number_->setValue(*value * scale_);
}

}  // namespace kickstand::ui
