#pragma once

#include <QAbstractTableModel>
#include <chrono>
#include <functional>
#include <vector>

#include "core/thunderbots/kick_record.h"

namespace kickstand::ui {

/// A kick with what a person has noted.
struct KickRow {
    thunderbots::KickRecord record;
    QString note;
};

/// Where the wall's clock stood at a moment of the engine's.
using WallClock = std::function<std::chrono::system_clock::time_point(TimePoint)>;

/// Kicks as comma-separated values, a line a kick, oldest first: the same in every locale, and empty where
/// nothing was measured.
QString kickCsv(const std::vector<KickRow>& rows, const WallClock& clock);

/// The kicks of the shown session as a table. It keeps what the session itself has forgotten, up to a limit,
/// and the notes. GUI thread.
class KickRows final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Time, Robot, Cause, Width1, Width2, Offset, Before, After, Drop, Recharge, Note, Columns };
    /// The bare number of a cell, to sort by; nothing where there is none.
    static constexpr int kSortRole = Qt::UserRole;
    static constexpr std::size_t kMost = 5000;
    static constexpr int kLongestNote = 200;

    explicit KickRows(WallClock clock, QObject* parent = nullptr);

    /// Takes over what a snapshot has: new kicks, and news of those that are still being measured.
    void take(const thunderbots::KickRecords& records);
    /// Another session is shown: nothing of the one before stays.
    void clear();
    const std::vector<KickRow>& rows() const { return rows_; }
    /// "12:04:03.1".
    QString clockText(TimePoint time) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

  private:
    QString text(const KickRow& row, int column) const;

    WallClock clock_;
    std::vector<KickRow> rows_;  ///< Oldest first, numbered upwards.
};

}  // namespace kickstand::ui
