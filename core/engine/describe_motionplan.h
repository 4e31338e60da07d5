#pragma once

#include <QString>

#include "core/engine/describe.h"
#include "core/motionplan/events.h"
#include "core/motionplan/snapshot.h"

namespace kickstand {

// The words for motion plans. Any thread once the application object exists.

/// How the serial line stands, in a word or two.
QString describe(motionplan::LinkState state);
/// Whether and what the robot executes, in a word or two.
QString describe(motionplan::Execution::State state);
/// What STOP cannot do: for a robot whose Bluetooth is gone.
QString outOfReachText();
/// "forward 25", "turn left 84°": a movement for a person.
QString movementText(const motionplan::wire::Movement& movement);
/// "both wheels forward", …: which wheels.
QString wheelsText(motionplan::wire::Wheels wheels);

/// The words for an event, and how much it matters.
EventText describeMotionplanEvent(const motionplan::Event& event);

}  // namespace kickstand
