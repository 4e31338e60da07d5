#include "ui/thunderbots/experiment_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableView>
#include <QVBoxLayout>

#include "core/thunderbots/commands.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/experiment_plot.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/thunderbots/thunderbots_view.h"
#include "ui/widgets/save_file.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

constexpr int kCellWidth = 23;
constexpr int kOffsetWidth = 30;
constexpr int kHeaderHeight = 16;
constexpr int kTallestRow = 20;
constexpr int kLowestRow = 11;
constexpr int kRows = static_cast<int>(wire::kExperimentBufferBytes) / ExperimentBytes::kColumns;

/// Bytes that have arrived as text, the others quietly on a tint.
class ByteDelegate final : public QStyledItemDelegate {
  public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const Tokens& t = tokensOf(option.palette);
        const bool known = index.data(ExperimentBytes::kKnownRole).toBool();
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        painter->save();
        if (selected || !known) painter->fillRect(option.rect, selected ? t.accentSoft : t.background);
        painter->setPen(known ? t.text : t.muted);
        painter->setFont(option.font);
        painter->drawText(option.rect, Qt::AlignCenter | Qt::TextDontClip, index.data().toString());
        if (option.state.testFlag(QStyle::State_HasFocus)) {
            painter->setPen(t.accent);
            painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
        }
        painter->restore();
    }
};

/// Offsets, quietly: rows may be lower than a line of text, whose letters still fit.
class OffsetHeader final : public QHeaderView {
  public:
    OffsetHeader(Qt::Orientation orientation, QWidget* parent) : QHeaderView(orientation, parent) {
        setFont(numberFont(metrics::kSmallTextSize));
        setMinimumSectionSize(1);
        setSectionResizeMode(Fixed);
    }

  protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override {
        painter->save();
        painter->setPen(tokensOf(palette()).muted);
        painter->setFont(font());
        painter->drawText(rect, Qt::AlignCenter | Qt::TextDontClip,
                          model()->headerData(section, orientation()).toString());
        painter->restore();
    }
};

QPushButton* smallButton(const QString& text, const char* name, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromLatin1(name));
    button->setAutoDefault(false);
    button->setFixedHeight(metrics::kFieldHeight);
    return button;
}

}  // namespace

ExperimentPanel::ExperimentPanel(Bench& bench, RobotChoice& choice, QWidget* parent)
    : Panel(bench, parent),
      choice_(choice),
      table_(new QTableView(this)),
      plot_(new ExperimentPlot(this)),
      state_(new QLabel(this)),
      refused_(new QLabel(this)) {
    buildTable();
    state_->setObjectName(QStringLiteral("experimentState"));
    state_->setWordWrap(true);
    refused_->setObjectName(QStringLiteral("experimentRefused"));
    refused_->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->setSpacing(metrics::kPadding);
    row->addWidget(table_);
    row->addWidget(plot_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(metrics::kPadding, metrics::kGap, metrics::kPadding, metrics::kGap);
    column->setSpacing(6);
    column->addLayout(row, 1);
    column->addWidget(state_);
    column->addWidget(refused_);
    connect(&bench, &Bench::changed, this, &ExperimentPanel::refresh);
    connect(&choice_, &RobotChoice::changed, this, &ExperimentPanel::followChoice);
}

void ExperimentPanel::buildTable() {
    table_->setObjectName(QStringLiteral("experimentBytes"));
    table_->setAccessibleName(tr("Experiment buffer, hexadecimal, sixteen bytes a row"));
    table_->setModel(&model_);
    table_->setItemDelegate(new ByteDelegate(table_));
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setFont(numberFont(metrics::kSmallTextSize));
    table_->setTabKeyNavigation(false);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->setHorizontalHeader(new OffsetHeader(Qt::Horizontal, table_));
    table_->setVerticalHeader(new OffsetHeader(Qt::Vertical, table_));
    // Nothing stands in the corner.
    if (auto* corner = table_->findChild<QAbstractButton*>()) corner->setMaximumSize(0, 0);
    table_->horizontalHeader()->setDefaultSectionSize(kCellWidth);
    table_->horizontalHeader()->setFixedHeight(kHeaderHeight);
    // All 256 bytes at once: the rows share the height that there is.
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    table_->verticalHeader()->setFixedWidth(kOffsetWidth);
    table_->setFixedWidth(kOffsetWidth + ExperimentBytes::kColumns * kCellWidth);
    table_->setMinimumHeight(kHeaderHeight + kRows * kLowestRow);
    table_->setMaximumHeight(kHeaderHeight + kRows * kTallestRow + 2);
}

QWidget* ExperimentPanel::headerTools() {
    auto* tools = new QWidget(this);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kGap);
    robots_ = new QComboBox(tools);
    robots_->setObjectName(QStringLiteral("experimentRobot"));
    robots_->setAccessibleName(tr("Whose experiment data"));
    for (int number = 0; number < kRobots; ++number)
        robots_->addItem(tr("Robot %1").arg(number), number);
    robots_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    copy_ = smallButton(tr("Copy"), "experimentCopy", tools);
    copy_->setToolTip(tr("Copies offsets and values, as they would be saved."));
    save_ = smallButton(tr("Save CSV\u2026"), "experimentSave", tools);
    clear_ = smallButton(tr("Clear"), "experimentClear", tools);
    clear_->setToolTip(tr("Forgets this robot's bytes, so that the next experiment begins empty."));
    for (QWidget* widget : std::initializer_list<QWidget*>{robots_, copy_, save_, clear_})
        row->addWidget(widget);
    connect(robots_, &QComboBox::currentIndexChanged, this, &ExperimentPanel::refresh);
    connect(copy_, &QPushButton::clicked, this, &ExperimentPanel::copy);
    connect(save_, &QPushButton::clicked, this, &ExperimentPanel::save);
    connect(clear_, &QPushButton::clicked, this, &ExperimentPanel::clear);
    refresh();
    return tools;
}

int ExperimentPanel::robot() const {
    return robots_ == nullptr ? 0 : robots_->currentIndex();
}

void ExperimentPanel::followChoice() {
    for (int number = 0; robots_ != nullptr && number < kRobots; ++number) {
        if (!choice_.isChosen(number)) continue;
        robots_->setCurrentIndex(number);
        return;
    }
}

void ExperimentPanel::refresh() {
    const Snapshot* snapshot = snapshotOf(bench().session());
    static const Snapshot nothing;
    const Snapshot& shown = snapshot == nullptr ? nothing : *snapshot;
    const ExperimentBuffer& buffer = shown.robots[static_cast<std::size_t>(robot())].experiment;
    refreshRobots(shown);
    model_.setBuffer(buffer);
    plot_->setBuffer(buffer);
    const bool any = buffer.known.any();
    state_->setText(any ? experimentText(buffer)
                        : tr("Nothing has arrived from robot %1. A robot sends its buffer by itself when its "
                             "experiment has ended; nothing here starts one.")
                              .arg(robot()));
    refused_->setVisible(buffer.rejected > 0);
    refused_->setText(tr("Messages refused, because their offset was past 224: %1.").arg(buffer.rejected));
    for (QPushButton* button : {copy_, save_}) {
        if (button != nullptr) button->setEnabled(any);
    }
    if (clear_ != nullptr) clear_->setEnabled(any || buffer.rejected > 0);
}

void ExperimentPanel::refreshRobots(const Snapshot& snapshot) {
    for (int number = 0; robots_ != nullptr && number < kRobots; ++number) {
        const auto known = snapshot.robots[static_cast<std::size_t>(number)].experiment.known.count();
        const QString text =
            known == 0 ? tr("Robot %1").arg(number) : tr("Robot %1 \u00b7 %2 bytes").arg(number).arg(known);
        if (robots_->itemText(number) != text) robots_->setItemText(number, text);
    }
}

void ExperimentPanel::clear() {
    bench().submit(SystemCommand{thunderbots::Command{ClearExperiment{maskOf(robot())}}});
}

void ExperimentPanel::copy() {
    QApplication::clipboard()->setText(QString::fromUtf8(experimentCsv(model_.buffer())));
}

void ExperimentPanel::save() {
    askToSave(this, tr("Save experiment data"), QStringLiteral("experiment-robot%1.csv").arg(robot()),
              QStringLiteral("csv"), [this] { return experimentCsv(model_.buffer()); });
}

}  // namespace kickstand::ui
