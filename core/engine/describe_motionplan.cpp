#include "core/engine/describe_motionplan.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

#include "core/engine/describe_facts.h"
#include "core/motionplan/wire/nxt_status.h"

namespace kickstand {
namespace {

namespace wire = motionplan::wire;
using motionplan::EventKind;
using wire::Wheels;

struct PlanWords {
    Q_DECLARE_TR_FUNCTIONS(PlanWords)
};

using Text = std::optional<EventText>;

EventText information(QString text) {
    return {std::move(text), Severity::Information};
}
EventText warning(QString text) {
    return {std::move(text), Severity::Warning};
}
EventText danger(QString text) {
    return {std::move(text), Severity::Danger};
}

/// "plan 9 in slot 4".
QString where(const motionplan::Event& event) {
    return PlanWords::tr("plan %1 in slot %2").arg(event.previous).arg(event.code);
}

/// The command of a number that stands in an event.
QString commandText(std::int64_t code) {
    switch (static_cast<wire::MessageKind>(std::clamp<std::int64_t>(code, 0, UINT8_MAX))) {
        case wire::MessageKind::Create:
            return PlanWords::tr("create");
        case wire::MessageKind::Stop:
            return PlanWords::tr("stop");
        case wire::MessageKind::Update:
            return PlanWords::tr("update");
        case wire::MessageKind::Execute:
            return PlanWords::tr("execute");
        case wire::MessageKind::Query:
            return PlanWords::tr("query");
        case wire::MessageKind::Adjust:
            return PlanWords::tr("adjust");
        case wire::MessageKind::Trigger:
            return PlanWords::tr("trigger plan");
        case wire::MessageKind::Status:
        case wire::MessageKind::Error:
            break;
    }
    return QString::number(code);
}

Text linkEvent(const motionplan::Event& event) {
    switch (event.kind) {
        case EventKind::Connected:
            return information(PlanWords::tr("connected; nothing was started or stopped"));
        case EventKind::Disconnected:
            return information(PlanWords::tr("disconnected"));
        case EventKind::LinkLost:
            return danger(PlanWords::tr("link lost. %1").arg(outOfReachText()));
        case EventKind::LinkFailed: {
            Error error;
            error.code = static_cast<Errc>(event.code);
            error.port = event.text;
            return danger(PlanWords::tr("link failed: %1").arg(describe(error).what));
        }
        case EventKind::Waiting:
            return information(PlanWords::tr("waiting for the robot's serial port"));
        case EventKind::Silent:
            return warning(PlanWords::tr("the robot does not answer"));
        case EventKind::Answers:
            return information(PlanWords::tr("the robot answers"));
        case EventKind::NxtStatus: {
            const auto code = static_cast<std::uint8_t>(std::clamp<std::int64_t>(event.code, 0, UINT8_MAX));
            const QString text =
                PlanWords::tr("the NXT says: %1").arg(QString::fromUtf8(wire::nxtStatus(code).text));
            const bool fine = code == wire::kStatusSuccess || code == wire::kStatusMailboxEmpty;
            return fine ? information(text) : warning(text);
        }
        case EventKind::Malformed:
            return warning(
                PlanWords::tr("unreadable messages: %1 (%2)").arg(event.code).arg(printable(event.text)));
        default:
            return {};
    }
}

Text planEvent(const motionplan::Event& event) {
    const QString movements = QString::number(event.value, 'f', 0);
    switch (event.kind) {
        case EventKind::SlotRead:
            if (event.previous == wire::kNoPlan)
                return information(PlanWords::tr("slot %1 is empty").arg(event.code));
            return information(PlanWords::tr("slot %1 holds plan %2").arg(event.code).arg(event.previous));
        case EventKind::PlanCreated:
            return information(PlanWords::tr("created %1, movements: %2").arg(where(event), movements));
        case EventKind::PlanUpdated:
            return information(PlanWords::tr("updated %1, movements: %2").arg(where(event), movements));
        case EventKind::TriggerSet:
            return warning(
                PlanWords::tr("trigger plan %1 set: it starts when the connection ends").arg(event.previous));
        case EventKind::TriggerRead:
            if (event.previous == wire::kNoPlan)
                return information(PlanWords::tr("there is no trigger plan"));
            return information(
                PlanWords::tr("trigger plan %1, movements: %2").arg(event.previous).arg(movements));
        case EventKind::Refused: {
            const QString why = QString::fromUtf8(
                wire::errorCode(static_cast<int>(std::clamp<std::int64_t>(event.code, -1, UINT8_MAX))).text);
            return warning(PlanWords::tr("the robot reports error %1: %2").arg(event.code).arg(why));
        }
        case EventKind::Differs:
            return warning(PlanWords::tr("%1: the robot confirmed something else: %2")
                               .arg(commandText(event.code), printable(event.text)));
        case EventKind::Unconfirmed:
            return warning(PlanWords::tr("%1: nothing came back that confirms it; look at the robot")
                               .arg(commandText(event.code)));
        default:
            return {};
    }
}

Text motionEvent(const motionplan::Event& event) {
    switch (event.kind) {
        case EventKind::Executing:
            return warning(PlanWords::tr("executing %1").arg(where(event)));
        case EventKind::Step:
            return information(PlanWords::tr("step %1 of %2").arg(event.value, 0, 'f', 0).arg(where(event)));
        case EventKind::Ended:
            return information(PlanWords::tr("%1 has come to its end").arg(where(event)));
        case EventKind::Stopped:
            return information(event.code != 0 ? PlanWords::tr("stopped: nothing was executing")
                                               : PlanWords::tr("stopped, as the robot confirms"));
        case EventKind::StopUnconfirmed:
            return danger(PlanWords::tr("Stop was sent, and the robot did not confirm it: it may go on"));
        case EventKind::Stale:
            return warning(PlanWords::tr("%1 executes, and nothing is heard of it").arg(where(event)));
        case EventKind::Adjusted: {
            const auto wheels = static_cast<Wheels>(std::clamp<std::int64_t>(event.code, 0, UINT8_MAX));
            return information(
                PlanWords::tr("speed of %1 changed by %2 %").arg(wheelsText(wheels)).arg(event.previous));
        }
        default:
            return {};
    }
}

}  // namespace

QString outOfReachText() {
    return PlanWords::tr(
        "The robot's Bluetooth is gone: it goes on with its plan or starts its trigger plan, and STOP cannot "
        "reach it.");
}

QString describe(motionplan::LinkState state) {
    switch (state) {
        case motionplan::LinkState::Idle:
            return PlanWords::tr("not connected");
        case motionplan::LinkState::Searching:
            return PlanWords::tr("waiting for the serial port");
        case motionplan::LinkState::Opening:
            return PlanWords::tr("opening; Bluetooth can take seconds");
        case motionplan::LinkState::Running:
            return PlanWords::tr("connected", "link");
        case motionplan::LinkState::Failed:
            return PlanWords::tr("failed", "link");
    }
    return {};
}

QString describe(motionplan::Execution::State state) {
    switch (state) {
        case motionplan::Execution::State::Idle:
            return PlanWords::tr("at rest");
        case motionplan::Execution::State::Asked:
            return PlanWords::tr("asked to execute");
        case motionplan::Execution::State::Runs:
            return PlanWords::tr("executing");
        case motionplan::Execution::State::Unsure:
            return PlanWords::tr("may be executing");
    }
    return {};
}

QString wheelsText(Wheels wheels) {
    switch (wheels) {
        case Wheels::BothForward:
            return PlanWords::tr("both wheels forward");
        case Wheels::BothBack:
            return PlanWords::tr("both wheels back");
        case Wheels::LeftForward:
            return PlanWords::tr("left wheel forward");
        case Wheels::LeftBack:
            return PlanWords::tr("left wheel back");
        case Wheels::RightForward:
            return PlanWords::tr("right wheel forward");
        case Wheels::RightBack:
            return PlanWords::tr("right wheel back");
    }
    return {};
}

QString movementText(const wire::Movement& movement) {
    switch (movement.wheels) {
        case Wheels::BothForward:
            return PlanWords::tr("forward %1 cm").arg(movement.amount);
        case Wheels::BothBack:
            return PlanWords::tr("back %1 cm").arg(movement.amount);
        case Wheels::LeftForward:
            return PlanWords::tr("turn right %1°").arg(movement.amount);
        case Wheels::LeftBack:
            return PlanWords::tr("turn left back %1°").arg(movement.amount);
        case Wheels::RightForward:
            return PlanWords::tr("turn left %1°").arg(movement.amount);
        case Wheels::RightBack:
            return PlanWords::tr("turn right back %1°").arg(movement.amount);
    }
    return {};
}

EventText describeMotionplanEvent(const motionplan::Event& event) {
    for (const auto& group : {linkEvent, planEvent, motionEvent}) {
        if (auto text = group(event)) return *std::move(text);
    }
    return warning(PlanWords::tr("something that this program has no words for"));
}

}  // namespace kickstand
