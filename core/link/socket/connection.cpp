#include "core/link/socket/connection.h"

#include <utility>

#include <asio/buffer.hpp>

namespace kickstand::socket {
namespace {

/// How long a peer may take nothing before what it was sent is given up.
constexpr auto kPatience = std::chrono::seconds(1);

class SocketStream final : public ByteStream {
  public:
    explicit SocketStream(ConnectionPointer connection) : connection_(std::move(connection)) {}
    ~SocketStream() override { closeOnce(); }
    SocketStream(const SocketStream&) = delete;
    SocketStream& operator=(const SocketStream&) = delete;

    void start(Events events) override {
        if (receiver_ || closed_) return;
        receiver_ = std::make_shared<Receiver>(Receiver{std::move(events)});
        connection_->start(receiver_);
    }
    void send(ByteView bytes) override {
        if (!closed_ && !bytes.empty()) connection_->send(bytes);
    }
    std::size_t unsent() const override { return connection_->unsent(); }
    void close() override { closeOnce(); }

  private:
    void closeOnce() {
        if (std::exchange(closed_, true)) return;
        if (receiver_) receiver_->silent = true;
        connection_->close();
    }

    const ConnectionPointer connection_;
    std::shared_ptr<Receiver> receiver_;
    bool closed_ = false;
};

}  // namespace

Connection::Connection(IoCorePointer core, Protocol::socket connected)
    : core_(std::move(core)), socket_(std::move(connected)), patience_(core_->io) {}

void Connection::begin() {
    core_->tasks.insert(shared_from_this());
}

void Connection::abandon() {
    closing_ = true;
    end();
}

// ---- The scheduler's thread.

void Connection::start(std::weak_ptr<Receiver> receiver) {
    receiver_ = std::move(receiver);
    core_->post([self = shared_from_this()] { self->read(); });
}

void Connection::send(ByteView bytes) {
    unsent_ += bytes.size();
    core_->post([self = shared_from_this(), copy = std::vector<std::uint8_t>(bytes.begin(), bytes.end())] {
        self->append(copy);
    });
}

void Connection::close() {
    core_->post([self = shared_from_this()] { self->beginClosing(); });
}

void Connection::deliver(std::size_t size) {
    const auto receiver = receiver_.lock();
    if (!receiver || receiver->silent || core_->over) return;
    receiver->events.received(ByteView(piece_).first(size));
    if (!receiver->silent) core_->post([self = shared_from_this()] { self->read(); });
}

void Connection::tellEnd(const Error& error) {
    const auto receiver = receiver_.lock();
    if (!receiver || core_->over || std::exchange(receiver->silent, true)) return;
    receiver->events.closed(error);
}

// ---- The sockets' thread.

void Connection::read() {
    if (ended_ || closing_) return;
    reading_ = true;
    socket_.async_read_some(asio::buffer(piece_),
                            [self = shared_from_this()](const std::error_code& code, std::size_t size) {
                                self->pieceRead(code, size);
                            });
}

void Connection::pieceRead(const std::error_code& code, std::size_t size) {
    reading_ = false;
    if (ended_) return;
    if (closing_) return drain();
    if (!code) return core_->mailbox.post([self = shared_from_this(), size] { self->deliver(size); });
    end();
    core_->mailbox.post(
        [self = shared_from_this(), error = toError(code, "connection")] { self->tellEnd(error); });
}

void Connection::append(const std::vector<std::uint8_t>& bytes) {
    if (ended_ || broken_) {
        unsent_ -= bytes.size();
        return;
    }
    waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
    if (writing_) return;
    writing_ = true;
    write();
}

void Connection::write() {
    if (sent_ == sending_.size()) {
        sending_.clear();
        sending_.swap(waiting_);
        sent_ = 0;
    }
    socket_.async_write_some(asio::buffer(sending_.data() + sent_, sending_.size() - sent_),
                             [self = shared_from_this()](const std::error_code& code, std::size_t size) {
                                 self->pieceWritten(code, size);
                             });
}

void Connection::pieceWritten(const std::error_code& code, std::size_t size) {
    if (ended_) return;
    if (code) {
        // What the peer sent before it went is still to be read; then the reader finds the end too.
        writing_ = false;
        broken_ = true;
        loseUnsent();
        if (closing_) end();
        return;
    }
    sent_ += size;
    unsent_ -= size;
    if (closing_) linger();
    if (sent_ < sending_.size() || !waiting_.empty()) return write();
    writing_ = false;
    if (closing_) drain();
}

void Connection::loseUnsent() {
    unsent_ -= sending_.size() - sent_ + waiting_.size();
    sending_.clear();
    waiting_.clear();
    sent_ = 0;
}

void Connection::beginClosing() {
    if (ended_ || closing_) return;
    closing_ = true;
    if (broken_) return end();
    linger();
    if (!writing_) drain();
}

void Connection::linger() {
    patience_.expires_after(kPatience);
    patience_.async_wait([self = shared_from_this()](const std::error_code& code) {
        if (!code) self->end();
    });
}

/// Everything is sent. A socket that is closed with bytes unread may take back what the peer has not read
/// yet, so the peer is told that this is the end and heard out until it is.
void Connection::drain() {
    if (ended_ || writing_) return;
    std::error_code ignored;
    socket_.shutdown(Protocol::socket::shutdown_send, ignored);
    if (std::exchange(reading_, true)) return;
    socket_.async_read_some(asio::buffer(drained_),
                            [self = shared_from_this()](const std::error_code& code, std::size_t) {
                                self->reading_ = false;
                                if (code) return self->end();
                                self->drain();
                            });
}

void Connection::end() {
    if (std::exchange(ended_, true)) return;
    std::error_code ignored;
    socket_.close(ignored);
    patience_.cancel();
    loseUnsent();
    core_->tasks.erase(shared_from_this());
}

std::unique_ptr<ByteStream> makeStream(ConnectionPointer connection) {
    return std::make_unique<SocketStream>(std::move(connection));
}

}  // namespace kickstand::socket
