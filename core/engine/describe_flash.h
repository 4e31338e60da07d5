#pragma once

#include <QString>
#include <QStringList>
#include <optional>

#include "core/engine/describe.h"
#include "core/thunderbots/flash_progress.h"

namespace kickstand {

// The words for uploads. Any thread once the application object exists.

/// What an upload does, in a few words: "erasing".
QString describe(thunderbots::FlashStage stage);
/// In what state a robot is left, and what that means, as a whole sentence.
QString describe(thunderbots::FlashLeft left);
/// How an upload goes, or went, in one plain sentence; after one that failed, its remedy too.
Description describeFlash(int robot, const thunderbots::FlashProgress& progress);
/// The upload's log, a line for each entry, with the seconds since its beginning.
QStringList flashLogLines(const thunderbots::FlashProgress& progress);
/// "1 min 20 s", "12 s".
QString durationText(Duration span);

/// The words for an event about uploads; nothing for other events.
std::optional<EventText> describeFlashEvent(const thunderbots::Event& event);

}  // namespace kickstand
