#pragma once

#include <QAbstractTableModel>
#include <chrono>
#include <functional>
#include <vector>

#include "core/engine/messages.h"
#include "core/thunderbots/kick_record.h"

namespace kickstand::ui {

/// A kick with what a person has noted.
struct KickRow {
    thunderbots::KickRecord record;
    QString note;
    SessionId session = 0;  ///< Its numbers count within this.
    QString link;           ///< Over which it was given.
};

/// Where the wall's clock stood at a moment of the engine's.
using WallClock = std::function<std::chrono::system_clock::time_point(TimePoint)>;

/// Kicks as comma-separated values, a line a kick, oldest first: the same in every locale, and empty where
/// nothing was measured.
QString kickCsv(const std::vector<KickRow>& rows, const WallClock& clock);

/// The kicks of a run of the program as a table. It keeps what a session itself has forgotten or what ended
/// with it, up to a limit, and the notes. GUI thread.
class KickRows final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column {
        Time,
        Robot,
        Cause,
        Width1,
        Width2,
        Offset,
        Before,
        After,
        Drop,
        Recharge,
        Link,
        Note,
        Columns
    };
    /// The bare number of a cell, to sort by; nothing where there is none.
    static constexpr int kSortRole = Qt::UserRole;
    static constexpr std::size_t kMost = 5000;
    static constexpr int kLongestNote = 200;

    explicit KickRows(WallClock clock, QObject* parent = nullptr);

    /// Takes over what a session's snapshot has: new kicks, and news of those that are still being measured.
    void take(SessionId session, const QString& link, const thunderbots::KickRecords& records);
    /// What is still being measured, other than in these sessions, never will be.
    void endAllBut(const std::vector<SessionId>& sessions);
    /// Whether not all came over the same link.
    bool hasSeveralLinks() const;
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
    std::vector<KickRow>::iterator find(SessionId session, std::uint64_t number);
    void changed(std::vector<KickRow>::iterator row);
    void append(std::vector<KickRow> added);

    WallClock clock_;
    std::vector<KickRow> rows_;  ///< Those of a session oldest first, numbered upwards.
};

}  // namespace kickstand::ui
