#pragma once

#include <QString>

#include "core/engine/describe.h"

namespace kickstand {

// The words for COACHes, TOWRPs and their radios (coach protocol). Any thread once the application object
// exists.

/// A state in a word or two, as labels and charts show it.
QString describe(coach::LinkState state);
QString describe(coach::CoachState state);
QString describe(coach::TowrpState state);
/// What a timer does when it is over.
QString describe(coach::TimerKind timer);
/// Why a side is not paired any more.
QString describe(coach::Unpairing why);
/// How a module speaks.
QString describe(coach::ModuleMode mode);
/// What the module said of a packet that was sent: its TX status.
QString describeOutcome(const coach::TrafficEntry& sent);
/// A message with its parameter: "velocity 100 % forward, 45 % clockwise".
QString describe(const coach::wire::Message& message);
/// A velocity in words: "stop", "29 % backward".
QString describe(const coach::wire::Velocity& velocity);
/// The address of a radio: "TOWRP 5", "all", "0x1234".
QString describeAddress(std::uint16_t address);
/// The words for an event, and how much it matters.
EventText describeCoachEvent(const coach::Event& event);

}  // namespace kickstand
