#include "ui/thunderbots/kick_rows.h"

#include <QDateTime>
#include <algorithm>
#include <array>
#include <iterator>

#include "core/thunderbots/wire/kick_timing.h"
#include "ui/thunderbots/kick_words.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

using namespace thunderbots;

namespace {

const QString kNothing = QStringLiteral("\u2014");

bool isMeasuring(const KickRecord& record) {
    return record.measure == KickMeasure::Waiting || record.measure == KickMeasure::Recharging;
}

/// One of the three numbers that make a kick.
std::optional<double> pulseNumber(const KickRecord& record, int column) {
    if (!record.times) return std::nullopt;
    const wire::KickPulses pulses = wire::personTermsOf(*record.times);
    if (column == KickRows::Width1) return pulses.width1_us;
    return column == KickRows::Width2 ? pulses.width2_us : pulses.offset_us;
}

/// The bare number of a column; none where there is none.
std::optional<double> number(const KickRecord& record, int column) {
    switch (column) {
        case KickRows::Time:
            return seconds(record.time.time_since_epoch());
        case KickRows::Robot:
            return record.robot;
        case KickRows::Cause:
            return static_cast<double>(record.cause);
        case KickRows::Width1:
        case KickRows::Width2:
        case KickRows::Offset:
            return pulseNumber(record, column);
        case KickRows::Before:
            return record.before_V;
        case KickRows::After:
            return record.after_V;
        case KickRows::Drop:
            return record.drop_V();
        case KickRows::Recharge:
            return record.recharge ? std::optional(seconds(*record.recharge)) : std::nullopt;
        default:
            return std::nullopt;
    }
}

QString quoted(QString text) {
    return u'"' + text.replace(u'"', QStringLiteral("\"\"")).simplified() + u'"';
}

/// A number as every locale reads it; empty where there is none.
QString plain(const std::optional<double>& value, int decimals) {
    return value ? QString::number(*value, 'f', decimals) : QString();
}

const char* csvName(KickCause cause) {
    constexpr std::array names{"asked", "sweep", "autokick"};
    return names.at(static_cast<std::size_t>(cause));
}

const char* csvName(KickMeasure measure) {
    constexpr std::array names{"waiting",       "recharging",   "recharged",   "no-drop",
                               "not-recharged", "kicked-again", "not-measured"};
    return names.at(static_cast<std::size_t>(measure));
}

QString csvLine(const KickRow& row, const WallClock& clock) {
    const KickRecord& record = row.record;
    const auto since =
        std::chrono::duration_cast<std::chrono::milliseconds>(clock(record.time).time_since_epoch());
    QStringList cells{QDateTime::fromMSecsSinceEpoch(since.count(), Qt::UTC).toString(Qt::ISODateWithMs),
                      QString::number(record.robot), QString::fromLatin1(csvName(record.cause))};
    for (const int column : {KickRows::Width1, KickRows::Width2, KickRows::Offset})
        cells << plain(number(record, column), 0);
    if (record.times) {
        for (const int value : {int{record.times->t1}, int{record.times->t2}, int{record.times->dt},
                                int{record.times->flag1}, int{record.times->flag2}})
            cells << QString::number(value);
    } else {
        cells << QString() << QString() << QString() << QString() << QString();
    }
    for (const int column : {KickRows::Before, KickRows::After, KickRows::Drop})
        cells << plain(number(record, column), 1);
    cells << plain(number(record, KickRows::Recharge), 3) << QString::fromLatin1(csvName(record.measure))
          << quoted(row.link) << quoted(row.note);
    return cells.join(u',');
}

}  // namespace

QString kickCsv(const std::vector<KickRow>& rows, const WallClock& clock) {
    QString csv = QStringLiteral(
        "time,robot,cause,width1_us,width2_us,offset_us,t1,t2,dt,flag1,flag2,before_V,after_V,drop_V,"
        "recharge_s,outcome,link,note\n");
    for (const KickRow& row : rows)
        csv += csvLine(row, clock) + u'\n';
    return csv;
}

KickRows::KickRows(WallClock clock, QObject* parent)
    : QAbstractTableModel(parent), clock_(std::move(clock)) {}

QString KickRows::clockText(TimePoint time) const {
    const auto since = std::chrono::duration_cast<std::chrono::milliseconds>(clock_(time).time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count()).toString(QStringLiteral("HH:mm:ss.zzz")).chopped(2);
}

std::vector<KickRow>::iterator KickRows::find(SessionId session, std::uint64_t number) {
    // From the newest: news is of the last ones.
    const auto found = std::find_if(rows_.rbegin(), rows_.rend(), [session, number](const KickRow& row) {
        return row.session == session && row.record.number <= number;
    });
    return found != rows_.rend() && found->record.number == number ? std::prev(found.base()) : rows_.end();
}

void KickRows::changed(std::vector<KickRow>::iterator row) {
    const int line = static_cast<int>(row - rows_.begin());
    emit dataChanged(index(line, 0), index(line, Columns - 1));
}

void KickRows::take(SessionId session, const QString& link, const KickRecords& records) {
    const auto newest = std::find_if(rows_.rbegin(), rows_.rend(),
                                     [session](const KickRow& row) { return row.session == session; });
    const std::uint64_t last = newest == rows_.rend() ? 0 : newest->record.number;
    std::vector<KickRow> added;
    for (const KickRecord& record : records) {
        if (record.number > last) {
            added.push_back({record, {}, session, link});
            continue;
        }
        const auto known = find(session, record.number);
        if (known == rows_.end() || known->record == record) continue;
        known->record = record;
        changed(known);
    }
    append(std::move(added));
}

void KickRows::append(std::vector<KickRow> added) {
    if (added.empty()) return;
    if (rows_.size() + added.size() > kMost) {
        const std::size_t surplus = std::min(rows_.size(), rows_.size() + added.size() - kMost);
        beginRemoveRows({}, 0, static_cast<int>(surplus) - 1);
        rows_.erase(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(surplus));
        endRemoveRows();
    }
    const int first = static_cast<int>(rows_.size());
    beginInsertRows({}, first, first + static_cast<int>(added.size()) - 1);
    std::move(added.begin(), added.end(), std::back_inserter(rows_));
    endInsertRows();
}

void KickRows::endAllBut(const std::vector<SessionId>& sessions) {
    for (auto row = rows_.begin(); row != rows_.end(); ++row) {
        const bool goesOn = std::find(sessions.begin(), sessions.end(), row->session) != sessions.end();
        if (goesOn || !isMeasuring(row->record)) continue;
        row->record.measure = KickMeasure::Lost;
        changed(row);
    }
}

bool KickRows::hasSeveralLinks() const {
    return std::any_of(rows_.begin(), rows_.end(),
                       [this](const KickRow& row) { return row.link != rows_.front().link; });
}

int KickRows::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int KickRows::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : Columns;
}

QString KickRows::text(const KickRow& row, int column) const {
    const KickRecord& record = row.record;
    const std::optional<double> value = number(record, column);
    switch (column) {
        case Time:
            return clockText(record.time);
        case Cause:
            return causeText(record.cause);
        case Link:
            return row.link;
        case Note:
            return row.note;
        case Recharge:
            if (record.recharge) return secondsText(*record.recharge);
            return isMeasuring(record) ? QStringLiteral("\u2026") : measureWord(record.measure);
        case Before:
        case After:
        case Drop:
            if (!value) return isMeasuring(record) ? QStringLiteral("\u2026") : kNothing;
            return tr("%1 V").arg(*value, 0, 'f', 1);
        case Robot:
            return QString::number(record.robot);
        default:
            return value ? tr("%1 \u00b5s").arg(signedNumber(static_cast<int>(*value))) : kNothing;
    }
}

QVariant KickRows::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    const KickRow& row = rows_[static_cast<std::size_t>(index.row())];
    switch (role) {
        case Qt::DisplayRole:
            return text(row, index.column());
        case Qt::EditRole:
            return index.column() == Note ? QVariant(row.note) : QVariant();
        case kSortRole: {
            if (index.column() == Note) return row.note;
            if (index.column() == Link) return row.link;
            const auto value = number(row.record, index.column());
            return value ? QVariant(*value) : QVariant();
        }
        case Qt::ToolTipRole:
            return index.column() == Note ? QVariant() : QVariant(measureText(row.record));
        case Qt::TextAlignmentRole:
            return index.column() >= Width1 && index.column() < Link
                       ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                       : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
        default:
            return {};
    }
}

bool KickRows::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || index.column() != Note || role != Qt::EditRole) return false;
    rows_[static_cast<std::size_t>(index.row())].note = value.toString().simplified().left(kLongestNote);
    emit dataChanged(index, index);
    return true;
}

QVariant KickRows::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::ToolTipRole && section == Offset)
        return tr("How much later solenoid 2 began; negative: solenoid 1.");
    if (role == Qt::ToolTipRole && section == Recharge)
        return tr("From the kick until charged again, or back at 98 % of before.");
    if (role == Qt::TextAlignmentRole)
        return section >= Width1 && section < Link ? QVariant(Qt::AlignRight | Qt::AlignVCenter)
                                                   : QVariant(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    switch (section) {
        case Time:
            return tr("Time");
        case Robot:
            return tr("Robot");
        case Cause:
            return tr("Kicked");
        case Width1:
            return tr("Width 1");
        case Width2:
            return tr("Width 2");
        case Offset:
            return tr("Offset");
        case Before:
            return tr("Before");
        case After:
            return tr("After");
        case Drop:
            return tr("Drop");
        case Recharge:
            return tr("Recharge");
        case Link:
            return tr("Link");
        case Note:
            return tr("Note");
        default:
            return {};
    }
}

Qt::ItemFlags KickRows::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
    return index.column() == Note ? usual | Qt::ItemIsEditable : usual;
}

}  // namespace kickstand::ui
