#pragma once

#include <QWidget>
#include <memory>

#include "core/base/time.h"

namespace kickstand::bench {

// What the plot row of the design asks for: sixteen robots with five signals each at 200 Hz, ten minutes of
// them on screen.
constexpr int kUnits = 16;
constexpr int kSignals = 5;
constexpr std::size_t kSeries = std::size_t{kUnits} * kSignals;
constexpr Duration kTick = std::chrono::milliseconds(5);
constexpr Duration kSpan = std::chrono::minutes(10);
constexpr double kLowest = 0;
constexpr double kHighest = 1100;

/// A live plot that is measured: its five areas stand above each other on one time axis.
class PlotSubject {
  public:
    virtual ~PlotSubject() = default;

    /// The widget that is painted.
    virtual QWidget& canvas() = 0;
    /// One new value of every series.
    virtual void append(TimePoint time, const float* values) = 0;
    /// The present is this: time for a new frame.
    virtual void frame(TimePoint now) = 0;
    virtual void follow() = 0;
    /// Moves by a part of what is seen.
    virtual void pan(double part) = 0;
    virtual void zoom(double factor) = 0;
};

std::unique_ptr<PlotSubject> makeOwnPlot(QWidget* parent);
/// Plain QCustomPlot: a QCPGraph for each series, which holds all of its data.
std::unique_ptr<PlotSubject> makePeerPlot(QWidget* parent);

}  // namespace kickstand::bench
