#pragma once

#include <vector>

#include "core/thunderbots/parameters.h"

namespace kickstand::thunderbots {

/// Values for some of the fields: a file's, a snapshot's, or what has been edited.
using ParameterValues = std::array<std::optional<std::uint8_t>, kParameterFieldCount>;

/// All fields of a block.
ParameterValues valuesOf(const wire::OperationalParameters& parameters);

/// A robot's parameters while a person edits them. What has not been edited follows the robot; what has stays
/// as it was edited when the robot is read again. Values are checked before they get here. Pure.
class ParameterDraft {
  public:
    /// Steps that can be undone; the oldest are forgotten.
    static constexpr std::size_t kMostSteps = 200;

    /// What the robot has, or nothing where that is not known. Never undone.
    void setRobot(const std::optional<wire::OperationalParameters>& robot);
    const std::optional<wire::OperationalParameters>& robot() const { return robot_; }

    /// The draft's value: what was edited, else what the robot has, else nothing.
    std::optional<std::uint8_t> value(ParameterField field) const;
    /// Whether the draft differs from the robot in a field, or in which ones. None while the robot is not
    /// known.
    bool changed(ParameterField field) const { return contains(changes(), field); }
    ParameterMask changes() const;

    /// Edits one field. A step of its own, unless it goes on with the edit of the same field before it
    /// (`merge`), as while a value is being typed or dragged.
    void set(ParameterField field, std::uint8_t value, bool merge = false);
    /// Takes over what `values` has for these fields, in one step.
    void take(const ParameterValues& values, ParameterMask fields = kAllParameters);
    /// Back to what the robot has, in one step.
    void reset(ParameterMask fields = kAllParameters);

    bool canUndo() const { return !undone_.empty(); }
    bool canRedo() const { return !redone_.empty(); }
    void undo();
    void redo();

    /// The robot's block with the draft's values in these fields, all else as the robot has it; nothing while
    /// the robot is not known.
    std::optional<wire::OperationalParameters> blockWith(ParameterMask fields) const;

  private:
    std::optional<std::uint8_t>& edit(ParameterField field) {
        return edits_[static_cast<std::size_t>(field)];
    }
    void beginStep();
    void endStep(std::optional<ParameterField> field);

    std::optional<wire::OperationalParameters> robot_;
    ParameterValues edits_;
    ParameterValues before_;               ///< While a step is being made.
    std::vector<ParameterValues> undone_;  ///< What undo() goes back to, the nearest last.
    std::vector<ParameterValues> redone_;
    std::optional<ParameterField> lastField_;  ///< Of the newest step, where it edits one field.
};

}  // namespace kickstand::thunderbots
