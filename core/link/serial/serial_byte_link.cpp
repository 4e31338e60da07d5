#include "core/link/serial/serial_byte_link.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/link/serial/serial_port.h"

namespace kickstand {
namespace {

/// The caller's side of a serial port. What the port's thread says is posted to the scheduler, and void once
/// the link is gone.
class SerialByteLink final : public ByteLink {
  public:
    SerialByteLink(Scheduler& scheduler, std::string port, Baud baud)
        : scheduler_(scheduler), baud_(baud), port_(std::move(port), events()) {}
    ~SerialByteLink() override { alive_.reset(); }
    SerialByteLink(const SerialByteLink&) = delete;
    SerialByteLink& operator=(const SerialByteLink&) = delete;

    void open(std::function<void(Result<ByteLinkInfo>)> done) override;
    void close(std::function<void()> done) override;
    Result<void> write(ByteView bytes) override;
    std::size_t waiting() const override { return waiting_; }
    void setBaud(Baud baud, std::function<void(Result<void>)> done) override;
    void setReceiver(std::function<void(ByteView)> receiver) override { receiver_ = std::move(receiver); }
    void setPresenceListener(std::function<void(bool)> listener) override { presence_ = std::move(listener); }

  private:
    enum class State : std::uint8_t { Closed, Opening, Open, Closing };

    serial::PortEvents events();
    void opened(Result<ByteLinkInfo> info);
    void received(ByteView bytes);
    void lost();
    void closed();
    void tellPresence(bool present);
    /// Any thread.
    void post(std::function<void()> callback);

    Scheduler& scheduler_;
    Baud baud_;
    State state_ = State::Closed;
    std::function<void(Result<ByteLinkInfo>)> opened_;
    std::vector<std::function<void()>> closers_;
    std::function<void(ByteView)> receiver_;
    std::function<void(bool)> presence_;
    std::size_t waiting_ = 0;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    const std::weak_ptr<const bool> observedAlive_ = alive_;
    // Last, so that its thread ends before what it posts to.
    serial::Port port_;
};

serial::PortEvents SerialByteLink::events() {
    serial::PortEvents events;
    events.opened = [this](Result<ByteLinkInfo> info) {
        post([this, info = std::move(info)] { opened(info); });
    };
    events.received = [this](std::vector<std::uint8_t> bytes) {
        post([this, bytes = std::move(bytes)] { received(bytes); });
    };
    events.sent = [this](std::size_t bytes) {
        post([this, bytes] { waiting_ -= std::min(bytes, waiting_); });
    };
    events.lost = [this] { post([this] { lost(); }); };
    events.closed = [this] { post([this] { closed(); }); };
    events.appeared = [this] {
        post([this] {
            if (state_ == State::Closed) tellPresence(true);
        });
    };
    return events;
}

void SerialByteLink::post(std::function<void()> callback) {
    scheduler_.post([alive = observedAlive_, callback = std::move(callback)] {
        if (!alive.expired()) callback();
    });
}

void SerialByteLink::open(std::function<void(Result<ByteLinkInfo>)> done) {
    if (state_ != State::Closed)
        return post([done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
    state_ = State::Opening;
    opened_ = std::move(done);
    port_.open(baud_);
}

void SerialByteLink::opened(Result<ByteLinkInfo> info) {
    if (state_ != State::Opening) return;  // Closed meanwhile; the closing follows.
    state_ = info ? State::Open : State::Closed;
    waiting_ = 0;
    std::exchange(opened_, nullptr)(std::move(info));
}

void SerialByteLink::close(std::function<void()> done) {
    if (!done) done = [] {};
    if (state_ == State::Closed) return post(std::move(done));
    closers_.push_back(std::move(done));
    if (state_ == State::Closing) return;
    if (state_ == State::Opening)
        post([opened = std::exchange(opened_, nullptr)] { opened(fail(Errc::Cancelled, "link")); });
    state_ = State::Closing;
    port_.close();
}

Result<void> SerialByteLink::write(ByteView bytes) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    if (bytes.size() > kSendLimit - waiting_) return fail(Errc::QueueFull, "link");
    waiting_ += bytes.size();
    port_.write({bytes.begin(), bytes.end()});
    return {};
}

void SerialByteLink::received(ByteView bytes) {
    port_.taken(bytes.size());
    // A copy, because the receiver may destroy this link.
    if (const auto receiver = receiver_; receiver && state_ == State::Open) receiver(bytes);
}

void SerialByteLink::setBaud(Baud baud, std::function<void(Result<void>)> done) {
    if (!done) done = [](const Result<void>&) {};
    if (state_ != State::Open)
        return post([done = std::move(done)] { done(fail(Errc::NotConnected, "link")); });
    if (baud == 0 || baud > static_cast<Baud>(std::numeric_limits<int>::max()))
        return post([done = std::move(done)] { done(fail(Errc::OutOfRange, "baud")); });
    port_.setBaud(baud, [this, baud, done = std::move(done)](Result<void> result) {
        post([this, baud, done, result = std::move(result)]() mutable {
            if (result && state_ != State::Open) result = fail(Errc::Cancelled, "link");
            if (result) baud_ = baud;
            done(std::move(result));
        });
    });
}

void SerialByteLink::lost() {
    waiting_ = 0;
    if (state_ == State::Closing) return;  // The closing that was asked for follows.
    state_ = State::Closed;
    tellPresence(false);
}

void SerialByteLink::closed() {
    state_ = State::Closed;
    waiting_ = 0;
    const std::weak_ptr alive(alive_);
    for (const auto& done : std::exchange(closers_, {})) {
        done();
        if (alive.expired()) return;
    }
}

void SerialByteLink::tellPresence(bool present) {
    // A copy, because the listener may destroy this link.
    if (const auto listener = presence_) listener(present);
}

}  // namespace

std::unique_ptr<ByteLink> makeSerialByteLink(Scheduler& scheduler, std::string port, Baud baud) {
    return std::make_unique<SerialByteLink>(scheduler, std::move(port), baud);
}

}  // namespace kickstand
