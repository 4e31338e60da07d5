#include "core/base/error.h"

#include <array>
#include <cstddef>

namespace kickstand {
namespace {

struct Named {
    Errc code;
    const char* name;
};

constexpr std::array kNames = std::to_array<Named>({
    {Errc::BadArgument, "bad-argument"},
    {Errc::OutOfRange, "out-of-range"},
    {Errc::UnknownName, "unknown-name"},
    {Errc::BadUri, "bad-uri"},
    {Errc::Unsupported, "unsupported"},
    {Errc::NoEncoding, "no-encoding"},
    {Errc::Malformed, "malformed"},
    {Errc::NoDevice, "no-device"},
    {Errc::SeveralDevices, "several-devices"},
    {Errc::PermissionDenied, "permission-denied"},
    {Errc::ClaimedElsewhere, "claimed-elsewhere"},
    {Errc::Disconnected, "disconnected"},
    {Errc::Stalled, "stalled"},
    {Errc::TimedOut, "timed-out"},
    {Errc::Cancelled, "cancelled"},
    {Errc::Io, "io"},
    {Errc::RadioFailed, "radio-failed"},
    {Errc::ChannelsLocked, "channels-locked"},
    {Errc::NotConnected, "not-connected"},
    {Errc::StopLatched, "stop-latched"},
    {Errc::NotArmed, "not-armed"},
    {Errc::RobotNotAlive, "robot-not-alive"},
    {Errc::EmergencyStopNotRun, "emergency-stop-not-run"},
    {Errc::KickOutstanding, "kick-outstanding"},
    {Errc::KickExpired, "kick-expired"},
    {Errc::MustPassZero, "must-pass-zero"},
    {Errc::NotDischarging, "not-discharging"},
    {Errc::ReadingsUnknown, "readings-unknown"},
    {Errc::SweepRunning, "sweep-running"},
    {Errc::CheckRunning, "check-running"},
    {Errc::NotCharging, "not-charging"},
    {Errc::QueueFull, "queue-full"},
    {Errc::HeartbeatStale, "heartbeat-stale"},
    {Errc::RequestPending, "request-pending"},
    {Errc::Unanswered, "unanswered"},
    {Errc::NotBraked, "not-braked"},
    {Errc::CapacitorLive, "capacitor-live"},
    {Errc::BatteryLow, "battery-low"},
    {Errc::NotCommitted, "not-committed"},
    {Errc::RebootNeeded, "reboot-needed"},
    {Errc::ParametersUnread, "parameters-unread"},
    {Errc::FlashRunning, "flash-running"},
    {Errc::FlashNotRunning, "flash-not-running"},
    {Errc::AlreadyThere, "already-there"},
    {Errc::NotVerified, "not-verified"},
    {Errc::WrongSignature, "wrong-signature"},
    {Errc::NoMovementCode, "no-movement-code"},
    {Errc::PlanRefused, "plan-refused"},
    {Errc::WouldBeRefused, "would-be-refused"},
    {Errc::PlanExecuting, "plan-executing"},
    {Errc::EchoDiffers, "echo-differs"},
    {Errc::Unconfirmed, "unconfirmed"},
    {Errc::NxtRefused, "nxt-refused"},
    {Errc::NotPaired, "not-paired"},
    {Errc::PairedElsewhere, "paired-elsewhere"},
    {Errc::RoleRunning, "role-running"},
    {Errc::RadioNotReady, "radio-not-ready"},
    {Errc::RadioNotSet, "radio-not-set"},
    {Errc::RadioDiffers, "radio-differs"},
    {Errc::DeviceRefused, "device-refused"},
});

/// Each has its name, at its own place.
constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kNames.size(); ++i) {
        if (static_cast<std::size_t>(kNames[i].code) != i) return false;
    }
    return kNames.back().code == Errc::DeviceRefused;
}
static_assert(isInOrder());

}  // namespace

const char* name(Errc code) {
    const auto at = static_cast<std::size_t>(code);
    return at < kNames.size() ? kNames[at].name : "unknown";
}

}  // namespace kickstand
