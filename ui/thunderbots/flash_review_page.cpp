#include "ui/thunderbots/flash_review_page.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/engine/describe_flash.h"
#include "ui/thunderbots/flash_words.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kRobotWidth = 64;

/// The robots that something is sent to.
RobotMask sentTo(const FlashWizardState& state) {
    RobotMask robots = 0;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(state.robots, robot) && !state.plansFor(robot).empty()) robots |= maskOf(robot);
    }
    return robots;
}

}  // namespace

FlashReviewPage::FlashReviewPage(QWidget* parent)
    : FlashPageView(parent),
      summary_(makeText("flashSummary", this)),
      order_(makeText("flashOrderOfThings", content())),
      notice_(makeText("flashReviewNotice", content())),
      read_(makeButton("flashReadAgain", tr("Read again"), this)) {
    auto* row = new QHBoxLayout;
    row->addWidget(summary_, 1);
    row->addWidget(read_);
    head()->addLayout(row);
    for (int robot = 0; robot < kRobots; ++robot)
        rows_[static_cast<std::size_t>(robot)] = makeRow(robot);
    column()->addSpacing(4);
    column()->addWidget(order_);
    column()->addWidget(notice_);
    column()->addStretch(1);
    connect(read_, &QPushButton::clicked, this, &FlashReviewPage::readAsked);
}

FlashReviewPage::Row FlashReviewPage::makeRow(int robot) {
    Row row;
    row.all = new QWidget(content());
    auto* line = new QHBoxLayout(row.all);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::kGap);
    auto* name = new QLabel(tr("Robot %1").arg(robot), row.all);
    name->setFixedWidth(kRobotWidth);
    row.signature = makeText("flashSignature", row.all);
    row.signature->setObjectName(QStringLiteral("flashSignature%1").arg(robot));
    row.signature->setFont(numberFont(metrics::kTextSize));
    row.leaveOut = new QCheckBox(row.all);
    row.leaveOut->setObjectName(QStringLiteral("flashLeaveOut%1").arg(robot));
    row.leaveOut->setAccessibleName(tr("Robot %1: do not send what is there already").arg(robot));
    line->addWidget(name, 0, Qt::AlignTop);
    line->addWidget(row.signature, 1);
    line->addWidget(row.leaveOut, 0, Qt::AlignTop);
    column()->addWidget(row.all);
    connect(row.leaveOut, &QCheckBox::clicked, this,
            [this, robot](bool on) { emit leaveOutAsked(robot, on); });
    return row;
}

void FlashReviewPage::showState(const FlashWizardState& state) {
    bool failed = false;
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto at = static_cast<std::size_t>(robot);
        const Row& row = rows_[at];
        const bool chosen = contains(state.robots, robot);
        row.all->setVisible(chosen);
        if (!chosen) continue;
        row.signature->setText(signatureText(state, robot));
        const QString there = thereText(state, robot);
        row.leaveOut->setText(there);
        row.leaveOut->setVisible(!there.isEmpty());
        row.leaveOut->setChecked(state.reviews[at].leaveOut);
        failed = failed || state.reviews[at].state == FlashReview::State::Failed;
    }
    read_->setVisible(failed);
    const RobotMask robots = sentTo(state);
    summary_->setText(robots == 0 ? tr("Nothing will be sent.")
                                  : tr("To %1: about %2, longer where the radio is weak.")
                                        .arg(robotsText(robots), durationText(state.estimate())));
    QStringList lines;
    for (const QString& line : orderOfThings(state.plans()))
        lines << tr("%1. %2").arg(lines.size() + 1).arg(line);
    order_->setText(lines.join(u'\n'));
    const QString notice = state.losesBitstream() ? filesNotice(state) : QString();
    notice_->setText(notice);
    notice_->setVisible(!notice.isEmpty());
}

}  // namespace kickstand::ui
