#include "core/thunderbots/message_turns.h"

#include <utility>

namespace kickstand::thunderbots {
namespace {

/// A message that waits longer than this has found the dongle's buffers full.
constexpr Duration kPrompt = std::chrono::microseconds(2500);

}  // namespace

void MessageTurns::push(int robot, const std::vector<wire::MessagePayload>& messages, Taken taken) {
    Queue& queue = queueOf(robot);
    ++queue.batch;
    queue.waiting.assign(messages.begin(), messages.end());
    queue.taken = std::move(taken);
    wakeSoon();
}

void MessageTurns::drop(int robot) {
    Queue& queue = queueOf(robot);
    ++queue.batch;
    queue.waiting.clear();
    queue.taken = {};
}

void MessageTurns::wakeSoon() {
    if (handed_ || wake_ != 0) return;
    wake_ = scheduler_.callAfter(Duration::zero(), [this] {
        wake_ = 0;
        handNext();
    });
}

int MessageTurns::choose() const {
    if (promptly_ && !queueOf(turn_).waiting.empty()) return turn_;
    for (int step = 1; step <= kRobots; ++step) {
        const int robot = (turn_ + step) % kRobots;
        if (!queueOf(robot).waiting.empty()) return robot;
    }
    return -1;
}

void MessageTurns::handNext() {
    const int robot = handed_ ? -1 : choose();
    if (robot < 0) return;
    turn_ = robot;
    Queue& queue = queueOf(robot);
    OutMessage message;
    message.robot = robot;
    message.pipe = wire::Pipe::FirmwareRequest;
    message.payload = queue.waiting.front();
    queue.waiting.pop_front();
    handed_ = true;
    const TimePoint now = scheduler_.now();
    const auto pushed = pipe_.push(message, [this, robot, batch = queue.batch, now](Result<void> result) {
        messageTaken(robot, batch, now, std::move(result));
    });
    if (!pushed) messageTaken(robot, queue.batch, now, pushed);
}

void MessageTurns::messageTaken(int robot, std::uint64_t batch, TimePoint handed, Result<void> result) {
    handed_ = false;
    promptly_ = scheduler_.now() - handed <= kPrompt;
    // The pipe goes on as soon as this returns: what is next has to be with it by then.
    const bool failed = !result;
    Queue& queue = queueOf(robot);
    Taken taken;
    if (queue.batch == batch && (failed || queue.waiting.empty())) {
        queue.waiting.clear();
        taken = std::exchange(queue.taken, {});
    }
    if (failed) {
        wakeSoon();
    } else {
        handNext();
    }
    if (taken) taken(std::move(result));
}

}  // namespace kickstand::thunderbots
