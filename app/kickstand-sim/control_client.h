#pragma once

#include <QJsonObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "app/kickstand-sim/line_reader.h"
#include "app/kickstandctl/failure.h"
#include "app/kickstandctl/interruption.h"
#include "core/base/thread_scheduler.h"
#include "core/link/socket/sockets.h"

namespace kickstand::sim {

/// The other end of a control socket: asks, waits for the answer. Main thread.
class ControlClient {
  public:
    /// The most that an answer may be long, in bytes.
    static constexpr std::size_t kMaxAnswerBytes = std::size_t{4} << 20;

    /// `interruption` ends every wait, and must outlive it.
    explicit ControlClient(ctl::Interruption& interruption) : interruption_(interruption) {}
    ~ControlClient();
    ControlClient(const ControlClient&) = delete;
    ControlClient& operator=(const ControlClient&) = delete;

    /// Connects to the simulator whose control socket is at `path`.
    ctl::Outcome connect(const std::string& path);
    /// Sends a request and waits for its answer, which has "ok": true; a refusal is a Failure.
    ctl::Expected<QJsonObject> ask(const QJsonObject& request);

  private:
    /// Waits until `ready` holds, which is asked under the lock. Not longer than `limit`, and not when
    /// somebody wants the program to end.
    bool waitFor(std::unique_lock<std::mutex>& lock, const std::function<bool()>& ready, Duration limit);
    void connected(Result<std::unique_ptr<ByteStream>> stream);
    void received(ByteView bytes);
    void ended();

    ctl::Interruption& interruption_;
    ThreadScheduler scheduler_;
    // On the scheduler's thread.
    std::unique_ptr<Sockets> sockets_;
    std::unique_ptr<ByteStream> stream_;
    LineReader lines_{kMaxAnswerBytes};

    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<Result<void>> connected_;
    std::deque<std::string> answers_;
    bool ended_ = false;
};

}  // namespace kickstand::sim
