#pragma once

#include <array>
#include <deque>
#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/thunderbots/message_pipe.h"
#include "core/thunderbots/types.h"

namespace kickstand::thunderbots {

/// Firmware requests of sixteen robots on their way into the one message pipe: a queue for each robot, and at
/// most one message handed to the pipe at a time, so that a kick never waits behind more than that. Engine
/// thread.
///
/// While the dongle takes a message a millisecond, what a robot has waiting goes in one piece: it works on
/// its page while the others' are filled. Where the dongle lets a message wait, its buffers are full and the
/// radio carries one message a robot and round (protocol 5.7): then robots take turns message by message.
class MessageTurns {
  public:
    using Taken = std::function<void(Result<void>)>;

    /// Both outlive it.
    MessageTurns(Scheduler& scheduler, MessagePipe& pipe) : scheduler_(scheduler), pipe_(pipe) {}
    ~MessageTurns() { scheduler_.cancel(wake_); }
    MessageTurns(const MessageTurns&) = delete;
    MessageTurns& operator=(const MessageTurns&) = delete;

    /// Queues messages for a robot that has none waiting, in order. `taken` comes once, never from inside
    /// this call: when the dongle has taken the last of them, or with the error of the first that it has not,
    /// after which the others are not sent.
    void push(int robot, const std::vector<wire::MessagePayload>& messages, Taken taken);
    /// Forgets what a robot has waiting; its `taken` does not come any more.
    void drop(int robot);

  private:
    struct Queue {
        std::deque<wire::MessagePayload> waiting;
        Taken taken;
        std::uint64_t batch = 0;  ///< Tells what the pipe says of an earlier batch from this one.
    };

    void wakeSoon();
    void handNext();
    int choose() const;
    void messageTaken(int robot, std::uint64_t batch, TimePoint handed, Result<void> result);
    Queue& queueOf(int robot) { return queues_[static_cast<std::size_t>(robot)]; }
    const Queue& queueOf(int robot) const { return queues_[static_cast<std::size_t>(robot)]; }

    Scheduler& scheduler_;
    MessagePipe& pipe_;
    std::array<Queue, kRobots> queues_;
    TimerId wake_ = 0;
    int turn_ = 0;          ///< The robot whose message went last.
    bool handed_ = false;   ///< The pipe has one of ours.
    bool promptly_ = true;  ///< The dongle took the last one without letting it wait.
};

}  // namespace kickstand::thunderbots
