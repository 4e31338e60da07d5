#include "ui/thunderbots/faults_model.h"

#include "core/engine/describe_fault.h"

namespace kickstand::ui {

using namespace thunderbots;
using wire::Fault;
using wire::FaultSubject;

namespace {

QString aboutText(const Fault& fault) {
    switch (fault.subject) {
        case FaultSubject::Motor:
            return fault.index == 5 ? FaultsModel::tr("Motor 5, dribbler")
                                    : FaultsModel::tr("Motor %1").arg(fault.index);
        case FaultSubject::Radio:
            return FaultsModel::tr("Radio %1").arg(fault.index);
        case FaultSubject::Robot:
            return FaultsModel::tr("Robot %1").arg(fault.index);
        case FaultSubject::None:
            break;
    }
    return {};
}

}  // namespace

FaultsModel::FaultsModel(QObject* parent) : QAbstractTableModel(parent) {
    rows_.reserve(wire::kDongleFaultCount + wire::kRobotFaultCount);
    for (std::uint8_t code = 0; code < wire::kDongleFaultCount; ++code)
        rows_.push_back({FaultTable::Dongle, wire::dongleFault(code)});
    for (std::uint8_t code = 0; code < wire::kRobotFaultCount; ++code)
        rows_.push_back({FaultTable::Robot, wire::robotFault(code)});
}

int FaultsModel::rowOf(FaultTable table, int code) const {
    const int count = table == FaultTable::Dongle ? wire::kDongleFaultCount : wire::kRobotFaultCount;
    if (code < 0 || code >= count) return -1;
    return table == FaultTable::Dongle ? code : wire::kDongleFaultCount + code;
}

void FaultsModel::noteSeen(std::uint8_t dongleCode) {
    const int row = rowOf(FaultTable::Dongle, dongleCode);
    if (row < 0) {
        ++unknownSeen_;
        return;
    }
    ++rows_[static_cast<std::size_t>(row)].seen;
    emit dataChanged(index(row, Seen), index(row, Seen));
}

int FaultsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int FaultsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString FaultsModel::cell(const Row& row, int column) const {
    switch (column) {
        case Table:
            return row.table == FaultTable::Dongle ? tr("Dongle") : tr("Robot");
        case Code:
            return QStringLiteral("%1  0x%2")
                .arg(row.fault.code)
                .arg(row.fault.code, 2, 16, QLatin1Char('0'));
        case About:
            return aboutText(row.fault);
        case Meaning:
            return faultMeaning(row.fault);
        case Seen:
            return row.seen == 0 ? QString() : tr("%1 \u00d7").arg(row.seen);
        default:
            return {};
    }
}

QVariant FaultsModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole) return cell(row, index.column());
    if (role == Qt::ToolTipRole) return cell(row, Meaning);
    if (role != kSearchRole) return {};
    QStringList words;
    for (int column = 0; column < Seen; ++column)
        words << cell(row, column);
    words << QString::fromUtf8(row.fault.id);
    return words.join(u' ');
}

QVariant FaultsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Table:
            return tr("Table");
        case Code:
            return tr("Code");
        case About:
            return tr("About");
        case Meaning:
            return tr("What it says");
        default:
            return tr("Seen in this run");
    }
}

}  // namespace kickstand::ui
