#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tests/unit/link/socket_rig.h"

namespace kickstand::testing {
namespace {

namespace fs = std::filesystem;

class LocalSockets : public SocketsTest {
  protected:
    LocalSockets() {
        std::string pattern = (fs::temp_directory_path() / "kickstand-socket-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
    }
    ~LocalSockets() override {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }

    std::string path() const { return (folder_ / "control").string(); }
    Result<std::unique_ptr<Listener>> listenHere() {
        return sockets_->listenLocal(
            path(), [this](std::unique_ptr<ByteStream> stream) { server_.take(std::move(stream)); });
    }
    void listenLocally() {
        run([this] {
            auto listener = listenHere();
            ASSERT_TRUE(listener) << listener.error().detail;
            listener_ = std::move(*listener);
        });
    }
    void connectHere() {
        run([this] {
            sockets_->connectLocal(path(), kDeadline, [this](auto connected) {
                ASSERT_TRUE(connected) << connected.error().detail;
                client_.take(std::move(*connected));
            });
        });
        ASSERT_TRUE(waitUntil([this] { return client_.stream && server_.stream; }));
    }

    fs::path folder_;
};

TEST_F(LocalSockets, BytesArriveBothWays) {
    listenLocally();
    connectHere();
    run([&] {
        EXPECT_EQ(listener_->port(), 0);
        client_.stream->send(pattern(100'000));
        server_.stream->send(pattern(500));
    });
    ASSERT_TRUE(
        waitUntil([&] { return server_.received.size() == 100'000 && client_.received.size() == 500; }));
    run([&] {
        EXPECT_EQ(server_.received, pattern(100'000));
        EXPECT_EQ(client_.received, pattern(500));
        server_.stream.reset();
    });
    ASSERT_TRUE(waitUntil([&] { return client_.closed.has_value(); }));
    run([&] { EXPECT_EQ(client_.closed->code, Errc::Disconnected); });
}

TEST_F(LocalSockets, OnlyItsOwnerMayOpenIt) {
    listenLocally();
    EXPECT_EQ(fs::status(path()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(LocalSockets, TheFileGoesWithTheListener) {
    listenLocally();
    EXPECT_TRUE(fs::exists(path()));
    run([&] { listener_.reset(); });
    EXPECT_FALSE(fs::exists(path()));
    const Error error =
        connectInVain([&](auto done) { sockets_->connectLocal(path(), kDeadline, std::move(done)); });
    EXPECT_EQ(error.code, Errc::NoDevice);
    EXPECT_EQ(error.subject, path());
}

TEST_F(LocalSockets, WhatADeadProgramLeftIsReplaced) {
    listenLocally();
    // A socket whose program ended without a word: its file under the name of the next.
    fs::create_hard_link(path(), folder_ / "left");
    run([&] { listener_.reset(); });
    fs::rename(folder_ / "left", path());
    const Error error =
        connectInVain([&](auto done) { sockets_->connectLocal(path(), kDeadline, std::move(done)); });
    EXPECT_EQ(error.code, Errc::NoDevice);
    listenLocally();
    connectHere();
}

TEST_F(LocalSockets, OneThatIsServedIsNotReplaced) {
    listenLocally();
    run([&] {
        const auto second = listenHere();
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().code, Errc::ClaimedElsewhere);
    });
    connectHere();
}

TEST_F(LocalSockets, AFileThatIsNoSocketIsLeftAlone) {
    std::ofstream(path()) << "mine";
    run([&] {
        const auto listener = listenHere();
        ASSERT_FALSE(listener);
        EXPECT_EQ(listener.error().code, Errc::ClaimedElsewhere);
    });
    EXPECT_EQ(fs::file_size(path()), 4U);
}

TEST_F(LocalSockets, PathsThatNoSocketCanHaveAreRefused) {
    const std::string tooLong = (folder_ / std::string(200, 'x')).string();
    run([&] {
        const auto listener = sockets_->listenLocal(tooLong, [](auto) {});
        ASSERT_FALSE(listener);
        EXPECT_EQ(listener.error().code, Errc::OutOfRange);
        EXPECT_EQ(listener.error().got, static_cast<std::int64_t>(tooLong.size()));
        EXPECT_EQ(sockets_->listenLocal("", [](auto) {}).error().code, Errc::BadArgument);
        EXPECT_FALSE(sockets_->listenLocal((folder_ / "no" / "such").string(), [](auto) {}));
    });
    const Error error =
        connectInVain([&](auto done) { sockets_->connectLocal(tooLong, kDeadline, std::move(done)); });
    EXPECT_EQ(error.code, Errc::OutOfRange);
}

}  // namespace
}  // namespace kickstand::testing
