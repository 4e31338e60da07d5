#include <QCoreApplication>

#include "ui/smartdevice/card.h"
#include "ui/smartdevice/device_words.h"

namespace kickstand::ui {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DeviceCards)
};

constexpr double kTicksPerTurn = 4400;
/// Where a threshold stands on the current's bar, and the bar's end where none was set.
constexpr double kThresholdPlace = 0.8;
constexpr double kUsualCurrent_A = 10;

using Kind = CardPart::Kind;

CardPart gains(const QString& caption, const CardValues& values, const char* kp, const char* ki,
               const char* kd) {
    const auto text = [&values](const char* name) {
        const auto written = values.written(name);
        return written ? QString::number(*written, 'g', 4) : QStringLiteral("\u2014");
    };
    return {Kind::Words, caption, Words::tr("P %1 I %2 D %3").arg(text(kp), text(ki), text(kd))};
}

CardPart setPoint(const QString& caption, const CardValues& values, const char* name, const QString& unit) {
    const auto written = values.written(name);
    return {Kind::Words, caption, written ? numberText(*written, 0) + u' ' + unit : QStringLiteral("\u2014")};
}

CardPart current(const CardValues& values) {
    const auto now = values.number("motor_current");
    const auto threshold = values.written("current_thresh");
    const bool limited = threshold && *threshold > 0;
    const double end_A = limited ? *threshold / kThresholdPlace : kUsualCurrent_A;
    CardPart part{Kind::Level, Words::tr("current"), values.text("motor_current", 2)};
    if (limited) part.text += Words::tr(" of %1 A").arg(numberText(*threshold, 1));
    if (now) part.value = *now / end_A;
    if (limited) part.high = kThresholdPlace;
    if (limited && now && *now >= *threshold * 0.98) part.tone = Tone::Warning;
    return part;
}

}  // namespace

CardContent motorCard(const CardValues& values) {
    CardPart duty{Kind::Centre, Words::tr("deadband"), values.text("deadband", 2),
                  values.number("duty_cycle")};
    if (const auto deadband = values.number("deadband"); deadband && *deadband > 0) {
        duty.low = -*deadband;
        duty.high = *deadband;
    }
    CardPart angle{Kind::Turn, Words::tr("position"), values.text("enc_pos", 0)};
    QString speed = QStringLiteral("\u2014");
    if (const auto ticks = values.number("enc_pos")) {
        angle.value = *ticks / kTicksPerTurn;
        angle.caption = values.marked(Words::tr("%1 turns").arg(numberText(*angle.value, 2)), "enc_pos");
    }
    if (const auto ticks_per_s = values.number("enc_vel"))
        speed = values.marked(Words::tr("%1 turns/s").arg(numberText(*ticks_per_s / kTicksPerTurn, 2)),
                              "enc_vel");
    return {{{{Kind::Number, Words::tr("duty cycle"), values.text("duty_cycle", 2)}, duty},
             {angle},
             {{Kind::Number, speed, values.text("enc_vel", 0)}, current(values)},
             {setPoint(Words::tr("position to"), values, "pid_pos_setpoint", Words::tr("ticks")),
              gains(Words::tr("position"), values, "pid_pos_kp", "pid_pos_ki", "pid_pos_kd"),
              setPoint(Words::tr("speed to"), values, "pid_vel_setpoint", Words::tr("ticks/s")),
              gains(Words::tr("speed"), values, "pid_vel_kp", "pid_vel_ki", "pid_vel_kd")}},
            2};
}

}  // namespace kickstand::ui
