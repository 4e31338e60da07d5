#include <utility>

#include "core/motionplan/plan.h"
#include "core/motionplan/session.h"

namespace kickstand::motionplan {

using wire::MessageKind;

namespace {

tl::unexpected<Error> wouldBeRefused(int code) {
    return fail(refusalError(Errc::WouldBeRefused, code));
}

wire::Message planMessage(MessageKind kind, int plan, int slot = 0) {
    wire::Message message;
    message.kind = kind;
    message.plan = plan;
    message.slot = slot;
    return message;
}

/// A message with its movements' bytes.
Result<wire::Message> withMovements(wire::Message message, const std::vector<wire::Movement>& movements) {
    auto bytes =
        planBytes(movements, message.kind == MessageKind::Trigger ? PlanUse::Trigger : PlanUse::Slot);
    if (!bytes) return fail(bytes.error());
    message.movements = std::move(*bytes);
    return message;
}

}  // namespace

void Session::execute(CommandId id, const Command& command) {
    ++version_;
    if (auto taken = checkTaken(command); !taken) {
        answer(id, taken);
        return;
    }
    std::visit([this, id](const auto& one) { perform(id, one); }, command);
}

Result<void> Session::checkTaken(const Command& command) const {
    if (ending_ || state_ != LinkState::Running) return fail(Errc::NotConnected);
    const bool harmless = std::holds_alternative<QuerySlot>(command) ||
                          std::holds_alternative<ReadTrigger>(command) ||
                          std::holds_alternative<StopPlan>(command);
    if (!harmless && host_.stop.isSet()) return fail(Errc::StopLatched);
    return {};
}

void Session::perform(CommandId id, const CreatePlan& command) {
    const auto message =
        withMovements(planMessage(MessageKind::Create, command.plan, command.slot), command.movements);
    message ? sendToSlot(id, *message) : answer(id, fail(message.error()));
}

void Session::perform(CommandId id, const UpdatePlan& command) {
    const auto message =
        withMovements(planMessage(MessageKind::Update, command.plan, command.slot), command.movements);
    message ? sendToSlot(id, *message) : answer(id, fail(message.error()));
}

void Session::perform(CommandId id, const ExecutePlan& command) {
    if (active() || startAsked_) {
        answer(id, fail(Errc::PlanExecuting));
        return;
    }
    startAsked_ = id;
    sendToSlot(id, planMessage(MessageKind::Execute, command.plan, command.slot));
}

void Session::perform(CommandId id, const StopPlan&) {
    if (stopAskers_.size() >= Station::kQueue) {
        answer(id, fail(Errc::QueueFull));
        return;
    }
    stopAskers_.push_back(id);
    sendStop(Errc::Cancelled);
}

void Session::perform(CommandId id, const QuerySlot& command) {
    submit(id, {planMessage(MessageKind::Query, wire::kDummyPlan, command.slot)});
}

void Session::perform(CommandId id, const AdjustSpeed& command) {
    const Execution& execution = model_.execution();
    wire::Message message = planMessage(MessageKind::Adjust, execution.plan, execution.slot);
    message.wheels = command.wheels;
    message.change_percent = command.change_percent;
    if (auto fits = checkAdjust(message); !fits) {
        answer(id, fits);
        return;
    }
    submit(id, {std::move(message)});
}

void Session::perform(CommandId id, const SetTrigger& command) {
    const auto message = withMovements(planMessage(MessageKind::Trigger, command.plan), command.movements);
    message ? submit(id, {*message}) : answer(id, fail(message.error()));
}

void Session::perform(CommandId id, const ReadTrigger&) {
    submit(id, {planMessage(MessageKind::Trigger, wire::kFirstPlan), true});
}

void Session::sendToSlot(CommandId id, const wire::Message& message) {
    // What makes no message is refused before anything is asked.
    if (auto bytes = wire::encodeMessage(message); !bytes) {
        answer(id, fail(bytes.error()));
        return;
    }
    if (model_.slots()[static_cast<std::size_t>(message.slot)].known) {
        sendKnown(id, message);
        return;
    }
    Exchange::Request query{planMessage(MessageKind::Query, wire::kDummyPlan, message.slot)};
    const auto queued = station_.submit(std::move(query), [this, id, message](const Exchange& exchange) {
        if (!exchange.result()) {
            tellFailure(exchange);
            answer(id, exchange.result());
            return;
        }
        ended(exchange);
        sendKnown(id, message);
    });
    if (!queued) answer(id, queued);
}

void Session::sendKnown(CommandId id, const wire::Message& message) {
    if (auto fits = checkSlot(message); !fits) {
        answer(id, fits);
        return;
    }
    submit(id, {message});
}

Result<void> Session::checkSlot(const wire::Message& message) const {
    const SlotState& slot = model_.slots()[static_cast<std::size_t>(message.slot)];
    if (!slot.known) return {};
    const int resident = slot.plan;
    const bool empty = resident == wire::kNoPlan;
    switch (message.kind) {
        case MessageKind::Create:
            if (!empty) return wouldBeRefused(wire::kErrorSlotFull);
            break;
        case MessageKind::Update:
            if (empty) return wouldBeRefused(wire::kErrorUpdateEmptySlot);
            if (resident != message.plan) return wouldBeRefused(wire::kErrorUpdateOtherPlan);
            break;
        case MessageKind::Execute:
            if (empty) return wouldBeRefused(wire::kErrorExecuteEmptySlot);
            if (resident != message.plan) return wouldBeRefused(wire::kErrorExecuteOtherPlan);
            break;
        default:
            break;
    }
    return {};
}

Result<void> Session::checkAdjust(const wire::Message& message) const {
    const Execution& execution = model_.execution();
    const bool runs = execution.state == Execution::State::Runs && execution.plan == message.plan &&
                      execution.slot == message.slot;
    return runs ? Result<void>() : wouldBeRefused(wire::kErrorAdjustIdle);
}

void Session::answer(CommandId id, const Result<void>& result) {
    if (startAsked_ == id) startAsked_.reset();
    host_.answer(id, result);
}

void Session::submit(CommandId id, Exchange::Request request) {
    if (!request.readsTrigger) {
        if (auto bytes = wire::encodeMessage(request.message); !bytes) {
            answer(id, fail(bytes.error()));
            return;
        }
    }
    const auto queued = station_.submit(std::move(request), [this, id](const Exchange& exchange) {
        ended(exchange);
        answer(id, exchange.result());
    });
    if (!queued) answer(id, queued);
}

void Session::ended(const Exchange& exchange) {
    const TimePoint now = host_.scheduler.now();
    const wire::Message& message = exchange.request().message;
    ++version_;
    if (message.kind == MessageKind::Execute) {
        model_.executeEnded(exchange.result(), now);
        if (exchange.planEnded()) model_.idle(now);
    }
    if (!exchange.result()) {
        doubt(exchange);
        if (exchange.answeredPlan()) model_.slotRead(message.slot, *exchange.answeredPlan(), now);
        tellFailure(exchange);
        return;
    }
    switch (message.kind) {
        case MessageKind::Create:
        case MessageKind::Update:
            model_.planPut(message, now);
            break;
        case MessageKind::Query:
        case MessageKind::Execute:
            if (exchange.answeredPlan()) model_.slotRead(message.slot, *exchange.answeredPlan(), now);
            break;
        case MessageKind::Adjust:
            raise(EventKind::Adjusted, static_cast<std::int64_t>(message.wheels), message.change_percent);
            break;
        case MessageKind::Trigger:
            if (exchange.request().readsTrigger)
                model_.triggerRead(exchange.triggerContent().view(), now);
            else
                model_.triggerPut(message, now);
            break;
        default:
            break;
    }
}

void Session::doubt(const Exchange& exchange) {
    const wire::Message& message = exchange.request().message;
    if (exchange.attempts() == 0) return;
    switch (message.kind) {
        case MessageKind::Create:
        case MessageKind::Update:
            model_.slotUnknown(message.slot);
            break;
        case MessageKind::Execute:
            // A refusal says that something else is there than was thought.
            if (exchange.result().error().code == Errc::PlanRefused) model_.slotUnknown(message.slot);
            break;
        case MessageKind::Trigger:
            if (exchange.request().readsTrigger) break;
            model_.triggerUnknown(message.plan);
            if (exchange.hasTriggerContent())
                model_.triggerRead(exchange.triggerContent().view(), host_.scheduler.now());
            break;
        default:
            break;
    }
}

void Session::tellFailure(const Exchange& exchange) {
    const Error& error = exchange.result().error();
    const auto kind = static_cast<std::int64_t>(exchange.request().message.kind);
    if (error.code == Errc::PlanRefused) raise(EventKind::Refused, error.got.value_or(-1));
    if (error.code == Errc::EchoDiffers) raise(EventKind::Differs, kind, 0, error.detail);
    if (error.code == Errc::Unconfirmed) raise(EventKind::Unconfirmed, kind);
}

}  // namespace kickstand::motionplan
