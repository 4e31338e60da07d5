#include "ui/motionplan/plan_step_row.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStringList>

#include "core/engine/describe_motionplan.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using motionplan::Movement;
using motionplan::Wheels;

namespace {

constexpr int kMostAmount = 55000;
constexpr int kFirstAmount = 25;

QPushButton* button(const char* name, const QString& text, QWidget* parent) {
    auto* made = new QPushButton(text, parent);
    made->setObjectName(QString::fromLatin1(name));
    made->setAutoDefault(false);
    return made;
}

QString sumText(const std::vector<Movement>& movements) {
    QStringList parts;
    for (const Movement& movement : movements)
        parts << movementText(movement);
    return parts.join(QStringLiteral(" + "));
}

}  // namespace

PlanStepRow::PlanStepRow(QWidget* parent)
    : QWidget(parent),
      way_(new QComboBox(this)),
      amount_(new QSpinBox(this)),
      add_(button("planAdd", tr("Add"), this)),
      change_(button("planChange", tr("Change"), this)),
      offer_(new QLabel(this)) {
    way_->setObjectName(QStringLiteral("planWay"));
    way_->setAccessibleName(tr("Which way the robot moves"));
    const std::pair<QString, Wheels> ways[] = {
        {tr("Forward"), Wheels::BothForward},     {tr("Back"), Wheels::BothBack},
        {tr("Turn left"), Wheels::RightForward},  {tr("Turn right"), Wheels::LeftForward},
        {tr("Turn left back"), Wheels::LeftBack}, {tr("Turn right back"), Wheels::RightBack}};
    for (const auto& [text, wheels] : ways) {
        way_->addItem(text, static_cast<int>(wheels));
        way_->setItemData(way_->count() - 1, wheelsText(wheels), Qt::ToolTipRole);
    }
    amount_->setObjectName(QStringLiteral("planAmount"));
    amount_->setAccessibleName(tr("How far, in centimetres or degrees"));
    amount_->setRange(1, kMostAmount);
    amount_->setValue(kFirstAmount);
    offer_->setObjectName(QStringLiteral("planOffer"));
    offer_->setWordWrap(true);
    offer_->setFont(textFont(metrics::kSmallTextSize));
    offer_->setTextFormat(Qt::PlainText);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    for (QWidget* widget : std::initializer_list<QWidget*>{way_, amount_, add_, change_})
        row->addWidget(widget);
    row->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    column->addLayout(row);
    column->addWidget(offer_);
    connect(way_, &QComboBox::currentIndexChanged, this, &PlanStepRow::refresh);
    connect(amount_, &QSpinBox::valueChanged, this, &PlanStepRow::refresh);
    connect(add_, &QPushButton::clicked, this, [this] { emit added(wanted()); });
    connect(change_, &QPushButton::clicked, this, [this] { emit changed(wanted()); });
    refresh();
}

Movement PlanStepRow::movement() const {
    return {static_cast<Wheels>(way_->currentData().toInt()), amount_->value()};
}

void PlanStepRow::setMovement(const Movement& movement) {
    way_->setCurrentIndex(way_->findData(static_cast<int>(movement.wheels)));
    amount_->setValue(movement.amount);
}

void PlanStepRow::setCanChange(bool can) {
    canChange_ = can;
    refresh();
}

std::vector<Movement> PlanStepRow::wanted() const {
    const Movement one = movement();
    if (motionplan::wire::encodeMovement(one)) return {one};
    return motionplan::wire::exactSum(one.wheels, one.amount, motionplan::wire::kMostMovements)
        .value_or(std::vector<Movement>{});
}

void PlanStepRow::refresh() {
    const Movement one = movement();
    amount_->setSuffix(motionplan::wire::isTurn(one.wheels) ? tr("\u00b0") : tr(" cm"));
    const std::vector<Movement> parts = wanted();
    add_->setEnabled(!parts.empty());
    change_->setEnabled(!parts.empty() && canChange_);
    if (parts.size() == 1)
        offer_->setText(tr("%1, one byte").arg(wheelsText(one.wheels)));
    else if (!parts.empty())
        offer_->setText(tr("No code for this; added as exactly the same: %1").arg(sumText(parts)));
    else if (const std::string nearest = motionplan::alternativeTo(one); !nearest.empty())
        offer_->setText(
            tr("No code for this, and no sum is the same. Nearest: %1").arg(QString::fromStdString(nearest)));
    else
        offer_->setText(tr("No plan is long enough for this: at most %1 movements fit.")
                            .arg(motionplan::wire::kMostMovements));
}

}  // namespace kickstand::ui
