#pragma once

#include <QString>
#include <optional>

#include "core/engine/describe.h"
#include "core/thunderbots/parameter_draft.h"
#include "core/thunderbots/parameter_state.h"

namespace kickstand {

// The words for robots' operational parameters. Any thread once the application object exists.

/// What is known of how long a robot keeps what it has, as a whole sentence.
QString describe(const thunderbots::ParameterState& state);
/// "Channel of radio 0".
QString describe(thunderbots::ParameterField field);
/// A value with its unit: "0x0e (14)", "not configured", "120 (47 %)", "FPGA bitstream".
QString describeValue(thunderbots::ParameterField field, std::uint8_t value);
/// "FPGA bitstream", "microcontroller", "no data".
QString describe(thunderbots::wire::FlashContents contents);

/// What a person is about to do.
enum class ParameterStep { Apply, Commit, Reboot };
/// What will happen, and when, seen from this step.
QString describe(const thunderbots::ParameterWarning& warning, ParameterStep step);

/// The words for an event about parameters; nothing for other events.
std::optional<EventText> describeParameterEvent(const thunderbots::Event& event);

}  // namespace kickstand
