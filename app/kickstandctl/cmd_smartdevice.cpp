#include <algorithm>
#include <array>
#include <limits>

#include "app/kickstandctl/cmd_smartdevice_subscribe.h"
#include "app/kickstandctl/device_access.h"
#include "app/kickstandctl/device_report.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_smartdevice.h"

namespace kickstand::ctl {
namespace {

using smartdevice::DeviceState;
using smartdevice::wire::ParameterMask;

constexpr Duration kPingFor = std::chrono::seconds(2);
constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();

void printValues(const Context& context, const DeviceState& device, ParameterMask mask) {
    QList<QStringList> rows;
    for (std::size_t i = 0; i < device.parameters.size(); ++i) {
        if ((mask >> i & 1) == 0) continue;
        rows.append({QString::fromStdString(device.spec->parameters[i].name),
                     valueText(device.spec->parameters[i], device.parameters[i].value),
                     describe(device.parameters[i].verdict)});
    }
    context.output.table(rows);
}

/// Waits until what has been answered is in the snapshot, which comes a little later.
template <class Shown>
Outcome awaitShown(SessionRunner& runner, Shown shown) {
    const auto waited = runner.waitUntil(shown, std::chrono::seconds(1));
    if (!waited) return tl::unexpected(waited.error());
    return {};
}

// ---- The commands.

Outcome listDevices(const Context& context, SessionRunner& runner) {
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    if (auto settled = settleBoards(runner); !settled) return settled;
    const smartdevice::Snapshot& state = boardsOf(runner);
    QJsonArray devices;
    QList<QStringList> rows{
        {Words::tr("kind"), Words::tr("name"), Words::tr("UID"), Words::tr("port"), Words::tr("state")}};
    for (const DeviceState& device : state.devices) {
        QJsonObject json = toJson(device);
        const QString own = ownNameOf(device);
        json[QStringLiteral("own_name")] = own.isEmpty() ? QJsonValue() : QJsonValue(own);
        devices.append(json);
        rows.append({QString::fromStdString(device.spec->name), own.isEmpty() ? QStringLiteral("-") : own,
                     QString::fromStdString(smartdevice::wire::toText(device.uid)),
                     QString::fromStdString(device.port), describe(device.presence)});
    }
    QJsonArray ports;
    QStringList troubles;
    for (const smartdevice::PortState& port : state.ports) {
        ports.append(toJson(port));
        if (const QString trouble = troubleOf(port); !trouble.isEmpty()) troubles << trouble;
    }
    QJsonValue catalogue;
    if (state.catalogueError) catalogue = toJson(*state.catalogueError);
    context.output.value(QJsonObject{{QStringLiteral("devices"), devices},
                                     {QStringLiteral("ports"), ports},
                                     {QStringLiteral("catalogue_error"), catalogue}});
    if (rows.size() > 1) context.output.table(rows);
    if (rows.size() == 1) context.output.line(Words::tr("There is no smart device here."));
    for (const QString& trouble : troubles)
        context.output.line(trouble);
    return {};
}

Outcome ping(const Context& context, SessionRunner& runner) {
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    if (auto waited = runner.waitUntil([] { return false; }, kPingFor); !waited)
        return tl::unexpected(waited.error());
    const DeviceState& device = deviceOf(runner, *number);
    if (!device.latency) return failed({.code = Errc::TimedOut, .subject = device.spec->name});
    context.output.value(toJson(device));
    context.output.line(
        Words::tr("%1 at %2 answers after %3 ms (median), %4 ms (99 of 100)")
            .arg(QString::fromStdString(device.spec->name), QString::fromStdString(device.port))
            .arg(seconds(device.latency->median) * 1000, 0, 'f', 2)
            .arg(seconds(device.latency->p99) * 1000, 0, 'f', 2));
    return {};
}

Outcome read(const Context& context, SessionRunner& runner) {
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    const auto mask = parametersOf(context, deviceOf(runner, *number), 1);
    if (!mask) return tl::unexpected(mask.error());
    const SystemCommand command = smartdevice::Command(smartdevice::ReadValues{*number, *mask});
    const TimePoint asked = runner.engine().now();
    if (auto done = runner.perform(command); !done) return done;
    const auto isShown = [&] {
        const DeviceState& device = deviceOf(runner, *number);
        for (std::size_t i = 0; i < device.parameters.size(); ++i) {
            const bool wanted = (*mask & device.spec->readable()) >> i & 1;
            if (wanted && device.parameters[i].at < asked) return false;
        }
        return true;
    };
    if (auto shown = awaitShown(runner, isShown); !shown) return shown;
    context.output.value(valuesToJson(deviceOf(runner, *number), *mask));
    printValues(context, deviceOf(runner, *number), *mask);
    return {};
}

struct WriteRequest {
    std::vector<std::pair<int, smartdevice::wire::Value>> values;
    ParameterMask mask = 0;
    bool moves = false;
};

/// What a person has to enter for it, to follow "it is ".
QString typeText(const smartdevice::ParameterSpec& spec) {
    using smartdevice::wire::ValueType;
    if (spec.type == ValueType::Raw) return Words::tr("bytes in hex, %1 of them").arg(spec.rawWidth);
    if (spec.type == ValueType::Bool) return Words::tr("on or off");
    return smartdevice::wire::isInteger(spec.type) ? Words::tr("a whole number") : Words::tr("a number");
}

/// The value of a parameter that is written, as it was typed.
Expected<smartdevice::wire::Value> readValue(const smartdevice::ParameterSpec& spec,
                                             const std::string& text) {
    const QString name = QString::fromStdString(spec.name);
    if (!spec.writable())
        return badUsage(Words::tr("%1 can only be read.").arg(name),
                        Words::tr("Write to another parameter; the help page of the boards says which."));
    auto value = smartdevice::wire::fromText(spec.type, text, spec.name);
    const bool fits = value && smartdevice::wire::bytesOf(*value).size() == spec.width();
    if (fits) return *std::move(value);
    if (!value && value.error().code != Errc::BadArgument)
        return tl::unexpected(refusedInput(value.error()).value());
    return badUsage(Words::tr("%1 cannot be “%2”.").arg(name, printable(text)),
                    Words::tr("It is %1.").arg(typeText(spec)));
}

Expected<WriteRequest> readWrite(const Context& context, const DeviceState& device) {
    WriteRequest request;
    const auto& operands = context.invocation.operands;
    for (std::size_t i = 1; i < operands.size(); ++i) {
        const std::size_t equals = operands[i].find('=');
        if (equals == std::string::npos || equals == 0)
            return badUsage(Words::tr("“%1” is no parameter with its value.").arg(printable(operands[i])),
                            Words::tr("Write it as NAME=VALUE, as in duty_cycle=0.2."));
        const std::string name = operands[i].substr(0, equals);
        const int parameter = device.spec->find(name);
        if (parameter < 0) return noParameter(device, name);
        const smartdevice::ParameterSpec& spec = device.spec->parameters[static_cast<std::size_t>(parameter)];
        const auto value = readValue(spec, operands[i].substr(equals + 1));
        if (!value) return tl::unexpected(value.error());
        // Zero is where a speed ends, but a place like any other.
        const bool zero = spec.zeroOnStop && smartdevice::wire::toNumber(*value) == 0.0;
        request.moves = request.moves || (spec.moves && !zero);
        request.mask = static_cast<ParameterMask>(request.mask | 1U << parameter);
        // The last one counts, as for the board.
        std::erase_if(request.values, [&](const auto& one) { return one.first == parameter; });
        request.values.emplace_back(parameter, *value);
    }
    return request;
}

/// Whether what was written is, as far as is known, still so.
bool holds(const DeviceState& device, const WriteRequest& request) {
    return std::ranges::all_of(request.values, [&](const auto& one) {
        return device.parameters.at(static_cast<std::size_t>(one.first)).written == one.second;
    });
}

/// Whether the board tells zero of what it had taken and what drives: it disabled itself.
bool stoppedItself(const DeviceState& device, const WriteRequest& request) {
    // Of several set points one takes over from another, whose zero then says nothing.
    const auto moves = [&](const auto& one) {
        return device.spec->parameters.at(static_cast<std::size_t>(one.first)).moves;
    };
    if (std::ranges::count_if(request.values, moves) != 1) return false;
    return std::ranges::any_of(request.values, [&](const auto& one) {
        const auto at = static_cast<std::size_t>(one.first);
        const smartdevice::ParameterState& parameter = device.parameters.at(at);
        return device.spec->parameters.at(at).zeroOnStop &&
               parameter.verdict == smartdevice::WriteVerdict::Done &&
               smartdevice::wire::toNumber(one.second) != 0.0 && parameter.value &&
               smartdevice::wire::toNumber(*parameter.value) == 0.0;
    });
}

QString whyNotHeld(const DeviceState& device, const WriteRequest& request) {
    const QString name = QString::fromStdString(device.spec->name);
    if (holds(device, request)) return Words::tr("%1 stopped by itself meanwhile.").arg(name);
    return Words::tr("%1 began anew meanwhile: what was written is gone.").arg(name);
}

/// Waits as long as what was written is to last. Fails as soon as it does not hold any more.
Outcome hold(SessionRunner& runner, int number, const WriteRequest& request, Duration span) {
    const auto ended = runner.waitUntil(
        [&] {
            const DeviceState& device = deviceOf(runner, number);
            return device.presence == smartdevice::Presence::Lost || !holds(device, request) ||
                   stoppedItself(device, request);
        },
        span);
    if (!ended) return tl::unexpected(ended.error());
    if (!*ended) return {};
    const DeviceState& device = deviceOf(runner, number);
    Failure failure = failed({.code = Errc::Disconnected, .subject = device.spec->name}).value();
    if (device.presence != smartdevice::Presence::Lost)
        failure.text = {whyNotHeld(device, request),
                        Words::tr("Check its power supply and its cable, then write it again."),
                        {}};
    return tl::unexpected(std::move(failure));
}

Outcome writeAndWatch(const Context& context, SessionRunner& runner, bool& stops) {
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    const auto request = readWrite(context, deviceOf(runner, *number));
    if (!request) return tl::unexpected(request.error());
    const bool timed = context.invocation.has("--for");
    if (request->moves && !timed)
        return badUsage(Words::tr("What moves needs --for."),
                        Words::tr("Say how long, as in --for 2: the device is stopped afterwards."));
    Duration span{};
    if (timed) {
        const auto parsed = parseSeconds(context.invocation.text("--for"), "--for");
        if (!parsed) return tl::unexpected(parsed.error());
        span = *parsed;
    }
    stops = request->moves;
    const SystemCommand command = smartdevice::Command(smartdevice::WriteValues{*number, request->values});
    Outcome outcome = runner.perform(command);
    const auto isJudged = [&] {
        const DeviceState& device = deviceOf(runner, *number);
        return holds(device, *request) && std::ranges::none_of(request->values, [&](const auto& one) {
                   return device.parameters.at(static_cast<std::size_t>(one.first)).verdict ==
                          smartdevice::WriteVerdict::Pending;
               });
    };
    if (outcome) outcome = awaitShown(runner, isJudged);
    if (outcome && timed) outcome = hold(runner, *number, *request, span);
    const DeviceState& device = deviceOf(runner, *number);
    QJsonObject verdicts;
    for (const auto& [parameter, value] : request->values) {
        const auto at = static_cast<std::size_t>(parameter);
        verdicts[QString::fromStdString(device.spec->parameters[at].name)] =
            QLatin1String(smartdevice::name(device.parameters[at].verdict));
    }
    if (outcome) {
        context.output.value(QJsonObject{{QStringLiteral("verdicts"), verdicts},
                                         {QStringLiteral("values"), valuesToJson(device, request->mask)}});
        printValues(context, device, request->mask);
    }
    return outcome;
}

Outcome disable(const Context& context, SessionRunner& runner) {
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    const SystemCommand command = smartdevice::Command(smartdevice::DisableDevice{*number});
    if (auto done = runner.perform(command); !done) return done;
    context.output.value(QJsonObject{{QStringLiteral("disabled"), true}});
    context.output.line(Words::tr("%1 was told to stop everything.")
                            .arg(QString::fromStdString(deviceOf(runner, *number).spec->name)));
    return {};
}

/// What moves nothing ends without stopping what others may have set going.
template <Outcome (*command)(const Context&, SessionRunner&)>
Outcome leaving(const Context& context) {
    SessionRunner runner(context);
    Outcome outcome = command(context, runner);
    runner.leave();
    return outcome;
}

Outcome write(const Context& context) {
    SessionRunner runner(context);
    bool stops = false;
    Outcome outcome = writeAndWatch(context, runner, stops);
    if (!stops) {
        runner.leave();
        return outcome;
    }
    const bool stopped = runner.finish();
    if (outcome && !stopped) return notStopped(runner);
    if (stopped) context.output.line(Words::tr("The devices were told to stop."));
    return outcome;
}

constexpr std::array kWriteOptions{
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long; needed for what moves")}};
constexpr std::array kSubscribeOptions{
    OptionSpec{"--delay", "MS",
               QT_TRANSLATE_NOOP("kickstandctl", "from one update to the next; 40 without it")},
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long; without it until Ctrl+C")}};
constexpr char kDeviceDetails[] = QT_TRANSLATE_NOOP("kickstandctl",
                                                    "DEVICE is its kind (PolarBear) where there is one of "
                                                    "it, the name it was given in the window, its UID, or "
                                                    "its port.");

constexpr CommandSpec kCommands[] = {
    {"smartdevice list",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Lists the smart devices that are plugged in, and the ports without one."),
     "",
     {},
     "--link sim:smartdevice smartdevice list",
     leaving<listDevices>},
    {"smartdevice ping",
     "DEVICE",
     1,
     1,
     QT_TRANSLATE_NOOP("kickstandctl", "Measures how fast a device answers."),
     kDeviceDetails,
     {},
     "smartdevice ping PolarBear",
     leaving<ping>},
    {"smartdevice read",
     "DEVICE [PARAMETER]…",
     1,
     kAnyNumber,
     QT_TRANSLATE_NOOP("kickstandctl", "Reads parameters once; all without a name."),
     kDeviceDetails,
     {},
     "smartdevice read BatteryBuzzer v_batt is_unsafe",
     leaving<read>},
    {"smartdevice write", "DEVICE PARAMETER=VALUE…", 2, kAnyNumber,
     QT_TRANSLATE_NOOP("kickstandctl", "Writes parameters, and says whether the device took them."),
     kDeviceDetails, kWriteOptions, "smartdevice write PolarBear duty_cycle=0.2 --for 2", write},
    {"smartdevice subscribe", "DEVICE [PARAMETER]…", 1, kAnyNumber,
     QT_TRANSLATE_NOOP("kickstandctl", "Prints parameters as the device sends them."), kDeviceDetails,
     kSubscribeOptions, "--json smartdevice subscribe LineFollower --delay 20 --for 5",
     leaving<subscribeBoard>},
    {"smartdevice disable",
     "DEVICE",
     1,
     1,
     QT_TRANSLATE_NOOP("kickstandctl", "Lets a device stop everything; its next write resumes it."),
     kDeviceDetails,
     {},
     "smartdevice disable PolarBear",
     leaving<disable>},
};

}  // namespace

std::span<const CommandSpec> smartDeviceCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
