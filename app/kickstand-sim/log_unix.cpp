#include <QDateTime>
#include <cerrno>

#include <poll.h>
#include <unistd.h>

#include "app/kickstand-sim/json.h"
#include "app/kickstand-sim/log.h"
#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

/// A line of up to PIPE_BUF bytes goes whole into a pipe that is ready; a longer one may wait.
bool writeNow(const QByteArray& line) {
    pollfd watched{STDOUT_FILENO, POLLOUT, 0};
    if (::poll(&watched, 1, 0) <= 0 || (watched.revents & POLLOUT) == 0) return false;
    qsizetype at = 0;
    while (at < line.size()) {
        const ssize_t count =
            ::write(STDOUT_FILENO, line.constData() + at, static_cast<std::size_t>(line.size() - at));
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        at += count;
    }
    return true;
}

}  // namespace

void Log::announce(const QString& text, const QJsonObject& facts) {
    write(json_ ? compact(facts) + '\n' : text.toUtf8() + '\n');
}

void Log::event(const std::string& text) {
    const QDateTime now = QDateTime::currentDateTime();
    const QString shown = printable(text);
    if (!json_) {
        write((now.toString(QStringLiteral("hh:mm:ss.zzz  ")) + shown + QLatin1Char('\n')).toUtf8());
        return;
    }
    write(compact({{QStringLiteral("type"), QStringLiteral("log")},
                   {QStringLiteral("time"), now.toUTC().toString(Qt::ISODateWithMs)},
                   {QStringLiteral("text"), shown}}) +
          '\n');
}

void Log::write(const QByteArray& line) {
    const std::lock_guard lock(mutex_);
    QByteArray whole = line;
    if (leftOut_ > 0) {
        const QString gap = Words::tr("%1 lines left out: nobody read them").arg(leftOut_);
        const QByteArray before = json_ ? compact({{QStringLiteral("type"), QStringLiteral("left-out")},
                                                   {QStringLiteral("lines"), static_cast<qint64>(leftOut_)}})
                                        : gap.toUtf8();
        whole.prepend(before + '\n');
    }
    if (writeNow(whole))
        leftOut_ = 0;
    else
        ++leftOut_;
}

}  // namespace kickstand::sim
