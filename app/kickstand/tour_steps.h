#pragma once

#include <vector>

#include "app/kickstand/tour.h"

namespace kickstand::app {

struct TourBus;

/// What the tour does, in order. All three outlive it.
std::vector<TourStep> tourSteps(ui::MainWindow& window, ui::Bench& bench, TourBus& bus);

}  // namespace kickstand::app
