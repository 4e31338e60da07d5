#include "ui/thunderbots/checks_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QVBoxLayout>
#include <bit>

#include "core/engine/describe.h"
#include "core/engine/describe_check.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/checks_report_file.h"
#include "ui/thunderbots/checks_settings_box.h"
#include "ui/thunderbots/kick_state.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/scrolled.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kRowHeight = 24;
constexpr int kControlsWidth = 264;
constexpr int kQuestionSize = 14;
constexpr int kQuestionLines = 3;
constexpr int kVerdictWidth = 68;
/// Of the columns before the last; the step takes what is left.
constexpr int kWidths[] = {48, 0, 76, 62};

QPushButton* makeButton(const char* name, const QString& text, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    return button;
}

}  // namespace

ChecksPanel::ChecksPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      settings_(new ChecksSettingsBox(bench.settings(), this)),
      table_(new QTableView(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(metrics::kPadding, metrics::kGap, 1, metrics::kPanelRadius);
    row->setSpacing(metrics::kPadding);
    row->addWidget(makeControls());
    row->addLayout(makeRight(), 1);
    connectAll();
    refresh();
}

QWidget* ChecksPanel::makeControls() {
    auto* box = new QWidget(this);
    box->setFixedWidth(kControlsWidth);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(4);
    arm_ = makeButton("checksArm", tr("Arm"), box);
    arm_->setCheckable(true);
    start_ = makeButton("checksStart", tr("Start check"), box);
    stop_ = makeButton("checksStop", tr("End check"), box);
    for (QPushButton* button : {arm_, start_, stop_})
        buttons->addWidget(button);
    column->addLayout(buttons);
    column->addWidget(scrolled(settings_, box), 1);
    return box;
}

QWidget* ChecksPanel::makeQuestion() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, metrics::kPadding, 0);
    column->setSpacing(metrics::kGap);
    words_ = new QLabel(box);
    words_->setObjectName(QStringLiteral("checksWords"));
    words_->setFont(textFont(kQuestionSize));
    words_->setWordWrap(true);
    words_->setTextFormat(Qt::PlainText);
    words_->setMinimumHeight(kQuestionLines * words_->fontMetrics().lineSpacing());
    column->addWidget(words_);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kGap);
    answers_ = {makeButton("checksYes", tr("&Yes"), box), makeButton("checksNo", tr("&No"), box),
                makeButton("checksSkip", tr("S&kip"), box), makeButton("checksAgain", tr("&Again"), box)};
    for (QPushButton* button : answers_)
        row->addWidget(button);
    row->addStretch(1);
    column->addLayout(row);
    notice_ = new QLabel(box);
    notice_->setObjectName(QStringLiteral("checksNotice"));
    notice_->setWordWrap(true);
    notice_->setTextFormat(Qt::PlainText);
    notice_->setForegroundRole(QPalette::PlaceholderText);
    column->addWidget(notice_);
    return box;
}

QLayout* ChecksPanel::makeRight() {
    auto* column = new QVBoxLayout;
    column->setSpacing(metrics::kGap);
    column->addWidget(makeQuestion());
    buildTable();
    column->addWidget(table_, 1);
    return column;
}

void ChecksPanel::buildTable() {
    table_->setObjectName(QStringLiteral("checksTable"));
    table_->setAccessibleName(tr("Steps of the check"));
    table_->setModel(&rows_);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setFont(numberFont(metrics::kTextSize));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setTabKeyNavigation(false);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setMinimumSectionSize(kRowHeight);
    table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    table_->horizontalHeader()->setHighlightSections(false);
    int column = 0;
    for (const int width : kWidths)
        table_->setColumnWidth(column++, width);
    table_->setColumnWidth(ChecksRows::Verdict, kVerdictWidth);
    table_->horizontalHeader()->setSectionResizeMode(ChecksRows::Step, QHeaderView::Stretch);
}

QWidget* ChecksPanel::headerTools() {
    report_ = makeButton("checksReport", tr("Report"), this);
    report_->setToolTip(tr("Saves or prints the report."));
    auto* menu = new QMenu(report_);
    addReportActions(
        menu, this, [this] { return check_; },
        [this](TimePoint time) { return bench().client().wallTime(time); });
    report_->setMenu(menu);
    report_->setEnabled(false);
    return report_;
}

void ChecksPanel::connectAll() {
    connect(arm_, &QPushButton::clicked, this, [this](bool on) { ask(ArmHighVoltage{summary_.live, on}); });
    connect(start_, &QPushButton::clicked, this, &ChecksPanel::start);
    connect(stop_, &QPushButton::clicked, this, [this] { ask(StopCheck{}); });
    for (std::size_t place = 0; place < answers_.size(); ++place) {
        connect(answers_[place], &QPushButton::clicked, this,
                [this, place] { answer(static_cast<CheckAnswer>(place)); });
    }
    connect(settings_, &ChecksSettingsBox::edited, this, &ChecksPanel::refresh);
    connect(settings_, &ChecksSettingsBox::refused, this, [this](const QString& why) {
        refusal_ = why;
        refresh();
    });
    connect(&choice_, &RobotChoice::changed, this, [this] {
        refusal_.clear();
        refresh();
    });
    connect(&bench(), &Bench::changed, this, &ChecksPanel::refresh);
    connect(&bench().client(), &EngineClient::stopChanged, this, &ChecksPanel::refresh);
}

void ChecksPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    summary_ = snapshot == nullptr ? ChoiceSummary{} : summarize(*snapshot, choice_.chosen());
    if (snapshot != nullptr && !snapshot->check->rows.empty()) check_ = snapshot->check;
    rows_.take(check_);
    table_->setColumnHidden(ChecksRows::Robot, std::popcount(check().plan.robots) == 1);
    showControls(snapshot);
    showQuestion();
    if (report_ != nullptr) report_->setEnabled(!check().rows.empty());
    if (check().rows.empty())
        setNote(summary_.chosen == 0 ? tr("no robot chosen") : robotsText(summary_.chosen));
    else
        setNote(tr("step %1 of %2").arg(check().current + 1).arg(check().rows.size()));
    if (rows_.currentRow() == shownRow_) return;
    shownRow_ = rows_.currentRow();
    if (shownRow_ >= 0) table_->scrollTo(rows_.index(shownRow_, 0), QAbstractItemView::PositionAtCenter);
}

QString ChecksPanel::reasonNotToStart(const Snapshot* snapshot) const {
    QString reason = reasonNotToUse(snapshot, summary_, bench().client().isStopped());
    if (reason.isEmpty() && settings_->plan(summary_.chosen).highVoltage && summary_.armed != All::Every)
        reason = tr("Charge and kick need the robots armed: press Arm.");
    return reason;
}

void ChecksPanel::showControls(const Snapshot* snapshot) {
    const bool running = check().running() && !check().rows.empty();
    const QString reason = reasonNotToStart(snapshot);
    const bool usable = reasonNotToUse(snapshot, summary_, bench().client().isStopped()).isEmpty();
    arm_->setEnabled(!running && usable);
    arm_->setChecked(summary_.armed == All::Every);
    arm_->setText(summary_.armed == All::Every ? tr("Armed") : tr("Arm"));
    arm_->setToolTip(tr("Arms the high voltage of the chosen robots."));
    start_->setEnabled(!running && reason.isEmpty());
    start_->setToolTip(reason);
    setButtonRole(start_, start_->isEnabled() ? ButtonRole::Primary : ButtonRole::Normal);
    stop_->setEnabled(running);
    settings_->setEnabled(!running);
    QString text = refusal_;
    if (text.isEmpty() && !running) text = reason;
    notice_->setText(text);
    notice_->setVisible(!text.isEmpty());
}

void ChecksPanel::showQuestion() {
    const bool some = !check().rows.empty();
    const bool running = some && check().running();
    const bool asking = running && check().stage == CheckStage::Asking;
    if (!asking) answered_.reset();
    const bool open = asking && answered_ != check().current;
    QString text = tr("Checks the chosen robots on their stands, one after another.");
    if (asking)
        text = questionText(check().rows[check().current].step);
    else if (running)
        text = workText(check().rows[check().current], check().stage);
    else if (some)
        text = sentenceOf(check());
    const bool ready = asking && check().rows[check().current].step.kind == CheckKind::Ready;
    if (running && !ready) {
        const QString robot = tr("Robot %1").arg(check().rows[check().current].step.robot);
        text = QStringLiteral("%1: %2").arg(robot, text);
    }
    words_->setText(text);
    for (QPushButton* button : answers_)
        button->setVisible(running);
    for (QPushButton* button : answers_)
        button->setEnabled(open);
    answers_[static_cast<std::size_t>(CheckAnswer::Again)]->setEnabled(open && check().canRepeat());
    // Whether hands are away is not to be answered by habit.
    setButtonRole(answers_[0], open && !ready ? ButtonRole::Primary : ButtonRole::Normal);
}

void ChecksPanel::start() {
    ask(StartCheck{settings_->plan(summary_.chosen)});
}

void ChecksPanel::answer(CheckAnswer answer) {
    // The next question takes a moment to come: a second press is not meant for it.
    answered_ = check().current;
    ask(AnswerCheck{check().current, answer});
    showQuestion();
}

void ChecksPanel::ask(const thunderbots::Command& command) {
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
}

void ChecksPanel::closed() {
    if (check().running() && !check().rows.empty()) bench().client().stop(StopReason::PanelClosed);
}

}  // namespace kickstand::ui
