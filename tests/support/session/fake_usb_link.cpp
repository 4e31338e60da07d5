#include "tests/support/session/fake_usb_link.h"

#include <utility>

#include "core/base/hex.h"

namespace kickstand::testing {
namespace {

std::string hexOf(std::uint8_t byte) {
    return toHex(ByteView{&byte, 1});
}

std::string describe(const UsbSetup& setup) {
    return "control " + hexOf(setup.requestType) + " " + hexOf(setup.request) + " " +
           hexOf(static_cast<std::uint8_t>(setup.value >> 8)) + hexOf(static_cast<std::uint8_t>(setup.value));
}

template <class T>
T takeFront(std::deque<T>& queue) {
    T front = std::move(queue.front());
    queue.pop_front();
    return front;
}

}  // namespace

void FakeUsbLink::finishOpen(Result<UsbDeviceInfo> result) {
    open_ = result.has_value();
    if (const auto opened = std::exchange(opened_, nullptr)) opened(std::move(result));
}

void FakeUsbLink::finishClose() {
    open_ = false;
    if (const auto opened = std::exchange(opened_, nullptr)) opened(fail(Errc::Cancelled, "link"));
    endAll(UsbStatus::Cancelled);
    while (!closed_.empty()) {
        if (const auto closed = takeFront(closed_)) closed();
    }
}

void FakeUsbLink::complete(std::uint8_t endpoint, UsbStatus status, ByteView in) {
    if (pipes_[endpoint].empty()) return;
    const Transfer transfer = takeFront(pipes_[endpoint]);
    const bool isOut = !isInEndpoint(endpoint);
    const bool moved = status == UsbStatus::Completed;
    if (isOut && moved) taken_[endpoint].push_back(transfer.data);
    const std::size_t actual = isOut ? transfer.data.size() : in.size();
    transfer.done({.status = status, .data = in, .actual = moved ? actual : 0});
}

void FakeUsbLink::completeControl(UsbStatus status, ByteView in) {
    if (controls_.empty()) return;
    const Control control = takeFront(controls_);
    if (control.done) control.done({.status = status, .data = in, .actual = in.size()});
}

std::vector<std::uint8_t> FakeUsbLink::clearing() const {
    std::vector<std::uint8_t> endpoints;
    for (const Clear& clear : clears_)
        endpoints.push_back(clear.endpoint);
    return endpoints;
}

void FakeUsbLink::completeClear(UsbStatus status) {
    if (clears_.empty()) return;
    const Clear clear = takeFront(clears_);
    clear.done({.status = status});
}

void FakeUsbLink::unplug() {
    open_ = false;
    endAll(UsbStatus::NoDevice);
    if (presence_) presence_(false);
}

void FakeUsbLink::appear() {
    if (presence_) presence_(true);
}

void FakeUsbLink::endAll(UsbStatus status) {
    while (!controls_.empty())
        completeControl(status);
    while (!clears_.empty())
        completeClear(status);
    for (auto& [endpoint, transfers] : pipes_) {
        while (!transfers.empty())
            complete(endpoint, status);
    }
}

void FakeUsbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    log_.emplace_back(opened_ ? "open while opening" : "open");
    opened_ = std::move(done);
}

void FakeUsbLink::close(std::function<void()> done) {
    log_.emplace_back("close");
    closed_.push_back(std::move(done));
}

void FakeUsbLink::control(const UsbSetup& setup, ByteView, Duration, UsbCallback done) {
    log_.push_back(describe(setup));
    controls_.push_back({setup, std::move(done)});
}

Result<UsbTransferId> FakeUsbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    return submit(endpoint, {0, {data.begin(), data.end()}, 0, std::move(done)});
}

Result<UsbTransferId> FakeUsbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    return submit(endpoint, {0, {}, size, std::move(done)});
}

Result<UsbTransferId> FakeUsbLink::submit(std::uint8_t endpoint, Transfer transfer) {
    if (!open_) return fail(Errc::NotConnected, "link");
    log_.push_back((isInEndpoint(endpoint) ? "in " : "out ") + hexOf(endpoint));
    transfer.id = ++lastId_;
    pipes_[endpoint].push_back(std::move(transfer));
    return lastId_;
}

void FakeUsbLink::cancel(UsbTransferId id) {
    for (auto& [endpoint, transfers] : pipes_) {
        for (Transfer& transfer : transfers) {
            if (transfer.id != id) continue;
            log_.push_back("cancel " + hexOf(endpoint));
            transfer.cancelAsked = true;
        }
    }
}

void FakeUsbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    log_.push_back("clear " + hexOf(endpoint));
    clears_.push_back({endpoint, std::move(done)});
}

void FakeUsbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

}  // namespace kickstand::testing
