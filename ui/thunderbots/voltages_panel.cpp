#include "ui/thunderbots/voltages_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSaveFile>
#include <QSettings>
#include <chrono>

#include "ui/plot/plot_tools.h"
#include "ui/plot/time_plot.h"
#include "ui/plot/time_ticks.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/thunderbots/voltages_table.h"
#include "ui/thunderbots/voltages_trigger.h"
#include "ui/thunderbots/words.h"
#include "ui/widgets/bench_style.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

using namespace std::chrono_literals;

constexpr const char* kSignalsSetting = "voltages/signals";
constexpr const char* kSpanSetting = "voltages/span_s";
constexpr const char* kRobotsSetting = "voltages/robots";
constexpr SignalMask kFirstSignals = bitOf(Signal::Battery_V) | bitOf(Signal::Capacitor_V);
constexpr int kFirstSpan_s = 60;
constexpr auto kNumbersInterval = 200ms;
constexpr auto kMessageTime = 6s;

QPushButton* menuButton(const char* name, QMenu* menu, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    button->setMenu(menu);
    return button;
}

}  // namespace

VoltagesPanel::VoltagesPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      plot_(new TimePlot({[&bench] { return bench.client().now(); },
                          [&bench](TimePoint time) { return bench.client().wallTime(time); }},
                         this)),
      table_(new VoltagesTable(this)),
      trigger_(new VoltagesTrigger(this)),
      body_(new QWidget(this)),
      empty_(new QLabel(this)),
      message_(new QLabel(this)),
      signals_(bench.settings().value(kSignalsSetting, kFirstSignals).toUInt()) {
    const QVariant pinned = bench.settings().value(kRobotsSetting);
    if (pinned.isValid()) pinned_ = static_cast<RobotMask>(pinned.toUInt() & kAllRobots);
    build();
    plot_->setSpan(std::chrono::seconds(bench.settings().value(kSpanSetting, kFirstSpan_s).toInt()));
    plot_->setDescribeMark([this](const Mark& mark) { return markWords(mark, shownRobots_); }, marksText);
    connect(&bench, &Bench::changed, this, &VoltagesPanel::refresh);
    connect(&choice_, &RobotChoice::changed, this, &VoltagesPanel::refresh);
    connect(plot_, &TimePlot::viewChanged, this, &VoltagesPanel::refreshTools);
    connect(plot_, &TimePlot::viewChanged, this, &VoltagesPanel::refreshNumbers);
    connect(trigger_, &VoltagesTrigger::armed, plot_, &TimePlot::arm);
    connect(&numbers_, &QTimer::timeout, this, &VoltagesPanel::refreshNumbers);
    connect(&quiet_, &QTimer::timeout, message_, &QLabel::hide);
    refresh();
}

void VoltagesPanel::build() {
    plot_->setAccessibleDescription(
        tr("Arrow keys move, plus and minus zoom, Ctrl with them zooms values; P pauses, F follows, C shows "
           "cursors, Shift with arrows moves one, X takes the other; M goes to the next mark."));
    plot_->setToolTip({});
    empty_->setObjectName(QStringLiteral("voltagesEmpty"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    message_->setObjectName(QStringLiteral("voltagesMessage"));
    message_->setContentsMargins(metrics::kPadding, 2, metrics::kPadding, 2);
    message_->hide();
    trigger_->hide();
    quiet_.setSingleShot(true);
    auto* row = new QHBoxLayout(body_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(plot_, 1);
    row->addWidget(table_);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(4, 2, metrics::kGap, 4);
    layout->setSpacing(0);
    layout->addWidget(trigger_, 0, 0);
    layout->addWidget(message_, 1, 0);
    layout->addWidget(body_, 2, 0);
    layout->addWidget(empty_, 2, 0);
    layout->setRowStretch(2, 1);
}

QWidget* VoltagesPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    auto* common = new PlotTools(*plot_, QStringLiteral("plot"), tools);
    connect(common, &PlotTools::spanChosen, this,
            [this](int span_s) { bench().settings().setValue(kSpanSetting, span_s); });
    triggerButton_ =
        toggle(tr("Trigger"), "plotTrigger", tr("Stands still when a curve crosses a level"), tools);
    connect(triggerButton_, &QPushButton::clicked, this, [this](bool on) {
        trigger_->setVisible(on);
        if (!on) plot_->disarm();
    });
    row->addWidget(robotsButton(tools));
    row->addWidget(signalsButton(tools));
    row->addWidget(common);
    row->addWidget(triggerButton_);
    row->addWidget(saveButton(tools));
    refreshTools();
    return tools;
}

QPushButton* VoltagesPanel::toggle(const QString& text, const char* name, const QString& tip,
                                   QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setCheckable(true);
    button->setAutoDefault(false);
    button->setToolTip(tip);
    return button;
}

QPushButton* VoltagesPanel::robotsButton(QWidget* parent) {
    robotsMenu_ = new QMenu(parent);
    robotsMenu_->setObjectName(QStringLiteral("plotRobotsMenu"));
    QAction* follow =
        robotsMenu_->addAction(tr("Those that are &chosen"), this, [this] { pin(std::nullopt); });
    follow->setCheckable(true);
    robotsMenu_->addSeparator();
    for (int robot = 0; robot < kRobots; ++robot) {
        QAction* action = robotsMenu_->addAction(tr("Robot %1").arg(robot), this, [this, robot](bool on) {
            const RobotMask one = maskOf(robot);
            const RobotMask before = pinned_.value_or(shownRobots_);
            pin(static_cast<RobotMask>(on ? before | one : before & ~one));
        });
        action->setCheckable(true);
    }
    connect(robotsMenu_, &QMenu::aboutToShow, this, [this] {
        const QList<QAction*> actions = robotsMenu_->actions();
        actions[0]->setChecked(!pinned_);
        for (int robot = 0; robot < kRobots; ++robot)
            actions[2 + robot]->setChecked(contains(shownRobots_, robot));
    });
    robotsButton_ = menuButton("plotRobots", robotsMenu_, parent);
    robotsButton_->setAccessibleName(tr("Robots that are shown"));
    robotsButton_->setToolTip(tr("Shows the robots that are chosen in the grid, or some that are pinned"));
    return robotsButton_;
}

QPushButton* VoltagesPanel::signalsButton(QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("plotSignalsMenu"));
    for (int i = 0; i < kSignals; ++i) {
        const auto signal = static_cast<Signal>(i);
        QAction* action =
            menu->addAction(signalName(signal), this, [this, signal](bool on) { setSignal(signal, on); });
        action->setCheckable(true);
        action->setChecked((signals_ & bitOf(signal)) != 0);
    }
    QPushButton* button = menuButton("plotSignals", menu, parent);
    button->setText(tr("Signals"));
    button->setToolTip(tr("What is shown of each robot"));
    return button;
}

QPushButton* VoltagesPanel::saveButton(QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->setObjectName(QStringLiteral("plotSaveMenu"));
    menu->addAction(tr("&Picture\u2026"), this, [this] {
        askFile(tr("Save the picture"), QStringLiteral("png"), &VoltagesPanel::savePicture);
    });
    menu->addAction(tr("&Values as CSV\u2026"), this, [this] {
        askFile(tr("Save the values"), QStringLiteral("csv"), &VoltagesPanel::saveValues);
    });
    menu->addAction(tr("&Copy picture"), this, [this] {
        QApplication::clipboard()->setPixmap(bodyPicture());
        say(tr("The picture is in the clipboard."));
    });
    menu->addAction(tr("Copy &table"), this, [this] {
        QApplication::clipboard()->setText(table_->text());
        say(tr("The table is in the clipboard."));
    });
    QPushButton* button = menuButton("plotSave", menu, parent);
    button->setText(tr("Save"));
    button->setToolTip(tr("What is seen, as a picture or as numbers"));
    return button;
}

RobotMask VoltagesPanel::robots() const {
    if (pinned_) return *pinned_;
    if (choice_.chosen() != 0) return choice_.chosen();
    RobotMask heard = 0;
    const Snapshot* snapshot = snapshotOf(bench().session());
    for (int robot = 0; snapshot != nullptr && robot < kRobots; ++robot) {
        const RobotState& state = snapshot->robots[static_cast<std::size_t>(robot)];
        if (state.live || state.feedback) heard |= maskOf(robot);
    }
    return heard;
}

void VoltagesPanel::refresh() {
    const SessionSnapshot* session = bench().session();
    plot_->setStore(session == nullptr ? nullptr : session->telemetry);
    const RobotMask wanted = robots();
    if (wanted != shownRobots_ || signals_ != shownSignals_) {
        shownRobots_ = wanted;
        shownSignals_ = signals_;
        refreshContents();
    }
    refreshTools();
    refreshEmpty();
}

void VoltagesPanel::refreshContents() {
    VoltagesContents contents = voltagesContents(shownRobots_, shownSignals_);
    trigger_->setCurves(contents.curves, contents.areas);
    plot_->setContents(contents.areas, std::move(contents.curves));
    refreshNumbers();
}

void VoltagesPanel::refreshEmpty() {
    QString why;
    if (bench().session() == nullptr) {
        why = tr("Not connected.");
    } else if (shownSignals_ == 0) {
        why = tr("No signal is chosen: choose some under Signals.");
    } else if (shownRobots_ == 0) {
        why = pinned_ ? tr("No robot is pinned: choose some under the first button.")
                      : tr("No robot is heard yet. Curves begin with its first readings.");
    }
    empty_->setText(why);
    empty_->setVisible(!why.isEmpty());
    body_->setVisible(why.isEmpty());
}

void VoltagesPanel::refreshNumbers() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    const Cursors& cursors = plot_->state().cursors;
    std::vector<CurveLine> lines;
    lines.reserve(plot_->state().curves.size());
    for (const PlotCurve& curve : plot_->state().curves) {
        const auto signal = static_cast<Signal>(curve.signal.signal);
        CurveLine line{curve.colour, curve.tag, signalName(signal), {QStringLiteral("\u2014")}, {}};
        if (snapshot != nullptr) line.now = nowText(snapshot->robots[curve.signal.unit], signal);
        if (cursors.isShown()) {
            const auto a = plot_->valueAt(curve, cursors.at(0));
            const auto b = plot_->valueAt(curve, cursors.at(1));
            const auto text = [signal](std::optional<float> value) {
                return value ? valueText(static_cast<double>(*value), signal) : QStringLiteral("\u2014");
            };
            line.values = {text(a), text(b), text(a && b ? std::optional(*b - *a) : std::nullopt)};
        } else if (const auto stats = plot_->statsOf(curve)) {
            line.values = {valueText(static_cast<double>(stats->min), signal),
                           valueText(static_cast<double>(stats->max), signal),
                           valueText(stats->mean, signal)};
        } else {
            line.values.fill(QStringLiteral("\u2014"));
        }
        lines.push_back(std::move(line));
    }
    table_->lines().setLines(std::move(lines), cursors.isShown());
}

void VoltagesPanel::refreshTools() {
    if (robotsButton_ == nullptr) return;
    const QString chosen = choice_.chosen() == 0 ? tr("All heard") : tr("As chosen");
    robotsButton_->setText(pinned_ ? tr("Pinned: %1").arg(std::popcount(*pinned_)) : chosen);
    const std::optional<PlotTrigger>& trigger = plot_->state().trigger;
    if (!trigger) {
        trigger_->setState({}, false);
    } else if (trigger->state == PlotTrigger::State::Waiting) {
        trigger_->setState(tr("waiting\u2026"), true);
    } else {
        const QString at = clockText(bench().client().wallTime(trigger->caughtAt));
        trigger_->setState(tr("fired at %1").arg(at), false);
    }
}

void VoltagesPanel::pin(std::optional<RobotMask> robots) {
    pinned_ = robots;
    if (pinned_) {
        bench().settings().setValue(kRobotsSetting, uint{*pinned_});
    } else {
        bench().settings().remove(kRobotsSetting);
    }
    refresh();
}

void VoltagesPanel::setSignal(Signal signal, bool shown) {
    signals_ = shown ? signals_ | bitOf(signal) : signals_ & ~bitOf(signal);
    bench().settings().setValue(kSignalsSetting, signals_);
    refresh();
}

void VoltagesPanel::askFile(const QString& title, const QString& suffix,
                            bool (VoltagesPanel::*save)(const QString&)) {
    auto* dialog = new QFileDialog(this, title);
    dialog->setObjectName(QStringLiteral("plotFile"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setOption(QFileDialog::DontUseNativeDialog);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(suffix);
    dialog->setNameFilter(suffix == QLatin1String("png") ? tr("Pictures (*.png)") : tr("Tables (*.csv)"));
    dialog->selectFile(tr("voltages") + u'.' + suffix);
    connect(dialog, &QFileDialog::fileSelected, this,
            [this, save](const QString& file) { (this->*save)(file); });
    dialog->open();
}

QPixmap VoltagesPanel::bodyPicture() {
    plot_->frame();
    return body_->grab();
}

bool VoltagesPanel::savePicture(const QString& file) {
    QSaveFile out(file);
    const bool written = out.open(QIODevice::WriteOnly) && bodyPicture().save(&out, "PNG") && out.commit();
    return saved(file, written ? QString() : out.errorString());
}

bool VoltagesPanel::saveValues(const QString& file) {
    const QString text =
        csvOf(plot_->seen(), [this](TimePoint time) { return clockText(bench().client().wallTime(time)); });
    QSaveFile out(file);
    const QByteArray bytes = text.toUtf8();
    const bool written = out.open(QIODevice::WriteOnly) && out.write(bytes) == bytes.size() && out.commit();
    return saved(file, written ? QString() : out.errorString());
}

bool VoltagesPanel::saved(const QString& file, const QString& error) {
    say(error.isEmpty() ? tr("Saved as %1.").arg(file) : tr("Cannot write %1: %2.").arg(file, error));
    return error.isEmpty();
}

void VoltagesPanel::say(const QString& text) {
    message_->setText(text);
    message_->show();
    quiet_.start(kMessageTime);
}

void VoltagesPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    refreshNumbers();
    numbers_.start(kNumbersInterval);
}

void VoltagesPanel::hideEvent(QHideEvent* event) {
    numbers_.stop();
    Panel::hideEvent(event);
}

}  // namespace kickstand::ui
