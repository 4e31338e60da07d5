#pragma once

#include <functional>

#include "core/coach/events.h"
#include "core/coach/types.h"

namespace kickstand::coach {

/// What a side of the protocol does to the world: sends packets and tells what happens. Called on the
/// scheduler's thread.
struct SideOutput {
    std::function<void(std::uint16_t destination, const wire::Message& message)> send;
    std::function<void(EventKind kind, int team, std::int64_t code, std::int64_t previous)> event;
};

/// A message that came by radio.
struct Received {
    std::uint16_t source = 0;
    int rssi_dBm = 0;
    wire::Message message;
};

}  // namespace kickstand::coach
