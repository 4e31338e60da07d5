#include "core/link/tapped_usb_link.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

constexpr std::uint8_t kClearFeature = 1;
constexpr std::uint8_t kEndpointRecipient = 2;

std::vector<std::uint8_t> copyOf(ByteView data) {
    return {data.begin(), data.end()};
}

/// The control transfer that clearing a halt is on the wire (USB 2.0, 9.4.1).
UsbSetup clearHaltSetup(std::uint8_t endpoint) {
    UsbSetup setup;
    setup.requestType = kEndpointRecipient;
    setup.request = kClearFeature;
    setup.index = endpoint;
    return setup;
}

}  // namespace

TappedUsbLink::TappedUsbLink(std::unique_ptr<UsbLink> inner, Scheduler& scheduler)
    : scheduler_(scheduler), inner_(std::move(inner)) {
    inner_->setPresenceListener([this](bool present) {
        if (!present) observe({.kind = UsbTapRecord::Kind::Lost, .status = UsbStatus::NoDevice});
        open_ = false;
        // A copy, because the listener may destroy this link.
        if (const auto listener = presence_) listener(present);
    });
}

void TappedUsbLink::addObserver(UsbTapObserver* observer) {
    observers_.push_back(observer);
}

void TappedUsbLink::removeObserver(UsbTapObserver* observer) {
    // While observers are being told, the place stays, so that none is skipped.
    std::replace(observers_.begin(), observers_.end(), observer, static_cast<UsbTapObserver*>(nullptr));
    if (!observing_) std::erase(observers_, nullptr);
}

void TappedUsbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    inner_->open([this, done = std::move(done)](Result<UsbDeviceInfo> opened) {
        if (opened) {
            open_ = true;
            observe({.kind = UsbTapRecord::Kind::Opened});
        }
        done(std::move(opened));
    });
}

void TappedUsbLink::close(std::function<void()> done) {
    inner_->close([this, done = std::move(done)] {
        if (std::exchange(open_, false)) observe({.kind = UsbTapRecord::Kind::Closed});
        if (done) done();
    });
}

void TappedUsbLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    inner_->control(setup, data, deadline, observedControl(setup, data, std::move(done)));
}

void TappedUsbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    inner_->clearHalt(endpoint, observedControl(clearHaltSetup(endpoint), {}, std::move(done)));
}

UsbCallback TappedUsbLink::observedControl(const UsbSetup& setup, ByteView data, UsbCallback done) {
    const UsbTransferId id = ++lastRecord_;
    observe({.kind = UsbTapRecord::Kind::Submitted, .setup = setup, .data = data, .id = id});
    return [this, setup, id, sent = copyOf(data), done = std::move(done)](const UsbCompletion& completion) {
        observe({.setup = setup,
                 .status = completion.status,
                 .actual = completion.actual,
                 .data = setup.isIn() ? completion.data : ByteView(sent),
                 .id = id});
        if (done) done(completion);
    };
}

Result<UsbTransferId> TappedUsbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    const UsbTransferId id = lastRecord_ + 1;
    auto submitted = inner_->submitOut(
        endpoint, data,
        [this, endpoint, id, sent = copyOf(data), done = std::move(done)](const UsbCompletion& completion) {
            observe({.endpoint = endpoint,
                     .status = completion.status,
                     .actual = completion.actual,
                     .data = sent,
                     .id = id});
            if (done) done(completion);
        });
    if (!submitted) return submitted;
    lastRecord_ = id;
    observe({.kind = UsbTapRecord::Kind::Submitted, .endpoint = endpoint, .data = data, .id = id});
    return submitted;
}

Result<UsbTransferId> TappedUsbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    return inner_->submitIn(endpoint, size,
                            [this, endpoint, done = std::move(done)](const UsbCompletion& completion) {
                                observe({.endpoint = endpoint,
                                         .status = completion.status,
                                         .actual = completion.actual,
                                         .data = completion.data});
                                if (done) done(completion);
                            });
}

void TappedUsbLink::cancel(UsbTransferId id) {
    inner_->cancel(id);
}

void TappedUsbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void TappedUsbLink::observe(UsbTapRecord record) {
    record.time = scheduler_.now();
    observing_ = true;
    for (std::size_t i = 0; i < observers_.size(); ++i) {
        if (observers_[i]) observers_[i]->observe(record);
    }
    observing_ = false;
    std::erase(observers_, nullptr);
}

}  // namespace kickstand
