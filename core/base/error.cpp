#include "core/base/error.h"

namespace kickstand {

const char* name(Errc code) {
    switch (code) {
        case Errc::BadArgument:
            return "bad-argument";
        case Errc::OutOfRange:
            return "out-of-range";
        case Errc::UnknownName:
            return "unknown-name";
        case Errc::BadUri:
            return "bad-uri";
        case Errc::Unsupported:
            return "unsupported";
        case Errc::NoEncoding:
            return "no-encoding";
        case Errc::Malformed:
            return "malformed";
        case Errc::NoDevice:
            return "no-device";
        case Errc::SeveralDevices:
            return "several-devices";
        case Errc::PermissionDenied:
            return "permission-denied";
        case Errc::ClaimedElsewhere:
            return "claimed-elsewhere";
        case Errc::Disconnected:
            return "disconnected";
        case Errc::Stalled:
            return "stalled";
        case Errc::TimedOut:
            return "timed-out";
        case Errc::Cancelled:
            return "cancelled";
        case Errc::Io:
            return "io";
        case Errc::RadioFailed:
            return "radio-failed";
        case Errc::ChannelsLocked:
            return "channels-locked";
        case Errc::NotConnected:
            return "not-connected";
        case Errc::StopLatched:
            return "stop-latched";
        case Errc::NotArmed:
            return "not-armed";
        case Errc::RobotNotAlive:
            return "robot-not-alive";
        case Errc::EmergencyStopNotRun:
            return "emergency-stop-not-run";
        case Errc::KickOutstanding:
            return "kick-outstanding";
        case Errc::KickExpired:
            return "kick-expired";
        case Errc::MustPassZero:
            return "must-pass-zero";
        case Errc::NotDischarging:
            return "not-discharging";
        case Errc::ReadingsUnknown:
            return "readings-unknown";
        case Errc::SweepRunning:
            return "sweep-running";
        case Errc::NotCharging:
            return "not-charging";
        case Errc::QueueFull:
            return "queue-full";
        case Errc::HeartbeatStale:
            return "heartbeat-stale";
    }
    return "unknown";
}

}  // namespace kickstand
