#include <array>

#include "app/kickstandctl/device_access.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/plan_report.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

/// "PolarBear at /dev/ttyACM0, …".
QString boardsText(const smartdevice::Snapshot& state) {
    QStringList boards;
    for (const smartdevice::DeviceState& board : state.devices)
        boards << Words::tr("%1 at %2")
                      .arg(QString::fromStdString(board.spec->name), QString::fromStdString(board.port));
    return boards.join(QStringLiteral(", "));
}

/// What is said of a link whose robots were stopped.
QString stoppedText(const QString& link, const SystemSnapshot& system) {
    if (std::holds_alternative<thunderbots::Snapshot>(system))
        return Words::tr("%1: all robots were told to brake; chargers, dribblers and autokick are off.")
            .arg(link);
    if (std::holds_alternative<motionplan::Snapshot>(system))
        return Words::tr("%1: the robot stands, as it says itself.").arg(link);
    if (const auto* const boards = std::get_if<smartdevice::Snapshot>(&system))
        return Words::tr("%1: told to stop: %2.").arg(link, boardsText(*boards));
    return Words::tr("%1: everything was told to stop.").arg(link);
}

/// Opens one link, which brakes all robots, and leaves them braked.
QJsonObject stopLink(const Context& context, const LinkUri& uri, std::optional<Failure>& failure) {
    const QString link = QString::fromStdString(toString(uri));
    SessionRunner runner(context);
    Outcome outcome = runner.connect(uri);
    SystemSnapshot system;
    if (runner.session() != nullptr) system = runner.session()->system;
    const bool onNxt = outcome && std::holds_alternative<motionplan::Snapshot>(system);
    if (onNxt) system = stopAndAsk(runner);
    const bool braked = runner.finish();
    const bool onBoards = outcome && std::holds_alternative<smartdevice::Snapshot>(system);
    if (onBoards) system = boardsOf(runner);
    if (outcome && !braked) {
        if (onBoards)
            outcome = notStopped(runner);
        else if (onNxt)
            outcome = failed({.code = Errc::Unconfirmed, .subject = "stop"});
        else
            outcome = failed({.code = Errc::TimedOut, .subject = toString(uri)});
    }
    QJsonObject json{{QStringLiteral("link"), link}, {QStringLiteral("braked"), braked}};
    QString closing;
    if (const auto* const robot = std::get_if<motionplan::Snapshot>(&system); onNxt && robot != nullptr) {
        addClosing(json, *robot);
        closing = closingText(*robot);
    }
    if (outcome) {
        context.output.line(stoppedText(link, system));
        for (const smartdevice::PortState& port : boardsOf(runner).ports) {
            if (const QString trouble = troubleOf(port); !trouble.isEmpty()) context.output.line(trouble);
        }
    } else {
        json[QStringLiteral("error")] = toJson(outcome.error());
        if (!failure) failure = outcome.error();
    }
    if (!closing.isEmpty()) context.output.line(closing);
    return json;
}

Outcome stopAll(const Context& context) {
    std::vector<LinkUri> links;
    if (context.invocation.link) {
        links.push_back(*context.invocation.link);
    } else {
        SessionRunner runner(context);
        const auto devices = runner.discover();
        if (!devices) return tl::unexpected(devices.error());
        for (const FoundDevice& device : *devices)
            links.push_back(device.uri);
    }
    if (links.empty()) return failed({.code = Errc::NoDevice});
    std::optional<Failure> failure;
    QJsonArray json;
    for (const LinkUri& uri : links)
        json.append(stopLink(context, uri, failure));
    context.output.value(QJsonObject{{QStringLiteral("stopped"), json}});
    if (failure) return tl::unexpected(*std::move(failure));
    return {};
}

Outcome stopOne(const Context& context) {
    SessionRunner runner(context);
    const auto uri = runner.chooseLink();
    if (!uri) return tl::unexpected(uri.error());
    std::optional<Failure> failure;
    context.output.value(
        QJsonObject{{QStringLiteral("stopped"), QJsonArray{stopLink(context, *uri, failure)}}});
    if (failure) return tl::unexpected(*std::move(failure));
    return {};
}

constexpr CommandSpec kCommands[] = {
    {"stop",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Brakes everything on every link that is plugged in, or on the one that is named."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Chargers, dribblers and autokick go off too. A program that holds a dongle has its "
                       "own STOP. What a dongle still "
                       "holds of kicks cannot be called back."),
     {},
     "stop",
     stopAll},
    {"thunderbots stop",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl", "The same for one dongle or cabled robot."),
     "",
     {},
     "--link usb: thunderbots stop",
     stopOne},
};

}  // namespace

std::span<const CommandSpec> stopCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
