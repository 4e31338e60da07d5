#include "ui/thunderbots/flash_result_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <bit>

#include "ui/thunderbots/flash_words.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kOutcomeWidth = 152;

std::pair<Tone, QString> outcomeState(FlashOutcome outcome) {
    switch (outcome) {
        case FlashOutcome::Done:
            return {Tone::Good, FlashResultPage::tr("done")};
        case FlashOutcome::Cancelled:
            return {Tone::Warning, FlashResultPage::tr("cancelled")};
        case FlashOutcome::Refused:
            return {Tone::Danger, FlashResultPage::tr("not begun")};
        case FlashOutcome::Gone:
            return {Tone::Danger, FlashResultPage::tr("cut off")};
        default:
            return {Tone::Danger, FlashResultPage::tr("failed")};
    }
}

}  // namespace

FlashResultPage::FlashResultPage(QWidget* parent)
    : FlashPageView(parent),
      summary_(makeText("flashResultSummary", this)),
      logs_(makeButton("flashLogs", tr("Save all logs\u2026"), this)),
      again_(makeButton("flashAgain", tr("Upload again to those that failed"), this)) {
    summary_->setFont(textFont(metrics::kTextSize, QFont::DemiBold));
    auto* row = new QHBoxLayout;
    row->addWidget(summary_, 1);
    row->addWidget(again_);
    row->addWidget(logs_);
    head()->addLayout(row);
    for (int robot = 0; robot < kRobots; ++robot)
        rows_[static_cast<std::size_t>(robot)] = makeRow(robot);
    column()->addStretch(1);
    again_->setToolTip(tr("Goes back to the first page with these robots ticked, and the same files."));
    connect(logs_, &QPushButton::clicked, this, [this] { emit logAsked(robots_); });
    connect(again_, &QPushButton::clicked, this, [this] { emit againAsked(unfinished_); });
}

FlashResultPage::Row FlashResultPage::makeRow(int robot) {
    Row row;
    row.all = new QWidget(content());
    auto* line = new QHBoxLayout(row.all);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::kGap);
    row.outcome = new StateLabel(row.all);
    row.outcome->setObjectName(QStringLiteral("flashOutcome%1").arg(robot));
    row.outcome->setFixedWidth(kOutcomeWidth);
    row.sentence = makeText("flashSentence", row.all);
    row.sentence->setObjectName(QStringLiteral("flashSentence%1").arg(robot));
    row.sentence->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* log = makeButton("flashLog", tr("Save log\u2026"), row.all);
    log->setObjectName(QStringLiteral("flashLog%1").arg(robot));
    log->setAccessibleName(tr("Save the log of robot %1").arg(robot));
    line->addWidget(row.outcome);
    line->addWidget(row.sentence, 1);
    line->addWidget(log);
    row.all->setMinimumHeight(metrics::kControlHeight);
    column()->addWidget(row.all);
    connect(log, &QPushButton::clicked, this, [this, robot] { emit logAsked(maskOf(robot)); });
    return row;
}

void FlashResultPage::showState(const FlashRun& run) {
    robots_ = run.robots();
    unfinished_ = run.unfinished();
    for (int robot = 0; robot < kRobots; ++robot) {
        const Row& row = rows_[static_cast<std::size_t>(robot)];
        row.all->setVisible(contains(robots_, robot));
        if (!contains(robots_, robot)) continue;
        const auto [tone, text] = outcomeState(run.at(robot).outcome());
        row.outcome->setState(tone, tr("Robot %1 \u00b7 %2").arg(robot).arg(text));
        row.sentence->setText(outcomeText(robot, run.at(robot)));
    }
    const int done = std::popcount(run.with(FlashOutcome::Done));
    const int all = std::popcount(robots_);
    summary_->setText(done == all && all == 1 ? tr("Done.")
                      : done == all           ? tr("All %1 robots are done.").arg(all)
                                              : tr("%1 of %2 robots done.").arg(done).arg(all));
    again_->setVisible(unfinished_ != 0);
}

}  // namespace kickstand::ui
