#include "ui/thunderbots/flash_progress_page.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <bit>

#include "core/engine/describe_flash.h"
#include "ui/thunderbots/flash_words.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kRobotWidth = 64;
constexpr int kStageWidth = 176;
constexpr int kBarWidth = 110;
constexpr int kBarSteps = 1000;

Tone toneOf(FlashOutcome outcome) {
    switch (outcome) {
        case FlashOutcome::Asked:
        case FlashOutcome::Running:
            return Tone::Busy;
        case FlashOutcome::Done:
            return Tone::Good;
        case FlashOutcome::Paused:
        case FlashOutcome::Cancelled:
            return Tone::Warning;
        default:
            return Tone::Danger;
    }
}

/// How full a robot's bar is; none where nobody can tell.
std::optional<int> barOf(const FlashRunRobot& entry) {
    if (entry.outcome() == FlashOutcome::Done) return kBarSteps;
    if (!entry.progress || entry.ended()) return 0;
    if (entry.progress->total_B == 0) return std::nullopt;
    return static_cast<int>(static_cast<double>(kBarSteps) * entry.progress->done_B /
                            entry.progress->total_B);
}

}  // namespace

FlashProgressPage::FlashProgressPage(QWidget* parent)
    : FlashPageView(parent),
      summary_(makeText("flashProgressSummary", this)),
      cancelAll_(makeButton("flashCancelAll", tr("Cancel all"), this)) {
    auto* row = new QHBoxLayout;
    row->addWidget(summary_, 1);
    row->addWidget(cancelAll_);
    head()->addLayout(row);
    makePause();
    for (int robot = 0; robot < kRobots; ++robot)
        rows_[static_cast<std::size_t>(robot)] = makeRow(robot);
    column()->addStretch(1);
    cancelAll_->setToolTip(tr("Ends all uploads at once. What has been written is used by the next one."));
    connect(cancelAll_, &QPushButton::clicked, this, [this] { emit cancelAsked(running_); });
}

void FlashProgressPage::makePause() {
    pause_ = new QWidget(this);
    auto* row = new QHBoxLayout(pause_);
    row->setContentsMargins(0, 0, 0, 0);
    paused_ = makeText("flashPaused", pause_);
    resume_ = makeButton("flashResume", tr("Resume"), pause_);
    row->addWidget(paused_, 1);
    row->addWidget(resume_);
    head()->addWidget(pause_);
    connect(resume_, &QPushButton::clicked, this, [this] { emit resumeAsked(pausedRobots_); });
}

FlashProgressPage::Row FlashProgressPage::makeRow(int robot) {
    Row row;
    row.all = new QWidget(content());
    auto* line = new QHBoxLayout(row.all);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(metrics::kGap);
    auto* name = new QLabel(tr("Robot %1").arg(robot), row.all);
    name->setFixedWidth(kRobotWidth);
    row.stage = new StateLabel(row.all);
    row.stage->setObjectName(QStringLiteral("flashStage%1").arg(robot));
    row.stage->setFixedWidth(kStageWidth);
    row.bar = new QProgressBar(row.all);
    row.bar->setObjectName(QStringLiteral("flashBar%1").arg(robot));
    row.bar->setAccessibleName(tr("Progress of robot %1").arg(robot));
    row.bar->setTextVisible(false);
    row.bar->setRange(0, kBarSteps);
    row.bar->setFixedSize(kBarWidth, metrics::kGap);
    row.figures = new QLabel(row.all);
    row.figures->setObjectName(QStringLiteral("flashFigures%1").arg(robot));
    row.figures->setFont(numberFont(metrics::kSmallTextSize));
    // What does not fit is cut rather than widening the panel.
    row.figures->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row.figures->setWordWrap(true);
    row.cancel = makeButton("flashCancel", tr("Cancel"), row.all);
    row.cancel->setObjectName(QStringLiteral("flashCancel%1").arg(robot));
    row.cancel->setAccessibleName(tr("Cancel the upload to robot %1").arg(robot));
    line->addWidget(name);
    line->addWidget(row.stage);
    line->addWidget(row.bar);
    line->addWidget(row.figures, 1);
    line->addWidget(row.cancel);
    row.all->setMinimumHeight(metrics::kFieldHeight);
    column()->addWidget(row.all);
    connect(row.cancel, &QPushButton::clicked, this, [this, robot] { emit cancelAsked(maskOf(robot)); });
    return row;
}

void FlashProgressPage::showState(const FlashRun& run, bool stopped) {
    running_ = static_cast<RobotMask>(run.robots() & ~run.ended());
    for (int robot = 0; robot < kRobots; ++robot) {
        const Row& row = rows_[static_cast<std::size_t>(robot)];
        row.all->setVisible(contains(run.robots(), robot));
        if (contains(run.robots(), robot)) showRow(row, run.at(robot));
    }
    summary_->setText(tr("%1 of %2 done. Leave the robots switched on and where they are.")
                          .arg(std::popcount(run.with(FlashOutcome::Done)))
                          .arg(std::popcount(run.robots())));
    cancelAll_->setEnabled(running_ != 0);
    showPause(run, stopped);
}

void FlashProgressPage::showRow(const Row& row, const FlashRunRobot& entry) {
    row.stage->setState(toneOf(entry.outcome()), stageText(entry));
    const std::optional<int> bar = barOf(entry);
    // A range of nothing shows that something goes on whose end nobody can tell.
    row.bar->setRange(0, bar ? kBarSteps : 0);
    if (bar) row.bar->setValue(*bar);
    row.figures->setText(figuresText(entry));
    row.cancel->setVisible(!entry.ended());
}

void FlashProgressPage::showPause(const FlashRun& run, bool stopped) {
    pausedRobots_ = run.with(FlashOutcome::Paused);
    pause_->setVisible(pausedRobots_ != 0);
    paused_->setText(stopped ? tr("Paused by STOP: nothing more is written. Re-arm, then resume.")
                             : tr("Paused by STOP: nothing more is written. Resume, or cancel."));
    resume_->setEnabled(!stopped);
}

}  // namespace kickstand::ui
