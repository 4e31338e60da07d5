#include "tests/contract/libusb_rig.h"

namespace kickstand::testing {

LibusbRig::LibusbRig(UsbWatchOptions options)
    : options_(options), bus_(std::make_unique<UmockdevBus>(deviceThread_)) {
    bool answered = false;
    linkThread_.run([&] {
        listening_ = makeLibusbLink(linkThread_, UsbMatch{});
        listening_->open([&](const Result<UsbDeviceInfo>&) { answered = true; });
    });
    linkThread_.waitUntil([&] { return answered; });
    bus_->connect(device_, "1-1");
}

LibusbRig::~LibusbRig() {
    bus_.reset();
    linkThread_.run([this] { listening_.reset(); });
    // What the bus still had to do on the device's thread happens before the device goes.
    deviceThread_.run([] {});
}

UsbMatch LibusbRig::match() {
    UsbMatch match;
    match.vendor = FakeUsbDevice::kVendor;
    match.product = FakeUsbDevice::kProduct;
    match.interfaces = {0, 1};
    return match;
}

std::unique_ptr<UsbLink> LibusbRig::makeLink(UsbMatch match) {
    return makeLibusbLink(linkThread_, std::move(match), options_);
}

void LibusbRig::onDevice(const std::function<void(FakeUsbDevice&)>& action) {
    deviceThread_.run([&] { action(device_); });
}

void LibusbRig::settle() {
    // There and back twice: an answer may provoke a question.
    for (int round = 0; round < 2; ++round) {
        deviceThread_.run([] {});
        linkThread_.run([] {});
    }
}

}  // namespace kickstand::testing
