#include <algorithm>
#include <array>
#include <limits>

#include "app/kickstandctl/device_report.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/interruption.h"
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
using smartdevice::PortPhase;
using smartdevice::Presence;
using smartdevice::wire::ParameterMask;

/// A port is asked for five seconds; a board that nobody knows takes some more.
constexpr Duration kSettleLimit = std::chrono::seconds(9);
constexpr Duration kPingFor = std::chrono::seconds(2);
constexpr Duration kEndless = std::chrono::hours(24 * 365);
constexpr std::size_t kAnyNumber = std::numeric_limits<std::size_t>::max();
constexpr int kUsualDelay_ms = 40;

const smartdevice::Snapshot& stateOf(const SessionRunner& runner) {
    return runner.stateOf<smartdevice::Snapshot>();
}

bool isUnderWay(const smartdevice::Snapshot& state) {
    const bool asking = std::ranges::any_of(state.ports, [](const smartdevice::PortState& port) {
        return port.phase == PortPhase::Opening || port.phase == PortPhase::Asking;
    });
    return asking || std::ranges::any_of(state.devices, &DeviceState::learning);
}

/// Connects; without a link to every serial port on USB.
Outcome connect(const Context& context, SessionRunner& runner) {
    const LinkUri uri =
        context.invocation.link.value_or(LinkUri{.scheme = "serial", .target = {}, .options = {}});
    if (auto connected = runner.connect(uri); !connected) return connected;
    if (stateOf(runner).link == smartdevice::LinkState::Running) return {};
    return badUsage(Words::tr("This link does not lead to smart devices."),
                    Words::tr("Name serial ports, as in --link serial:/dev/ttyACM0, or sim:smartdevice."));
}

/// Waits until every port has answered, or it is known that it does not.
Outcome settle(SessionRunner& runner) {
    const auto settled = runner.waitUntil([&runner] { return !isUnderWay(stateOf(runner)); }, kSettleLimit);
    if (!settled) return tl::unexpected(settled.error());
    return {};
}

bool isCalled(const DeviceState& device, const std::string& name) {
    return device.spec->name == name || device.port == name ||
           smartdevice::wire::uidFromText(name) == device.uid;
}

QString namesOf(const smartdevice::Snapshot& state) {
    QStringList names;
    for (const DeviceState& device : state.devices)
        names << QStringLiteral("%1 (%2)").arg(QString::fromStdString(device.spec->name),
                                               QString::fromStdString(smartdevice::wire::toText(device.uid)));
    return names.isEmpty() ? Words::tr("none") : names.join(QStringLiteral(", "));
}

/// The device of that name, UID or port, once it is there; its number.
Expected<int> awaitDevice(SessionRunner& runner, const std::string& name) {
    const auto found = [&] {
        const auto& devices = stateOf(runner).devices;
        return std::ranges::any_of(devices, [&](const DeviceState& device) {
            return isCalled(device, name) && device.presence == Presence::Live && !device.learning;
        });
    };
    const bool byKind = !smartdevice::wire::uidFromText(name) && name.find('/') == std::string::npos;
    // A kind may be there twice, which is known only when every port has answered.
    const auto waited =
        runner.waitUntil([&] { return (found() && !byKind) || !isUnderWay(stateOf(runner)); }, kSettleLimit);
    if (!waited) return tl::unexpected(waited.error());
    std::vector<int> numbers;
    for (const DeviceState& device : stateOf(runner).devices) {
        if (isCalled(device, name) && device.presence == Presence::Live) numbers.push_back(device.number);
    }
    if (numbers.size() == 1) return numbers.front();
    Failure failure = failed({.code = Errc::NoDevice, .subject = name}).value();
    failure.text.what = numbers.empty() ? Words::tr("There is no device “%1” here.").arg(printable(name))
                                        : Words::tr("There are several devices “%1”.").arg(printable(name));
    failure.text.remedy =
        Words::tr("Name one by its kind, UID or port; there are: %1.").arg(namesOf(stateOf(runner)));
    return tl::unexpected(std::move(failure));
}

const DeviceState& deviceOf(const SessionRunner& runner, int number) {
    return stateOf(runner).devices.at(static_cast<std::size_t>(number));
}

tl::unexpected<Failure> noParameter(const DeviceState& device, const std::string& name) {
    QStringList known;
    for (const smartdevice::ParameterSpec& spec : device.spec->parameters)
        known << QString::fromStdString(spec.name);
    return badUsage(Words::tr("%1 has no parameter “%2”.")
                        .arg(QString::fromStdString(device.spec->name), printable(name)),
                    Words::tr("It has: %1.").arg(known.join(QStringLiteral(", "))));
}

/// The parameters of the operands from `first` on; all that can be read where there are none.
Expected<ParameterMask> parametersOf(const Context& context, const DeviceState& device, std::size_t first) {
    const auto& operands = context.invocation.operands;
    if (operands.size() <= first) return device.spec->readable();
    ParameterMask mask = 0;
    for (std::size_t i = first; i < operands.size(); ++i) {
        const int parameter = device.spec->find(operands[i]);
        if (parameter < 0) return noParameter(device, operands[i]);
        mask = static_cast<ParameterMask>(mask | 1U << parameter);
    }
    return mask;
}

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
    if (auto connected = connect(context, runner); !connected) return connected;
    if (auto settled = settle(runner); !settled) return settled;
    const smartdevice::Snapshot& state = stateOf(runner);
    QJsonArray devices;
    QList<QStringList> rows{{Words::tr("kind"), Words::tr("UID"), Words::tr("port"), Words::tr("state")}};
    for (const DeviceState& device : state.devices) {
        devices.append(toJson(device));
        rows.append({QString::fromStdString(device.spec->name),
                     QString::fromStdString(smartdevice::wire::toText(device.uid)),
                     QString::fromStdString(device.port), describe(device.presence)});
    }
    QJsonArray ports;
    QStringList troubles;
    for (const smartdevice::PortState& port : state.ports) {
        ports.append(toJson(port));
        if (port.error) troubles << describe(*port.error).line();
        if (port.phase == PortPhase::Silent)
            troubles << Words::tr("Nobody answers at %1. Check that a smart device is at its end.")
                            .arg(QString::fromStdString(port.name));
    }
    context.output.value(QJsonObject{{QStringLiteral("devices"), devices}, {QStringLiteral("ports"), ports}});
    if (rows.size() > 1) context.output.table(rows);
    if (rows.size() == 1) context.output.line(Words::tr("There is no smart device here."));
    for (const QString& trouble : troubles)
        context.output.line(trouble);
    return {};
}

Outcome ping(const Context& context, SessionRunner& runner) {
    if (auto connected = connect(context, runner); !connected) return connected;
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
    if (auto connected = connect(context, runner); !connected) return connected;
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
        const auto value = smartdevice::wire::fromText(spec.type, operands[i].substr(equals + 1), name);
        if (!value) return tl::unexpected(refusedInput(value.error()).value());
        // Zero is where a speed ends, but a place like any other.
        const bool zero = spec.zeroOnStop && smartdevice::wire::toNumber(*value) == 0.0;
        request.moves = request.moves || (spec.moves && !zero);
        request.mask = static_cast<ParameterMask>(request.mask | 1U << parameter);
        request.values.emplace_back(parameter, *value);
    }
    return request;
}

Outcome writeAndWatch(const Context& context, SessionRunner& runner, bool& stops) {
    if (auto connected = connect(context, runner); !connected) return connected;
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
        return std::ranges::all_of(request->values, [&](const auto& one) {
            const auto& state = deviceOf(runner, *number).parameters.at(static_cast<std::size_t>(one.first));
            return state.written == one.second && state.verdict != smartdevice::WriteVerdict::Pending;
        });
    };
    if (outcome) outcome = awaitShown(runner, isJudged);
    if (outcome && timed) {
        const auto kept = runner.waitUntil([] { return false; }, span);
        if (!kept) outcome = tl::unexpected(kept.error());
    }
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

/// Tells each value that came anew.
class Updates {
  public:
    Updates(const Context& context, SessionRunner& runner, int number, ParameterMask mask)
        : context_(context), runner_(runner), number_(number), mask_(mask) {}

    void look() {
        const DeviceState& device = deviceOf(runner_, number_);
        if (device.samples == samples_) return;
        samples_ = device.samples;
        const QJsonObject values = valuesToJson(device, mask_);
        QJsonObject json{
            {QStringLiteral("type"), QStringLiteral("update")},
            {QStringLiteral("time"), isoTime(runner_.engine(), stateOf(runner_).time)},
            {QStringLiteral("device"), QString::fromStdString(device.spec->name)},
            {QStringLiteral("uid"), QString::fromStdString(smartdevice::wire::toText(device.uid))},
            {QStringLiteral("values"), values}};
        context_.output.value(json);
        QStringList texts;
        for (std::size_t i = 0; i < device.parameters.size(); ++i) {
            if ((mask_ >> i & 1) == 0) continue;
            texts << QStringLiteral("%1 %2").arg(
                QString::fromStdString(device.spec->parameters[i].name),
                valueText(device.spec->parameters[i], device.parameters[i].value));
        }
        context_.output.line(QStringLiteral("%1  %2").arg(clockText(runner_.engine(), stateOf(runner_).time),
                                                          texts.join(QStringLiteral("  "))));
    }

  private:
    const Context& context_;
    SessionRunner& runner_;
    const int number_;
    const ParameterMask mask_;
    std::uint64_t samples_ = 0;
};

Outcome subscribe(const Context& context, SessionRunner& runner) {
    int delay_ms = kUsualDelay_ms;
    if (context.invocation.has("--delay")) {
        const auto parsed = parseWhole(context.invocation.text("--delay"), "--delay", 1, 65535);
        if (!parsed) return tl::unexpected(parsed.error());
        delay_ms = *parsed;
    }
    Duration span = kEndless;
    if (context.invocation.has("--for")) {
        const auto parsed = parseSeconds(context.invocation.text("--for"), "--for");
        if (!parsed) return tl::unexpected(parsed.error());
        span = *parsed;
    }
    if (auto connected = connect(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    const auto mask = parametersOf(context, deviceOf(runner, *number), 1);
    if (!mask) return tl::unexpected(mask.error());
    const SystemCommand command =
        smartdevice::Command(smartdevice::Subscribe{*number, *mask, static_cast<std::uint16_t>(delay_ms)});
    if (auto done = runner.perform(command); !done) return done;
    runner.watchOnly();
    Updates updates(context, runner, *number, *mask);
    const auto watched = runner.waitUntil(
        [&updates] {
            updates.look();
            return false;
        },
        span);
    // Ctrl+C is how one that has no end is ended.
    if (!watched && !(span == kEndless && context.interruption.isRequest()))
        return tl::unexpected(watched.error());
    return {};
}

Outcome disable(const Context& context, SessionRunner& runner) {
    if (auto connected = connect(context, runner); !connected) return connected;
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
    if (outcome && !stopped) return failed({.code = Errc::TimedOut, .subject = "stop"});
    if (stopped) context.output.line(Words::tr("The devices were told to stop."));
    return outcome;
}

constexpr std::array kWriteOptions{
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long; needed for what moves")}};
constexpr std::array kSubscribeOptions{
    OptionSpec{"--delay", "MS",
               QT_TRANSLATE_NOOP("kickstandctl", "from one update to the next; 40 without it")},
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long; without it until Ctrl+C")}};
constexpr char kDeviceDetails[] = QT_TRANSLATE_NOOP(
    "kickstandctl", "DEVICE is its kind (PolarBear) where there is one of it, its UID, or its port.");

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
     kSubscribeOptions, "--json smartdevice subscribe LineFollower --delay 20 --for 5", leaving<subscribe>},
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
