#pragma once

#include <atomic>
#include <memory>
#include <set>
#include <string>
#include <system_error>

#include <asio/executor_work_guard.hpp>
#include <asio/generic/stream_protocol.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>

#include "core/base/error.h"
#include "core/link/socket/mailbox.h"

namespace kickstand::socket {

using Protocol = asio::generic::stream_protocol;

/// Whatever waits for the operating system on the sockets' thread.
class IoTask {
  public:
    virtual ~IoTask() = default;
    /// Ends at once and calls nobody back. The sockets' thread.
    virtual void abandon() = 0;
};

/// What the sockets of one Sockets share. It lives as long as the last of them.
struct IoCore {
    explicit IoCore(Scheduler& scheduler) : mailbox(scheduler) {}

    /// Does something on the sockets' thread; nothing once that is over. The scheduler's thread.
    template <class Action>
    void post(Action&& action) {
        if (!over) asio::post(io, std::forward<Action>(action));
    }

    asio::io_context io{1};
    Mailbox mailbox;
    std::set<std::shared_ptr<IoTask>>
        tasks;  ///< The sockets' thread: all that has to be abandoned at the end.
    std::atomic<bool> over{false};
};
using IoCorePointer = std::shared_ptr<IoCore>;

/// What the operating system said, as an error of this project: NoDevice where nobody is there,
/// PermissionDenied, ClaimedElsewhere for an address in use, Disconnected, TimedOut, or Io. Any thread.
Error toError(const std::error_code& code, std::string subject);

}  // namespace kickstand::socket
