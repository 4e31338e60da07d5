#include "ui/thunderbots/wheel_unit.h"

#include <QCoreApplication>
#include <cmath>
#include <numbers>

#include "core/thunderbots/types.h"
#include "ui/widgets/tokens.h"

namespace kickstand::ui {

namespace {

struct WheelText {
    Q_DECLARE_TR_FUNCTIONS(WheelText)
};

constexpr double kSecondsOfMinute = 60;

}  // namespace

QStringList wheelUnitTexts() {
    return {WheelText::tr("rpm"), WheelText::tr("turns/s"), WheelText::tr("rad/s")};
}

QString wheelSpeedText(int units, WheelUnit unit) {
    const double turns_rpm = thunderbots::wheel_rpm(units);
    switch (unit) {
        case WheelUnit::Rpm:
            return WheelText::tr("%1 rpm").arg(signedNumber(static_cast<int>(std::lround(turns_rpm))));
        case WheelUnit::TurnsPerSecond:
            return WheelText::tr("%1 turns/s").arg(signedNumber(turns_rpm / kSecondsOfMinute, 1));
        case WheelUnit::RadiansPerSecond:
            return WheelText::tr("%1 rad/s")
                .arg(signedNumber(turns_rpm / kSecondsOfMinute * 2 * std::numbers::pi, 1));
    }
    return {};
}

}  // namespace kickstand::ui
