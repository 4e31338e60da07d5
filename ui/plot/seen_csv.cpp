#include "ui/plot/seen_csv.h"

#include <cmath>

namespace kickstand::ui {

namespace {

/// Quoted where a comma or a quote would end it early.
QString cell(QString text) {
    if (!text.contains(u',') && !text.contains(u'"') && !text.contains(u'\n')) return text;
    return u'"' + text.replace(u'"', QStringLiteral("\"\"")) + u'"';
}

QString number(float value) {
    return std::isnan(value) ? QString() : QString::number(static_cast<double>(value), 'g', 7);
}

}  // namespace

QString csvOf(const Seen& seen, const std::function<QString(TimePoint)>& clock) {
    QString text = QStringLiteral("time_s,clock");
    std::size_t count = 0;
    for (const SeenCurve& curve : seen.curves) {
        text += u',' + cell(curve.name + QStringLiteral(" min")) + u',' +
                cell(curve.name + QStringLiteral(" max"));
        count = std::max(count, curve.columns.size());
    }
    text += u'\n';
    for (std::size_t i = 0; i < count; ++i) {
        const Duration offset = seen.columnWidth * static_cast<Duration::rep>(i);
        text += QString::number(seconds(offset), 'f', 6) + u',' + cell(clock(seen.begin + offset));
        for (const SeenCurve& curve : seen.curves) {
            const Column column = i < curve.columns.size() ? curve.columns[i] : Column{};
            text += u',' + number(column.min) + u',' + number(column.max);
        }
        text += u'\n';
    }
    return text;
}

}  // namespace kickstand::ui
