#pragma once

#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "core/link/socket/sockets.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {

using Bytes = std::vector<std::uint8_t>;

/// One end of a connection, and what its owner has heard of it. On the scheduler's thread.
struct StreamEnd {
    std::unique_ptr<ByteStream> stream;
    Bytes received;
    std::optional<Error> closed;
    std::function<void(ByteView)> read;  ///< Called with every piece, where it is set.

    void take(std::unique_ptr<ByteStream> made) {
        stream = std::move(made);
        stream->start({.received = [this](ByteView bytes) { piece(bytes); },
                       .closed = [this](const Error& error) { closed = error; }});
    }

  private:
    void piece(ByteView bytes) {
        received.insert(received.end(), bytes.begin(), bytes.end());
        if (read) read(bytes);
    }
};

/// Sockets on a real scheduler, a listener at a free port of this machine, and two ends of a connection.
class SocketsTest : public ::testing::Test {
  protected:
    SocketsTest() {
        run([this] { sockets_ = std::make_unique<Sockets>(scheduler_); });
    }
    ~SocketsTest() override {
        run([this] {
            server_.stream.reset();
            client_.stream.reset();
            listener_.reset();
            sockets_.reset();
        });
    }

    void run(const std::function<void()>& action) { scheduler_.run(action); }
    [[nodiscard]] bool waitUntil(const std::function<bool()>& done) { return scheduler_.waitUntil(done); }

    /// Gives the port.
    std::uint16_t listen() {
        std::uint16_t port = 0;
        run([&] {
            auto listener = sockets_->listenTcp("127.0.0.1", 0, [this](std::unique_ptr<ByteStream> stream) {
                server_.take(std::move(stream));
            });
            ASSERT_TRUE(listener) << listener.error().detail;
            listener_ = std::move(*listener);
            port = listener_->port();
        });
        return port;
    }
    /// Connects both ends.
    void connect() {
        const std::uint16_t port = listen();
        run([&] {
            sockets_->connectTcp("127.0.0.1", port, kDeadline, [this](auto connected) {
                ASSERT_TRUE(connected) << connected.error().detail;
                client_.take(std::move(*connected));
            });
        });
        ASSERT_TRUE(waitUntil([this] { return client_.stream && server_.stream; }));
    }
    /// Tries to connect to what is not there.
    Error connectInVain(const std::function<void(Sockets::Connected)>& attempt) {
        std::optional<Error> error;
        run([&] {
            attempt([&](Result<std::unique_ptr<ByteStream>> connected) {
                error = connected ? Error{} : connected.error();
            });
            EXPECT_FALSE(error) << "called back from inside the call";
        });
        EXPECT_TRUE(waitUntil([&] { return error.has_value(); }));
        return *error;
    }

    static constexpr Duration kDeadline = std::chrono::seconds(20);

    WatchedScheduler scheduler_;
    // On the scheduler's thread.
    std::unique_ptr<Sockets> sockets_;
    std::unique_ptr<Listener> listener_;
    StreamEnd server_;
    StreamEnd client_;
};

inline Bytes pattern(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::uint8_t>(i * 7 + i / 251);
    return bytes;
}

}  // namespace kickstand::testing
