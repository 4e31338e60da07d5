#include "core/motionplan/wire/fields.h"

#include <array>

namespace kickstand::motionplan::wire {
namespace {

constexpr std::array<const char*, 6> kWheelLabels{"both-forward", "both-back",     "left-forward",
                                                  "left-back",    "right-forward", "right-back"};

constexpr FieldSpec plan(std::uint8_t offset, int lowest, int highest, const char* description) {
    return {FieldId::Plan, "plan", offset, lowest, highest, "", description};
}
constexpr FieldSpec slot(std::uint8_t offset) {
    return {FieldId::Slot, "slot", offset, 0, kSlots - 1, "", "Which of the robot's five places"};
}
constexpr FieldSpec movements(std::uint8_t offset, int most) {
    return {FieldId::Movements, "movements", offset, 1, most, "", "One byte a movement (protocol 5)"};
}
constexpr const char* kPlanText = "ID of the plan";

constexpr std::array kPlanFields{plan(1, kFirstPlan, kLastPlan, kPlanText), slot(2),
                                 movements(3, kMostMovements)};
constexpr std::array kExecuteFields{plan(1, kFirstPlan, kLastPlan, kPlanText), slot(2)};
constexpr std::array kStatusFields{
    plan(1, 0, 255, "ID of the plan that executes"), slot(2),
    FieldSpec{FieldId::Step, "step", 3, 0, 255, "", "Which movement executes, from 1; 0 at rest"}};
constexpr std::array kQueryFields{
    plan(1, 0, 255, "Asked: a dummy, 255; answered: the plan in the slot, 0 for none"), slot(2)};
constexpr std::array kAdjustFields{
    plan(1, kFirstPlan, kLastPlan, kPlanText), slot(2),
    FieldSpec{FieldId::Wheels, "wheels", 3, 0, kWheelLabels.size() - 1, "", "Which wheels", kWheelLabels},
    FieldSpec{FieldId::Change, "change", 4, -kMostChange_percent, kMostChange_percent, "%",
              "Change of their speed"}};
constexpr std::array kErrorFields{
    FieldSpec{FieldId::Error, "error", 1, 0, 255, "", "Why the robot refused (protocol 4.10)"}};
constexpr std::array kTriggerFields{plan(1, kFirstPlan, kLastPlan, kPlanText),
                                    movements(2, kMostTriggerMovements)};

constexpr std::array<MessageSpec, kMessageKinds> kSpecs{{
    {MessageKind::Create, kCommandBox, "4.1", "Puts a plan into an empty slot", kPlanFields},
    {MessageKind::Stop, kCommandBox, "4.2", "Stops the plan that executes", {}},
    {MessageKind::Update, kCommandBox, "4.3", "Replaces the plan of that ID in its slot", kPlanFields},
    {MessageKind::Execute, kCommandBox, "4.4", "Executes the plan of a slot", kExecuteFields},
    {MessageKind::Status, kCommandOutbox, "4.5", "Which movement of which plan executes", kStatusFields},
    {MessageKind::Query, kCommandBox, "4.6", "Asks which plan is in a slot, and the answer", kQueryFields},
    {MessageKind::Adjust, kCommandBox, "4.7", "Changes the speed of wheels while a plan executes",
     kAdjustFields},
    {MessageKind::Error, kCommandOutbox, "4.10", "Why the robot refused a command", kErrorFields},
    {MessageKind::Trigger, kTriggerBox, "4.9", "The plan for when the connection is lost", kTriggerFields},
}};

}  // namespace

std::size_t MessageSpec::fewestBytes() const {
    if (fields.empty()) return 1;
    const FieldSpec& last = fields.back();
    return last.offset + (last.isBytes() ? static_cast<std::size_t>(last.lowest) : 1U);
}

std::size_t MessageSpec::mostBytes() const {
    if (fields.empty()) return 1;
    const FieldSpec& last = fields.back();
    return last.offset + (last.isBytes() ? static_cast<std::size_t>(last.highest) : 1U);
}

std::span<const MessageSpec> messageSpecs() noexcept {
    return kSpecs;
}

const MessageSpec& specOf(MessageKind kind) noexcept {
    const auto index = static_cast<std::size_t>(kind);
    return kSpecs[index < kSpecs.size() ? index : 0];
}

}  // namespace kickstand::motionplan::wire
