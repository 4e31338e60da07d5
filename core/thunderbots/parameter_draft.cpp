#include "core/thunderbots/parameter_draft.h"

#include <utility>

namespace kickstand::thunderbots {

ParameterValues valuesOf(const wire::OperationalParameters& parameters) {
    ParameterValues values;
    for (const ParameterField field : kParameterFields)
        values[static_cast<std::size_t>(field)] = valueOf(parameters, field);
    return values;
}

void ParameterDraft::setRobot(const std::optional<wire::OperationalParameters>& robot) {
    robot_ = robot;
}

std::optional<std::uint8_t> ParameterDraft::value(ParameterField field) const {
    if (const auto& edited = edits_[static_cast<std::size_t>(field)]) return edited;
    if (robot_) return valueOf(*robot_, field);
    return std::nullopt;
}

ParameterMask ParameterDraft::changes() const {
    const auto block = blockWith(kAllParameters);
    return block ? differences(*robot_, *block) : ParameterMask{0};
}

void ParameterDraft::beginStep() {
    before_ = edits_;
}

void ParameterDraft::endStep(std::optional<ParameterField> field) {
    if (edits_ == before_) return;
    undone_.push_back(before_);
    if (undone_.size() > kMostSteps) undone_.erase(undone_.begin());
    redone_.clear();
    lastField_ = field;
}

void ParameterDraft::set(ParameterField field, std::uint8_t value, bool merge) {
    if (merge && lastField_ == field && canUndo() && redone_.empty()) {
        edit(field) = value;
        return;
    }
    beginStep();
    edit(field) = value;
    endStep(field);
}

void ParameterDraft::take(const ParameterValues& values, ParameterMask fields) {
    beginStep();
    for (const ParameterField field : kParameterFields) {
        const auto& value = values[static_cast<std::size_t>(field)];
        if (value && contains(fields, field)) edit(field) = value;
    }
    endStep(std::nullopt);
}

void ParameterDraft::reset(ParameterMask fields) {
    beginStep();
    for (const ParameterField field : kParameterFields) {
        if (contains(fields, field)) edit(field).reset();
    }
    endStep(std::nullopt);
}

void ParameterDraft::undo() {
    if (undone_.empty()) return;
    redone_.push_back(std::exchange(edits_, undone_.back()));
    undone_.pop_back();
    lastField_.reset();
}

void ParameterDraft::redo() {
    if (redone_.empty()) return;
    undone_.push_back(std::exchange(edits_, redone_.back()));
    redone_.pop_back();
    lastField_.reset();
}

std::optional<wire::OperationalParameters> ParameterDraft::blockWith(ParameterMask fields) const {
    if (!robot_) return std::nullopt;
    wire::OperationalParameters block = *robot_;
    for (const ParameterField field : kParameterFields) {
        if (contains(fields, field)) setValue(block, field, *value(field));
    }
    return block;
}

}  // namespace kickstand::thunderbots
