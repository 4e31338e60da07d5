#include "core/thunderbots/types.h"

namespace kickstand::thunderbots {

std::string_view name(LinkState state) {
    switch (state) {
        case LinkState::Idle:
            return "idle";
        case LinkState::Searching:
            return "searching";
        case LinkState::Opening:
            return "opening";
        case LinkState::Starting:
            return "starting";
        case LinkState::Braking:
            return "braking";
        case LinkState::Running:
            return "running";
        case LinkState::Failed:
            return "failed";
    }
    return "unknown";
}

std::string_view name(Signal signal) {
    switch (signal) {
        case Signal::Battery_V:
            return "battery_V";
        case Signal::Capacitor_V:
            return "capacitor_V";
        case Signal::Dribbler_C:
            return "dribbler_C";
        case Signal::Light:
            return "light";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots
