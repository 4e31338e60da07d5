#pragma once

#include "core/coach/snapshot.h"
#include "ui/coach/chart_view.h"

namespace kickstand::ui {

/// The state charts of both sides (coach protocol 6, 7), as they stand at the snapshot's moment.
Chart coachChart(const coach::Snapshot& snapshot);
Chart towrpChart(const coach::Snapshot& snapshot);

}  // namespace kickstand::ui
