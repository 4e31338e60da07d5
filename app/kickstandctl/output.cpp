#include "app/kickstandctl/output.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cerrno>
#include <climits>

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "app/kickstandctl/interruption.h"

namespace kickstand::ctl {
namespace {

/// What a pipe takes without blocking when it takes anything.
constexpr qsizetype kChunk = PIPE_BUF;
constexpr int kLook_ms = 50;

/// The value alone, without a document around it.
QByteArray compact(const QJsonValue& value) {
    if (value.isObject()) return QJsonDocument(value.toObject()).toJson(QJsonDocument::Compact);
    return QJsonDocument(value.toArray()).toJson(QJsonDocument::Compact);
}

}  // namespace

void Output::value(const QJsonValue& value) {
    if (!json_) return;
    hasValue_ = true;
    raw(QString::fromUtf8(compact(value)) + QLatin1Char('\n'));
}

void Output::line(const QString& text) {
    if (!json_) raw(text + QLatin1Char('\n'));
}

void Output::table(const QList<QStringList>& rows) {
    if (json_ || rows.isEmpty()) return;
    const auto right = [&rows](qsizetype column) { return rows[0][column].startsWith(QLatin1Char('<')); };
    QList<qsizetype> widths(rows[0].size(), 0);
    const auto cell = [&](qsizetype row, qsizetype column) {
        return row == 0 && right(column) ? rows[row][column].mid(1) : rows[row][column];
    };
    for (qsizetype row = 0; row < rows.size(); ++row) {
        for (qsizetype column = 0; column < rows[row].size(); ++column)
            widths[column] = std::max(widths[column], cell(row, column).size());
    }
    for (qsizetype row = 0; row < rows.size(); ++row) {
        QString text;
        for (qsizetype column = 0; column < rows[row].size(); ++column) {
            if (column > 0) text += QStringLiteral("  ");
            const QString content = cell(row, column);
            text += right(column) ? content.rightJustified(widths[column])
                                  : content.leftJustified(widths[column]);
        }
        while (text.endsWith(QLatin1Char(' ')))
            text.chop(1);
        line(text);
    }
}

bool Output::writable() {
    for (;;) {
        pollfd watched{STDOUT_FILENO, POLLOUT, 0};
        if (::poll(&watched, 1, kLook_ms) > 0) return true;
        interruption_.wait(Duration::zero());
        if (interruption_.cause()) return false;
    }
}

void Output::raw(const QString& text) {
    const QByteArray bytes = text.toUtf8();
    for (qsizetype at = 0; at < bytes.size() && !failed_;) {
        const qsizetype count = std::min(kChunk, bytes.size() - at);
        const ssize_t written =
            writable() ? ::write(STDOUT_FILENO, bytes.constData() + at, static_cast<std::size_t>(count)) : 0;
        if (written > 0)
            at += written;
        else if (written == 0 || errno != EINTR)
            failed_ = true;
    }
}

void Output::complain(const Failure& failure, const char* program) {
    const QByteArray line =
        QStringLiteral("%1: %2\n").arg(QLatin1String(program), failure.text.line()).toUtf8();
    // Standard error is the last place there is: nothing is left to tell if it is gone.
    (void)!::write(STDERR_FILENO, line.constData(), static_cast<std::size_t>(line.size()));
}

void reserveStandardStreams() {
    for (;;) {
        const int descriptor = ::open("/dev/null", O_RDWR | O_CLOEXEC);
        if (descriptor < 0) return;
        if (descriptor > STDERR_FILENO) {
            ::close(descriptor);
            return;
        }
    }
}

}  // namespace kickstand::ctl
