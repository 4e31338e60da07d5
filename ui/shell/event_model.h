#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <cstdint>
#include <deque>
#include <vector>

#include "core/engine/describe.h"

namespace kickstand::ui {

/// One line of the list.
struct EventLine {
    std::chrono::system_clock::time_point time;
    int robot = -1;
    QString about;  ///< "robot 3": whom it concerns.
    QString text;
    Severity severity = Severity::Information;
    /// Lines that may repeat are counted instead of repeated.
    bool countable = false;
    int count = 1;
    /// Where more is said about it, as Bench::goTo() takes it; empty where nowhere is.
    QString place{};
};

/// The events of this run, newest first, at most so many: the oldest give way.
class EventModel final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Time, Robot, Text, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole, RobotRole, PlaceRole };
    static constexpr std::size_t kMostLines = 10'000;

    explicit EventModel(QObject* parent = nullptr, std::size_t most = kMostLines);

    /// Oldest first.
    void add(std::vector<EventLine> lines);
    /// How many have given way to newer ones.
    std::uint64_t dropped() const { return dropped_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    bool counted(const EventLine& line);
    void append(const EventLine* lines, std::size_t count);

    std::size_t most_;
    std::deque<EventLine> lines_;  ///< Oldest first.
    std::uint64_t dropped_ = 0;
};

/// What of it is shown.
class EventFilter final : public QSortFilterProxyModel {
    Q_OBJECT
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// Whom it concerns, as EventLine has it; empty for all, and what concerns none.
    void setAbout(const QString& about);
    void setLeast(Severity severity);
    void setText(const QString& text);

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

  private:
    QString about_;
    Severity least_ = Severity::Information;
    QString text_;
};

/// Rows as text for a spreadsheet or a report, in the order of `rows`: time, robot, what, tab-separated.
QString eventText(const QAbstractItemModel& model, const std::vector<int>& rows);
/// All rows, oldest first, as CSV with a header line: time, robot, weight, what.
QByteArray eventCsv(const QAbstractItemModel& model);

}  // namespace kickstand::ui
