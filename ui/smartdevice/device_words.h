#pragma once

#include <QString>
#include <optional>

#include "core/smartdevice/snapshot.h"
#include "ui/widgets/state_label.h"

namespace kickstand::ui {

/// How something stands: a shape and a few words.
struct Standing {
    Tone tone = Tone::Idle;
    QString text;

    friend bool operator==(const Standing&, const Standing&) = default;
};

/// How near a board is, with its age where nothing comes any more.
Standing standingOf(const smartdevice::DeviceState& device, TimePoint now);
/// What goes on at a port.
Standing standingOf(const smartdevice::PortState& port);
/// What is to be done about a port at which there is no board; empty where nothing is.
QString remedyOf(const smartdevice::PortState& port);
/// What became of a write that ended with an error before it was judged.
Standing standingOf(const Error& error);
/// What became of the last write of a parameter.
Standing standingOf(const smartdevice::ParameterState& parameter, const smartdevice::ParameterSpec& spec);

/// "1.2 ms", "p99 3.4 ms": the median and what one answer in a hundred exceeds; empty before the first.
QString medianText(const smartdevice::DeviceState& device);
QString p99Text(const smartdevice::DeviceState& device);
/// What was asked for and what the board granted.
QString updatesText(const smartdevice::DeviceState& device);

/// How many places after the point a parameter's values are shown with.
int decimalsOf(const smartdevice::ParameterSpec& spec);
/// "−0.40": with a typographic minus, and none before a zero.
QString numberText(double number, int decimals);
/// A value as it is shown, without its unit.
QString valueText(const smartdevice::wire::Value& value, const smartdevice::ParameterSpec& spec);
/// "duty_cycle, A".
QString withUnit(const QString& text, const smartdevice::ParameterSpec& spec);
/// "40 s ago".
QString agoText(Duration age);
/// Whether a value is too old to be taken for the present one.
bool isOld(const smartdevice::ParameterState& parameter, const smartdevice::DeviceState& device,
           TimePoint now);

}  // namespace kickstand::ui
