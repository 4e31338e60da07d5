#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace kickstand::smartdevice {

/// What can happen. The comment says what Event's numbers and text mean for it.
enum class EventKind : std::uint8_t {
    PortFound,    ///< text: the port.
    PortGone,     ///< text: the port.
    PortFailed,   ///< text: the port; code: the Errc why it could not be opened.
    PortSilent,   ///< text: the port, at which nothing answered.
    DeviceFound,  ///< text: its kind and port.
    DeviceBack,   ///< As DeviceFound, of one that was there before.
    DeviceQuiet,  ///< Nothing came from it for a second.
    DeviceLost,
    DeviceReset,  ///< It began anew by itself; its subscription was asked for again.
    Subscribed,   ///< code: the delay granted, ms; previous: the one asked for.
    Ungranted,    ///< It grants no updates; code: how often it was asked.
    Update,  ///< Data came. code: its parameters' mask; text: their bytes; previous: how many came before.
    WriteRefused,  ///< text: the parameter.
    WriteChanged,  ///< text: the parameter; value: what it has instead.
    Disabled,
    DeviceError,   ///< code: what it said (protocol 3.9).
    Misfit,        ///< Its data do not fit its kind: code bytes came, previous were expected.
    Stopped,       ///< Zero was written and the device disabled.
    CatalogueBad,  ///< text: what is wrong with the user's file.
};
/// "port-found", "device-lost", …: stable, for JSON. Any thread.
std::string_view name(EventKind kind) noexcept;

/// One thing that happened.
struct Event {
    EventKind kind = EventKind::PortFound;
    TimePoint time{};
    int robot = -1;      ///< The device it concerns, or -1.
    std::string device;  ///< Its name; empty where it concerns none.
    std::int64_t code = 0;
    std::int64_t previous = 0;
    double value = 0;
    std::string text;

    friend bool operator==(const Event&, const Event&) = default;
};

}  // namespace kickstand::smartdevice
