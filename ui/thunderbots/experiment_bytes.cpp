#include "ui/thunderbots/experiment_bytes.h"

#include <QCoreApplication>
#include <QStringList>

namespace kickstand::ui {

using namespace thunderbots;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Experiment)
};

constexpr int kBytes = static_cast<int>(wire::kExperimentBufferBytes);
constexpr int kNoByte = -1;

QString hexText(int value, int digits) {
    return QString::number(value, 16).toUpper().rightJustified(digits, u'0');
}

/// "0–31, 96–255".
QString gapsText(const ExperimentBuffer& buffer) {
    QStringList gaps;
    for (int first = 0; first < kBytes; ++first) {
        if (buffer.known.test(static_cast<std::size_t>(first))) continue;
        int last = first;
        while (last + 1 < kBytes && !buffer.known.test(static_cast<std::size_t>(last + 1)))
            ++last;
        gaps << (last == first ? QString::number(first) : QStringLiteral("%1\u2013%2").arg(first).arg(last));
        first = last;
    }
    return gaps.join(QStringLiteral(", "));
}

}  // namespace

QByteArray experimentCsv(const ExperimentBuffer& buffer) {
    QByteArray csv("offset,value\n");
    for (std::size_t offset = 0; offset < buffer.data.size(); ++offset) {
        csv += QByteArray::number(static_cast<qulonglong>(offset)) + ',';
        if (buffer.known.test(offset)) csv += QByteArray::number(buffer.data[offset]);
        csv += '\n';
    }
    return csv;
}

QString experimentText(const ExperimentBuffer& buffer) {
    const auto known = static_cast<int>(buffer.known.count());
    QString text = Words::tr("%1 of 256 bytes, messages: %2").arg(known).arg(buffer.messages);
    if (known > 0 && known < kBytes) text += Words::tr("; missing: %1").arg(gapsText(buffer));
    return text;
}

void ExperimentBytes::setBuffer(const ExperimentBuffer& buffer) {
    if (buffer.known == buffer_.known && buffer.data == buffer_.data) return;
    buffer_ = buffer;
    emit dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
}

int ExperimentBytes::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kBytes / kColumns;
}

int ExperimentBytes::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : kColumns;
}

QVariant ExperimentBytes::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid)) return {};
    const int offset = index.row() * kColumns + index.column();
    const auto at = static_cast<std::size_t>(offset);
    const int byte = buffer_.known.test(at) ? buffer_.data[at] : kNoByte;
    switch (role) {
        case Qt::DisplayRole:
            return byte == kNoByte ? QStringLiteral("\u00b7\u00b7") : hexText(byte, 2);
        case Qt::ToolTipRole:
        case Qt::AccessibleTextRole:
            return byte == kNoByte ? tr("Offset %1: not arrived").arg(offset)
                                   : tr("Offset %1: %2").arg(offset).arg(byte);
        case Qt::TextAlignmentRole:
            return static_cast<int>(Qt::AlignCenter);
        case kKnownRole:
            return byte != kNoByte;
        default:
            return {};
    }
}

QVariant ExperimentBytes::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::TextAlignmentRole) return static_cast<int>(Qt::AlignCenter);
    if (role != Qt::DisplayRole) return {};
    return orientation == Qt::Horizontal ? hexText(section, 1) : hexText(section * kColumns, 2);
}

}  // namespace kickstand::ui
