#pragma once

#include <QAbstractTableModel>
#include <array>
#include <cstdint>
#include <vector>

#include "core/thunderbots/wire/faults.h"

namespace kickstand::ui {

/// Whose numbering a code belongs to.
enum class FaultTable { Dongle, Robot };

/// Both tables of fault codes as lists (protocol 7.1, 7.2): the dongle's error queue, then the robot's.
class FaultsModel final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Table, Code, About, Meaning, Seen, ColumnCount };
    /// For searching: everything that a row says.
    static constexpr int kSearchRole = Qt::UserRole;

    explicit FaultsModel(QObject* parent = nullptr);

    /// The row of a code; -1 where there is none.
    int rowOf(FaultTable table, int code) const;
    /// A code of the dongle's has come.
    void noteSeen(std::uint8_t dongleCode);
    /// How many codes have come that are in no table.
    int unknownSeen() const { return unknownSeen_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    struct Row {
        FaultTable table;
        thunderbots::wire::Fault fault;
        int seen = 0;
    };
    QString cell(const Row& row, int column) const;

    std::vector<Row> rows_;
    int unknownSeen_ = 0;
};

}  // namespace kickstand::ui
