#include "ui/thunderbots/parameters_history.h"

#include <QDateTime>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "core/base/hex.h"
#include "core/engine/describe.h"
#include "core/engine/describe_facts.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

enum Column { kTime, kRobotNumber, kFrom, kFirmware, kNote };
constexpr int kTimeWidth = 132;
constexpr int kRobotWidth = 52;
constexpr int kFromWidth = 76;
constexpr int kFirmwareWidth = 140;
constexpr int kIdRole = Qt::UserRole;

QString sourceText(const std::string& source) {
    return source.rfind("sim:", 0) == 0 ? ParametersHistory::tr("simulated") : ParametersHistory::tr("robot");
}

QString signatureText(const std::optional<std::uint16_t>& signature) {
    if (!signature) return ParametersHistory::tr("not read");
    return QStringLiteral("0x%1").arg(*signature, 4, 16, QLatin1Char('0'));
}

QString firmwareText(const ParameterRecord& record) {
    if (!record.microcontrollerSignature && !record.flashSignature) return QStringLiteral("\u2013");
    return QStringLiteral("%1, %2").arg(signatureText(record.microcontrollerSignature),
                                        signatureText(record.flashSignature));
}

QString tipOf(const ParameterRecord& record) {
    return ParametersHistory::tr("%1\nbytes %2\nmicrocontroller %3, flash %4")
        .arg(printable(record.source), QString::fromStdString(toHex(record.block)),
             signatureText(record.microcontrollerSignature), signatureText(record.flashSignature));
}

}  // namespace

QString recordTime(const ParameterRecord& record) {
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(record.time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count()).toString(QStringLiteral("d MMM, hh:mm:ss"));
}

ParametersHistory::ParametersHistory(QWidget* parent)
    : QWidget(parent),
      list_(new QTreeWidget(this)),
      state_(new QLabel(this)),
      compare_(new QPushButton(tr("Compare"), this)),
      restore_(new QPushButton(tr("Restore"), this)),
      note_(new QPushButton(tr("Note\u2026"), this)) {
    list_->setObjectName(QStringLiteral("parameterHistory"));
    list_->setAccessibleName(tr("Earlier readings"));
    list_->setHeaderLabels({tr("Read"), tr("Robot"), tr("From"), tr("Firmware, flash"), tr("Note")});
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setColumnWidth(kTime, kTimeWidth);
    list_->setColumnWidth(kRobotNumber, kRobotWidth);
    list_->setColumnWidth(kFrom, kFromWidth);
    list_->setColumnWidth(kFirmware, kFirmwareWidth);
    list_->setMinimumHeight(84);
    state_->setObjectName(QStringLiteral("historyState"));
    state_->setWordWrap(true);
    state_->setForegroundRole(QPalette::PlaceholderText);
    compare_->setObjectName(QStringLiteral("historyCompare"));
    compare_->setToolTip(tr("Shows this reading beside the draft."));
    restore_->setObjectName(QStringLiteral("historyRestore"));
    restore_->setToolTip(tr("Takes this reading over into the draft, but for the flash contents."));
    note_->setObjectName(QStringLiteral("historyNote"));
    note_->setToolTip(tr("Which robot it was, what was tried: a number alone is nobody's identity."));
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(metrics::kGap);
    for (QPushButton* button : {compare_, restore_, note_}) {
        button->setAutoDefault(false);
        buttons->addWidget(button);
    }
    buttons->addStretch(1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::kGap / 2);
    column->addWidget(list_, 1);
    column->addWidget(state_);
    column->addLayout(buttons);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &ParametersHistory::refreshButtons);
    connect(compare_, &QPushButton::clicked, this, &ParametersHistory::compareAsked);
    connect(list_, &QTreeWidget::itemActivated, this, &ParametersHistory::compareAsked);
    connect(restore_, &QPushButton::clicked, this, &ParametersHistory::restoreAsked);
    connect(note_, &QPushButton::clicked, this, &ParametersHistory::noteAsked);
    refreshButtons();
}

void ParametersHistory::showView(const LedgerView& view, int robot) {
    if (view.version == view_.version && robot == robot_ && list_->topLevelItemCount() > 0) return;
    const bool same = view.version == view_.version && robot == robot_;
    view_ = view;
    robot_ = robot;
    if (!same) fill();
    QStringList lines;
    if (view_.error) lines << tr("Readings cannot be kept: %1").arg(describe(*view_.error).line());
    if (view_.lost > 0) lines << tr("%1 could not be kept.").arg(view_.lost);
    if (view_.unreadable > 0) lines << tr("%1 in the file cannot be read.").arg(view_.unreadable);
    if (lines.isEmpty() && list_->topLevelItemCount() == 0)
        lines << (robot < 0 ? tr("Every reading is kept here.")
                            : tr("No reading of robot %1 yet: every one is kept here.").arg(robot));
    state_->setText(lines.join(QLatin1Char('\n')));
    state_->setVisible(!lines.isEmpty());
    refreshButtons();
}

void ParametersHistory::fill() {
    const QSignalBlocker blocker(list_);
    const ParameterRecord* before = selected();
    const std::int64_t id = before == nullptr ? 0 : before->id;
    list_->clear();
    for (const ParameterRecord& record : *view_.records) {
        if (robot_ >= 0 && record.robot != robot_) continue;
        auto* item = new QTreeWidgetItem(
            list_, {recordTime(record), QString::number(record.robot), sourceText(record.source),
                    firmwareText(record), printable(record.note)});
        item->setData(0, kIdRole, static_cast<qlonglong>(record.id));
        item->setToolTip(kTime, tipOf(record));
        item->setToolTip(kNote, printable(record.note));
        if (record.id == id) item->setSelected(true);
    }
}

const ParameterRecord* ParametersHistory::selected() const {
    const auto chosen = list_->selectedItems();
    if (chosen.isEmpty()) return nullptr;
    const auto id = chosen.front()->data(0, kIdRole).toLongLong();
    for (const ParameterRecord& record : *view_.records) {
        if (record.id == id) return &record;
    }
    return nullptr;
}

void ParametersHistory::refreshButtons() {
    const bool any = !list_->selectedItems().isEmpty();
    for (QPushButton* button : {compare_, restore_, note_})
        button->setEnabled(any);
}

}  // namespace kickstand::ui
