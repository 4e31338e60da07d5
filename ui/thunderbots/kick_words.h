#pragma once

#include <QString>

#include "core/thunderbots/kick_record.h"
#include "core/thunderbots/snapshot.h"
#include "core/thunderbots/sweep_plan.h"
#include "core/thunderbots/wire/kick_timing.h"

namespace kickstand::ui {

// What the kick panels say.

/// "2400 / 1280 µs, solenoid 2 later by 384 µs".
QString pulsesText(const thunderbots::wire::KickPulses& pulses);
/// "t1 75 · t2 52 · Δt 12 · flags 1 0".
QString wireText(const thunderbots::wire::KickTimes& times);
/// "219 → 148 V (−71 V), charged again in 1.9 s", or why there is no such number.
QString measureText(const thunderbots::KickRecord& record);
/// One word or two for how a measurement stands.
QString measureWord(thunderbots::KickMeasure measure);
/// What made the robot kick.
QString causeText(thunderbots::KickCause cause);
/// "kick 3 of 12 · 960 / 0 µs · charging"; how it ended when it has.
QString sweepText(const thunderbots::SweepProgress& sweep);
/// How charging goes: "charging for 2.0 s", "charged · took 3.1 s from switching on", "charger off, still
/// live".
QString chargeText(const thunderbots::ChargeRecord& charge, const thunderbots::Readings& readings,
                   bool charger, TimePoint now);
/// Seconds with one decimal.
QString secondsText(Duration span);

}  // namespace kickstand::ui
