#include "ui/thunderbots/checks_rows.h"

#include <QApplication>
#include <QPalette>
#include <utility>

#include "core/engine/describe_check.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

void ChecksRows::take(std::shared_ptr<const CheckProgress> progress) {
    if (progress == progress_) return;
    const bool same = progress->rows.size() == progress_->rows.size() && progress->began == progress_->began;
    if (!same) beginResetModel();
    progress_ = std::move(progress);
    if (!same)
        endResetModel();
    else if (rowCount() > 0)
        emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ChecksRows::currentRow() const {
    return progress_->running() && !progress_->rows.empty() ? static_cast<int>(progress_->current) : -1;
}

int ChecksRows::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(progress_->rows.size());
}

int ChecksRows::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QString ChecksRows::text(const CheckRow& row, int column) const {
    switch (column) {
        case Robot:
            return QString::number(row.step.robot);
        case Step:
            return describe(row.step);
        case Limit:
            return limitText(row);
        case Value:
            return valueText(row);
        default:
            return row.verdict == CheckVerdict::Waiting ? QString() : describe(row.verdict);
    }
}

QVariant ChecksRows::colour(const CheckRow& row, int column) const {
    const Tokens& tokens = tokensOf(QApplication::palette());
    if (column != Verdict) return {};
    switch (row.verdict) {
        case CheckVerdict::Passed:
            return tokens.ok;
        case CheckVerdict::Failed:
        case CheckVerdict::NotSeen:
            return tokens.danger;
        default:
            return tokens.muted;
    }
}

QVariant ChecksRows::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const CheckRow& row = progress_->rows[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::ToolTipRole:
            return index.column() == Step ? describe(row.step) : reasonText(row);
        case Qt::ForegroundRole:
            return colour(row, index.column());
        case Qt::FontRole:
            if (index.row() != currentRow()) return {};
            return numberFont(metrics::kTextSize, QFont::DemiBold);
        default:
            return {};
    }
}

QVariant ChecksRows::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Robot:
            return tr("Robot");
        case Step:
            return tr("Step");
        case Limit:
            return tr("Limit");
        case Value:
            return tr("Value");
        default:
            return tr("Verdict");
    }
}

}  // namespace kickstand::ui
