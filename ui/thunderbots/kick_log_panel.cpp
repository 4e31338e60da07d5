#include "ui/thunderbots/kick_log_panel.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <algorithm>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/kick_settings.h"
#include "ui/thunderbots/kick_state.h"
#include "ui/thunderbots/kick_sweep_box.h"
#include "ui/thunderbots/kick_words.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/scrolled.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kRowHeight = 24;
/// Its fields and the scroll bar beside them.
constexpr int kSweepWidth = 256;
constexpr int kColumnGap = 16;
constexpr int kWidths[] = {82, 46, 64, 62, 62, 60, 62, 62, 58, 64, 120, 40};

}  // namespace

KickLogPanel::KickLogPanel(Bench& bench, RobotChoice& choice, KickSettings& kick, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      kick_(kick),
      rows_([&client = bench.client()](TimePoint time) { return client.wallTime(time); }),
      sweep_(new KickSweepBox(bench.settings(), this)),
      table_(new QTableView(this)),
      empty_(new QLabel(tr("No kick yet."), this)) {
    setObjectName(QStringLiteral("kickLogPanel"));
    sorted_.setSourceModel(&rows_);
    sorted_.setSortRole(KickRows::kSortRole);
    buildTable();
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    empty_->setAttribute(Qt::WA_TransparentForMouseEvents);
    // Where the window is too low for what a sweep says of itself, it can be scrolled to.
    QScrollArea* scroll = scrolled(sweep_, this);
    scroll->setFixedWidth(kSweepWidth);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(metrics::kPadding, 4, 1, metrics::kPanelRadius);
    grid->setHorizontalSpacing(kColumnGap);
    grid->addWidget(scroll, 0, 0);
    grid->addWidget(table_, 0, 1);
    grid->addWidget(empty_, 0, 1);
    grid->setColumnStretch(1, 1);
    connect(sweep_, &KickSweepBox::startAsked, this, &KickLogPanel::startSweep);
    connect(sweep_, &KickSweepBox::stopAsked, this, [this] { ask(StopSweep{}); });
    connect(sweep_, &KickSweepBox::edited, this, &KickLogPanel::refresh);
    connect(&kick_, &KickSettings::changed, this, &KickLogPanel::refresh);
    connect(&choice_, &RobotChoice::changed, this, &KickLogPanel::refresh);
    connect(&bench, &Bench::changed, this, &KickLogPanel::refresh);
    connect(&bench.client(), &EngineClient::stopChanged, this, &KickLogPanel::refresh);
    refresh();
}

void KickLogPanel::buildTable() {
    table_->setObjectName(QStringLiteral("kickTable"));
    table_->setAccessibleName(tr("Kicks"));
    table_->setModel(&sorted_);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setWordWrap(false);
    table_->setFont(numberFont(metrics::kTextSize));
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    table_->setTabKeyNavigation(false);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::SelectedClicked);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setMinimumSectionSize(kRowHeight);
    table_->verticalHeader()->setDefaultSectionSize(kRowHeight);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setHighlightSections(false);
    int column = 0;
    for (const int width : kWidths)
        table_->setColumnWidth(column++, width);
    table_->setSortingEnabled(true);
    table_->sortByColumn(KickRows::Time, Qt::DescendingOrder);
    auto* copyRows = new QAction(tr("Copy"), table_);
    copyRows->setShortcut(QKeySequence::Copy);
    copyRows->setShortcutContext(Qt::WidgetShortcut);
    connect(copyRows, &QAction::triggered, this, &KickLogPanel::copy);
    table_->addAction(copyRows);
    table_->setContextMenuPolicy(Qt::ActionsContextMenu);
}

QWidget* KickLogPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    row->addWidget(sweep_->buttons());
    row->addSpacing(metrics::kGap);
    auto* copyButton = new QPushButton(tr("Copy"), tools);
    copyButton->setObjectName(QStringLiteral("kickCopy"));
    copyButton->setToolTip(tr("Copies the selected kicks, or all, as comma-separated values."));
    auto* save = new QPushButton(tr("Save as CSV\u2026"), tools);
    save->setObjectName(QStringLiteral("kickSave"));
    for (QPushButton* button : {copyButton, save}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(copyButton, &QPushButton::clicked, this, &KickLogPanel::copy);
    connect(save, &QPushButton::clicked, this, [this] {
        askToSave(this, tr("Save kicks"), QStringLiteral("kicks.csv"), QStringLiteral("csv"), [this] {
            const EngineClient& client = bench().client();
            return kickCsv(rows_.rows(), [&client](TimePoint time) { return client.wallTime(time); })
                .toUtf8();
        });
    });
    return tools;
}

void KickLogPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    summary_ = snapshot == nullptr ? ChoiceSummary{} : summarize(*snapshot, choice_.chosen());
    takeRows(snapshot);
    empty_->setVisible(rows_.rowCount() == 0);
    setNote(rows_.rowCount() == 1 ? tr("1 kick") : tr("%1 kicks").arg(rows_.rowCount()));
    showSweep(snapshot);
}

void KickLogPanel::takeRows(const Snapshot* snapshot) {
    std::vector<SessionId> alive;
    for (const SessionSnapshot& session : bench().client().snapshot().sessions)
        alive.push_back(session.id);
    rows_.endAllBut(alive);
    if (snapshot != nullptr && snapshot->kicks != taken_) {
        taken_ = snapshot->kicks;
        const SessionSnapshot& session = *bench().session();
        rows_.take(session.id, QString::fromStdString(toString(session.uri)), *taken_);
    }
    table_->setColumnHidden(KickRows::Link, !rows_.hasSeveralLinks());
}

void KickLogPanel::showSweep(const Snapshot* snapshot) {
    bool possible = false;
    const QString words = outlook(possible);
    QString reason = reasonNotToSweep(snapshot, summary_, bench().client().isStopped());
    if (reason.isEmpty() && !possible) reason = words;
    sweep_->showState(snapshot == nullptr ? std::nullopt : snapshot->sweep, reason,
                      refusal_.isEmpty() ? words : refusal_);
}

QString KickLogPanel::outlook(bool& possible) const {
    const SweepPlan plan = sweep_->plan(std::max(0, onlyRobot(summary_)), kick_.pulses());
    const auto kicks = planSweep(plan);
    possible = kicks.has_value();
    if (!kicks) return describe(kicks.error()).line();
    QString text = tr("%1 kicks in %2 steps.").arg(kicks->size()).arg(stepsOf(plan));
    if (plan.otherWidth_us > 0) {
        text += tr(" Width %1 stays %2 \u00b5s, the offset %3 \u00b5s.")
                    .arg(plan.solenoid == 1 ? 2 : 1)
                    .arg(plan.otherWidth_us)
                    .arg(signedNumber(plan.offset_us));
    }
    return text;
}

void KickLogPanel::startSweep() {
    const int robot = onlyRobot(summary_);
    if (robot >= 0) ask(StartSweep{sweep_->plan(robot, kick_.pulses())});
}

std::vector<KickRow> KickLogPanel::wantedRows() const {
    QModelIndexList shown = table_->selectionModel()->selectedRows();
    std::sort(shown.begin(), shown.end(),
              [](const QModelIndex& a, const QModelIndex& b) { return a.row() < b.row(); });
    if (shown.isEmpty()) return rows_.rows();
    std::vector<KickRow> wanted;
    wanted.reserve(static_cast<std::size_t>(shown.size()));
    for (const QModelIndex& row : shown)
        wanted.push_back(rows_.rows()[static_cast<std::size_t>(sorted_.mapToSource(row).row())]);
    return wanted;
}

void KickLogPanel::copy() {
    const EngineClient& client = bench().client();
    QApplication::clipboard()->setText(
        kickCsv(wantedRows(), [&client](TimePoint time) { return client.wallTime(time); }));
}

void KickLogPanel::ask(const thunderbots::Command& command) {
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
}

void KickLogPanel::closed() {
    if (bench().isActive()) bench().client().stop(StopReason::PanelClosed);
}

}  // namespace kickstand::ui
