#include "ui/shell/event_model.h"

#include <QDateTime>
#include <algorithm>

namespace kickstand::ui {

namespace {

QString clockText(std::chrono::system_clock::time_point time) {
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count()).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString textOf(const EventLine& line) {
    return line.count == 1 ? line.text : EventModel::tr("%1 (%2 times)").arg(line.text).arg(line.count);
}

/// Stable names, for files.
QString weightName(Severity severity) {
    switch (severity) {
        case Severity::Information:
            return QStringLiteral("information");
        case Severity::Warning:
            return QStringLiteral("warning");
        case Severity::Danger:
            return QStringLiteral("danger");
    }
    return {};
}

}  // namespace

EventModel::EventModel(QObject* parent, std::size_t most) : QAbstractTableModel(parent), most_(most) {}

void EventModel::add(std::vector<EventLine> lines) {
    std::size_t first = 0;
    while (first < lines.size() && counted(lines[first]))
        ++first;
    // More at once than fit: the oldest of them would go at once anyway.
    if (lines.size() - first > most_) {
        dropped_ += lines.size() - first - most_;
        first = lines.size() - most_;
    }
    append(lines.data() + first, lines.size() - first);
}

bool EventModel::counted(const EventLine& line) {
    if (!line.countable || lines_.empty()) return false;
    EventLine& last = lines_.back();
    if (!last.countable || last.text != line.text || last.robot != line.robot || last.about != line.about)
        return false;
    ++last.count;
    last.time = line.time;
    emit dataChanged(index(0, 0), index(0, ColumnCount - 1));
    return true;
}

void EventModel::append(const EventLine* lines, std::size_t count) {
    if (count == 0) return;
    if (lines_.size() + count > most_) {
        const std::size_t surplus = std::min(lines_.size(), lines_.size() + count - most_);
        dropped_ += surplus;
        const int last = static_cast<int>(lines_.size()) - 1;
        beginRemoveRows({}, last - static_cast<int>(surplus) + 1, last);
        lines_.erase(lines_.begin(), lines_.begin() + static_cast<std::ptrdiff_t>(surplus));
        endRemoveRows();
    }
    beginInsertRows({}, 0, static_cast<int>(count) - 1);
    lines_.insert(lines_.end(), lines, lines + count);
    endInsertRows();
}

int EventModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(lines_.size());
}

int EventModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant EventModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const EventLine& line = lines_[lines_.size() - 1 - static_cast<std::size_t>(index.row())];
    if (role == SeverityRole) return static_cast<int>(line.severity);
    if (role == RobotRole) return line.robot;
    if (role == PlaceRole) return line.place;
    if (role == Qt::ToolTipRole && index.column() == Text) {
        return line.place.isEmpty() ? textOf(line)
                                    : tr("%1\nDouble-click or Enter says more.").arg(textOf(line));
    }
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case Time:
            return clockText(line.time);
        case Robot:
            return line.about;
        default:
            return textOf(line);
    }
}

QVariant EventModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Time:
            return tr("Time");
        case Robot:
            return tr("Source");
        default:
            return tr("What happened");
    }
}

QString eventText(const QAbstractItemModel& model, const std::vector<int>& rows) {
    QStringList lines;
    for (const int row : rows) {
        QStringList cells;
        for (int column = 0; column < EventModel::ColumnCount; ++column)
            cells << model.index(row, column).data().toString();
        lines << cells.join(u'\t');
    }
    return lines.join(u'\n');
}

QByteArray eventCsv(const QAbstractItemModel& model) {
    QString csv = QStringLiteral("time,robot,weight,what\n");
    for (int row = model.rowCount() - 1; row >= 0; --row) {
        const QModelIndex index = model.index(row, EventModel::Text);
        const int robot = index.data(EventModel::RobotRole).toInt();
        const auto severity = static_cast<Severity>(index.data(EventModel::SeverityRole).toInt());
        QString what = index.data().toString();
        what.replace(u'"', QStringLiteral("\"\""));
        csv += QStringLiteral("%1,%2,%3,\"%4\"\n")
                   .arg(model.index(row, EventModel::Time).data().toString(),
                        robot < 0 ? QString() : QString::number(robot), weightName(severity), what);
    }
    return csv.toUtf8();
}

void EventFilter::setAbout(const QString& about) {
    about_ = about;
    invalidateFilter();
}

void EventFilter::setLeast(Severity severity) {
    least_ = severity;
    invalidateFilter();
}

void EventFilter::setText(const QString& text) {
    text_ = text.trimmed();
    invalidateFilter();
}

bool EventFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
    const QModelIndex text = sourceModel()->index(row, EventModel::Text, parent);
    if (!about_.isEmpty() && text.siblingAtColumn(EventModel::Robot).data().toString() != about_)
        return false;
    if (text.data(EventModel::SeverityRole).toInt() < static_cast<int>(least_)) return false;
    return text_.isEmpty() || text.data().toString().contains(text_, Qt::CaseInsensitive);
}

}  // namespace kickstand::ui
