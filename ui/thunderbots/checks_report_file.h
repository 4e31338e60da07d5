#pragma once

#include <functional>
#include <memory>

#include "core/engine/describe_check_report.h"

class QMenu;
class QWidget;

namespace kickstand::ui {

/// Fills a menu with the ways to keep a check's report: a page, PDF, JSON, text, and paper. Whatever
/// `current` gives when one is chosen is kept; `began` turns its time into that of the clock on the wall.
void addReportActions(QMenu* menu, QWidget* parent,
                      const std::function<std::shared_ptr<const thunderbots::CheckProgress>()>& current,
                      const std::function<WallTime(TimePoint)>& wallTime);

}  // namespace kickstand::ui
