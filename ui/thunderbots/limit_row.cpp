#include "ui/thunderbots/limit_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

#include "core/thunderbots/types.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/signed_spin_box.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kFirstRaise = 300;

}  // namespace

LimitRow::LimitRow(QWidget* parent)
    : QWidget(parent),
      label_(new QLabel(this)),
      change_(new QPushButton(this)),
      wanted_(new SignedSpinBox(this)),
      raise_(new QPushButton(tr("Raise"), this)),
      keep_(new QPushButton(tr("Keep"), this)) {
    label_->setForegroundRole(QPalette::PlaceholderText);
    change_->setObjectName(QStringLiteral("changeLimit"));
    wanted_->setObjectName(QStringLiteral("wantedLimit"));
    raise_->setObjectName(QStringLiteral("raiseLimit"));
    keep_->setObjectName(QStringLiteral("keepLimit"));
    setButtonRole(change_, ButtonRole::Flat);
    wanted_->setRange(thunderbots::kStartingWheelLimit, thunderbots::kFastestWheel);
    wanted_->setValue(kFirstRaise);
    wanted_->setFixedWidth(64);
    wanted_->setKeyboardTracking(true);
    wanted_->setAccessibleName(tr("Highest wheel speed"));
    const QString meaning =
        tr("Past \u00b1100 there is no ramp: the robot may leave its stand. It holds until the link "
           "is closed.");
    wanted_->setToolTip(meaning);
    raise_->setToolTip(meaning);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    row->addWidget(label_);
    row->addWidget(change_);
    row->addWidget(wanted_);
    row->addWidget(raise_);
    row->addWidget(keep_);
    for (QPushButton* button : {change_, raise_, keep_})
        button->setAutoDefault(false);
    connect(change_, &QPushButton::clicked, this, [this] {
        if (limit_ > thunderbots::kStartingWheelLimit) {
            emit asked(thunderbots::kStartingWheelLimit);
        } else {
            setAsking(true);
        }
    });
    connect(raise_, &QPushButton::clicked, this, [this] {
        setAsking(false);
        emit asked(wanted_->value());
    });
    connect(keep_, &QPushButton::clicked, this, [this] { setAsking(false); });
    setLimit(thunderbots::kStartingWheelLimit);
    setAsking(false);
}

void LimitRow::setLimit(int limit) {
    if (limit == limit_) return;
    limit_ = limit;
    setAsking(false);
}

void LimitRow::setAsking(bool asking) {
    label_->setText(asking ? tr("No ramp past \u00b1100.") : tr("limit \u00b1%1").arg(limit_));
    change_->setText(limit_ > thunderbots::kStartingWheelLimit ? tr("back to \u00b1100") : tr("raise\u2026"));
    change_->setVisible(!asking);
    for (QWidget* widget :
         {static_cast<QWidget*>(wanted_), static_cast<QWidget*>(raise_), static_cast<QWidget*>(keep_)}) {
        widget->setVisible(asking);
    }
    if (asking) wanted_->setFocus(Qt::OtherFocusReason);
}

}  // namespace kickstand::ui
