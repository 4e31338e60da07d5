#include "core/motionplan/sim/robot_program.h"

#include <algorithm>
#include <utility>

namespace kickstand::motionplan::sim {

using wire::MessageKind;

void RobotProgram::putMessage(const wire::Message& message) {
    if (const auto bytes = wire::encodeMessage(message)) put_(bytes->view());
}

void RobotProgram::putError(int code) {
    wire::Message message;
    message.kind = MessageKind::Error;
    message.error = code;
    putMessage(message);
}

void RobotProgram::putStatus() {
    wire::Message message;
    message.kind = MessageKind::Status;
    if (motion_) {
        message.plan = motion_->plan;
        message.slot = motion_->slot;
        message.step = static_cast<int>(motion_->step) + 1;
    }
    putMessage(message);
}

void RobotProgram::command(ByteView bytes, TimePoint now) {
    tick(now);
    put_(bytes);
    const auto message = wire::decodeMessage(bytes);
    if (!message) return;
    switch (message->kind) {
        case MessageKind::Create:
        case MessageKind::Update:
            createOrUpdate(*message);
            break;
        case MessageKind::Stop:
            stop();
            break;
        case MessageKind::Execute:
            execute(*message, now);
            break;
        case MessageKind::Query: {
            wire::Message answer = *message;
            answer.plan = slots_[static_cast<std::size_t>(message->slot)].id;
            putMessage(answer);
            break;
        }
        case MessageKind::Adjust:
            adjust(*message);
            break;
        default:
            break;
    }
}

void RobotProgram::createOrUpdate(const wire::Message& message) {
    KeptPlan& slot = slots_[static_cast<std::size_t>(message.slot)];
    const bool create = message.kind == MessageKind::Create;
    if (create && !slot.empty())
        putError(wire::kErrorSlotFull);
    else if (!create && slot.empty())
        putError(wire::kErrorUpdateEmptySlot);
    else if (!create && slot.id != message.plan)
        putError(wire::kErrorUpdateOtherPlan);
    else if (!create && strictUpdate_ && !motion_)
        putError(wire::kErrorUpdateIdle);
    else
        slot = {message.plan, message.movements};
}

void RobotProgram::execute(const wire::Message& message, TimePoint now) {
    const KeptPlan& slot = slots_[static_cast<std::size_t>(message.slot)];
    if (slot.empty())
        putError(wire::kErrorExecuteEmptySlot);
    else if (slot.id != message.plan)
        putError(wire::kErrorExecuteOtherPlan);
    else
        start({slot.id, message.slot, false, slot.movements, 0, 0}, now);
}

void RobotProgram::start(Motion motion, TimePoint now) {
    motion_ = std::move(motion);
    speeds_ = {1, 1};
    at_ = now;
    statusAt_ = now;
    putStatus();
}

void RobotProgram::stop() {
    if (!motion_) {
        putError(wire::kErrorStopIdle);
        return;
    }
    motion_.reset();
    putStatus();
}

void RobotProgram::adjust(const wire::Message& message) {
    if (!motion_) {
        putError(wire::kErrorAdjustIdle);
        return;
    }
    constexpr double kFastest = 2;
    const double change = message.change_percent / 100.0;
    const bool left = !wire::isTurn(message.wheels) || message.wheels == wire::Wheels::LeftForward ||
                      message.wheels == wire::Wheels::LeftBack;
    const bool right = !wire::isTurn(message.wheels) || !left;
    if (left) speeds_[0] = std::clamp(speeds_[0] + change, 0.0, kFastest);
    if (right) speeds_[1] = std::clamp(speeds_[1] + change, 0.0, kFastest);
}

void RobotProgram::triggerPlan(ByteView bytes) {
    const auto message = wire::decodeMessage(bytes);
    if (message && message->kind == MessageKind::Trigger) trigger_ = {message->plan, message->movements};
}

void RobotProgram::connectionLost(TimePoint now) {
    tick(now);
    if (!trigger_.empty()) start({trigger_.id, 0, true, trigger_.movements, 0, 0}, now);
}

double RobotProgram::stepsPerSecond() const {
    const auto movement = wire::decodeMovement(motion_->movements[motion_->step]);
    if (!movement) return 0;
    if (!wire::isTurn(movement->wheels))
        return pace_ * kSpeed_cm_per_s * (speeds_[0] + speeds_[1]) / 2 / movement->amount;
    const bool left =
        movement->wheels == wire::Wheels::LeftForward || movement->wheels == wire::Wheels::LeftBack;
    return pace_ * kTurn_deg_per_s * speeds_[left ? 0 : 1] / movement->amount;
}

void RobotProgram::nextStep(TimePoint now) {
    motion_->done = 0;
    if (++motion_->step >= motion_->movements.size()) {
        motion_.reset();
        ++executed_;
    }
    statusAt_ = now;
    putStatus();
}

void RobotProgram::tick(TimePoint now) {
    while (motion_) {
        const double rate = stepsPerSecond();
        const double left_s = seconds(now - at_);
        const double needed_s = rate > 0 ? (1 - motion_->done) / rate : left_s + 1;
        if (needed_s > left_s) {
            motion_->done += left_s * rate;
            break;
        }
        at_ += fromSeconds(needed_s);
        nextStep(at_);
    }
    at_ = now;
    if (!motion_ || now - statusAt_ < kStatusEvery) return;
    statusAt_ = now;
    putStatus();
}

void RobotProgram::restart() {
    slots_ = {};
    trigger_ = {};
    motion_.reset();
    speeds_ = {1, 1};
}

}  // namespace kickstand::motionplan::sim
