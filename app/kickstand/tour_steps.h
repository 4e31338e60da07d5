#pragma once

#include <vector>

#include "app/kickstand/tour.h"

namespace kickstand::app {

/// What the tour does, in order.
std::vector<TourStep> tourSteps(ui::MainWindow& window, ui::Bench& bench);

}  // namespace kickstand::app
