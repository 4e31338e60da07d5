#include "ui/smartdevice/device_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <bit>
#include <cmath>

#include "core/engine/describe.h"
#include "core/engine/describe_smartdevice.h"

namespace kickstand::ui {

using namespace smartdevice;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(SmartDevices)
};

constexpr Duration kFresh = std::chrono::seconds(1);
constexpr int kUsualDecimals = 3;

QString millisecondsText(Duration duration) {
    return Words::tr("%1 ms").arg(seconds(duration) * 1000, 0, 'f', 1);
}

}  // namespace

QString agoText(Duration age) {
    const double age_s = seconds(age);
    if (age_s < 120) return Words::tr("%1 s ago").arg(age_s, 0, 'f', 0);
    return Words::tr("%1 min ago").arg(age_s / 60, 0, 'f', 0);
}

Standing standingOf(const DeviceState& device, TimePoint now) {
    const QString ago = agoText(now - device.heardAt);
    switch (device.presence) {
        case Presence::Live:
            if (device.learning) return {Tone::Busy, Words::tr("finding out")};
            if (device.disabled && device.spec->writable() != 0) return {Tone::Idle, Words::tr("disabled")};
            if (device.driving) return {Tone::Busy, Words::tr("drives")};
            return {Tone::Good, describe(device.presence)};
        case Presence::Quiet:
            return {Tone::Warning, Words::tr("stale, %1").arg(ago)};
        case Presence::Lost:
            return {Tone::Danger, Words::tr("lost, %1").arg(ago)};
    }
    return {};
}

Standing standingOf(const PortState& port) {
    switch (port.phase) {
        case PortPhase::Failed:
            return {Tone::Danger, port.error && port.error->code == Errc::ClaimedElsewhere ? Words::tr("busy")
                                  : port.error && port.error->code == Errc::PermissionDenied
                                      ? Words::tr("not permitted")
                                      : describe(port.phase)};
        case PortPhase::Silent:
            return {Tone::Warning, Words::tr("silent")};
        case PortPhase::Talking:
            return {Tone::Good, describe(port.phase)};
        default:
            return {Tone::Busy, describe(port.phase)};
    }
}

QString remedyOf(const PortState& port) {
    if (port.phase == PortPhase::Failed) return port.error ? describe(*port.error).line() : QString();
    if (port.phase == PortPhase::Silent)
        return Words::tr(
                   "Nobody answers at %1. Check that it is a board of the kit with its firmware, and "
                   "its cable; then search again.")
            .arg(QString::fromStdString(port.name));
    return {};
}

Standing standingOf(const Error& error) {
    switch (error.code) {
        case Errc::TimedOut:
            return {Tone::Warning, Words::tr("sent, no answer")};
        case Errc::Disconnected:
            return {Tone::Warning, Words::tr("lost before it answered")};
        case Errc::StopLatched:
            return {Tone::Idle, Words::tr("stopped")};
        default:
            return {Tone::Danger, Words::tr("not sent")};
    }
}

Standing standingOf(const ParameterState& parameter, const ParameterSpec& spec) {
    switch (parameter.verdict) {
        case WriteVerdict::None:
            return {};
        case WriteVerdict::Pending:
            return {Tone::Busy, describe(parameter.verdict)};
        case WriteVerdict::Done:
            return {Tone::Good, describe(parameter.verdict)};
        case WriteVerdict::Refused:
            return {Tone::Danger, describe(parameter.verdict)};
        case WriteVerdict::Changed:
            return {Tone::Warning, parameter.written
                                       ? Words::tr("changed from %1").arg(valueText(*parameter.written, spec))
                                       : describe(parameter.verdict)};
        case WriteVerdict::Unconfirmed:
            return {Tone::Idle, describe(parameter.verdict)};
    }
    return {};
}

QString medianText(const DeviceState& device) {
    return device.latency ? millisecondsText(device.latency->median) : QString();
}

QString p99Text(const DeviceState& device) {
    return device.latency ? Words::tr("p99 %1").arg(millisecondsText(device.latency->p99)) : QString();
}

QString updatesText(const DeviceState& device) {
    const int wanted = std::popcount(device.wanted);
    if (device.wantedDelay_ms == 0) return Words::tr("no updates are asked for");
    if (device.presence == Presence::Lost) return Words::tr("asked for again when it is back");
    if (device.ungranted) return Words::tr("asked for many times, not granted");
    if (device.delay_ms == 0) return Words::tr("asked for, not granted yet");
    return Words::tr("granted: %1 of %2 parameters, every %3 ms")
        .arg(std::popcount(device.subscribed))
        .arg(wanted)
        .arg(device.delay_ms);
}

int decimalsOf(const ParameterSpec& spec) {
    if (spec.type == wire::ValueType::Raw || wire::isInteger(spec.type)) return 0;
    if (spec.unit == "ticks" || spec.unit == "ticks/s") return 0;
    if (spec.lowest && spec.highest && *spec.highest - *spec.lowest > 100) return 1;
    return kUsualDecimals;
}

QString numberText(double number, int decimals) {
    QString text = QString::number(number, 'f', decimals);
    if (text.toDouble() == 0) text.remove(u'-');
    return text.replace(u'-', QChar(0x2212));
}

QString valueText(const wire::Value& value, const ParameterSpec& spec) {
    if (const bool* on = std::get_if<bool>(&value)) return *on ? Words::tr("on") : Words::tr("off");
    const bool fraction = std::holds_alternative<float>(value) || std::holds_alternative<double>(value);
    constexpr double kLargest = 1e9;
    if (fraction && std::abs(*wire::toNumber(value)) < kLargest)
        return numberText(*wire::toNumber(value), decimalsOf(spec));
    // Whole numbers as they are: a double cannot hold all of them.
    QString text = QString::fromStdString(wire::toText(value));
    return std::holds_alternative<wire::RawValue>(value) ? text : text.replace(u'-', QChar(0x2212));
}

QString withUnit(const QString& text, const ParameterSpec& spec) {
    return spec.unit.empty() ? text : text + QChar(0x00A0) + QString::fromStdString(spec.unit);
}

bool isOld(const ParameterState& parameter, const DeviceState& device, TimePoint now) {
    if (device.presence != Presence::Live) return true;
    return now - parameter.at > std::max<Duration>(kFresh, 4 * std::chrono::milliseconds(device.delay_ms));
}

}  // namespace kickstand::ui
