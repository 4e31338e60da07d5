#pragma once

#include <QJsonObject>
#include <QtGlobal>
#include <array>

#include "app/kickstandctl/command.h"
#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::ctl {

/// The options by which a kick is described. Widths and offset are what encodePulses() takes.
inline constexpr std::array kKickOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true},
    OptionSpec{
        "--width1", "US",
        QT_TRANSLATE_NOOP("kickstandctl", "how long solenoid 1 (the kicker) is on, in µs; at most 4064"),
        true},
    OptionSpec{"--width2", "US",
               QT_TRANSLATE_NOOP("kickstandctl", "the same for solenoid 2 (the chipper); 0 without it")},
    OptionSpec{
        "--offset", "US",
        QT_TRANSLATE_NOOP("kickstandctl", "how much later solenoid 2 begins, in µs; negative: solenoid 1")},
};

/// What was asked for with --width1, --width2 and --offset, as it goes onto the wire. A kick without any
/// pulse, or one that the wire has no room for, is exit 2.
Expected<thunderbots::wire::KickEncoding> readKick(const Invocation& invocation);

/// What will be sent, in µs and in the wire's own numbers.
QJsonObject kickToJson(const thunderbots::wire::KickEncoding& kick);
/// "2400 / 1024 µs, solenoid 2 later by 320 µs; asked for 2390 / …".
QString kickText(const thunderbots::wire::KickEncoding& kick);

}  // namespace kickstand::ctl
