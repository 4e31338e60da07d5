#include "core/engine/event_marks.h"

#include <algorithm>
#include <array>

namespace kickstand {
namespace {

template <class Kind>
struct Marked {
    Kind event;
    MarkKind mark;
};

using Thunderbots = thunderbots::EventKind;
using SmartDevice = smartdevice::EventKind;
using Motionplan = motionplan::EventKind;
using Coach = coach::EventKind;

constexpr auto kThunderbots = std::to_array<Marked<Thunderbots>>({
    {Thunderbots::KickGiven, MarkKind::Kick},
    {Thunderbots::Autokick, MarkKind::Autokick},
    {Thunderbots::DongleFault, MarkKind::DeviceError},
    {Thunderbots::Connected, MarkKind::LinkUp},
    {Thunderbots::LinkLost, MarkKind::LinkDown},
    {Thunderbots::Disconnected, MarkKind::LinkDown},
    {Thunderbots::RobotFound, MarkKind::UnitHeard},
    {Thunderbots::RobotLost, MarkKind::UnitLost},
});
constexpr auto kSmartDevice = std::to_array<Marked<SmartDevice>>({
    {SmartDevice::DeviceFound, MarkKind::UnitHeard},
    {SmartDevice::DeviceBack, MarkKind::UnitHeard},
    {SmartDevice::DeviceLost, MarkKind::UnitLost},
    {SmartDevice::DeviceError, MarkKind::DeviceError},
});
constexpr auto kMotionplan = std::to_array<Marked<Motionplan>>({
    {Motionplan::Connected, MarkKind::LinkUp},
    {Motionplan::LinkLost, MarkKind::LinkDown},
    {Motionplan::Disconnected, MarkKind::LinkDown},
    {Motionplan::Refused, MarkKind::DeviceError},
});
constexpr auto kCoach = std::to_array<Marked<Coach>>({
    {Coach::Connected, MarkKind::LinkUp},
    {Coach::LinkLost, MarkKind::LinkDown},
    {Coach::Disconnected, MarkKind::LinkDown},
    {Coach::Paired, MarkKind::UnitHeard},
    {Coach::Unpaired, MarkKind::UnitLost},
});

/// `unit`: the robot, device or team; less than 0 for none.
template <class Event, class Table>
std::optional<Mark> find(const Event& event, int unit, const Table& table) {
    const auto row = std::ranges::find(table, event.kind, [](const auto& marked) { return marked.event; });
    if (row == table.end()) return std::nullopt;
    Mark mark{.time = event.time, .kind = row->mark};
    if (unit >= 0) mark.unit = static_cast<std::uint16_t>(unit);
    if (mark.kind == MarkKind::DeviceError) mark.value = static_cast<float>(event.code);
    return mark;
}

std::optional<Mark> markOf(const thunderbots::Event& event) {
    std::optional<Mark> mark = find(event, event.robot, kThunderbots);
    if (mark && mark->kind == MarkKind::Kick)
        mark->value = static_cast<float>(std::max(event.code, event.previous));
    return mark;
}

std::optional<Mark> markOf(const smartdevice::Event& event) {
    return find(event, event.robot, kSmartDevice);
}

std::optional<Mark> markOf(const motionplan::Event& event) {
    return find(event, -1, kMotionplan);
}

std::optional<Mark> markOf(const coach::Event& event) {
    return find(event, event.team, kCoach);
}

}  // namespace

std::optional<Mark> markOf(const SystemEvent& event) {
    return std::visit([](const auto& own) { return markOf(own); }, event);
}

}  // namespace kickstand
