#include "core/thunderbots/events.h"

namespace kickstand::thunderbots {

std::string_view name(EventKind kind) {
    switch (kind) {
        case EventKind::Connected:
            return "connected";
        case EventKind::Disconnected:
            return "disconnected";
        case EventKind::LinkLost:
            return "link-lost";
        case EventKind::LinkFailed:
            return "link-failed";
        case EventKind::Waiting:
            return "waiting";
        case EventKind::EmergencyStop:
            return "emergency-stop";
        case EventKind::Radios:
            return "radios";
        case EventKind::RobotFound:
            return "robot-found";
        case EventKind::RobotLost:
            return "robot-lost";
        case EventKind::BatteryLow:
            return "battery-low";
        case EventKind::Charged:
            return "charged";
        case EventKind::KickGiven:
            return "kick-given";
        case EventKind::KickDropped:
            return "kick-dropped";
        case EventKind::KickMeasured:
            return "kick-measured";
        case EventKind::Autokick:
            return "autokick";
        case EventKind::AutokickArmed:
            return "autokick-armed";
        case EventKind::Charger:
            return "charger";
        case EventKind::HighVoltage:
            return "high-voltage";
        case EventKind::TestMode:
            return "test-mode";
        case EventKind::DischargeStarted:
            return "discharge-started";
        case EventKind::DischargeEnded:
            return "discharge-ended";
        case EventKind::SweepStarted:
            return "sweep-started";
        case EventKind::SweepEnded:
            return "sweep-ended";
        case EventKind::CheckStarted:
            return "check-started";
        case EventKind::RobotChecked:
            return "robot-checked";
        case EventKind::CheckEnded:
            return "check-ended";
        case EventKind::ExperimentData:
            return "experiment-data";
        case EventKind::ParametersRead:
            return "parameters-read";
        case EventKind::ParametersApplied:
            return "parameters-applied";
        case EventKind::ParametersCommitted:
            return "parameters-committed";
        case EventKind::ParametersProven:
            return "parameters-proven";
        case EventKind::SignaturesRead:
            return "signatures-read";
        case EventKind::RobotRebooting:
            return "robot-rebooting";
        case EventKind::FlashStarted:
            return "flash-started";
        case EventKind::FlashPaused:
            return "flash-paused";
        case EventKind::FlashResumed:
            return "flash-resumed";
        case EventKind::FlashEnded:
            return "flash-ended";
        case EventKind::DongleFault:
            return "dongle-fault";
        case EventKind::DongleText:
            return "dongle-text";
        case EventKind::Malformed:
            return "malformed";
        case EventKind::Stalled:
            return "stalled";
        case EventKind::WheelLimit:
            return "wheel-limit";
        case EventKind::Channels:
            return "channels";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots
