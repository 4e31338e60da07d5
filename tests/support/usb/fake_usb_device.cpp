#include "tests/support/usb/fake_usb_device.h"

#include <algorithm>

#include "core/link/usb_descriptors.h"

namespace kickstand::testing {
namespace {

UsbDescriptors makeDescriptors() {
    using Type = UsbEndpointInfo::Type;
    UsbDeviceDescription description;
    description.vendor = FakeUsbDevice::kVendor;
    description.product = FakeUsbDevice::kProduct;
    description.release = 0x0123;
    description.manufacturer = "Bench works";
    description.productName = "Fake device";
    UsbInterfaceDescription first;
    first.name = "Slow";
    first.endpoints = {{FakeUsbDevice::kSlowIn, Type::Interrupt, 4, 25, 0},
                       {FakeUsbDevice::kBulkIn, Type::Bulk, 8, 0, 0}};
    UsbInterfaceDescription second;
    second.name = "Fast";
    second.endpoints = {{FakeUsbDevice::kFastOut, Type::Interrupt, 64, 1, 0},
                        {FakeUsbDevice::kFastIn, Type::Interrupt, 64, 1, 0},
                        {FakeUsbDevice::kBulkOut, Type::Bulk, 64, 0, 0}};
    description.interfaces = {first, second};
    return buildUsbDescriptors(description);
}

}  // namespace

FakeUsbDevice::FakeUsbDevice()
    : descriptors_(makeDescriptors()),
      standard_(descriptors_, {.configured =
                                   [this](std::uint8_t value) {
                                       configurations_.push_back(value);
                                       offered_.clear();
                                       changed();
                                   },
                               .haltCleared = [this](std::uint8_t endpoint) { ready(endpoint); }}) {}

void FakeUsbDevice::plug() {
    attached_ = true;
    if (listener_) listener_->attachedChanged(true);
}

void FakeUsbDevice::unplug() {
    attached_ = false;
    standard_.reset();
    offered_.clear();
    if (listener_) listener_->attachedChanged(false);
}

void FakeUsbDevice::offer(std::uint8_t endpoint, std::vector<std::uint8_t> packet) {
    offered_[endpoint].push_back(std::move(packet));
    ready(endpoint);
}

void FakeUsbDevice::setBusy(bool busy) {
    busy_ = busy;
    if (busy) return;
    ready(kFastOut);
    ready(kBulkOut);
}

void FakeUsbDevice::halt(std::uint8_t endpoint) {
    standard_.halt(endpoint);
    ready(endpoint);
}

UsbHandshake FakeUsbDevice::control(const UsbSetup& setup, ByteView out, std::vector<std::uint8_t>& in) {
    if (const auto answer = standard_.handle(setup, in)) return *answer;
    switch (setup.request) {
        case kEcho:
            in = stored_;
            return UsbHandshake::Ack;
        case kStore:
            stored_.assign(out.begin(), out.end());
            changed();
            return UsbHandshake::Ack;
        case kIgnore:
            return UsbHandshake::Nak;
        default:
            return UsbHandshake::Stall;
    }
}

UsbHandshake FakeUsbDevice::out(std::uint8_t endpoint, ByteView packet) {
    if (standard_.isHalted(endpoint)) return UsbHandshake::Stall;
    if (busy_) return UsbHandshake::Nak;
    received_.push_back({endpoint, {packet.begin(), packet.end()}});
    changed();
    return UsbHandshake::Ack;
}

UsbHandshake FakeUsbDevice::in(std::uint8_t endpoint, ByteSpan buffer, std::size_t& actual) {
    if (standard_.isHalted(endpoint)) return UsbHandshake::Stall;
    auto& offered = offered_[endpoint];
    if (offered.empty()) return UsbHandshake::Nak;
    actual = std::min(offered.front().size(), buffer.size());
    std::copy_n(offered.front().begin(), actual, buffer.begin());
    offered.pop_front();
    return UsbHandshake::Ack;
}

void FakeUsbDevice::ready(std::uint8_t endpoint) {
    if (listener_ && attached_) listener_->endpointReady(endpoint);
}

void FakeUsbDevice::changed() {
    if (observer_) observer_();
}

}  // namespace kickstand::testing
