#include "ui/smartdevice/plots_panel.h"

#include <QBuffer>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSettings>
#include <chrono>

#include "core/engine/describe.h"
#include "ui/plot/plot_tools.h"
#include "ui/plot/time_plot.h"
#include "ui/plot/time_ticks.h"
#include "ui/shell/bench.h"
#include "ui/smartdevice/device_choice.h"
#include "ui/smartdevice/plot_choice.h"
#include "ui/smartdevice/smartdevice_view.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

using namespace std::chrono_literals;

constexpr const char* kSpanSetting = "smartdevice/span_s";
constexpr int kFirstSpan_s = 30;
constexpr int kTreeWidth = 272;
constexpr auto kNumbersInterval = 200ms;

}  // namespace

PlotsPanel::PlotsPanel(Bench& bench, DeviceChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      tree_(new PlotChoice(bench.settings(), this)),
      plot_(new TimePlot({[&bench] { return bench.client().now(); },
                          [&bench](TimePoint time) { return bench.client().wallTime(time); }},
                         this)),
      empty_(new QLabel(this)) {
    build();
    plot_->setSpan(std::chrono::seconds(bench.settings().value(kSpanSetting, kFirstSpan_s).toInt()));
    plot_->setDescribeMark([this](const Mark& mark) { return wordsOf(mark); });
    connect(&bench, &Bench::sessionChanged, this, &PlotsPanel::refresh);
    connect(&choice, &DeviceChoice::changed, this, &PlotsPanel::refresh);
    connect(tree_, &PlotChoice::changed, this, &PlotsPanel::refresh);
    connect(&numbers_, &QTimer::timeout, this, &PlotsPanel::refresh);
    refresh();
}

void PlotsPanel::build() {
    plot_->setObjectName(QStringLiteral("boardPlot"));
    plot_->setAccessibleName(tr("Curves of the boards' parameters"));
    plot_->setAccessibleDescription(
        tr("Arrow keys move, plus and minus zoom, Ctrl with them zooms values; P pauses, F follows, C shows "
           "cursors, Shift with arrows moves one, X takes the other; M goes to the next mark."));
    empty_->setObjectName(QStringLiteral("boardPlotEmpty"));
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    empty_->setForegroundRole(QPalette::PlaceholderText);
    tree_->setFixedWidth(kTreeWidth);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(4, 2, metrics::kGap, 4);
    grid->setSpacing(4);
    grid->addWidget(tree_, 0, 0);
    grid->addWidget(plot_, 0, 1);
    grid->addWidget(empty_, 0, 1);
    grid->setColumnStretch(1, 1);
}

QWidget* PlotsPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    auto* common = new PlotTools(*plot_, QStringLiteral("boardPlot"), tools);
    connect(common, &PlotTools::spanChosen, this,
            [this](int span_s) { bench().settings().setValue(kSpanSetting, span_s); });
    row->addWidget(common);
    row->addWidget(makeSave(tools));
    return tools;
}

QWidget* PlotsPanel::makeSave(QWidget* parent) {
    auto* menu = new QMenu(parent);
    menu->addAction(tr("&Picture\u2026"), this, [this] {
        askToSave(this, tr("Save the picture"), tr("boards.png"), QStringLiteral("png"), [this] {
            QBuffer bytes;
            bytes.open(QIODevice::WriteOnly);
            plot_->picture().save(&bytes, "PNG");
            return bytes.data();
        });
    });
    menu->addAction(tr("&Values as CSV\u2026"), this, [this] {
        askToSave(this, tr("Save the values"), tr("boards.csv"), QStringLiteral("csv"), [this] {
            return csvOf(plot_->seen(),
                         [this](TimePoint time) { return clockText(bench().client().wallTime(time)); })
                .toUtf8();
        });
    });
    auto* button = new QPushButton(tr("Save"), parent);
    button->setObjectName(QStringLiteral("boardPlotSave"));
    button->setAutoDefault(false);
    button->setMenu(menu);
    button->setToolTip(tr("What is seen, as a picture or as numbers"));
    return button;
}

std::optional<MarkWords> PlotsPanel::wordsOf(const Mark& mark) const {
    QString title;
    const Snapshot* snapshot = boardsOf(bench().session());
    if (snapshot != nullptr && mark.unit < snapshot->devices.size())
        title = titleOf(bench().settings(), snapshot->devices[mark.unit]);
    switch (mark.kind) {
        case MarkKind::Stop:
            return MarkWords{
                tr("STOP"),
                tr("STOP: %1").arg(describe(static_cast<StopReason>(static_cast<int>(mark.value)))),
                MarkTone::Danger};
        case MarkKind::Rearmed:
            return MarkWords{tr("re-armed"), tr("Re-armed after STOP")};
        case MarkKind::UnitHeard:
            return MarkWords{tr("%1 found").arg(title), tr("%1 was found").arg(title)};
        case MarkKind::UnitLost:
            return MarkWords{tr("%1 lost").arg(title), tr("%1 was lost").arg(title), MarkTone::Danger};
        case MarkKind::DeviceError:
            return MarkWords{tr("%1 error").arg(title),
                             tr("%1 reported error %2").arg(title).arg(static_cast<int>(mark.value)),
                             MarkTone::Danger};
        default:
            return std::nullopt;
    }
}

void PlotsPanel::refresh() {
    const SessionSnapshot* session = bench().session();
    const Snapshot* snapshot = boardsOf(session);
    plot_->setStore(snapshot == nullptr ? nullptr : session->telemetry);
    if (tree_->follow(snapshot, bench().client().now()))
        plot_->setContents(tree_->contents().areas, tree_->contents().curves);
    QString why;
    if (snapshot == nullptr)
        why = tr("Not connected.");
    else if (snapshot->devices.empty())
        why = tr("No board is there yet.");
    else if (tree_->contents().curves.empty())
        why = tr("Check the parameters at the left that are to be plotted.");
    empty_->setText(why);
    empty_->setVisible(!why.isEmpty());
    plot_->setVisible(why.isEmpty());
}

void PlotsPanel::showEvent(QShowEvent* event) {
    Panel::showEvent(event);
    refresh();
    numbers_.start(kNumbersInterval);
}

void PlotsPanel::hideEvent(QHideEvent* event) {
    numbers_.stop();
    Panel::hideEvent(event);
}

}  // namespace kickstand::ui
