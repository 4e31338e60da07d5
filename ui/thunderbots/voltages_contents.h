#pragma once

#include <vector>

#include "core/thunderbots/snapshot.h"
#include "ui/plot/plot_contents.h"

namespace kickstand::ui {

/// A choice of signals: bit n is the signal of that number.
using SignalMask = unsigned;
constexpr SignalMask bitOf(thunderbots::Signal signal) {
    return 1U << static_cast<unsigned>(signal);
}

/// "Battery".
QString signalName(thunderbots::Signal signal);
/// "V".
QString signalUnit(thunderbots::Signal signal);

/// What the plot shows of some robots and signals: an area for each signal, a curve for each robot in it. A
/// robot has one colour in all areas.
struct VoltagesContents {
    std::vector<PlotArea> areas;
    std::vector<PlotCurve> curves;
};
VoltagesContents voltagesContents(thunderbots::RobotMask robots, SignalMask wanted);

/// A mark in words, where it concerns one of these robots or all.
std::optional<MarkWords> markWords(const Mark& mark, thunderbots::RobotMask robots);

/// Several marks of a kind, at least two, in words.
QString marksText(const MarkCount& marks);

/// A robot's reading as it stands now: what the table shows beside its curve.
struct NowText {
    QString text;
    bool stale = false;   ///< Of before it was lost.
    bool danger = false;  ///< A capacitor that is live, or to be taken for it.

    friend bool operator==(const NowText&, const NowText&) = default;
};
NowText nowText(const thunderbots::RobotState& robot, thunderbots::Signal signal);
/// A value of a signal with the digits that it has.
QString valueText(double value, thunderbots::Signal signal);

}  // namespace kickstand::ui
