#include "tests/contract/usbip_rig.h"

#include <array>

#include <gtest/gtest.h>

namespace kickstand::testing {

UsbipMemoryRig::UsbipMemoryRig(const MemoryStreamOptions& options)
    : options_(options),
      hall_{.exports = *UsbipExports::make(std::array{UsbipExport{address().busId, &device_}})} {}

UsbMatch UsbipMemoryRig::match() {
    UsbMatch match;
    match.vendor = FakeUsbDevice::kVendor;
    match.product = FakeUsbDevice::kProduct;
    match.interfaces = {0, 1};
    return match;
}

std::unique_ptr<UsbLink> UsbipMemoryRig::makeLink() {
    return makeUsbipLink(scheduler_, address(), match(), [this](auto done) {
        // Shared, because what is posted has to be copyable.
        const auto pair = std::make_shared<decltype(makeMemoryStreams(scheduler_))>(
            makeMemoryStreams(scheduler_, options_));
        scheduler_.post([this, pair, done = std::move(done)] {
            serve(std::move(pair->second));
            done(std::move(pair->first));
        });
    });
}

void UsbipMemoryRig::serve(std::unique_ptr<ByteStream> stream) {
    const auto place = connections_.emplace(connections_.end());
    *place = std::make_unique<UsbipConnection>(scheduler_, std::move(stream), hall_, UsbipLimits{},
                                               [this, place] { connections_.erase(place); });
}

UsbipTcpRig::UsbipTcpRig() {
    startServer();
}

UsbipTcpRig::~UsbipTcpRig() {
    stopServer();
}

std::unique_ptr<UsbLink> UsbipTcpRig::makeLink() {
    return makeUsbipLink(linkThread_, address(), UsbipMemoryRig::match());
}

void UsbipTcpRig::onDevice(const std::function<void(FakeUsbDevice&)>& action) {
    deviceThread_.run([&] { action(device_); });
}

void UsbipTcpRig::settle() {
    // There and back over the sockets, which nothing overtakes: the list is asked for and closes its
    // connection.
    bool answered = false;
    std::unique_ptr<UsbLink> probe;
    linkThread_.run([&] {
        probe = makeUsbipLink(linkThread_, {"127.0.0.1", port_, "none"}, UsbipMemoryRig::match());
        probe->open([&](const auto&) { answered = true; });
    });
    EXPECT_TRUE(linkThread_.waitUntil([&] { return answered; }));
    linkThread_.run([&] { probe.reset(); });
}

void UsbipTcpRig::stopServer() {
    deviceThread_.run([this] { server_.reset(); });
}

void UsbipTcpRig::startServer() {
    deviceThread_.run([this] {
        auto server = UsbipServer::serve(deviceThread_, {{"1-1", &device_}}, {.port = port_});
        ASSERT_TRUE(server) << server.error().detail;
        server_ = std::move(*server);
        port_ = server_->port();
    });
}

}  // namespace kickstand::testing
