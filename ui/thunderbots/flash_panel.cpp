#include "ui/thunderbots/flash_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <bit>

#include "ui/shell/bench.h"
#include "ui/thunderbots/flash_files_page.h"
#include "ui/thunderbots/flash_progress_page.h"
#include "ui/thunderbots/flash_result_page.h"
#include "ui/thunderbots/flash_review_page.h"
#include "ui/thunderbots/flash_robots_page.h"
#include "ui/thunderbots/flash_step_strip.h"
#include "ui/thunderbots/flash_words.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

/// Wrapped words in it do not make the panel ask for more height than there is.
template <class Base>
class FixedHeight final : public Base {
  public:
    using Base::Base;
    bool hasHeightForWidth() const override { return false; }
};

QPushButton* makeButton(const char* name, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    return button;
}

QString nextText(FlashStep step) {
    switch (step) {
        case FlashStep::Robots:
        case FlashStep::Files:
            return FlashPanel::tr("Next");
        case FlashStep::Review:
            return FlashPanel::tr("Start upload");
        case FlashStep::Progress:
            return FlashPanel::tr("Result");
        case FlashStep::Result:
            return FlashPanel::tr("New upload");
    }
    return {};
}

}  // namespace

FlashPanel::FlashPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      strip_(new FlashStepStrip(this)),
      pages_(new FixedHeight<QStackedWidget>(this)),
      robotsPage_(new FlashRobotsPage),
      filesPage_(new FlashFilesPage),
      reviewPage_(new FlashReviewPage),
      progressPage_(new FlashProgressPage),
      resultPage_(new FlashResultPage) {
    setObjectName(QStringLiteral("flashPanel"));
    build();
    addShortcuts();
    connectPages();
    connectBench();
    followChoice();
}

void FlashPanel::build() {
    // In the order of FlashStep.
    for (QWidget* page :
         std::initializer_list<QWidget*>{robotsPage_, filesPage_, reviewPage_, progressPage_, resultPage_})
        pages_->addWidget(page);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, 10, metrics::kPadding, metrics::kGap);
    column->setSpacing(metrics::kGap);
    column->addWidget(strip_);
    column->addWidget(pages_, 1);
    column->addWidget(makeFooter());
}

QWidget* FlashPanel::makeFooter() {
    auto* footer = new FixedHeight<QWidget>(this);
    auto* row = new QHBoxLayout(footer);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    back_ = makeButton("flashBack", footer);
    back_->setText(tr("Back"));
    back_->setToolTip(tr("Alt+Left"));
    reason_ = new QLabel(footer);
    reason_->setObjectName(QStringLiteral("flashReason"));
    reason_->setWordWrap(true);
    reason_->setTextFormat(Qt::PlainText);
    reason_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    next_ = makeButton("flashNext", footer);
    next_->setText(nextText(state_.step));
    row->addWidget(back_);
    row->addWidget(reason_, 1);
    row->addWidget(next_);
    connect(back_, &QPushButton::clicked, this, &FlashPanel::goBack);
    connect(next_, &QPushButton::clicked, this, &FlashPanel::goOn);
    return footer;
}

void FlashPanel::addShortcuts() {
    auto* back = new QShortcut(QKeySequence(Qt::ALT | Qt::Key_Left), this, this, &FlashPanel::goBack);
    auto* next = new QShortcut(QKeySequence(Qt::ALT | Qt::Key_Right), this, this, [this] {
        // An upload is started by its own button alone.
        if (state_.step < FlashStep::Review) goOn();
    });
    for (QShortcut* shortcut : {back, next})
        shortcut->setContext(Qt::WidgetWithChildrenShortcut);
}

void FlashPanel::connectPages() {
    connect(robotsPage_, &FlashRobotsPage::robotsAsked, this, [this](RobotMask robots) {
        state_.robots = robots;
        state_.chosenHere = true;
        refresh();
    });
    connect(robotsPage_, &FlashRobotsPage::optionsAsked, this, [this](const FlashOptions& options) {
        state_.options = options;
        refresh();
    });
    connect(robotsPage_, &FlashRobotsPage::remedyAsked, this, &FlashPanel::remedy);
    connect(filesPage_, &FlashFilesPage::pathsAsked, this, &FlashPanel::addFiles);
    connect(filesPage_, &FlashFilesPage::removeAsked, this, &FlashPanel::removeFile);
    connect(filesPage_, &FlashFilesPage::targetAsked, this,
            [this](std::size_t file, image::FlashTarget target) {
                if (file < state_.files.size()) state_.files[file].target = target;
                refresh();
            });
    connect(&reader_, &FlashReader::finished, this, &FlashPanel::takeFile);
    connect(reviewPage_, &FlashReviewPage::leaveOutAsked, this, [this](int robot, bool leaveOut) {
        state_.reviews[static_cast<std::size_t>(robot)].leaveOut = leaveOut;
        refresh();
    });
    connect(reviewPage_, &FlashReviewPage::readAsked, this, &FlashPanel::readAgain);
    connect(progressPage_, &FlashProgressPage::cancelAsked, this, &FlashPanel::cancel);
    connect(progressPage_, &FlashProgressPage::resumeAsked, this, &FlashPanel::resume);
    connect(resultPage_, &FlashResultPage::logAsked, this, &FlashPanel::saveLogs);
    connect(resultPage_, &FlashResultPage::againAsked, this, &FlashPanel::uploadAgain);
}

void FlashPanel::connectBench() {
    connect(&choice_, &RobotChoice::changed, this, &FlashPanel::followChoice);
    connect(&bench(), &Bench::changed, this, &FlashPanel::refresh);
    connect(&bench(), &Bench::sessionChanged, this, &FlashPanel::sessionGone);
    connect(&bench().client(), &EngineClient::stopChanged, this, &FlashPanel::refresh);
}

const Snapshot* FlashPanel::snapshot() const {
    return snapshotOf(bench().session());
}

void FlashPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    refresh();
}

void FlashPanel::refresh() {
    followLink();
    state_.reading = reader_.pending();
    if (const Snapshot* now = snapshot()) {
        state_.run.take(*now);
        state_.takeReviews(*now);
        disarmDischarged(*now);
    }
    if (state_.step == FlashStep::Review && linked_) readRobots();
    // What has come to its end is told without being asked.
    if (state_.step == FlashStep::Progress && !state_.run.running()) state_.step = FlashStep::Result;
    showNote();
    if (!isVisible()) return;
    showPage();
    showFooter();
}

void FlashPanel::showPage() {
    strip_->setStep(state_.step);
    pages_->setCurrentIndex(static_cast<int>(state_.step));
    switch (state_.step) {
        case FlashStep::Robots:
            robotsPage_->showState(state_, snapshot());
            break;
        case FlashStep::Files:
            filesPage_->showState(state_, filesNotice_);
            break;
        case FlashStep::Review:
            reviewPage_->showState(state_);
            break;
        case FlashStep::Progress:
            progressPage_->showState(state_.run, bench().client().isStopped());
            break;
        case FlashStep::Result:
            resultPage_->showState(state_.run);
            break;
    }
}

void FlashPanel::showFooter() {
    const auto hold = state_.hold(snapshot(), bench().client().isStopped());
    const QString held = hold ? holdText(*hold, state_, snapshot()) : QString();
    back_->setVisible(state_.step == FlashStep::Files || state_.step == FlashStep::Review);
    next_->setText(nextText(state_.step));
    next_->setEnabled(!hold);
    next_->setToolTip(held);
    setButtonRole(next_, hold ? ButtonRole::Normal : ButtonRole::Primary);
    reason_->setText(refusal_.isEmpty() ? held : refusal_);
    reason_->setForegroundRole(refusal_.isEmpty() ? QPalette::PlaceholderText : QPalette::WindowText);
}

void FlashPanel::showNote() {
    const FlashRun& run = state_.run;
    if (state_.step < FlashStep::Progress) {
        setNote(state_.robots == 0 ? tr("no robot chosen") : robotsText(state_.robots));
        return;
    }
    QString note =
        tr("%1 of %2 done").arg(std::popcount(run.with(FlashOutcome::Done))).arg(std::popcount(run.robots()));
    if (run.with(FlashOutcome::Paused) != 0) note = tr("%1 \u00b7 paused by STOP").arg(note);
    setNote(note);
}

void FlashPanel::followLink() {
    const Snapshot* now = snapshot();
    const bool linked = now != nullptr && now->link == LinkState::Running;
    if (linked == linked_) return;
    linked_ = linked;
    // The robots may be others, or have changed, when it comes back.
    forgetReviews();
}

void FlashPanel::followChoice() {
    if (state_.step == FlashStep::Robots && !state_.chosenHere) state_.robots = choice_.chosen();
    refresh();
}

void FlashPanel::go(FlashStep step) {
    state_.step = step;
    refusal_.clear();
    if (step == FlashStep::Review) forgetReviews();
    refresh();
}

void FlashPanel::goBack() {
    if (state_.step == FlashStep::Files) go(FlashStep::Robots);
    if (state_.step == FlashStep::Review) go(FlashStep::Files);
}

void FlashPanel::goOn() {
    if (state_.hold(snapshot(), bench().client().isStopped())) return refresh();
    switch (state_.step) {
        case FlashStep::Robots:
            return go(FlashStep::Files);
        case FlashStep::Files:
            return go(FlashStep::Review);
        case FlashStep::Review:
            return start();
        case FlashStep::Progress:
            return go(FlashStep::Result);
        case FlashStep::Result:
            return startOver();
    }
}

}  // namespace kickstand::ui
