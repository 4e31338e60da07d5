#pragma once

#include <QAbstractTableModel>
#include <QByteArray>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// The experiment buffer as CSV: offset, value; a byte that has not arrived has no value.
QByteArray experimentCsv(const thunderbots::ExperimentBuffer& buffer);
/// "64 of 256 bytes in 2 messages; missing: 0–31, 96–255".
QString experimentText(const thunderbots::ExperimentBuffer& buffer);

/// The 256 bytes in rows of sixteen, as hexadecimal numbers.
class ExperimentBytes final : public QAbstractTableModel {
    Q_OBJECT
  public:
    static constexpr int kColumns = 16;
    /// Whether the byte has arrived.
    static constexpr int kKnownRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void setBuffer(const thunderbots::ExperimentBuffer& buffer);
    const thunderbots::ExperimentBuffer& buffer() const { return buffer_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    thunderbots::ExperimentBuffer buffer_;
};

}  // namespace kickstand::ui
