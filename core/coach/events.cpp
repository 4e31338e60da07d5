#include "core/coach/events.h"

namespace kickstand::coach {

std::string_view name(EventKind kind) {
    switch (kind) {
        case EventKind::Connected:
            return "connected";
        case EventKind::NoModule:
            return "no-module";
        case EventKind::Disconnected:
            return "disconnected";
        case EventKind::LinkLost:
            return "link-lost";
        case EventKind::LinkFailed:
            return "link-failed";
        case EventKind::Waiting:
            return "waiting";
        case EventKind::CoachStarted:
            return "coach-started";
        case EventKind::TowrpStarted:
            return "towrp-started";
        case EventKind::RoleEnded:
            return "role-ended";
        case EventKind::BoatFound:
            return "boat-found";
        case EventKind::PairingFailed:
            return "pairing-failed";
        case EventKind::Paired:
            return "paired";
        case EventKind::Unpaired:
            return "unpaired";
        case EventKind::MutinyStarted:
            return "mutiny-started";
        case EventKind::MutinyQuelled:
            return "mutiny-quelled";
        case EventKind::MutinyLost:
            return "mutiny-lost";
        case EventKind::SuppressSent:
            return "suppress-sent";
        case EventKind::Jettisoned:
            return "jettisoned";
        case EventKind::FreeDigital:
            return "free-digital";
        case EventKind::FreeAnalog:
            return "free-analog";
        case EventKind::MoraleSet:
            return "morale-set";
        case EventKind::BoatStopped:
            return "boat-stopped";
        case EventKind::Stopped:
            return "stopped";
        case EventKind::RadioFound:
            return "radio-found";
        case EventKind::RadioNotFound:
            return "radio-not-found";
        case EventKind::RadioApplied:
            return "radio-applied";
        case EventKind::RadioFailed:
            return "radio-failed";
        case EventKind::ModuleReset:
            return "module-reset";
    }
    return "unknown";
}

std::string_view name(Unpairing why) {
    switch (why) {
        case Unpairing::Silence:
            return "silence";
        case Unpairing::Jettison:
            return "jettison";
        case Unpairing::Mutiny:
            return "mutiny";
        case Unpairing::RoleEnded:
            return "role-ended";
        case Unpairing::LinkLost:
            return "link-lost";
    }
    return "unknown";
}

}  // namespace kickstand::coach
