#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "core/base/time.h"

namespace kickstand::motionplan {

/// What can happen. The comment says what Event's members mean for it.
enum class EventKind : std::uint8_t {
    Connected,
    Disconnected,     ///< Closed on purpose.
    LinkLost,         ///< code 1: a plan was executing.
    LinkFailed,       ///< text: what it is about; code: its Errc.
    Waiting,          ///< The line is not there; the session waits for it.
    SlotRead,         ///< code: slot, previous: plan in it, 0 for none.
    PlanCreated,      ///< code: slot, previous: plan, value: movements.
    PlanUpdated,      ///< The same.
    TriggerSet,       ///< previous: plan, value: movements.
    TriggerRead,      ///< The same; plan 0: there is none.
    Executing,        ///< code: slot, previous: plan.
    Step,             ///< code: slot, previous: plan, value: step.
    Ended,            ///< By itself. code: slot, previous: plan.
    Stopped,          ///< Confirmed. code 1: nothing was executing.
    Adjusted,         ///< code: wire::Wheels, previous: change in %.
    Refused,          ///< By the robot. code: its error code; previous 1: nobody had asked.
    Differs,          ///< Something else came back. text: "sent …, got …".
    Unconfirmed,      ///< code: wire::MessageKind.
    StopUnconfirmed,  ///< STOP was sent, and nothing came back.
    Silent,           ///< The robot does not answer. code: reads in a row.
    Answers,          ///< It does again.
    NxtStatus,        ///< code: the status it answers with.
    Stale,            ///< A plan executes, and no status has come for a while. code: slot, previous: plan.
    Malformed,        ///< code: bytes or messages since the last such event; text: what was wrong.
};

/// One thing that happened, with its facts. Text for people is made in core/engine/describe.h.
struct Event {
    EventKind kind = EventKind::Connected;
    TimePoint time{};
    int robot = -1;  ///< There is one robot on a link: always -1.
    std::int64_t code = 0;
    std::int64_t previous = 0;
    double value = 0;
    std::string text;
};

/// "plan-created", …: stable names for JSON. Any thread.
std::string_view name(EventKind kind);

}  // namespace kickstand::motionplan
