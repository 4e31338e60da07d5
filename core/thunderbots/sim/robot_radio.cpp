#include "core/thunderbots/sim/robot_radio.h"

namespace kickstand::thunderbots::sim {

void RobotRadio::discover() {
    next_.reset();
    sending_.reset();
    bootDiscovered_ = robot_->boots();
    robot_->dropOutgoing();
}

void RobotRadio::takeDrive(ByteView block) const {
    if (discovered()) robot_->takeDrive(block);
}

bool RobotRadio::takeMessage(const RadioMessage& message) {
    if (!discovered()) return false;
    if (message.sequence == next_.of(message.pipe)) {
        next_.step(message.pipe);
        robot_->takeMessage(message.pipe, message.payload.view());
    }
    return true;
}

std::optional<RadioAnswer> RobotRadio::poll() const {
    if (!discovered()) return std::nullopt;
    const auto feedback = robot_->feedback();
    if (!feedback) return std::nullopt;
    RadioAnswer answer{.feedback = *feedback, .message = std::nullopt};
    if (const OutgoingMessage* message = robot_->outgoing())
        answer.message = {message->pipe, sending_.of(message->pipe), message->payload};
    return answer;
}

void RobotRadio::acknowledged(const RadioMessage& message) {
    const OutgoingMessage* first = robot_->outgoing();
    if (!discovered() || !first || first->pipe != message.pipe) return;
    if (sending_.of(message.pipe) != message.sequence) return;
    sending_.step(message.pipe);
    robot_->outgoingDelivered();
}

}  // namespace kickstand::thunderbots::sim
