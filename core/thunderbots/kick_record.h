#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/time.h"
#include "core/thunderbots/types.h"
#include "core/thunderbots/wire/kick.h"

namespace kickstand::thunderbots {

/// What made a robot kick.
enum class KickCause : std::uint8_t { Asked, Sweep, Autokick };

/// How far the measurement of what a kick did to the capacitor has come, or how it ended.
enum class KickMeasure : std::uint8_t {
    Waiting,       ///< The voltage has not fallen yet.
    Recharging,    ///< It has fallen; `after_V` is the lowest so far.
    Recharged,     ///< Complete.
    NoDrop,        ///< It did not fall: `after_V` is `before_V`.
    NotRecharged,  ///< It fell and did not come back in time.
    Overtaken,     ///< Another kick of the robot came too soon: what was not known by then is nobody's.
    Lost,          ///< The readings stopped, or nobody knew the voltage to begin with: not measured.
};

/// One kick with the settings that made it and what it did to the capacitor, as far as readings tell
/// (protocol 4.4, 6.3). What could not be measured is empty, never guessed.
struct KickRecord {
    std::uint64_t number = 0;  ///< Counts up from 1 through a session; never given twice.
    int robot = 0;             ///< 0-15.
    KickCause cause = KickCause::Asked;
    KickMeasure measure = KickMeasure::Waiting;
    TimePoint time{};                      ///< When the dongle took it, or reported an autokick.
    std::optional<wire::KickTimes> times;  ///< Empty for an autokick that this session has not armed.
    std::optional<double> before_V;
    std::optional<double> after_V;     ///< The lowest reading that came of it.
    std::optional<Duration> recharge;  ///< From the kick until charged again, or at 98 % of before.

    /// How far the voltage fell; empty where that is not known.
    std::optional<double> drop_V() const {
        if (!before_V || !after_V) return std::nullopt;
        return *before_V - *after_V;
    }

    friend bool operator==(const KickRecord&, const KickRecord&) = default;
};

/// Kicks, oldest first.
using KickRecords = std::vector<KickRecord>;

/// How a capacitor's charging goes, measured from switching the charger on.
struct ChargeRecord {
    std::optional<TimePoint> since;     ///< Charging since then, nothing in between.
    std::optional<Duration> toCharged;  ///< How long the last one took from there to "charged".

    friend bool operator==(const ChargeRecord&, const ChargeRecord&) = default;
};

}  // namespace kickstand::thunderbots
