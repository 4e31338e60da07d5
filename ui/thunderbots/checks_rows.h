#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "core/thunderbots/bench_check.h"

namespace kickstand::ui {

/// The steps of a check and what came of each, as a table.
class ChecksRows final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Robot, Step, Limit, Value, Verdict, kColumns };

    using QAbstractTableModel::QAbstractTableModel;

    /// Shows this progress.
    void take(std::shared_ptr<const thunderbots::CheckProgress> progress);
    /// The row of the step at work; -1 where none is.
    int currentRow() const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QString text(const thunderbots::CheckRow& row, int column) const;
    QVariant colour(const thunderbots::CheckRow& row, int column) const;

    std::shared_ptr<const thunderbots::CheckProgress> progress_ =
        std::make_shared<const thunderbots::CheckProgress>();
};

}  // namespace kickstand::ui
