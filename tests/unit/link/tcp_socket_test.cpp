#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "tests/unit/link/socket_rig.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;

using TcpSockets = SocketsTest;

/// A server whose queue of connections is full: whoever connects now waits.
class FullServer {
  public:
    FullServer() {
        ::sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        ::socklen_t size = sizeof address;
        auto* const plain = reinterpret_cast<::sockaddr*>(&address);
        const int server = open();
        EXPECT_EQ(::bind(server, plain, size), 0);
        EXPECT_EQ(::listen(server, 0), 0);
        EXPECT_EQ(::getsockname(server, plain, &size), 0);
        port_ = ntohs(address.sin_port);
        for (int i = 0; i < 4; ++i)
            static_cast<void>(::connect(open(), plain, size));
    }
    ~FullServer() {
        for (const int socket : sockets_)
            ::close(socket);
    }
    FullServer(const FullServer&) = delete;
    FullServer& operator=(const FullServer&) = delete;

    std::uint16_t port() const { return port_; }

  private:
    int open() { return sockets_.emplace_back(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0)); }

    std::vector<int> sockets_;
    std::uint16_t port_ = 0;
};

TEST_F(TcpSockets, BytesArriveBothWaysInOrder) {
    connect();
    const Bytes there = pattern(300'000);
    const Bytes back = pattern(70'001);
    run([&] {
        // In pieces of any size, an empty one among them.
        for (std::size_t at = 0, size = 0; at < there.size(); at += size) {
            size = std::min(there.size() - at, at % 4001 + 1);
            client_.stream->send(ByteView(there).subspan(at, size));
            client_.stream->send({});
        }
        server_.stream->send(back);
    });
    ASSERT_TRUE(waitUntil(
        [&] { return server_.received.size() >= there.size() && client_.received.size() >= back.size(); }));
    run([&] {
        EXPECT_EQ(server_.received, there);
        EXPECT_EQ(client_.received, back);
        EXPECT_FALSE(server_.closed || client_.closed);
    });
    ASSERT_TRUE(waitUntil([&] { return client_.stream->unsent() == 0; }));
}

TEST_F(TcpSockets, WhatCameBeforeTheStartIsKept) {
    std::unique_ptr<ByteStream> waiting;
    run([&] {
        auto listener = sockets_->listenTcp(
            "127.0.0.1", 0, [&](std::unique_ptr<ByteStream> stream) { waiting = std::move(stream); });
        ASSERT_TRUE(listener);
        listener_ = std::move(*listener);
        sockets_->connectTcp("127.0.0.1", listener_->port(), kDeadline, [this](auto connected) {
            ASSERT_TRUE(connected);
            client_.take(std::move(*connected));
            client_.stream->send(pattern(5));
            client_.stream->close();
        });
    });
    ASSERT_TRUE(waitUntil([&] { return waiting != nullptr && client_.stream; }));
    run([&] { server_.take(std::move(waiting)); });
    ASSERT_TRUE(waitUntil([&] { return server_.closed.has_value(); }));
    run([&] { EXPECT_EQ(server_.received, pattern(5)); });
}

TEST_F(TcpSockets, ANameIsLookedUp) {
    const std::uint16_t port = listen();
    run([&] {
        sockets_->connectTcp("localhost", port, kDeadline, [this](auto connected) {
            ASSERT_TRUE(connected) << connected.error().detail;
            client_.take(std::move(*connected));
        });
    });
    ASSERT_TRUE(waitUntil([&] { return client_.stream && server_.stream; }));
}

TEST_F(TcpSockets, NobodyListensThere) {
    const std::uint16_t port = listen();
    run([&] { listener_.reset(); });
    // The port is free once the sockets' thread has closed it, which it does in its turn before it connects.
    const Error error = connectInVain(
        [&](auto done) { sockets_->connectTcp("127.0.0.1", port, kDeadline, std::move(done)); });
    EXPECT_EQ(error.code, Errc::NoDevice);
    EXPECT_EQ(error.subject, "127.0.0.1:" + std::to_string(port));
    EXPECT_FALSE(error.detail.empty());
}

TEST_F(TcpSockets, AnUnknownNameIsNobody) {
    // No label of a name may be so long: nobody is asked about it.
    const std::string name = std::string(70, 'x') + ".invalid";
    const Error error =
        connectInVain([&](auto done) { sockets_->connectTcp(name, 1, kDeadline, std::move(done)); });
    EXPECT_EQ(error.code, Errc::NoDevice) << error.detail;
}

TEST_F(TcpSockets, TheDeadlineEndsAnAttempt) {
    const FullServer server;
    const Error error = connectInVain(
        [&](auto done) { sockets_->connectTcp("127.0.0.1", server.port(), 50ms, std::move(done)); });
    EXPECT_EQ(error.code, Errc::TimedOut);
}

TEST_F(TcpSockets, APortInUseIsClaimed) {
    const std::uint16_t port = listen();
    run([&] {
        const auto second = sockets_->listenTcp("127.0.0.1", port, [](auto) {});
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().code, Errc::ClaimedElsewhere);
    });
}

TEST_F(TcpSockets, OnlyAddressesCanBeListenedAt) {
    run([&] {
        for (const char* address : {"", "localhost", "127.0.0", "1.2.3.4.5", "[::1]"}) {
            const auto listener = sockets_->listenTcp(address, 0, [](auto) {});
            ASSERT_FALSE(listener) << address;
            EXPECT_EQ(listener.error().code, Errc::BadArgument) << address;
        }
        // An address for documentation alone, which no machine has.
        EXPECT_FALSE(sockets_->listenTcp("192.0.2.1", 0, [](auto) {}));
    });
}

TEST_F(TcpSockets, ThePeersClosingIsToldOnce) {
    connect();
    run([&] { server_.stream->close(); });
    ASSERT_TRUE(waitUntil([&] { return client_.closed.has_value(); }));
    run([&] {
        EXPECT_EQ(client_.closed->code, Errc::Disconnected);
        EXPECT_FALSE(server_.closed) << "told of its own closing";
        client_.stream->send(pattern(10));
        client_.stream->close();
    });
}

TEST_F(TcpSockets, WhatIsQueuedAtTheClosingStillArrives) {
    connect();
    const Bytes bytes = pattern(2'000'000);
    run([&] {
        client_.stream->send(bytes);
        client_.stream->close();
        client_.stream->send(Bytes{1, 2, 3});
    });
    ASSERT_TRUE(waitUntil([&] { return server_.closed.has_value(); }));
    run([&] { EXPECT_EQ(server_.received, bytes); });
}

TEST_F(TcpSockets, UnreadBytesDoNotTakeBackTheLastOnesSent) {
    connect();
    const Bytes bytes = pattern(100'000);
    run([&] {
        server_.stream->send(pattern(50'000));
        client_.stream->send(bytes);
        client_.stream.reset();
    });
    ASSERT_TRUE(waitUntil([&] { return server_.closed.has_value(); }));
    run([&] { EXPECT_EQ(server_.received, bytes); });
}

TEST_F(TcpSockets, APeerThatTakesNothingIsGivenUp) {
    std::unique_ptr<ByteStream> deaf;
    run([&] {
        auto listener = sockets_->listenTcp(
            "127.0.0.1", 0, [&](std::unique_ptr<ByteStream> stream) { deaf = std::move(stream); });
        ASSERT_TRUE(listener);
        listener_ = std::move(*listener);
        sockets_->connectTcp("127.0.0.1", listener_->port(), kDeadline, [this](auto connected) {
            ASSERT_TRUE(connected);
            client_.take(std::move(*connected));
            client_.stream->send(pattern(40'000'000));
            client_.stream->close();
        });
    });
    ASSERT_TRUE(waitUntil([&] { return deaf != nullptr && client_.stream; }));
    // More than any system keeps for a connection, and nobody reads: it is given up after a second.
    std::function<void()> look = [&] {
        if (client_.stream->unsent() > 0) scheduler_.callAfter(10ms, look);
    };
    run(look);
    EXPECT_TRUE(waitUntil([&] { return client_.stream->unsent() == 0; }));
    run([&] { deaf.reset(); });
}

TEST_F(TcpSockets, AFloodIsReadPieceByPiece) {
    connect();
    constexpr std::size_t kFlood = 8'000'000;
    constexpr std::size_t kLongestPiece = 65536;
    std::size_t longest = 0;
    run([&] {
        client_.read = [&](ByteView bytes) { longest = std::max(longest, bytes.size()); };
        server_.stream->send(pattern(kFlood));
    });
    ASSERT_TRUE(waitUntil([&] { return client_.received.size() == kFlood; }));
    run([&] {
        EXPECT_EQ(client_.received, pattern(kFlood));
        EXPECT_LE(longest, kLongestPiece);
    });
}

TEST_F(TcpSockets, AReaderMayDestroyItsStreamWhileItReads) {
    connect();
    int calls = 0;
    run([&] {
        client_.read = [&](ByteView) {
            ++calls;
            client_.stream.reset();
        };
        server_.stream->send(pattern(100'000));
    });
    ASSERT_TRUE(waitUntil([&] { return server_.closed.has_value(); }));
    run([&] {
        EXPECT_EQ(calls, 1);
        EXPECT_FALSE(client_.closed);
    });
}

TEST_F(TcpSockets, WhateverIsUnderWayTheEndIsSilent) {
    connect();
    bool called = false;
    run([&] {
        server_.stream->send(pattern(1'000'000));
        for (int i = 0; i < 20; ++i)
            sockets_->connectTcp("127.0.0.1", listener_->port(), kDeadline,
                                 [&](const auto&) { called = true; });
        sockets_->connectTcp("localhost", listener_->port(), kDeadline, [&](const auto&) { called = true; });
        sockets_.reset();
        client_.stream->send(pattern(10));
        client_.received.clear();
    });
    run([] {});
    run([&] {
        EXPECT_FALSE(called);
        EXPECT_TRUE(client_.received.empty());
        EXPECT_FALSE(client_.closed || server_.closed);
    });
}

}  // namespace
}  // namespace kickstand::testing
