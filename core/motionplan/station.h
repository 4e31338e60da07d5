#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>

#include "core/motionplan/exchange.h"
#include "core/motionplan/snapshot.h"
#include "core/motionplan/wire/telegram_parser.h"

namespace kickstand::motionplan {

/// The host's side of the mailboxes: reads what the robot puts out, one read at a time, and carries one
/// exchange after another (protocol 6). Told when bytes come and when time passes. Engine thread.
class Station {
  public:
    using Done = std::function<void(const Exchange&)>;

    /// What it is told and asked. All set, all outlive it.
    struct Hooks {
        std::function<Result<void>(ByteView)> write;
        /// Whether a message may leave now: STOP, and what has changed while it waited, is looked at here, at
        /// the last moment. The error is what it ends with.
        std::function<Result<void>(const wire::Message&)> maySend;
        /// Every message that the robot has put out, expected or not, but no doubled error. `belonged`: to
        /// the exchange.
        std::function<void(const wire::Message&, bool belonged)> message;
        /// What a mailbox held that is no message.
        std::function<void(const Error&)> malformed;
        std::function<void(std::uint8_t status)> nxtStatus;
        /// The NXT answers again (0), or has left this many reads in a row unanswered.
        std::function<void(int missed)> answering;
    };

    // How long a read may take, how often the outbox is looked at while something is expected and while
    // nothing is, and after how many unanswered reads the robot counts as silent (protocol 6.1).
    static constexpr Duration kReadLimit = std::chrono::seconds(1);
    static constexpr Duration kBusyPoll = std::chrono::milliseconds(60);
    static constexpr Duration kIdlePoll = std::chrono::milliseconds(250);
    static constexpr int kSilentAfter = 3;
    /// An error that comes again so soon, unasked, is the same one doubled on its way.
    static constexpr Duration kDoubledWithin = std::chrono::seconds(2);
    static constexpr std::size_t kQueue = 32;

    explicit Station(Hooks hooks) : hooks_(std::move(hooks)) {}

    /// The line has been opened, or is gone: what waits ends with `why`, and nothing is left of before.
    void reset(Errc why);
    /// Queues a request. QueueFull, and `done` never comes.
    Result<void> submit(Exchange::Request request, Done done);
    /// Everything that waits ends with `why`, and Stop goes out before this returns.
    void stopNow(TimePoint now, Errc why, Done done);
    /// Bytes from the robot.
    void received(ByteView bytes, TimePoint now);
    /// To be called every 10 ms or so while the line is open. `busy`: a status is expected.
    void tick(TimePoint now, bool busy);

    bool idle() const { return current_ == nullptr && queue_.empty(); }
    std::optional<RequestState> request() const;
    TrafficCounters traffic() const;

  private:
    struct Waiting {
        Exchange::Request request;
        Done done;
    };

    void take(const wire::Telegram& telegram, TimePoint now);
    void take(const wire::ReadReply& reply, TimePoint now);
    void takeCommandBox(ByteView content, TimePoint now);
    void begin(Waiting waiting, TimePoint now);
    void pump(TimePoint now);
    void writeMessage(const wire::Message& message);
    void endCurrent();
    void endAll(Errc why);
    void read(TimePoint now);
    bool isLate(ByteView bytes) const;
    bool isDoubled(int error, bool belonged, TimePoint now);

    Hooks hooks_;
    wire::TelegramParser parser_;
    std::unique_ptr<Exchange> current_;
    Done currentDone_;
    TimePoint currentSince_{};
    std::deque<Waiting> queue_;
    std::deque<wire::MessageBytes> sent_;  ///< The newest, to know late copies by.
    std::optional<TimePoint> readAt_;      ///< Of the read that is under way.
    bool readTriggerBox_ = false;
    std::optional<int> lastError_;  ///< That was told.
    TimePoint lastErrorAt_{};
    TimePoint nextRead_{};
    bool busy_ = false;
    int missed_ = 0;
    bool drained_ = false;  ///< The command outbox was empty once: what it holds is of this connection.
    TrafficCounters counters_;
};

}  // namespace kickstand::motionplan
