#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace kickstand::thunderbots {

/// What can happen. The comment says what Event's numbers mean for it.
enum class EventKind : std::uint8_t {
    Connected,      ///< The link runs; braked blocks have been sent to all robots.
    Disconnected,   ///< Closed on purpose.
    LinkLost,       ///< Unplugged or gone. text: why, where the link knows.
    LinkFailed,     ///< text: the error's detail; code: its Errc.
    Waiting,        ///< No device yet; the session waits for one.
    EmergencyStop,  ///< code: the new state, previous: the old one.
    Radios,         ///< code: the new state, previous: the old one.
    RobotFound,
    RobotLost,     ///< value: volts on its capacitor when last known, 0 if below the live mark.
    BatteryLow,    ///< value: volts; code 1 low, 2 at its end.
    Charged,       ///< value: volts.
    KickGiven,     ///< To the dongle. code: width 1 µs, previous: width 2 µs, value: offset µs.
    KickDropped,   ///< code: the Errc why.
    KickMeasured,  ///< code: recharge ms, -1 if not measured; previous: mV before; value: lowest volts after.
    Autokick,      ///< code: how many so far.
    AutokickArmed,        ///< code 1 armed, 0 disarmed.
    Charger,              ///< code 1 on, 0 off.
    HighVoltage,          ///< code 1 armed, 0 disarmed.
    TestMode,             ///< code: class, previous: target.
    DischargeStarted,     ///< value: volts.
    DischargeEnded,       ///< value: volts; code: 0 done, otherwise the Errc why it ended early.
    SweepStarted,         ///< code: how many kicks it will give.
    SweepEnded,           ///< code: 0 done, otherwise the Errc why it ended early; previous: kicks given.
    CheckStarted,         ///< code: how many robots it is for.
    RobotChecked,         ///< code: its CheckVerdict; previous: how many steps did not pass.
    CheckEnded,           ///< code: 0 through, otherwise the Errc why it ended early.
    ExperimentData,       ///< code: bytes known so far.
    ParametersRead,       ///< text: the block, in hex.
    ParametersApplied,    ///< To the volatile copy.
    ParametersCommitted,  ///< Unproven until a reboot.
    ParametersProven,     ///< Read after a reboot. code 1: what was committed, 0: something else.
    SignaturesRead,       ///< code: of the microcontroller, previous: of the flash.
    RobotRebooting,       ///< It will vanish for some seconds.
    FlashStarted,         ///< code: pages to be sent, previous: images.
    FlashPaused,          ///< By STOP.
    FlashResumed,
    FlashEnded,   ///< code: 0 done, otherwise the Errc why; previous: its FlashLeft; value: seconds.
    DongleFault,  ///< code: the error-queue code.
    DongleText,   ///< text: what the dongle printed.
    Malformed,    ///< code: endpoint, value: how many since the last such event; text: what was wrong.
    Stalled,      ///< code: endpoint, value: how often in a row.
    WheelLimit,   ///< code: the new limit, previous: the old one.
    Channels,     ///< code: radio 0, previous: radio 1.
};

/// One thing that happened, with its facts. Text for people is made in core/engine/describe.h.
struct Event {
    EventKind kind = EventKind::Connected;
    TimePoint time{};
    int robot = -1;  ///< 0-15, or -1 where it concerns none.
    std::int64_t code = 0;
    std::int64_t previous = 0;
    double value = 0;
    std::string text;
};

/// "kick-given", …: stable names for JSON. Any thread.
std::string_view name(EventKind kind);

}  // namespace kickstand::thunderbots
