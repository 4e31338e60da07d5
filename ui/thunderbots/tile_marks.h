#pragma once

#include <QString>

#include "core/thunderbots/snapshot.h"

namespace kickstand::ui {

/// What is to be said of a robot that its own state does not tell.
struct TileMarks {
    int lowestBattery = -1;  ///< The robot whose battery is lowest; −1: there is none to tell.
    int oddOne = -1;         ///< The one robot that is not as all the others are; −1: there is none.
    QString oddBy;           ///< By what: "charging".
    bool cable = false;      ///< It is heard over a cable, not by radio.

    friend bool operator==(const TileMarks&, const TileMarks&) = default;
};

/// The marks of a fleet. `lowestBefore` is the robot that was marked last: another one takes the mark only
/// when it is lower by what can be seen, so that noise moves nothing. Pure.
TileMarks tileMarks(const thunderbots::Snapshot& snapshot, int lowestBefore);

}  // namespace kickstand::ui
