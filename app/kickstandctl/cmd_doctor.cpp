#include <algorithm>

#include "app/kickstandctl/diagnosis.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/help.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

using State = Finding::State;

constexpr auto kBehindTheLink = {"radios", "e-stop", "robots", "feedback", "battery", "traffic"};

bool isWrong(const Finding& finding) {
    return finding.state == State::Problem;
}

void append(std::vector<Finding>& all, std::vector<Finding> more) {
    all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

Finding program() {
    return {
        "program",
        State::Ok,
        {Words::tr("%1 with Qt %2 works.").arg(versionText().trimmed(), QLatin1String(qVersion())), {}, {}}};
}

/// Opens the link and looks at what is behind it.
std::vector<Finding> examineLink(SessionRunner& runner, const LinkUri& uri) {
    Outcome outcome = runner.connect(uri);
    if (outcome) outcome = runner.settle();
    std::vector<Finding> findings;
    if (!outcome) {
        findings.push_back({"link", State::Problem, outcome.error().text});
        append(findings, notChecked(kBehindTheLink));
        return findings;
    }
    const QString link = QString::fromStdString(toString(uri));
    findings.push_back(
        {"link", State::Ok, {Words::tr("%1 runs: %2.").arg(link, deviceText(uri, runner.state())), {}, {}}});
    append(findings, diagnoseLink(runner.state()));
    return findings;
}

Expected<std::vector<Finding>> examine(const Context& context) {
    std::vector<Finding> findings{program()};
    SessionRunner runner(context);
    std::optional<LinkUri> uri = context.invocation.link;
    if (!uri || !uri->isSimulated()) {
        const auto devices = runner.discover();
        if (!devices) return tl::unexpected(devices.error());
        append(findings, diagnoseDevices(*devices, [](const std::string& port) { return findHolder(port); }));
        if (!uri && !devices->empty()) uri = devices->front().uri;
    }
    if (uri && std::none_of(findings.begin(), findings.end(), isWrong)) {
        append(findings, examineLink(runner, *uri));
    } else {
        append(findings, notChecked({"link"}));
        append(findings, notChecked(kBehindTheLink));
    }
    if (context.interruption.cause())
        return failed({.code = Errc::Cancelled, .subject = *context.interruption.cause()});
    return findings;
}

void report(const Context& context, const std::vector<Finding>& findings) {
    QJsonArray checks;
    QList<QStringList> rows;
    for (const Finding& finding : findings) {
        const QString state = QLatin1String(name(finding.state));
        QJsonObject json{{QStringLiteral("check"), QLatin1String(finding.check)},
                         {QStringLiteral("state"), state},
                         {QStringLiteral("what"), finding.text.what},
                         {QStringLiteral("remedy"), finding.text.remedy}};
        if (!finding.text.remedyCommand.isEmpty())
            json[QStringLiteral("command")] = finding.text.remedyCommand;
        checks.append(json);
        rows.append({state, QLatin1String(finding.check), finding.text.line()});
    }
    const bool ok = std::none_of(findings.begin(), findings.end(), isWrong);
    context.output.value(QJsonObject{{QStringLiteral("ok"), ok}, {QStringLiteral("checks"), checks}});
    context.output.table(rows);
}

Outcome doctor(const Context& context) {
    const auto findings = examine(context);
    if (!findings) return tl::unexpected(findings.error());
    report(context, *findings);
    const auto wrong = std::find_if(findings->begin(), findings->end(), isWrong);
    if (wrong == findings->end()) return {};
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
     QT_TRANSLATE_NOOP("kickstandctl", "Opening a link brakes its robots. Exit 1 when something is wrong."),
     {},
     "--link sim:thunderbots doctor",
     doctor},
};

}  // namespace

std::span<const CommandSpec> doctorCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
