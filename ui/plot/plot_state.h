#pragma once

#include <memory>
#include <vector>

#include "core/telemetry/store.h"
#include "ui/plot/cursors.h"
#include "ui/plot/plot_contents.h"
#include "ui/plot/time_view.h"
#include "ui/plot/trigger.h"

namespace kickstand::ui {

/// An area as it is seen.
struct ShownArea {
    PlotArea area;
    ValueRange range;
    bool usual = true;  ///< No person has chosen the range.
};

/// What a plot waits for.
struct PlotTrigger {
    enum class State { Waiting, Caught };

    SignalId signal;
    Edge edge = Edge::Rising;
    double level = 0;
    State state = State::Waiting;
    TimePoint caughtAt{};
};

/// All that there is to a plot but its pixels: what is shown of what, and how. GUI thread.
struct PlotState {
    PlotClock clock;
    std::shared_ptr<const TelemetryStore> store;
    std::vector<ShownArea> areas;
    std::vector<PlotCurve> curves;
    DescribeMark describeMark;
    CountMarks countMarks;
    TimeView view;
    Cursors cursors;
    std::optional<PlotTrigger> trigger;
    int keyArea = 0;  ///< The area whose values keys move and zoom.

    const TimeSeries* seriesOf(const PlotCurve& curve) const {
        return store == nullptr ? nullptr : store->find(curve.signal);
    }
};

}  // namespace kickstand::ui
