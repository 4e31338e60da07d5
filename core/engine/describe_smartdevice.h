#pragma once

#include <QString>

#include "core/engine/describe.h"
#include "core/smartdevice/events.h"
#include "core/smartdevice/snapshot.h"

namespace kickstand {

// The words for smart devices. Any thread once the application object exists.

/// How near a device is, in a word or two.
QString describe(smartdevice::Presence presence);
/// What goes on at a port, in a word or two.
QString describe(smartdevice::PortPhase phase);
/// Why the user's catalogue was left out, and what to do.
Description describeCatalogueError(const Error& error);
/// What became of a write, in a word or two; empty for none.
QString describe(smartdevice::WriteVerdict verdict);

/// Where the settings of the program keep the name that a person gave a board.
QString ownNameKey(const smartdevice::wire::Uid& uid);

/// The words for an event, and how much it matters.
EventText describeSmartDeviceEvent(const smartdevice::Event& event);

}  // namespace kickstand
