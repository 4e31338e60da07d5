#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <vector>

#include <asio/steady_timer.hpp>

#include "core/link/socket/byte_stream.h"
#include "core/link/socket/io_core.h"

namespace kickstand::socket {

/// What a stream's owner wants to hear. The scheduler's thread; gone with the stream.
struct Receiver {
    ByteStream::Events events;
    bool silent = false;  ///< Closed or ended: nothing is told any more.
};

/// One connected socket. It outlives the stream that it serves, until what was queued has been sent.
class Connection final : public IoTask, public std::enable_shared_from_this<Connection> {
  public:
    /// Either thread. Nothing happens before begin().
    Connection(IoCorePointer core, Protocol::socket connected);

    /// The sockets' thread, once.
    void begin();
    void abandon() override;

    // The scheduler's thread.
    void start(std::weak_ptr<Receiver> receiver);
    void send(ByteView bytes);
    void close();

    /// Any thread.
    std::size_t unsent() const { return unsent_; }

  private:
    static constexpr std::size_t kPieceBytes = 16384;

    // The sockets' thread.
    void read();
    void pieceRead(const std::error_code& code, std::size_t size);
    void append(const std::vector<std::uint8_t>& bytes);
    void write();
    void pieceWritten(const std::error_code& code, std::size_t size);
    void loseUnsent();
    void beginClosing();
    void linger();
    void drain();
    void end();

    // The scheduler's thread.
    void deliver(std::size_t size);
    void tellEnd(const Error& error);

    const IoCorePointer core_;
    std::atomic<std::size_t> unsent_{0};
    std::weak_ptr<Receiver> receiver_;               ///< Set before the sockets' thread first uses it.
    std::array<std::uint8_t, kPieceBytes> piece_{};  ///< Of one thread at a time: read, then delivered.

    // The sockets' thread.
    Protocol::socket socket_;
    asio::steady_timer patience_;
    std::array<std::uint8_t, 1024> drained_{};  ///< What comes in while closing, and goes nowhere.
    std::vector<std::uint8_t> waiting_;
    std::vector<std::uint8_t> sending_;
    std::size_t sent_ = 0;  ///< Of `sending_`.
    bool reading_ = false;
    bool writing_ = false;
    bool closing_ = false;
    bool broken_ = false;  ///< The peer takes nothing any more.
    bool ended_ = false;
};
using ConnectionPointer = std::shared_ptr<Connection>;

/// The stream of a connection, for its owner on the scheduler's thread.
std::unique_ptr<ByteStream> makeStream(ConnectionPointer connection);

}  // namespace kickstand::socket
