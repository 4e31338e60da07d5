#include "app/kickstandctl/cmd_smartdevice_subscribe.h"

#include <QJsonArray>
#include <algorithm>
#include <array>
#include <vector>

#include "app/kickstandctl/device_access.h"
#include "app/kickstandctl/device_report.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_smartdevice.h"

namespace kickstand::ctl {
namespace {

using smartdevice::DeviceState;
using smartdevice::EventKind;
using smartdevice::wire::ParameterMask;

constexpr Duration kEndless = std::chrono::hours(24 * 365);
constexpr int kUsualDelay_ms = 40;
/// Why no updates come, and that they will.
constexpr std::array kToldOfDevice{EventKind::DeviceQuiet, EventKind::DeviceLost, EventKind::DeviceBack,
                                   EventKind::DeviceReset, EventKind::Ungranted};

QString textOf(const std::string& held) {
    return QString::fromStdString(held);
}

/// Tells each Data message of one device, how many are missing where some are, and why none come.
class Updates {
  public:
    Updates(const Context& context, SessionRunner& runner, int number, ParameterMask mask)
        : context_(context), runner_(runner), number_(number), mask_(mask) {
        runner.setObserver([this](const EngineEvent& event) { take(event); });
    }
    ~Updates() { runner_.setObserver({}); }
    Updates(const Updates&) = delete;
    Updates& operator=(const Updates&) = delete;

    void tellGrant(int asked_ms) {
        const DeviceState& device = deviceOf(runner_, number_);
        QJsonArray parameters;
        QStringList names;
        for (std::size_t i = 0; i < device.spec->parameters.size(); ++i) {
            if ((device.subscribed >> i & 1) == 0) continue;
            names << textOf(device.spec->parameters[i].name);
            parameters.append(names.back());
        }
        QJsonObject json = about(QStringLiteral("subscribed"), runner_.engine().now());
        json[QStringLiteral("delay_ms")] = device.delay_ms;
        json[QStringLiteral("asked_delay_ms")] = asked_ms;
        json[QStringLiteral("parameters")] = parameters;
        context_.output.value(json);
        context_.output.line(Words::tr("%1 grants updates every %2 ms (asked: %3 ms) of %4.")
                                 .arg(textOf(device.spec->name))
                                 .arg(device.delay_ms)
                                 .arg(asked_ms)
                                 .arg(names.join(QStringLiteral(", "))));
    }

    void tell() {
        for (const smartdevice::Event& event : std::exchange(waiting_, {})) {
            if (event.kind != EventKind::Update) {
                tellOfDevice(event);
                continue;
            }
            const std::int64_t missing = next_ < 0 ? 0 : event.previous - next_;
            next_ = event.previous + 1;
            if (missing > 0) tellLost(missing, event.time);
            tellUpdate(event);
        }
    }

  private:
    void take(const EngineEvent& event) {
        const auto* system = std::get_if<SystemEvent>(&event.body);
        const auto* own = system == nullptr ? nullptr : std::get_if<smartdevice::Event>(system);
        if (own == nullptr || own->robot != number_) return;
        if (own->kind == EventKind::Update ||
            std::ranges::find(kToldOfDevice, own->kind) != kToldOfDevice.end())
            waiting_.push_back(*own);
    }

    QJsonObject about(const QString& type, TimePoint time) const {
        const DeviceState& device = deviceOf(runner_, number_);
        return {{QStringLiteral("type"), type},
                {QStringLiteral("time"), isoTime(runner_.engine(), time)},
                {QStringLiteral("device"), textOf(device.spec->name)},
                {QStringLiteral("uid"), textOf(smartdevice::wire::toText(device.uid))}};
    }

    void tellOfDevice(const smartdevice::Event& event) {
        const QString text = describeSmartDeviceEvent(event).text;
        const std::string_view kind = smartdevice::name(event.kind);
        QJsonObject json =
            about(QString::fromLatin1(kind.data(), static_cast<qsizetype>(kind.size())), event.time);
        json[QStringLiteral("text")] = text;
        context_.output.value(json);
        context_.output.line(QStringLiteral("%1  %2").arg(clockText(runner_.engine(), event.time), text));
    }

    void tellLost(std::int64_t count, TimePoint time) {
        QJsonObject json = about(QStringLiteral("lost"), time);
        json[QStringLiteral("count")] = static_cast<qint64>(count);
        context_.output.value(json);
        context_.output.line(Words::tr("%1 updates came too fast to be printed").arg(count));
    }

    void tellUpdate(const smartdevice::Event& event) {
        const auto& specs = deviceOf(runner_, number_).spec->parameters;
        QJsonObject values;
        QStringList texts;
        ByteView left(reinterpret_cast<const std::uint8_t*>(event.text.data()), event.text.size());
        for (std::size_t i = 0; i < specs.size(); ++i) {
            if ((event.code >> i & 1) == 0 || left.size() < specs[i].width()) continue;
            const auto value = smartdevice::wire::readValue(specs[i].type, left.first(specs[i].width()));
            left = left.subspan(specs[i].width());
            if ((mask_ >> i & 1) == 0) continue;
            values[textOf(specs[i].name)] = toJson(value);
            texts << QStringLiteral("%1 %2").arg(textOf(specs[i].name), valueText(specs[i], value));
        }
        // Of those that were on their way before, some have nothing in them that was asked for.
        if (values.isEmpty() && event.code != 0) return;
        QJsonObject json = about(QStringLiteral("update"), event.time);
        json[QStringLiteral("values")] = values;
        context_.output.value(json);
        context_.output.line(QStringLiteral("%1  %2").arg(clockText(runner_.engine(), event.time),
                                                          texts.join(QStringLiteral("  "))));
    }

    const Context& context_;
    SessionRunner& runner_;
    const int number_;
    const ParameterMask mask_;
    std::vector<smartdevice::Event> waiting_;
    std::int64_t next_ = -1;
};

}  // namespace

Outcome subscribeBoard(const Context& context, SessionRunner& runner) {
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
    if (auto connected = connectBoards(context, runner); !connected) return connected;
    const auto number = awaitDevice(runner, context.invocation.operands[0]);
    if (!number) return tl::unexpected(number.error());
    const auto mask = parametersOf(context, deviceOf(runner, *number), 1);
    if (!mask) return tl::unexpected(mask.error());
    Updates updates(context, runner, *number, *mask);
    const SystemCommand command = smartdevice::Command(
        smartdevice::Subscribe{*number, *mask, static_cast<std::uint16_t>(delay_ms), true});
    if (auto done = runner.perform(command); !done) return done;
    runner.watchOnly();
    updates.tellGrant(delay_ms);
    const auto watched = runner.waitUntil(
        [&updates] {
            updates.tell();
            return false;
        },
        span);
    // Ctrl+C is how one that has no end is ended.
    if (!watched && !(span == kEndless && context.interruption.isRequest()))
        return tl::unexpected(watched.error());
    return {};
}

}  // namespace kickstand::ctl
