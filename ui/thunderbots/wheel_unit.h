#pragma once

#include <QString>
#include <QStringList>

namespace kickstand::ui {

/// What a wheel's speed is told in, beside the wire's own units.
enum class WheelUnit { Rpm, TurnsPerSecond, RadiansPerSecond };

/// The choice of it, among the units that a person may choose.
inline constexpr QLatin1String kWheelSpeed("wheelSpeed");

/// "rpm", …, in the order of WheelUnit.
QStringList wheelUnitTexts();

/// A speed in the wire's units (-1023 to 1023) in words: "350 rpm".
QString wheelSpeedText(int units, WheelUnit unit);

}  // namespace kickstand::ui
