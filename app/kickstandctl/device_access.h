#pragma once

#include <QString>
#include <string>

#include "app/kickstandctl/command.h"
#include "app/kickstandctl/session_runner.h"

namespace kickstand::ctl {

// How the commands for smart devices get at them.

const smartdevice::Snapshot& boardsOf(const SessionRunner& runner);
const smartdevice::DeviceState& deviceOf(const SessionRunner& runner, int number);

/// Whether it is not known yet who is at some port.
bool arePortsUnderWay(const smartdevice::Snapshot& state);

/// Connects; without a link to every serial port on USB. Fails where the link names a port that is not there.
/// A catalogue of the user that cannot be read is complained about, and left out.
Outcome connectBoards(const Context& context, SessionRunner& runner);
/// Waits until every port has answered, or it is known that it does not.
Outcome settleBoards(SessionRunner& runner);
/// The device that is called so, by a person, its kind, UID or port, once it is there; its number.
Expected<int> awaitDevice(SessionRunner& runner, const std::string& name);
/// What keeps a port from being used, and what to do; empty where nothing does.
QString troubleOf(const smartdevice::PortState& port);
/// Why finish() could not tell every board to stop.
tl::unexpected<Failure> notStopped(const SessionRunner& runner);
/// The name that a person gave the device in the window; empty where nobody did.
QString ownNameOf(const smartdevice::DeviceState& device);

tl::unexpected<Failure> noParameter(const smartdevice::DeviceState& device, const std::string& name);
/// The parameters of the operands from `first` on; all that can be read where there are none.
Expected<smartdevice::wire::ParameterMask> parametersOf(const Context& context,
                                                        const smartdevice::DeviceState& device,
                                                        std::size_t first);

}  // namespace kickstand::ctl
