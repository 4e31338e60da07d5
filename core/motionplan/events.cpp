#include "core/motionplan/events.h"

#include <array>

namespace kickstand::motionplan {

std::string_view name(EventKind kind) {
    constexpr std::array<std::string_view, 24> kNames{
        "connected", "disconnected", "link-lost",    "link-failed",      "waiting",
        "slot-read", "plan-created", "plan-updated", "trigger-set",      "trigger-read",
        "executing", "step",         "ended",        "stopped",          "adjusted",
        "refused",   "differs",      "unconfirmed",  "stop-unconfirmed", "silent",
        "answers",   "nxt-status",   "stale",        "malformed"};
    static_assert(kNames.size() == static_cast<std::size_t>(EventKind::Malformed) + 1);
    const auto index = static_cast<std::size_t>(kind);
    return index < kNames.size() ? kNames[index] : "unknown";
}

}  // namespace kickstand::motionplan
