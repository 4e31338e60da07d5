#pragma once

#include <vector>

#include "ui/shell/system_view.h"

class QMessageBox;

namespace kickstand::ui {

class Bench;

/// What stays dangerous when the program ends now, of every session.
std::vector<Hazard> hazardsOf(const Bench& bench);

/// "robot 3: 212 V on its capacitor, 40 s ago: treat as live".
QString hazardLine(const Hazard& hazard, TimePoint now);

/// Asks whether to leave capacitors live, or robots that move. Not native, so that Space and Esc still mean
/// STOP ahead of it; deletes itself. accepted() when a person wants to leave all the same.
QMessageBox* makeLiveWarning(const std::vector<Hazard>& hazards, TimePoint now, const QString& leave,
                             QWidget* parent);

}  // namespace kickstand::ui
