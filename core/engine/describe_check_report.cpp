#include "core/engine/describe_check_report.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

#include "core/engine/describe_check.h"

namespace kickstand {

using namespace thunderbots;

namespace {

struct Report {
    Q_DECLARE_TR_FUNCTIONS(CheckReport)
};

/// Digits past these are the converters' noise.
double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

QJsonValue orNull(const std::optional<double>& value) {
    return value ? QJsonValue(rounded(*value)) : QJsonValue(QJsonValue::Null);
}

void forRobots(const CheckProgress& progress, const std::function<void(int robot)>& one) {
    for (int robot = 0; robot < kRobots; ++robot) {
        if (contains(progress.plan.robots, robot)) one(robot);
    }
}

void forRows(const CheckProgress& progress, int robot, const std::function<void(const CheckRow&)>& one) {
    for (const CheckRow& row : progress.rows) {
        if (row.step.robot == robot) one(row);
    }
}

QJsonObject toJson(const CheckRow& row) {
    QJsonObject json{{QStringLiteral("check"), QString::fromLatin1(name(row.step.kind))},
                     {QStringLiteral("value"), orNull(row.value)},
                     {QStringLiteral("limit"), orNull(row.limit)},
                     {QStringLiteral("verdict"), QString::fromLatin1(name(row.verdict))},
                     {QStringLiteral("text"), describe(row.step)}};
    if (row.step.kind == CheckKind::Wheel) {
        json[QStringLiteral("wheel")] = row.step.wheel;
        json[QStringLiteral("positive")] = row.step.forward;
    }
    if (row.step.kind == CheckKind::Lights) {
        json[QStringLiteral("test_class")] = QString::fromLatin1(wire::name(row.step.mode.testClass));
        json[QStringLiteral("test_target")] = row.step.mode.target;
    }
    if (row.why) json[QStringLiteral("reason")] = QString::fromLatin1(kickstand::name(*row.why));
    return json;
}

/// How the whole went, where that is not what is said of its only robot anyway.
QString wholeText(const CheckProgress& progress) {
    const bool one = std::popcount(progress.plan.robots) == 1;
    return one && !progress.endedBy ? QString() : sentenceOf(progress);
}

QDateTime dateOf(WallTime time) {
    return QDateTime::fromMSecsSinceEpoch(
        std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count());
}

QString title(WallTime began) {
    return Report::tr("Bench check of %1").arg(dateOf(began).toString(QStringLiteral("yyyy-MM-dd HH:mm")));
}

QString cell(const char* tag, const QString& text) {
    const QString name = QString::fromLatin1(tag);
    return QStringLiteral("<%1 align=\"left\">%2</%1>").arg(name, text.toHtmlEscaped());
}

QString rowHtml(const CheckRow& row) {
    const QString reason = reasonText(row);
    QString verdict = describe(row.verdict).toHtmlEscaped();
    if (row.verdict != CheckVerdict::Passed) verdict = QStringLiteral("<b>%1</b>").arg(verdict);
    if (!reason.isEmpty()) verdict += QStringLiteral(": %1").arg(reason.toHtmlEscaped());
    return QStringLiteral("<tr>%1%2%3<td align=\"left\">%4</td></tr>\n")
        .arg(cell("td", describe(row.step)), cell("td", limitText(row)), cell("td", valueText(row)), verdict);
}

tl::unexpected<QString> wrong(const QString& text) {
    return tl::unexpected<QString>(text);
}

}  // namespace

QJsonObject toJson(const CheckLimits& limits) {
    QJsonObject json;
    for (const CheckLimitInfo& info : checkLimitInfos())
        json[QString::fromLatin1(info.name)] = rounded(limits.*info.member);
    return json;
}

tl::expected<CheckLimits, QString> checkLimitsFromJson(const QByteArray& json) {
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(json, &error);
    if (!document.isObject()) {
        return wrong(Report::tr("These are no limits: %1.")
                         .arg(document.isNull() ? error.errorString() : Report::tr("no JSON object")));
    }
    const QJsonObject object = document.object();
    CheckLimits limits;
    for (auto entry = object.constBegin(); entry != object.constEnd(); ++entry) {
        const auto infos = checkLimitInfos();
        const auto info = std::ranges::find_if(
            infos, [&entry](const CheckLimitInfo& one) { return entry.key() == QLatin1String(one.name); });
        if (info == infos.end()) return wrong(Report::tr("There is no limit “%1”.").arg(entry.key()));
        const double value = entry->isDouble() ? entry->toDouble() : std::nan("");
        if (!(value >= info->lowest && value <= info->highest)) {
            return wrong(Report::tr("%1 has to be a number from %2 to %3.")
                             .arg(entry.key())
                             .arg(info->lowest)
                             .arg(info->highest));
        }
        limits.*info->member = value;
    }
    return limits;
}

QJsonObject checkReport(const CheckProgress& progress, WallTime began) {
    QJsonArray robots;
    forRobots(progress, [&](int robot) {
        QJsonArray rows;
        forRows(progress, robot, [&rows](const CheckRow& row) { rows.append(toJson(row)); });
        robots.append(QJsonObject{
            {QStringLiteral("robot"), robot},
            {QStringLiteral("verdict"), QString::fromLatin1(name(verdictOf(progress, robot)))},
            {QStringLiteral("sentence"), sentenceOf(progress, robot)},
            {QStringLiteral("steps"), rows},
        });
    });
    QJsonObject json{{QStringLiteral("began"), dateOf(began).toUTC().toString(Qt::ISODateWithMs)},
                     {QStringLiteral("limits"), toJson(progress.plan.limits)},
                     {QStringLiteral("passed"), allPassed(progress)},
                     {QStringLiteral("robots"), robots},
                     {QStringLiteral("sentence"), sentenceOf(progress)}};
    if (progress.endedBy)
        json[QStringLiteral("ended_by")] = QString::fromLatin1(kickstand::name(*progress.endedBy));
    return json;
}

QString checkReportHtml(const CheckProgress& progress, WallTime began) {
    QString body = QStringLiteral("<h1>%1</h1>\n").arg(title(began).toHtmlEscaped());
    const QString whole = wholeText(progress);
    if (!whole.isEmpty()) body += QStringLiteral("<p>%1</p>\n").arg(whole.toHtmlEscaped());
    // On paper each robot has its own sheet; the first shares its with the title.
    QString sheet;
    forRobots(progress, [&](int robot) {
        body += QStringLiteral("<h2%1>%2</h2>\n<p>%3</p>\n")
                    .arg(sheet, Report::tr("Robot %1").arg(robot).toHtmlEscaped(),
                         sentenceOf(progress, robot).toHtmlEscaped());
        sheet = QStringLiteral(" style=\"page-break-before: always\"");
        body +=
            QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"3\">\n<tr>%1%2%3%4</tr>\n")
                .arg(cell("th", Report::tr("Step")), cell("th", Report::tr("Limit")),
                     cell("th", Report::tr("Value")), cell("th", Report::tr("Verdict")));
        forRows(progress, robot, [&body](const CheckRow& row) { body += rowHtml(row); });
        body += QStringLiteral("</table>\n");
    });
    return QStringLiteral(
               "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\"><title>%1</title></head>\n"
               "<body>\n%2</body></html>\n")
        .arg(title(began).toHtmlEscaped(), body);
}

QString checkReportText(const CheckProgress& progress, WallTime began) {
    QString text = title(began) + u'\n';
    const QString whole = wholeText(progress);
    if (!whole.isEmpty()) text += whole + u'\n';
    forRobots(progress, [&](int robot) {
        text += u'\n' + sentenceOf(progress, robot) + u'\n';
        forRows(progress, robot, [&text](const CheckRow& row) {
            text += QStringLiteral("  %1  %2").arg(describe(row.step), -44).arg(describe(row.verdict), -9);
            QStringList facts{valueText(row), limitText(row), reasonText(row)};
            facts.removeAll(QString());
            text += QStringLiteral("  %1\n").arg(facts.join(QStringLiteral(", ")));
        });
    });
    return text;
}

}  // namespace kickstand
