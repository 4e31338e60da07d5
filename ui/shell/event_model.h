#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <deque>
#include <vector>

#include "core/engine/describe.h"

namespace kickstand::ui {

/// One line of the list.
struct EventLine {
    std::chrono::system_clock::time_point time;
    int robot = -1;
    QString text;
    Severity severity = Severity::Information;
    /// Lines that may repeat are counted instead of repeated.
    bool countable = false;
    int count = 1;
};

/// The events of this run, newest first, at most so many: the oldest give way.
class EventModel final : public QAbstractTableModel {
    Q_OBJECT
  public:
    enum Column { Time, Robot, Text, ColumnCount };
    enum Role { SeverityRole = Qt::UserRole, RobotRole };
    static constexpr std::size_t kMostLines = 10'000;

    explicit EventModel(QObject* parent = nullptr, std::size_t most = kMostLines);

    /// Oldest first.
    void add(std::vector<EventLine> lines);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    bool counted(const EventLine& line);
    void append(const EventLine* lines, std::size_t count);

    std::size_t most_;
    std::deque<EventLine> lines_;  ///< Oldest first.
};

/// What of it is shown.
class EventFilter final : public QSortFilterProxyModel {
    Q_OBJECT
  public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

    /// -1: all robots, and what concerns none.
    void setRobot(int robot);
    void setLeast(Severity severity);
    void setText(const QString& text);

  protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

  private:
    int robot_ = -1;
    Severity least_ = Severity::Information;
    QString text_;
};

}  // namespace kickstand::ui
