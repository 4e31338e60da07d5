#include "core/motionplan/model.h"

#include <algorithm>
#include <utility>

#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan {

using wire::MessageKind;

void Model::raise(EventKind kind, TimePoint now, std::int64_t code, std::int64_t previous, double value) {
    event_(Event{kind, now, -1, code, previous, value, {}});
}

SlotState* Model::slot(int number) {
    return number >= 0 && number < wire::kSlots ? &slots_[static_cast<std::size_t>(number)] : nullptr;
}

void Model::forget() {
    slots_ = {};
    trigger_ = {};
    execution_ = {};
    outOfReach_ = false;
}

void Model::outOfReach(bool gone) {
    outOfReach_ = gone;
}

void Model::slotRead(int number, int plan, TimePoint now) {
    SlotState* const state = slot(number);
    if (state == nullptr) return;
    const bool news = !state->known || state->plan != plan;
    // Another plan has come there by another way: what it does is not known.
    if (state->plan != plan) state->movements.clear();
    state->known = true;
    state->plan = plan;
    state->at = now;
    if (news) raise(EventKind::SlotRead, now, number, plan);
}

void Model::slotUnknown(int number) {
    if (SlotState* const state = slot(number)) *state = {};
}

void Model::planPut(const wire::Message& message, TimePoint now) {
    SlotState* const state = slot(message.slot);
    if (state == nullptr) return;
    *state = {true, message.plan, now, message.movements};
    raise(message.kind == MessageKind::Create ? EventKind::PlanCreated : EventKind::PlanUpdated, now,
          message.slot, message.plan, static_cast<double>(message.movements.size()));
}

void Model::triggerPut(const wire::Message& message, TimePoint now) {
    trigger_ = {true, message.plan, now, message.movements};
    raise(EventKind::TriggerSet, now, 0, message.plan, static_cast<double>(message.movements.size()));
}

void Model::triggerUnknown(int plan) {
    trigger_ = {false, plan, {}, {}};
}

void Model::triggerRead(ByteView content, TimePoint now) {
    auto message = wire::decodeMessage(content);
    const bool is = message && message->kind == MessageKind::Trigger;
    if (!is && !content.empty()) return;
    trigger_ = {true, wire::kNoPlan, now, {}};
    if (is) trigger_ = {true, message->plan, now, std::move(message->movements)};
    raise(EventKind::TriggerRead, now, 0, trigger_.plan, static_cast<double>(trigger_.movements.size()));
}

void Model::executeSent(const wire::Message& execute, TimePoint now) {
    execution_ = {};
    execution_.state = Execution::State::Asked;
    execution_.plan = execute.plan;
    execution_.slot = execute.slot;
    execution_.heardAt = now;
    if (const SlotState* const state = slot(execute.slot); state != nullptr && state->plan == execute.plan)
        execution_.movements = state->movements;
}

void Model::executeEnded(const Result<void>& result, TimePoint now) {
    if (execution_.state != Execution::State::Asked) return;
    // A refusal says that nothing began; whatever else went wrong says nothing.
    const bool nothingBegan =
        !result &&
        (result.error().code == Errc::PlanRefused ||
         (result.error().code == Errc::NxtRefused && result.error().got == wire::kStatusNoProgram));
    if (result) {
        execution_.state = Execution::State::Runs;
        execution_.heardAt = now;
        raise(EventKind::Executing, now, execution_.slot, execution_.plan);
    } else if (nothingBegan) {
        execution_ = {};
    } else {
        execution_.state = Execution::State::Unsure;
    }
}

void Model::stopped(bool wasIdle, TimePoint now) {
    execution_ = {};
    raise(EventKind::Stopped, now, wasIdle ? 1 : 0);
}

void Model::idle(TimePoint now) {
    // Of before the start that was just asked for, where that is not confirmed yet.
    if (execution_.state == Execution::State::Asked) return;
    if (execution_.state == Execution::State::Runs)
        raise(EventKind::Ended, now, execution_.slot, execution_.plan);
    execution_ = {};
}

void Model::status(const wire::Message& status, TimePoint now) {
    if (status.step == 0) {
        idle(now);
        return;
    }
    const bool same = execution_.plan == status.plan && execution_.slot == status.slot;
    const bool began = execution_.state != Execution::State::Runs || !same;
    if (!same) {
        execution_ = {};
        execution_.plan = status.plan;
        execution_.slot = status.slot;
        const SlotState* const state = slot(status.slot);
        if (state != nullptr && state->plan == status.plan) execution_.movements = state->movements;
        if (execution_.movements.empty() && trigger_.plan == status.plan)
            execution_.movements = trigger_.movements;
    }
    execution_.state = Execution::State::Runs;
    execution_.stale = false;
    execution_.heardAt = now;
    if (began) raise(EventKind::Executing, now, status.slot, status.plan);
    if (std::exchange(execution_.step, status.step) == status.step) return;
    execution_.stepAt = now;
    raise(EventKind::Step, now, status.slot, status.plan, status.step);
}

void Model::tick(TimePoint now) {
    if (execution_.state != Execution::State::Runs || execution_.stale) return;
    if (now - execution_.heardAt < kStatusSilence) return;
    execution_.stale = true;
    raise(EventKind::Stale, now, execution_.slot, execution_.plan);
}

}  // namespace kickstand::motionplan
