#include "ui/shell/doctor_row.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/engine/describe_findings.h"
#include "ui/shell/remedy_text.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

constexpr int kStateWidth = 92;
constexpr int kCheckWidth = 120;

Tone toneOf(CheckState state) {
    switch (state) {
        case CheckState::Ok:
            return Tone::Good;
        case CheckState::Warning:
            return Tone::Warning;
        case CheckState::Problem:
            return Tone::Danger;
        case CheckState::NotChecked:
            return Tone::Idle;
    }
    return Tone::Idle;
}

QLabel* sentence(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

}  // namespace

DoctorRow::DoctorRow(QWidget* parent)
    : QWidget(parent),
      state_(new StateLabel(this)),
      check_(new QLabel(this)),
      what_(sentence(this)),
      remedy_(sentence(this)),
      copy_(new QPushButton(tr("Copy command"), this)) {
    state_->setFixedWidth(kStateWidth);
    check_->setFixedWidth(kCheckWidth);
    check_->setFont(textFont(metrics::kTextSize, QFont::DemiBold));
    what_->setObjectName(QStringLiteral("what"));
    remedy_->setObjectName(QStringLiteral("remedy"));
    remedy_->setForegroundRole(QPalette::PlaceholderText);
    copy_->setObjectName(QStringLiteral("copyCommand"));
    copy_->setAutoDefault(false);
    auto* words = new QVBoxLayout;
    words->setSpacing(2);
    words->addWidget(what_);
    words->addWidget(remedy_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, 7, metrics::kPadding, 7);
    row->setSpacing(metrics::kGap);
    row->addWidget(state_, 0, Qt::AlignTop);
    row->addWidget(check_, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    row->addWidget(copy_, 0, Qt::AlignTop);
    connect(copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(command_); });
}

void DoctorRow::showFinding(const Finding& finding) {
    const Description words = describe(finding);
    const QString check = describe(finding.check);
    setObjectName(QLatin1String("doctor-") + QLatin1String(name(finding.check)));
    state_->setState(toneOf(finding.state), describe(finding.state));
    check_->setText(check);
    what_->setText(words.what);
    remedy_->setText(remedyBesideCopy(words));
    remedy_->setVisible(!words.remedy.isEmpty());
    command_ = words.remedyCommand;
    copy_->setVisible(!command_.isEmpty());
    copy_->setToolTip(command_);
    copy_->setAccessibleName(tr("Copy the command for: %1").arg(check));
    setAccessibleName(tr("%1: %2. %3").arg(check, describe(finding.state), words.line()));
}

void DoctorRow::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(QRect(0, height() - 1, width(), 1), tokensOf(palette()).grid);
}

}  // namespace kickstand::ui
