#include "ui/thunderbots/parameters_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedLayout>
#include <QVBoxLayout>
#include <bit>
#include <chrono>

#include "core/engine/describe_parameters.h"
#include "core/ledger/ledger.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/parameters_ask.h"
#include "ui/thunderbots/parameters_grid.h"
#include "ui/thunderbots/parameters_history.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/segmented.h"
#include "ui/widgets/state_label.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

enum Page { kDraftPage = 0, kHistoryPage = 1 };
/// How often the ledger is looked at while nothing else happens.
constexpr auto kLookEvery = std::chrono::milliseconds(250);

QPushButton* makeButton(const QString& text, const char* name, const QString& tip, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    button->setToolTip(tip);
    return button;
}

Tone toneOf(ParameterStanding standing) {
    switch (standing) {
        case ParameterStanding::Unread:
            return Tone::Idle;
        case ParameterStanding::AsRead:
        case ParameterStanding::Proven:
            return Tone::Good;
        case ParameterStanding::Applied:
        case ParameterStanding::Committed:
            return Tone::Warning;
        case ParameterStanding::Rebooted:
            return Tone::Busy;
        case ParameterStanding::Disproven:
            return Tone::Danger;
    }
    return Tone::Idle;
}

}  // namespace

ParametersPanel::ParametersPanel(Bench& bench, RobotChoice& choice, Ledger& ledger, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      ledger_(ledger),
      grid_(new ParametersGrid(this)),
      history_(new ParametersHistory(this)),
      pages_(new QStackedLayout),
      page_(new Segmented({tr("Draft"), tr("Earlier readings")}, this)),
      state_(new StateLabel(this)),
      notice_(new QLabel(this)) {
    setObjectName(QStringLiteral("parametersPanel"));
    state_->setObjectName(QStringLiteral("parameterState"));
    notice_->setObjectName(QStringLiteral("parameterNotice"));
    notice_->setWordWrap(true);
    notice_->setTextFormat(Qt::PlainText);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, 10, metrics::kPadding, metrics::kGap);
    column->addLayout(pages_);
    pages_->addWidget(makeDraft());
    pages_->addWidget(history_);
    page_->button(kDraftPage)->setObjectName(QStringLiteral("parameterDraftPage"));
    page_->button(kHistoryPage)->setObjectName(QStringLiteral("parameterHistoryPage"));
    page_->setCurrent(kDraftPage);
    connectAll();
    refresh();
}

QWidget* ParametersPanel::makeDraft() {
    auto* box = new QWidget(this);
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap);
    column->addWidget(grid_);
    column->addWidget(makeSteps());
    // Side by side, so that both are seen in the lowest window.
    auto* words = new QHBoxLayout;
    words->setSpacing(metrics::kPadding);
    // A notice that comes wraps, and takes no word from what the robot has.
    state_->setSizePolicy(QSizePolicy::Minimum, QSizePolicy::Fixed);
    words->addWidget(state_);
    words->addWidget(notice_, 1);
    column->addLayout(words);
    column->addStretch(1);
    return box;
}

void ParametersPanel::showPage(int page) {
    page_->setCurrent(page);
    pages_->setCurrentIndex(page);
    refresh();
}

QWidget* ParametersPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    auto* open = makeButton(tr("Open file\u2026"), "parameterOpen",
                            tr("Shows a file of parameters beside the draft."), tools);
    auto* save =
        makeButton(tr("Save draft\u2026"), "parameterSave", tr("Writes the draft to a file."), tools);
    row->addWidget(page_);
    row->addWidget(open);
    row->addWidget(save);
    connect(open, &QPushButton::clicked, this, &ParametersPanel::openFile);
    connect(save, &QPushButton::clicked, this, &ParametersPanel::saveFile);
    return tools;
}

void ParametersPanel::addEdits(QHBoxLayout& row) {
    const auto add = [this, &row](const QString& text, const char* name, const QKeySequence& key,
                                  const QString& tip) {
        auto* action = new QAction(text, this);
        action->setObjectName(QString::fromLatin1(name) + QStringLiteral("Action"));
        action->setShortcut(key);
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        addAction(action);
        const QString keys = key.toString(QKeySequence::NativeText);
        QPushButton* button =
            makeButton(text, name, keys.isEmpty() ? tip : QStringLiteral("%1 (%2)").arg(tip, keys), this);
        connect(button, &QPushButton::clicked, action, &QAction::trigger);
        connect(action, &QAction::enabledChanged, button, &QPushButton::setEnabled);
        row.addWidget(button);
        return action;
    };
    undo_ = add(tr("Undo"), "parameterUndo", QKeySequence::Undo, tr("Takes the last step back"));
    redo_ = add(tr("Redo"), "parameterRedo", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z),
                tr("Takes the step again"));
    reset_ = add(tr("Reset"), "parameterReset", {}, tr("Back to what the robot has"));
}

QWidget* ParametersPanel::makeSteps() {
    auto* box = new QWidget(this);
    auto* row = new QHBoxLayout(box);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    read_ = makeButton(tr("Read"), "parameterRead",
                       tr("Reads what the robot works with now, and which firmware it has."), box);
    apply_ = makeButton(tr("Apply"), "parameterApply",
                        tr("Gives the robot the ticked changes. They live until it reboots."), box);
    commit_ = makeButton(tr("Commit"), "parameterCommit",
                         tr("Has the robot keep what it works with now, over reboots too."), box);
    reboot_ = makeButton(tr("Reboot"), "parameterReboot",
                         tr("Reboots the robot and reads it again, which proves a commit."), box);
    for (QPushButton* button : {read_, apply_, commit_, reboot_})
        row->addWidget(button);
    setButtonRole(apply_, ButtonRole::Primary);
    row->addStretch(1);
    addEdits(*row);
    return box;
}

void ParametersPanel::connectAll() {
    connect(grid_, &ParametersGrid::edited, this,
            [this](ParameterField field, std::uint8_t value, bool goesOn) {
                draft().set(field, value, goesOn);
                refresh();
            });
    connect(grid_, &ParametersGrid::takeAsked, this, [this](ParameterField field) {
        draft().take(other().values, maskOf(field));
        refresh();
    });
    connect(grid_, &ParametersGrid::ticksChanged, this, &ParametersPanel::refresh);
    connect(grid_, &ParametersGrid::takeAllAsked, this, [this] {
        draft().take(other().values, kSettings);
        refresh();
    });
    connect(undo_, &QAction::triggered, this, [this] {
        draft().undo();
        refresh();
    });
    connect(redo_, &QAction::triggered, this, [this] {
        draft().redo();
        refresh();
    });
    connect(reset_, &QAction::triggered, this, [this] {
        draft().reset();
        refresh();
    });
    connect(page_, &Segmented::asked, this, &ParametersPanel::showPage);
    connect(read_, &QPushButton::clicked, this, &ParametersPanel::read);
    connect(apply_, &QPushButton::clicked, this, &ParametersPanel::apply);
    connect(commit_, &QPushButton::clicked, this, &ParametersPanel::commit);
    connect(reboot_, &QPushButton::clicked, this, &ParametersPanel::reboot);
    connect(history_, &ParametersHistory::compareAsked, this, [this] {
        compare();
        showPage(kDraftPage);
    });
    connect(history_, &ParametersHistory::restoreAsked, this, [this] {
        restore();
        showPage(kDraftPage);
    });
    connect(history_, &ParametersHistory::noteAsked, this, &ParametersPanel::editNote);
    connect(&choice_, &RobotChoice::changed, this, [this] {
        refusal_.clear();
        refresh();
    });
    // Behind another panel nobody sees it.
    const auto follow = [this] {
        if (isVisible()) refresh();
    };
    connect(&bench(), &Bench::changed, this, follow);
    connect(&bench(), &Bench::sessionChanged, this, &ParametersPanel::forgetDrafts);
    connect(&bench().client(), &EngineClient::stopChanged, this, &ParametersPanel::refresh);
    connect(&looks_, &QTimer::timeout, this, follow);
    looks_.start(kLookEvery);
}

void ParametersPanel::forgetDrafts() {
    drafts_ = {};
    others_ = {};
    refusal_.clear();
    refresh();
}

void ParametersPanel::takeReadings(const Snapshot* snapshot) {
    for (int robot = 0; robot < kRobots; ++robot) {
        const auto at = static_cast<std::size_t>(robot);
        drafts_[at].setRobot(snapshot == nullptr ? std::nullopt : snapshot->parameters[at].robot);
    }
}

void ParametersPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    refresh();
}

void ParametersPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    const RobotMask chosen = choice_.chosen();
    chosen_ = std::popcount(chosen);
    if (chosen != 0) robot_ = std::countr_zero(chosen);
    takeReadings(snapshot);
    grid_->showValues(draft(), other().values, other().title.isEmpty() ? tr("File") : other().title,
                      chosen_ == 1);
    history_->showView(ledger_.view(), chosen_ == 1 ? robot_ : -1);
    showState(snapshot);
    showSteps(snapshot);
    showEdits();
    setNote(chosen_ == 0 ? tr("no robot chosen") : robotsText(chosen));
}

void ParametersPanel::showState(const Snapshot* snapshot) {
    if (snapshot == nullptr || chosen_ != 1) {
        state_->setState(Tone::Idle, tr("No robot's parameters are shown."));
        return;
    }
    const ParameterState& state = snapshot->parameters[static_cast<std::size_t>(robot_)];
    state_->setState(toneOf(state.standing), describe(state));
    if (!state.signatures) {
        state_->setToolTip(tr("Its build signatures have not been read."));
        return;
    }
    state_->setToolTip(tr("Build signatures: microcontroller 0x%1, flash 0x%2")
                           .arg(state.signatures->microcontrollerCrc, 4, 16, QLatin1Char('0'))
                           .arg(state.signatures->flashCrc, 4, 16, QLatin1Char('0')));
}

void ParametersPanel::showSteps(const Snapshot* snapshot) {
    const QString reason = reasonNotToAsk(snapshot, robot_, chosen_);
    const bool can = reason.isEmpty();
    const bool known = can && draft().robot().has_value();
    const int ticked = std::popcount(grid_->ticked());
    read_->setEnabled(can);
    apply_->setEnabled(known && ticked > 0);
    apply_->setText(ticked > 1 ? tr("Apply %1 changes").arg(ticked) : tr("Apply"));
    commit_->setEnabled(known);
    reboot_->setEnabled(can && reasonNotToReboot(*snapshot, robot_, bench().client().isStopped()).isEmpty());
    showNotice(snapshot, reason);
}

void ParametersPanel::showNotice(const Snapshot* snapshot, const QString& reason) {
    QString text = reason.isEmpty() ? refusal_ : reason;
    if (text.isEmpty() && !draft().robot()) text = tr("Read the robot's parameters first.");
    if (text.isEmpty() && snapshot != nullptr)
        text = reasonNotToReboot(*snapshot, robot_, bench().client().isStopped());
    notice_->setText(text);
    notice_->setVisible(!text.isEmpty());
    notice_->setForegroundRole(text == refusal_ && !text.isEmpty() ? QPalette::WindowText
                                                                   : QPalette::PlaceholderText);
}

void ParametersPanel::showEdits() {
    const bool editable = chosen_ == 1;
    undo_->setEnabled(editable && draft().canUndo());
    redo_->setEnabled(editable && draft().canRedo());
    reset_->setEnabled(editable && draft().changes() != 0);
}

void ParametersPanel::ask(const thunderbots::Command& command) {
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        if (!result) refusal_ = describe(result.error()).line();
        refresh();
    });
    refresh();
}

void ParametersPanel::read() {
    const int robot = robot_;
    bench().submit(SystemCommand{thunderbots::Command{ReadParameters{robot}}}, this,
                   [this, robot](const Result<void>& result) {
                       refusal_ = result ? QString() : describe(result.error()).line();
                       // Which firmware it is goes with what it was told; that takes longer.
                       if (result) ask(ReadSignatures{robot});
                       refresh();
                   });
}

void ParametersPanel::askFirst(ParameterStep step, const wire::OperationalParameters& block,
                               const thunderbots::Command& command) {
    const Snapshot* snapshot = snapshotOf(bench().session());
    if (snapshot == nullptr) return;
    QStringList sentences;
    bool serious = false;
    for (const ParameterWarning& warning : warningsBefore(step, robot_, block, *snapshot)) {
        sentences << describe(warning, step);
        serious = serious || warning.serious();
    }
    askBefore(step, robot_, sentences, serious, this, [this, command] { ask(command); });
}

void ParametersPanel::apply() {
    const auto block = draft().blockWith(grid_->ticked());
    if (block) askFirst(ParameterStep::Apply, *block, ApplyParameters{robot_, *block});
}

void ParametersPanel::commit() {
    if (const auto& block = draft().robot())
        askFirst(ParameterStep::Commit, *block, CommitParameters{robot_});
}

void ParametersPanel::reboot() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    if (snapshot == nullptr) return;
    const ParameterState& state = snapshot->parameters[static_cast<std::size_t>(robot_)];
    if (state.standing == ParameterStanding::Applied) {
        askBefore(ParameterStep::Reboot, robot_,
                  {tr("What was applied and not committed is lost with the reboot.")}, false, this,
                  [this, robot = robot_] {
                      ask(RebootRobot{robot, true});
                  });
    } else if (state.robot) {
        askFirst(ParameterStep::Reboot, *state.robot, RebootRobot{robot_});
    } else {
        ask(RebootRobot{robot_});
    }
}

}  // namespace kickstand::ui
