#include <QCoreApplication>

#include "core/engine/describe.h"

namespace kickstand {
namespace {

struct State {
    Q_DECLARE_TR_FUNCTIONS(State)
};

}  // namespace

QString describe(StopReason reason) {
    switch (reason) {
        case StopReason::None:
            return State::tr("not stopped");
        case StopReason::Person:
            return State::tr("by hand");
        case StopReason::EmergencyStop:
            return State::tr("the emergency stop left “run”");
        case StopReason::RobotLost:
            return State::tr("a robot was lost while it was in use");
        case StopReason::LinkLost:
            return State::tr("the link was lost");
        case StopReason::FocusLost:
            return State::tr("the window lost the keyboard while something moved");
        case StopReason::HeartbeatStale:
            return State::tr("the program did not respond in time");
        case StopReason::PanelClosed:
            return State::tr("the panel that drives was closed");
        case StopReason::Suspend:
            return State::tr("the computer went to sleep");
    }
    return {};
}

QString describe(thunderbots::LinkState state) {
    using thunderbots::LinkState;
    switch (state) {
        case LinkState::Idle:
            return State::tr("not connected");
        case LinkState::Searching:
            return State::tr("waiting for the device");
        case LinkState::Opening:
            return State::tr("opening the device");
        case LinkState::Starting:
            return State::tr("starting the radios");
        case LinkState::Braking:
            return State::tr("braking all robots");
        case LinkState::Running:
            return State::tr("running", "link");
        case LinkState::Failed:
            return State::tr("failed", "link");
    }
    return {};
}

QString describe(thunderbots::wire::EStop state) {
    using thunderbots::wire::EStop;
    switch (state) {
        case EStop::Uninitialized:
            return State::tr("not known yet");
        case EStop::Disconnected:
            return State::tr("not plugged in");
        case EStop::Stop:
            return State::tr("stop");
        case EStop::Run:
            return State::tr("run");
    }
    return {};
}

QString describe(thunderbots::wire::RadioState state) {
    using thunderbots::wire::RadioState;
    switch (state) {
        case RadioState::PreInit:
            return State::tr("not started");
        case RadioState::InitRadio0:
            return State::tr("radio 0 starts");
        case RadioState::InitRadio1:
            return State::tr("radio 1 starts");
        case RadioState::Running:
            return State::tr("running", "radios");
        case RadioState::Radio0Failed:
            return State::tr("radio 0 failed");
        case RadioState::Radio1Failed:
            return State::tr("radio 1 failed");
    }
    return {};
}

}  // namespace kickstand
