#include "ui/plot/time_ticks.h"

#include <QCoreApplication>
#include <QDateTime>
#include <array>

#include "ui/plot/columns.h"

namespace kickstand::ui {

namespace {

using namespace std::chrono_literals;

struct TimeText {
    Q_DECLARE_TR_FUNCTIONS(TimeText)
};

constexpr auto kSteps =
    std::to_array<Duration>({1ms, 2ms,  5ms,  10ms, 20ms,  50ms,  100ms, 200ms, 500ms, 1s, 2s, 5s,  10s, 15s,
                             30s, 1min, 2min, 5min, 10min, 15min, 30min, 1h,    2h,    3h, 6h, 12h, 24h});

constexpr const char16_t* kMinus = u"\u2212";

QString minus() {
    return QString::fromUtf16(kMinus);
}

QString labelBefore(Duration before, Duration step) {
    if (before == Duration::zero()) return TimeText::tr("now");
    if (step >= 1h) return minus() + TimeText::tr("%1 h").arg(before / 1h);
    if (step >= 1min) return minus() + TimeText::tr("%1 min").arg(before / 1min);
    const int decimals = step >= 1s ? 0 : step >= 100ms ? 1 : step >= 10ms ? 2 : 3;
    return minus() + TimeText::tr("%1 s").arg(seconds(before), 0, 'f', decimals);
}

qint64 milliseconds(std::chrono::system_clock::time_point wall) {
    return std::chrono::floor<std::chrono::milliseconds>(wall.time_since_epoch()).count();
}

}  // namespace

Duration tickStep(Duration span, int most) {
    for (const Duration step : kSteps) {
        if (span / step <= most) return step;
    }
    return kSteps.back();
}

std::vector<TimeTick> ticksBefore(TimePoint begin, TimePoint end, Duration step) {
    std::vector<TimeTick> ticks;
    for (Duration before{}; end - before >= begin; before += step)
        ticks.push_back({end - before, labelBefore(before, step)});
    return ticks;
}

std::vector<TimeTick> clockTicks(TimePoint begin, TimePoint end, Duration step,
                                 std::chrono::system_clock::time_point wall) {
    const QDateTime local = QDateTime::fromMSecsSinceEpoch(milliseconds(wall));
    // Round by the clock that is read: a step of hours begins at local midnight.
    const Duration sinceMidnight = std::chrono::milliseconds(local.time().msecsSinceStartOfDay());
    const Duration over = sinceMidnight - step * floorDivide(sinceMidnight.count(), step.count());
    const QString format = step >= 1s ? QStringLiteral("HH:mm:ss") : QStringLiteral("HH:mm:ss.zzz");
    std::vector<TimeTick> ticks;
    for (Duration after = over == Duration::zero() ? over : step - over; begin + after <= end;
         after += step) {
        const qint64 after_ms = std::chrono::round<std::chrono::milliseconds>(after).count();
        ticks.push_back({begin + after, local.addMSecs(after_ms).toString(format)});
    }
    return ticks;
}

QString clockText(std::chrono::system_clock::time_point wall) {
    return QDateTime::fromMSecsSinceEpoch(milliseconds(wall)).toString(QStringLiteral("HH:mm:ss.zzz"));
}

QString durationText(Duration span) {
    const QString sign = span < Duration::zero() ? minus() : QString();
    const Duration size = std::chrono::abs(span);
    if (size < 100ms) return sign + TimeText::tr("%1 ms").arg(seconds(size) * 1000, 0, 'f', 1);
    if (size < 100s) return sign + TimeText::tr("%1 s").arg(seconds(size), 0, 'f', 3);
    return sign + TimeText::tr("%1 min %2 s").arg(size / 1min).arg(seconds(size % 1min), 0, 'f', 1);
}

}  // namespace kickstand::ui
