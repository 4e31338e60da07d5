#include "core/link/paced/paced_byte_link.h"

#include <chrono>
#include <utility>

namespace kickstand {
namespace {

/// How long close() lets what waits be sent.
constexpr Duration kLinger = std::chrono::milliseconds(200);
/// A device that sends more than the line can carry finds it full from here on, and loses what it sends.
constexpr std::size_t kBuffered = 4096;

tl::unexpected<Error> failAt(Errc code, const std::string& port) {
    Error error;
    error.code = code;
    error.port = port;
    return fail(std::move(error));
}

}  // namespace

PacedByteLink::PacedByteLink(Scheduler& scheduler, ByteDeviceModel& model, PacedLineOptions options)
    : scheduler_(scheduler),
      model_(model),
      options_(std::move(options)),
      faults_(options_.faults),
      toDevice_(scheduler, [this](ByteView bytes) { reachedDevice(bytes); }),
      toHost_(scheduler, [this](ByteView bytes) {
          // A copy, because the receiver may destroy this link.
          if (const auto receiver = receiver_; receiver && state_ == State::Open) receiver(bytes);
      }) {
    model_.setListener(this);
}

PacedByteLink::~PacedByteLink() {
    alive_.reset();
    scheduler_.cancel(closingTimer_);
    model_.setListener(nullptr);
    releaseLine();
}

void PacedByteLink::releaseLine() {
    if (std::exchange(lineOpen_, false) && model_.attached()) model_.lineClosed();
}

void PacedByteLink::post(std::function<void()> callback) {
    scheduler_.post([alive = std::weak_ptr(alive_), callback = std::move(callback)] {
        if (!alive.expired()) callback();
    });
}

void PacedByteLink::open(std::function<void(Result<ByteLinkInfo>)> done) {
    if (state_ != State::Closed)
        return post([done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
    state_ = State::Opening;
    done_ = std::move(done);
    post([this, opening = ++opening_] {
        if (state_ == State::Opening && opening == opening_) opened();
    });
}

void PacedByteLink::opened() {
    const auto done = std::exchange(done_, nullptr);
    if (!model_.attached()) {
        state_ = State::Closed;
        return done(failAt(Errc::NoDevice, options_.port));
    }
    state_ = State::Open;
    toDevice_.setBitRate(options_.baud);
    toHost_.setBitRate(options_.baud);
    lineOpen_ = true;
    model_.lineOpened(options_.baud);
    done(ByteLinkInfo{options_.port, options_.description, options_.baud});
}

void PacedByteLink::close(std::function<void()> done) {
    if (!done) done = [] {};
    if (state_ == State::Closed) return post(std::move(done));
    closers_.push_back(std::move(done));
    if (state_ == State::Opening) {
        post([opened = std::exchange(done_, nullptr)] { opened(fail(Errc::Cancelled, "link")); });
        state_ = State::Closing;
        post([this] { finishClosing(); });
    } else if (state_ == State::Open) {
        state_ = State::Closing;
        toHost_.clear();
        if (toDevice_.size() == 0)
            post([this] { finishClosing(); });
        else
            closingTimer_ = scheduler_.callAfter(kLinger, [this] { finishClosing(); });
    }
}

void PacedByteLink::finishClosing() {
    if (state_ != State::Closing) return;
    scheduler_.cancel(closingTimer_);
    toDevice_.clear();
    toHost_.clear();
    state_ = State::Closed;
    releaseLine();
    const std::weak_ptr alive(alive_);
    for (const auto& closed : std::exchange(closers_, {})) {
        closed();
        if (alive.expired()) return;
    }
}

Result<void> PacedByteLink::write(ByteView bytes) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    if (bytes.size() > kSendLimit - toDevice_.size()) return fail(Errc::QueueFull, "link");
    toDevice_.push(bytes);
    return {};
}

void PacedByteLink::reachedDevice(ByteView bytes) {
    if (model_.attached()) model_.hostSent(faults_.pass(bytes));
    if (state_ == State::Closing && toDevice_.size() == 0) post([this] { finishClosing(); });
}

void PacedByteLink::setBaud(Baud baud, std::function<void(Result<void>)> done) {
    Result<void> result;
    if (state_ != State::Open) {
        result = fail(Errc::NotConnected, "link");
    } else if (baud == 0) {
        result = fail(Errc::OutOfRange, "baud");
    } else {
        options_.baud = baud;
        toDevice_.setBitRate(baud);
        toHost_.setBitRate(baud);
        model_.lineBaudChanged(baud);
    }
    if (done) {
        post([this, done = std::move(done), result = std::move(result)]() mutable {
            if (result && state_ != State::Open) result = fail(Errc::Cancelled, "link");
            done(std::move(result));
        });
    }
}

void PacedByteLink::setReceiver(std::function<void(ByteView)> receiver) {
    receiver_ = std::move(receiver);
}

void PacedByteLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void PacedByteLink::deviceSent(ByteView bytes) {
    if (state_ == State::Open && toHost_.size() <= kBuffered) toHost_.push(faults_.pass(bytes));
}

void PacedByteLink::attachedChanged(bool attached) {
    if (attached) {
        post([this] {
            if (state_ != State::Closed || !model_.attached()) return;
            if (const auto listener = presence_) listener(true);
        });
    } else if (state_ == State::Opening) {
        state_ = State::Closed;
        post([done = std::exchange(done_, nullptr), port = options_.port] {
            done(failAt(Errc::Disconnected, port));
        });
    } else if (state_ == State::Open) {
        state_ = State::Losing;
        lineOpen_ = false;
        toDevice_.clear();
        toHost_.clear();
        post([this] { lost(); });
    } else if (state_ == State::Closing) {
        post([this] { finishClosing(); });
    }
}

void PacedByteLink::lost() {
    state_ = State::Closed;
    const std::weak_ptr alive(alive_);
    for (const auto& closed : std::exchange(closers_, {})) {
        closed();
        if (alive.expired()) return;
    }
    // Should it be back already, that is told by what attachedChanged() posted after this.
    if (const auto listener = presence_) listener(false);
}

}  // namespace kickstand
