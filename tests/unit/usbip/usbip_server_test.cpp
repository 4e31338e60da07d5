#include "core/usbip/usbip_server.h"

#include <gtest/gtest.h>

#include "core/link/socket/sockets.h"
#include "tests/support/usb/fake_usb_device.h"
#include "tests/support/usb/watched_scheduler.h"
#include "tests/unit/usbip/usbip_rig.h"

// The server on real sockets of this machine; all waits are for events.

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;
using Device = FakeUsbDevice;
using Status = usbip::TransferStatus;

class ServedOnSockets : public ::testing::Test {
  protected:
    ServedOnSockets() {
        run([this] { sockets_ = std::make_unique<Sockets>(scheduler_); });
    }
    ~ServedOnSockets() override {
        run([this] {
            clients_.clear();
            server_.reset();
            sockets_.reset();
        });
    }
    void run(const std::function<void()>& action) { scheduler_.run(action); }

    /// The error; none where it serves.
    std::optional<Error> serve(UsbipServerOptions options = {.port = 0}) {
        std::optional<Error> error;
        run([&] {
            auto served = UsbipServer::serve(scheduler_, {{"1-1", &device_}}, options);
            if (served) {
                server_ = std::move(*served);
            } else {
                error = served.error();
            }
        });
        return error;
    }
    UsbipServerReport report() {
        UsbipServerReport report;
        run([&] { report = server_->report(); });
        return report;
    }
    RawClient* connect() {
        RawClient* client = nullptr;
        run([&] {
            sockets_->connectTcp("127.0.0.1", server_->port(), 20s, [&](auto connected) {
                ASSERT_TRUE(connected) << connected.error().detail;
                client = &clients_.emplace_back(scheduler_, std::move(*connected));
                client->read();
            });
        });
        EXPECT_TRUE(scheduler_.waitUntil([&] { return client != nullptr; }));
        return client;
    }
    usbip::OpStatus import(RawClient* client) {
        run([&] { client->import("1-1"); });
        EXPECT_TRUE(scheduler_.waitUntil([&] { return client->status().has_value(); }));
        return client->status().value_or(usbip::OpStatus::Error);
    }
    RawClient::Answer await(RawClient* client, const std::function<std::uint32_t()>& command) {
        std::uint32_t sequence = 0;
        run([&] { sequence = command(); });
        RawClient::Answer answer;
        EXPECT_TRUE(scheduler_.waitUntil([&] {
            if (!client->answer(sequence)) return false;
            answer = *client->answer(sequence);
            return true;
        }));
        return answer;
    }
    bool waitUntil(const std::function<bool()>& done) { return scheduler_.waitUntil(done); }

    WatchedScheduler scheduler_;
    // On the scheduler's thread.
    Device device_;
    std::unique_ptr<UsbipServer> server_;
    std::unique_ptr<Sockets> sockets_;
    std::list<RawClient> clients_;
};

TEST_F(ServedOnSockets, AClientUsesTheDeviceAndTheNextOneAfterIt) {
    ASSERT_FALSE(serve());
    RawClient* first = connect();
    ASSERT_EQ(import(first), usbip::OpStatus::Ok);
    EXPECT_EQ(await(first, [&] { return first->controlOut({0x00, 9, 1, 0, 0}); }).reply.status, Status::Ok);
    EXPECT_EQ(await(first, [&] { return first->out(Device::kFastOut, {1, 2}); }).reply.actual, 2U);
    const auto in = await(first, [&] {
        device_.offer(Device::kFastIn, Bytes(64, 7));
        return first->in(Device::kFastIn, 64);
    });
    EXPECT_EQ(in.data, Bytes(64, 7));
    RawClient* second = connect();
    EXPECT_EQ(import(second), usbip::OpStatus::Busy);
    run([&] { first->close(); });
    ASSERT_TRUE(waitUntil([&] { return !server_->report().inUse; }));
    EXPECT_EQ(import(connect()), usbip::OpStatus::Ok);
    EXPECT_EQ(report().imports, 2U);
}

TEST_F(ServedOnSockets, AnUnplugIsToldBeforeTheConnectionEnds) {
    ASSERT_FALSE(serve());
    RawClient* client = connect();
    ASSERT_EQ(import(client), usbip::OpStatus::Ok);
    await(client, [&] { return client->controlOut({0x00, 9, 1, 0, 0}); });
    const auto ended = await(client, [&] {
        device_.setObserver([this] { scheduler_.post([this] { device_.unplug(); }); });
        const std::uint32_t waiting = client->in(Device::kFastIn, 64);
        client->out(Device::kFastOut, {1});  // Its coming is what pulls the plug.
        return waiting;
    });
    EXPECT_EQ(ended.reply.status, Status::Shutdown);
    EXPECT_TRUE(waitUntil([&] { return client->closed(); }));
}

TEST_F(ServedOnSockets, OneTooManyIsTurnedAway) {
    ASSERT_FALSE(serve({.port = 0, .maxConnections = 2}));
    connect();
    connect();
    RawClient* third = connect();
    EXPECT_TRUE(waitUntil([&] { return third->closed(); }));
    EXPECT_EQ(report().refused, 1U);
    EXPECT_EQ(report().connections, 2U);
}

TEST_F(ServedOnSockets, TheServerMayGoWhileClientsAreThere) {
    ASSERT_FALSE(serve());
    RawClient* client = connect();
    ASSERT_EQ(import(client), usbip::OpStatus::Ok);
    run([&] {
        client->in(Device::kFastIn, 64);
        server_.reset();
    });
    EXPECT_TRUE(waitUntil([&] { return client->closed(); }));
    run([&] { EXPECT_EQ(device_.configurations(), Bytes{0}); });
}

TEST_F(ServedOnSockets, OtherMachinesAreServedOnlyWhereAskedForInSoManyWords) {
    const auto refused = serve({.address = "0.0.0.0", .port = 0});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->code, Errc::BadArgument);
    EXPECT_FALSE(serve({.address = "0.0.0.0", .port = 0, .anyAddress = true}));
}

TEST_F(ServedOnSockets, APortInUseIsSaid) {
    ASSERT_FALSE(serve());
    std::uint16_t port = 0;
    run([&] { port = server_->port(); });
    const auto refused = serve({.port = port});
    ASSERT_TRUE(refused);
    EXPECT_EQ(refused->code, Errc::ClaimedElsewhere);
}

TEST(UsbipExportsMade, RefusesNamesThatCannotTravel) {
    Device device;
    const auto make = [&](std::vector<UsbipExport> exports) {
        return UsbipExports::make(exports).has_value();
    };
    EXPECT_TRUE(make({{"1-1.4", &device}, {"2-1", &device}}));
    EXPECT_FALSE(make({{"", &device}}));
    EXPECT_FALSE(make({{std::string(32, '1'), &device}}));
    EXPECT_FALSE(make({{"1 1", &device}}));
    EXPECT_FALSE(make({{"../1", &device}}));
    EXPECT_FALSE(make({{"1-1", nullptr}}));
    EXPECT_FALSE(make({{"1-1", &device}, {"1-1", &device}}));
}

}  // namespace
}  // namespace kickstand::testing
