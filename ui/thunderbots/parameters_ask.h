#pragma once

#include <QString>
#include <functional>
#include <vector>

#include "core/engine/describe_parameters.h"
#include "core/thunderbots/snapshot.h"

class QWidget;

namespace kickstand::ui {

/// What to tell a person before this step with a robot; none where nothing needs telling. `block`: what it is
/// to have, or has.
std::vector<thunderbots::ParameterWarning> warningsBefore(
    ParameterStep step, int robot, const thunderbots::wire::OperationalParameters& block,
    const thunderbots::Snapshot& snapshot);

/// Tells what will happen and when, and goes on where a person wants it all the same; at once where there is
/// nothing to tell. The dialog is not native, so that STOP keys work ahead of it, and `parent` owns it.
void askBefore(ParameterStep step, int robot, const QStringList& sentences, bool serious, QWidget* parent,
               const std::function<void()>& goOn);

/// Why a robot's parameters cannot be worked with now; empty where they can.
QString reasonNotToAsk(const thunderbots::Snapshot* snapshot, int robot, int chosen);
/// Why it cannot be rebooted now, apart from that.
QString reasonNotToReboot(const thunderbots::Snapshot& snapshot, int robot, bool stopped);

}  // namespace kickstand::ui
