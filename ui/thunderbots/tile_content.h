#pragma once

#include <QString>
#include <vector>

#include "core/thunderbots/snapshot.h"
#include "ui/thunderbots/tile_marks.h"

namespace kickstand::ui {

/// All that a robot's tile shows, as text and levels: a tile repaints when this differs, and not otherwise.
struct TileContent {
    enum class Weight { Plain, Warning, Danger, Accent };
    /// A shape that says the same as a chip's word, for where there is no room for it.
    enum class Sign { None, Ball, Dribbler };
    struct Chip {
        QString text;
        Weight weight = Weight::Plain;
        Sign sign = Sign::None;
        friend bool operator==(const Chip&, const Chip&) = default;
    };

    int robot = 0;
    bool live = false;   ///< The dongle hears it.
    bool known = false;  ///< There are readings of it, of now or of earlier.
    bool stale = false;  ///< Those are of earlier.
    bool chosen = false;
    QString battery;
    QString batteryWord;         ///< "low", "empty" or "lowest", where it is.
    bool lowestBattery = false;  ///< Of all robots.
    Weight batteryWeight = Weight::Plain;
    double batteryLevel = -1;  ///< 0-1; below 0: nothing to show.
    QString capacitor;
    bool capacitorLive = false;  ///< Dangerous, or to be taken for it.
    double capacitorLevel = -1;
    QString motion;  ///< Braked, holding, moving: what it was told.
    bool moving = false;
    std::vector<Chip> chips;  ///< The most important first.
    QString oddBy;            ///< What sets it apart from all the others; empty where nothing does.
    QString state;            ///< How it is heard and how old the readings are.
    QString stateShort;       ///< The same for where there is less room; empty where there is no shorter way.
    QString accessible;       ///< The same in one sentence.

    friend bool operator==(const TileContent&, const TileContent&) = default;
};

/// Where the marks of the two bars lie.
extern const double kBatteryEmptyMark;
extern const double kBatteryLowMark;
extern const double kCapacitorLiveMark;
extern const double kCapacitorChargedMark;

TileContent tileContent(int robot, const thunderbots::RobotState& state, bool chosen, TimePoint now,
                        const TileMarks& marks = {});
/// How the robot is heard, and the readings with their age and the raw numbers behind them.
QString readingsTip(int robot, const thunderbots::RobotState& state, TimePoint now,
                    const TileMarks& marks = {});

}  // namespace kickstand::ui
