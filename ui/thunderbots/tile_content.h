#pragma once

#include <QString>
#include <vector>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// All that a robot's tile shows, as text and levels: a tile repaints when this differs, and not otherwise.
struct TileContent {
    enum class Weight { Plain, Warning, Danger, Accent };
    struct Chip {
        QString text;
        Weight weight = Weight::Plain;
        friend bool operator==(const Chip&, const Chip&) = default;
    };

    int robot = 0;
    bool live = false;   ///< The dongle hears it.
    bool known = false;  ///< There are readings of it, of now or of earlier.
    bool stale = false;  ///< Those are of earlier.
    bool chosen = false;
    QString battery;
    Weight batteryWeight = Weight::Plain;
    double batteryLevel = -1;  ///< 0-1; below 0: nothing to show.
    QString capacitor;
    bool capacitorLive = false;  ///< Dangerous, or to be taken for it.
    double capacitorLevel = -1;
    QString motion;  ///< Braked, holding, moving: what it was told.
    bool moving = false;
    std::vector<Chip> chips;
    QString state;       ///< What else it was told, or why there is nothing newer.
    QString accessible;  ///< The same in one sentence.

    friend bool operator==(const TileContent&, const TileContent&) = default;
};

/// Where the marks of the two bars lie.
extern const double kBatteryEmptyMark;
extern const double kBatteryLowMark;
extern const double kCapacitorLiveMark;
extern const double kCapacitorChargedMark;

TileContent tileContent(int robot, const thunderbots::RobotState& state, bool chosen, TimePoint now);
/// The readings with the raw numbers behind them.
QString readingsTip(int robot, const thunderbots::RobotState& state);

}  // namespace kickstand::ui
