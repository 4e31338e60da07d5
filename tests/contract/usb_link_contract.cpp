#include "tests/contract/usb_link_contract.h"

namespace kickstand::testing {

using Device = FakeUsbDevice;
using Bytes = std::vector<std::uint8_t>;

void UsbLinkContract::SetUp() {
    rig_ = GetParam().make();
    makeLink();
}

void UsbLinkContract::makeLink() {
    rig_->onLink([this] {
        link_.reset();
        link_ = rig_->makeLink();
        link_->setPresenceListener([this](bool present) { presence_.push_back(present); });
    });
}

void UsbLinkContract::TearDown() {
    destroy();
    rig_.reset();
}

void UsbLinkContract::destroy() {
    rig_->onLink([this] { link_.reset(); });
}

Result<UsbDeviceInfo> UsbLinkContract::tryOpen() {
    auto opened = std::make_shared<std::optional<Result<UsbDeviceInfo>>>();
    rig_->onLink(
        [&] { link_->open([opened](Result<UsbDeviceInfo> result) { *opened = std::move(result); }); });
    if (!rig_->waitUntil([&] { return opened->has_value(); })) return fail(Errc::TimedOut, "watchdog");
    return **opened;
}

UsbDeviceInfo UsbLinkContract::open() {
    const auto opened = tryOpen();
    EXPECT_TRUE(opened.has_value()) << name(opened.error().code) << " " << opened.error().detail;
    return opened.value_or(UsbDeviceInfo{});
}

void UsbLinkContract::close() {
    auto closed = std::make_shared<bool>(false);
    rig_->onLink([&] { link_->close([closed] { *closed = true; }); });
    ASSERT_TRUE(rig_->waitUntil([&] { return *closed; }));
}

UsbCallback UsbLinkContract::record(int number) {
    return [this, number](const UsbCompletion& completion) {
        Ending& ending = endings_[number];
        ++ending.calls;
        ending.status = completion.status;
        ending.data.assign(completion.data.begin(), completion.data.end());
        ending.actual = completion.actual;
        order_.push_back(number);
    };
}

int UsbLinkContract::out(std::uint8_t endpoint, Bytes bytes) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        const auto id = link_->submitOut(endpoint, bytes, record(number));
        ASSERT_TRUE(id.has_value()) << name(id.error().code);
        EXPECT_NE(*id, 0U);
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
        ids_[number] = *id;
    });
    return number;
}

int UsbLinkContract::in(std::uint8_t endpoint, std::size_t size) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        const auto id = link_->submitIn(endpoint, size, record(number));
        ASSERT_TRUE(id.has_value()) << name(id.error().code);
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
        ids_[number] = *id;
    });
    return number;
}

int UsbLinkContract::control(const UsbSetup& setup, Bytes bytes, Duration deadline) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        link_->control(setup, bytes, deadline, record(number));
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
    });
    return number;
}

int UsbLinkContract::clearHalt(std::uint8_t endpoint) {
    const int number = ++lastNumber_;
    rig_->onLink([&] {
        link_->clearHalt(endpoint, record(number));
        EXPECT_FALSE(endings_.contains(number)) << "called back from inside the call";
    });
    return number;
}

void UsbLinkContract::cancel(int number) {
    rig_->onLink([&] {
        const std::size_t before = order_.size();
        link_->cancel(ids_.at(number));
        EXPECT_EQ(order_.size(), before) << "called back from inside the call";
    });
}

Ending UsbLinkContract::ending(int number) {
    Ending found;
    rig_->onLink([&] {
        if (const auto known = endings_.find(number); known != endings_.end()) found = known->second;
    });
    return found;
}

Ending UsbLinkContract::finished(int number) {
    EXPECT_TRUE(rig_->waitUntil([&] { return endings_.contains(number); })) << "transfer never ended";
    return ending(number);
}

bool UsbLinkContract::waitForPresence(std::size_t changes) {
    return rig_->waitUntil([&] { return presence_.size() >= changes; });
}

std::vector<Device::Packet> UsbLinkContract::received() {
    std::vector<Device::Packet> packets;
    rig_->onDevice([&](Device& device) { packets = device.received(); });
    return packets;
}

}  // namespace kickstand::testing
