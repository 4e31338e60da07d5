#include "ui/coach/conversation_view.h"

#include <QDateTime>
#include <QScrollBar>

#include "core/engine/describe_coach.h"
#include "ui/shell/bench.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

ConversationView::ConversationView(Bench& bench, QWidget* parent) : QPlainTextEdit(parent), bench_(bench) {
    setReadOnly(true);
    setTabChangesFocus(true);
    setLineWrapMode(NoWrap);
    setAccessibleName(tr("Conversation"));
    setFont(numberFont(metrics::kSmallTextSize));
    setPlaceholderText(tr("Packets will show here as they are sent and heard."));
}

QString ConversationView::lineOf(const coach::TrafficEntry& entry) const {
    const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(
        bench_.client().wallTime(entry.time).time_since_epoch());
    const QString clock =
        QDateTime::fromMSecsSinceEpoch(time.count()).toString(QStringLiteral("HH:mm:ss.zzz"));
    const QString whom = describeAddress(entry.address);
    const QString what = describe(entry.message);
    if (!entry.sent)
        return tr("%1  from %2  %3  (%4 dBm)").arg(clock, whom, what, signedNumber(entry.rssi_dBm));
    return tr("%1  to %2  %3  (%4)").arg(clock, whom, what, describeOutcome(entry));
}

void ConversationView::show(const std::shared_ptr<const coach::TrafficEntries>& entries) {
    if (entries == shown_) return;
    shown_ = entries;
    QScrollBar* bar = verticalScrollBar();
    // Who has scrolled back is reading.
    const bool follows = bar->value() == bar->maximum();
    const int place = bar->value();
    QStringList lines;
    for (const coach::TrafficEntry& entry : *entries)
        lines << lineOf(entry);
    setPlainText(lines.join(QLatin1Char('\n')));
    bar->setValue(follows ? bar->maximum() : place);
}

}  // namespace kickstand::ui
