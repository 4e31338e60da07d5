#include <algorithm>

#include "app/composition/usb_links.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/help.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_findings.h"

namespace kickstand::ctl {
namespace {

constexpr auto kBehindTheLink = {Check::Radios,   Check::EmergencyStop, Check::Robots,
                                 Check::Feedback, Check::Battery,       Check::Traffic};

constexpr Duration kAnswerLimit = std::chrono::seconds(4);

/// One line of the answer.
struct Line {
    const char* check = "";
    CheckState state = CheckState::Ok;
    Description text;
};

bool isWrong(const Line& line) {
    return line.state == CheckState::Problem;
}

void append(std::vector<Line>& lines, const std::vector<Finding>& findings) {
    for (const Finding& finding : findings)
        lines.push_back({name(finding.check), finding.state, describe(finding)});
}

Line program() {
    return {
        name(Check::Program),
        CheckState::Ok,
        {Words::tr("%1 with Qt %2 works.").arg(versionText().trimmed(), QLatin1String(qVersion())), {}, {}}};
}

bool isOnSerialPort(const SessionSnapshot* session) {
    return session != nullptr && !std::holds_alternative<thunderbots::Snapshot>(session->system);
}

/// What there is to say of a link over a serial port, which may not run.
std::vector<Line> examineSerial(SessionRunner& runner, bool runs) {
    const auto findings = [&runner] { return diagnoseSession(*runner.session()); };
    runner.watchOnly();
    // What answers may take its time, and what does not is said afterwards.
    if (runs)
        static_cast<void>(runner.waitUntil([&] { return runner.session() == nullptr || isWell(findings()); },
                                           kAnswerLimit));
    std::vector<Line> lines;
    if (runner.session() != nullptr) append(lines, findings());
    // Nothing was set going here: what others have set going is left alone.
    runner.leave();
    return lines;
}

/// Opens the link and looks at what is behind it.
std::vector<Line> examineLink(SessionRunner& runner, const LinkUri& uri) {
    Outcome outcome = runner.connect(uri);
    if (isOnSerialPort(runner.session())) return examineSerial(runner, outcome.has_value());
    if (outcome) outcome = runner.settle();
    std::vector<Line> lines;
    if (!outcome) {
        lines.push_back({name(Check::Link), CheckState::Problem, outcome.error().text});
        append(lines, notChecked(kBehindTheLink));
        return lines;
    }
    append(lines, {runningLink(uri, runner.state())});
    append(lines, diagnoseLink(runner.state()));
    return lines;
}

Expected<std::vector<Line>> examine(const Context& context) {
    std::vector<Line> lines{program()};
    SessionRunner runner(context);
    std::optional<LinkUri> uri = context.invocation.link;
    // What is plugged in here has no say about a simulated device, or one on a server.
    if (!uri || isHardware(*uri)) {
        const auto devices = runner.discover();
        if (!devices) return tl::unexpected(devices.error());
        append(lines, diagnoseDevices(*devices));
        if (!uri && !devices->empty()) uri = devices->front().uri;
    }
    if (uri && std::none_of(lines.begin(), lines.end(), isWrong)) {
        const std::vector<Line> link = examineLink(runner, *uri);
        lines.insert(lines.end(), link.begin(), link.end());
    } else {
        append(lines, notChecked({Check::Link}));
        append(lines, notChecked(kBehindTheLink));
    }
    if (context.interruption.cause())
        return failed({.code = Errc::Cancelled, .subject = *context.interruption.cause()});
    return lines;
}

void report(const Context& context, const std::vector<Line>& lines) {
    QJsonArray checks;
    QList<QStringList> rows;
    for (const Line& line : lines) {
        const QString state = QLatin1String(name(line.state));
        QJsonObject json{{QStringLiteral("check"), QLatin1String(line.check)},
                         {QStringLiteral("state"), state},
                         {QStringLiteral("what"), line.text.what},
                         {QStringLiteral("remedy"), line.text.remedy}};
        if (!line.text.remedyCommand.isEmpty()) json[QStringLiteral("command")] = line.text.remedyCommand;
        checks.append(json);
        rows.append({state, QLatin1String(line.check), line.text.line()});
    }
    const bool ok = std::none_of(lines.begin(), lines.end(), isWrong);
    context.output.value(QJsonObject{{QStringLiteral("ok"), ok}, {QStringLiteral("checks"), checks}});
    context.output.table(rows);
}

Outcome doctor(const Context& context) {
    const auto lines = examine(context);
    if (!lines) return tl::unexpected(lines.error());
    report(context, *lines);
    const auto wrong = std::find_if(lines->begin(), lines->end(), isWrong);
    if (wrong == lines->end()) return {};
    return tl::unexpected(Failure{kFailed, wrong->text, QLatin1String(wrong->check)});
}

constexpr CommandSpec kCommands[] = {
    {"doctor",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Says why it does not work: device, permission, radios, e-stop, robots; with remedies."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Opening a link to thunderbots brakes them; closing one to an NXT starts its trigger "
                       "plan, as ever. Exit 1 when something is wrong."),
     {},
     "--link sim:thunderbots doctor",
     doctor},
};

}  // namespace

std::span<const CommandSpec> doctorCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
