#include "app/kickstandctl/device_access.h"

#include <QSettings>
#include <algorithm>

#include "app/kickstandctl/output.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/engine/describe_smartdevice.h"

namespace kickstand::ctl {
namespace {

using smartdevice::DeviceState;
using smartdevice::PortPhase;
using smartdevice::PortState;
using smartdevice::Presence;
using smartdevice::wire::ParameterMask;

/// A port is asked for five seconds; a board that nobody knows takes some more.
constexpr Duration kSettleLimit = std::chrono::seconds(9);

bool isUnderWay(const smartdevice::Snapshot& state) {
    return arePortsUnderWay(state) || std::ranges::any_of(state.devices, &DeviceState::learning);
}

bool isCalled(const DeviceState& device, const std::string& name) {
    return device.spec->name == name || device.port == name ||
           smartdevice::wire::uidFromText(name) == device.uid ||
           ownNameOf(device) == QString::fromStdString(name);
}

QString namesOf(const smartdevice::Snapshot& state) {
    QStringList names;
    for (const DeviceState& device : state.devices) {
        const QString own = ownNameOf(device);
        names << QStringLiteral("%1 (%2)").arg(
            own.isEmpty() ? QString::fromStdString(device.spec->name) : own,
            QString::fromStdString(smartdevice::wire::toText(device.uid)));
    }
    return names.isEmpty() ? Words::tr("none") : names.join(QStringLiteral(", "));
}

/// Whether the link names a port that is not there.
bool isPortMissing(const SessionRunner& runner) {
    const std::string& target = runner.uri().target;
    return runner.uri().scheme == "serial" && !target.empty() &&
           std::ranges::find(boardsOf(runner).ports, target, &PortState::name) ==
               boardsOf(runner).ports.end();
}

/// Why nothing is called so: a port that was named, or all there are, cannot be used.
std::optional<Error> culprit(const smartdevice::Snapshot& state, const std::string& name) {
    const auto named = std::ranges::find(state.ports, name, &PortState::name);
    if (named != state.ports.end()) return named->error;
    if (!state.devices.empty()) return std::nullopt;
    const auto any =
        std::ranges::find_if(state.ports, [](const PortState& one) { return one.error.has_value(); });
    return any == state.ports.end() ? std::nullopt : any->error;
}

/// What keeps a port from being used; nothing where it can be, or may still turn out so.
std::optional<Failure> failureOf(const PortState& port) {
    if (port.error) return failed(*port.error).value();
    if (port.phase != PortPhase::Silent) return std::nullopt;
    Failure failure = failed({.code = Errc::TimedOut, .subject = port.name}).value();
    failure.text = {Words::tr("Nobody answers at %1.").arg(QString::fromStdString(port.name)),
                    Words::tr("Check that a smart device is at its end."),
                    {}};
    return failure;
}

tl::unexpected<Failure> noDevice(const smartdevice::Snapshot& state, const std::string& name) {
    Failure failure = failed({.code = Errc::NoDevice, .subject = name}).value();
    failure.text = {Words::tr("There is no device “%1” here.").arg(printable(name)),
                    Words::tr("Name one by its kind, its own name, its UID or its port; there are: %1.")
                        .arg(namesOf(state)),
                    {}};
    QStringList troubles;
    for (const PortState& port : state.ports) {
        if (!troubleOf(port).isEmpty()) troubles << troubleOf(port);
    }
    if (!troubles.isEmpty()) failure.text.remedy += QLatin1Char(' ') + troubles.join(QLatin1Char(' '));
    return tl::unexpected(std::move(failure));
}

}  // namespace

const smartdevice::Snapshot& boardsOf(const SessionRunner& runner) {
    return runner.stateOf<smartdevice::Snapshot>();
}

const DeviceState& deviceOf(const SessionRunner& runner, int number) {
    return boardsOf(runner).devices.at(static_cast<std::size_t>(number));
}

bool arePortsUnderWay(const smartdevice::Snapshot& state) {
    return std::ranges::any_of(state.ports, [](const PortState& port) {
        return port.phase == PortPhase::Opening || port.phase == PortPhase::Asking;
    });
}

Outcome connectBoards(const Context& context, SessionRunner& runner) {
    const LinkUri uri =
        context.invocation.link.value_or(LinkUri{.scheme = "serial", .target = {}, .options = {}});
    if (auto connected = runner.connect(uri); !connected) return connected;
    if (boardsOf(runner).link != smartdevice::LinkState::Running)
        return badUsage(
            Words::tr("This link does not lead to smart devices."),
            Words::tr("Name serial ports, as in --link serial:/dev/ttyACM0, or sim:smartdevice."));
    if (isPortMissing(runner)) return failed({.code = Errc::NoDevice, .port = runner.uri().target});
    if (const auto& error = boardsOf(runner).catalogueError) {
        Failure failure = failed(*error).value();
        failure.text = describeCatalogueError(*error);
        Output::complain(failure);
    }
    return {};
}

Outcome settleBoards(SessionRunner& runner) {
    const auto settled = runner.waitUntil([&runner] { return !isUnderWay(boardsOf(runner)); }, kSettleLimit);
    if (!settled) return tl::unexpected(settled.error());
    return {};
}

Expected<int> awaitDevice(SessionRunner& runner, const std::string& name) {
    const auto found = [&] {
        const auto& devices = boardsOf(runner).devices;
        return std::ranges::any_of(devices, [&](const DeviceState& device) {
            return isCalled(device, name) && device.presence == Presence::Live && !device.learning;
        });
    };
    const bool byKind = !smartdevice::wire::uidFromText(name) && name.find('/') == std::string::npos;
    // A kind may be there twice, which is known only when every port has answered.
    const auto waited =
        runner.waitUntil([&] { return (found() && !byKind) || !isUnderWay(boardsOf(runner)); }, kSettleLimit);
    if (!waited) return tl::unexpected(waited.error());
    const smartdevice::Snapshot& state = boardsOf(runner);
    std::vector<int> numbers;
    for (const DeviceState& device : state.devices) {
        if (isCalled(device, name) && device.presence == Presence::Live) numbers.push_back(device.number);
    }
    if (numbers.size() == 1) return numbers.front();
    if (numbers.empty()) {
        if (const auto error = culprit(state, name)) return failed(*error);
        return noDevice(state, name);
    }
    Failure failure = failed({.code = Errc::SeveralDevices, .subject = name}).value();
    failure.text = {
        Words::tr("There are several devices “%1”.").arg(printable(name)),
        Words::tr("Name one by its own name, its UID or its port; there are: %1.").arg(namesOf(state)),
        {}};
    return tl::unexpected(std::move(failure));
}

QString troubleOf(const PortState& port) {
    const auto failure = failureOf(port);
    return failure ? failure->text.line() : QString();
}

tl::unexpected<Failure> notStopped(const SessionRunner& runner) {
    const smartdevice::Snapshot& state = boardsOf(runner);
    if (isPortMissing(runner)) return failed({.code = Errc::NoDevice, .port = runner.uri().target});
    const auto lost = std::ranges::find(state.devices, Presence::Lost, &DeviceState::presence);
    if (lost != state.devices.end()) return failed({.code = Errc::Disconnected, .subject = lost->spec->name});
    if (state.devices.empty()) {
        for (const PortState& port : state.ports) {
            if (auto failure = failureOf(port)) return tl::unexpected(*std::move(failure));
        }
    }
    if (!state.ports.empty()) return failed({.code = Errc::TimedOut, .subject = toString(runner.uri())});
    Failure nobody = failed({.code = Errc::NoDevice}).value();
    nobody.text = {Words::tr("There is no smart device here."), Words::tr("Plug one in."), {}};
    return tl::unexpected(std::move(nobody));
}

QString ownNameOf(const DeviceState& device) {
    // The window's settings, whatever this program is called.
    const QSettings settings(QStringLiteral("kickstand"), QStringLiteral("kickstand"));
    return settings.value(ownNameKey(device.uid)).toString();
}

tl::unexpected<Failure> noParameter(const DeviceState& device, const std::string& name) {
    QStringList known;
    for (const smartdevice::ParameterSpec& spec : device.spec->parameters)
        known << QString::fromStdString(spec.name);
    return badUsage(Words::tr("%1 has no parameter “%2”.")
                        .arg(QString::fromStdString(device.spec->name), printable(name)),
                    Words::tr("It has: %1.").arg(known.join(QStringLiteral(", "))));
}

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

}  // namespace kickstand::ctl
