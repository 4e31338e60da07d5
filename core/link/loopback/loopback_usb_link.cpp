#include "core/link/loopback/loopback_usb_link.h"

#include <algorithm>
#include <utility>

#include "core/link/usb_packet_check.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;

/// Longer than a bus ever takes; only a model that never answers comes to it.
constexpr Duration kClearHaltDeadline = 1s;

constexpr std::uint8_t kSetConfiguration = 9;
constexpr std::uint8_t kClearFeature = 1;
constexpr std::uint8_t kToEndpoint = 2;
constexpr std::uint8_t kConfigurationValue = 1;

// Places in the device descriptor (USB 2.0, table 9-8).
constexpr std::size_t kDeviceDescriptorSize = 18;
constexpr std::size_t kVendorAt = 8;
constexpr std::size_t kProductAt = 10;
constexpr std::size_t kReleaseAt = 12;
constexpr std::size_t kManufacturerAt = 14;
constexpr std::size_t kProductNameAt = 15;

std::string stringAt(const UsbDescriptors& descriptors, std::uint8_t index) {
    const auto found = descriptors.strings.find(index);
    return found == descriptors.strings.end() ? std::string() : found->second;
}

Result<UsbDeviceInfo> describe(const UsbDescriptors& descriptors, const std::string& port) {
    const ByteView device = descriptors.device;
    if (device.size() < kDeviceDescriptorSize) return fail(Errc::Io, port, "device descriptor too short");
    UsbDeviceInfo info;
    info.vendor = loadLe16(device, kVendorAt);
    info.product = loadLe16(device, kProductAt);
    info.release = loadLe16(device, kReleaseAt);
    info.port = port;
    info.manufacturer = stringAt(descriptors, device[kManufacturerAt]);
    info.productName = stringAt(descriptors, device[kProductNameAt]);
    return info;
}

}  // namespace

LoopbackUsbLink::LoopbackUsbLink(Scheduler& scheduler, UsbDeviceModel& model, LoopbackOptions options)
    : scheduler_(scheduler),
      model_(model),
      options_(std::move(options)),
      controller_(scheduler, model, {.everyFrame = options_.everyFrame}) {
    controller_.setAttachedListener([this](bool attached) { attachedChanged(attached); });
}

LoopbackUsbLink::~LoopbackUsbLink() {
    for (const auto& [number, timer] : deadlines_)
        scheduler_.cancel(timer);
}

void LoopbackUsbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    if (state_ != State::Closed) {
        controller_.later(
            [done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
        return;
    }
    state_ = State::Opening;
    ++opening_;
    opened_ = std::move(done);
    configure(0);
}

void LoopbackUsbLink::configure(std::uint8_t configuration) {
    UsbSetup setup;
    setup.request = kSetConfiguration;
    setup.value = configuration;
    controller_.control(setup, {},
                        [this, configuration, opening = opening_](const UsbCompletion& completion) {
                            if (state_ == State::Opening && opening == opening_)
                                configured(configuration, completion.status);
                        });
}

void LoopbackUsbLink::configured(std::uint8_t configuration, UsbStatus status) {
    if (status == UsbStatus::NoDevice) return finishOpen(fail(Errc::NoDevice, options_.port));
    if (status != UsbStatus::Completed)
        return finishOpen(fail(Errc::Io, options_.port, "set configuration refused"));
    if (configuration != kConfigurationValue) return configure(kConfigurationValue);
    finishOpen(describe(model_.descriptors(), options_.port));
}

void LoopbackUsbLink::finishOpen(Result<UsbDeviceInfo> result) {
    state_ = result ? State::Open : State::Closed;
    controller_.later([opened = std::exchange(opened_, nullptr), result = std::move(result)]() mutable {
        opened(std::move(result));
    });
}

void LoopbackUsbLink::close(std::function<void()> done) {
    if (state_ == State::Opening) {
        controller_.cancelAll(UsbStatus::Cancelled);
        finishOpen(fail(Errc::Cancelled, "link"));
    } else if (state_ == State::Open) {
        state_ = State::Closing;
        controller_.cancelAll(UsbStatus::Cancelled);
        controller_.later([this] { state_ = State::Closed; });
    }
    if (done) controller_.later(std::move(done));
}

void LoopbackUsbLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    if (state_ != State::Open) return end(std::move(done), UsbStatus::NoDevice);
    if (!setup.isIn() && data.size() != setup.length) return end(std::move(done), UsbStatus::Failed);
    const std::uint64_t number = ++lastDeadline_;
    const UsbTransferId id = controller_.control(
        setup, data, [this, number, done = std::move(done)](const UsbCompletion& completion) {
            if (const auto timer = deadlines_.extract(number)) scheduler_.cancel(timer.mapped());
            if (done) done(completion);
        });
    deadlines_[number] = scheduler_.callAfter(deadline, [this, number, id] {
        deadlines_.erase(number);
        controller_.cancel(id, UsbStatus::TimedOut);
    });
}

void LoopbackUsbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    if (state_ != State::Open) return end(std::move(done), UsbStatus::NoDevice);
    const auto& endpoints = model_.descriptors().endpoints;
    if (std::ranges::find(endpoints, endpoint, &UsbEndpointInfo::address) == endpoints.end())
        return end(std::move(done), UsbStatus::Failed);
    UsbSetup setup;
    setup.requestType = kToEndpoint;
    setup.request = kClearFeature;
    setup.index = endpoint;
    control(setup, {}, kClearHaltDeadline, std::move(done));
}

void LoopbackUsbLink::end(UsbCallback done, UsbStatus status) {
    if (done) controller_.later([done = std::move(done), status] { done({.status = status}); });
}

Result<UsbTransferId> LoopbackUsbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    const auto allowed =
        checkUsbPacket(model_.descriptors().endpoints, endpoint, UsbDirection::Out, data.size());
    if (!allowed) return fail(allowed.error());
    return controller_.out(endpoint, data, false, std::move(done));
}

Result<UsbTransferId> LoopbackUsbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    const auto allowed = checkUsbPacket(model_.descriptors().endpoints, endpoint, UsbDirection::In, size);
    if (!allowed) return fail(allowed.error());
    return controller_.in(endpoint, size, std::move(done));
}

void LoopbackUsbLink::cancel(UsbTransferId id) {
    controller_.cancel(id);
}

void LoopbackUsbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void LoopbackUsbLink::attachedChanged(bool attached) {
    if (attached) {
        controller_.later([this] {
            if (state_ != State::Closed || !model_.attached()) return;
            if (const auto listener = presence_) listener(true);
        });
    } else if (state_ == State::Opening) {
        finishOpen(fail(Errc::Disconnected, options_.port));
    } else if (state_ == State::Open) {
        state_ = State::Losing;
        controller_.later([this] {
            state_ = State::Closed;
            if (const auto listener = presence_) listener(false);
        });
    }
}

}  // namespace kickstand
