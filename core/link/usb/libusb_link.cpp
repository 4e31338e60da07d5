#include "core/link/usb/libusb_link.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/link/usb/job_thread.h"
#include "core/link/usb/libusb_context.h"
#include "core/link/usb/libusb_device.h"
#include "core/link/usb_packet_check.h"

namespace kickstand {
namespace {

using usb::EndedTransfer;
using usb::LibusbContext;
using usb::LibusbDevice;
using usb::TransferRequest;

/// Where a device is told apart from the next by: the address of libusb's record of it, never followed.
using Identity = const libusb_device*;

/// What happens where: the caller's side of the link on the scheduler's thread, everything that may block on
/// the job thread, which owns the context and the open device, and libusb's callbacks on its event thread.
/// The last two only ever post to the first, and what they post is void once the link is gone.
class LibusbLink final : public UsbLink {
  public:
    LibusbLink(Scheduler& scheduler, UsbMatch match, UsbWatchOptions options);
    ~LibusbLink() override;
    LibusbLink(const LibusbLink&) = delete;
    LibusbLink& operator=(const LibusbLink&) = delete;

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

  private:
    enum class State : std::uint8_t { Closed, Opening, Open, Closing, Losing };

    struct Pending {
        UsbCallback done;
        TimerId deadline = 0;
        bool timedOut = false;
    };

    // The scheduler's thread.
    Result<UsbTransferId> submit(TransferRequest request, UsbDirection direction, std::size_t size,
                                 UsbCallback done);
    void refuse(UsbCallback done, UsbStatus status);
    void requestCancel(UsbTransferId id);
    void openEnded(Result<UsbDeviceInfo> opened, LibusbDevice* device);
    void transferEnded(const EndedTransfer& ended);
    UsbStatus statusFor(const Pending& pending, UsbStatus status) const;
    void lose();
    void shutDevice();
    void deviceShut();
    void deviceCame();
    void deviceWent(Identity device);
    void tellPresence(bool present);
    void pollLater();

    // The job thread.
    void startWatching();
    void openDevice();
    void pollDevices();

    // Any thread.
    void post(std::function<void()> callback);

    Scheduler& scheduler_;
    const UsbMatch match_;
    const UsbWatchOptions options_;

    // The scheduler's thread.
    State state_ = State::Closed;
    std::function<void(Result<UsbDeviceInfo>)> opened_;
    std::vector<std::function<void()>> closers_;
    std::function<void(bool)> presence_;
    std::unordered_map<UsbTransferId, Pending> pending_;
    UsbTransferId lastId_ = 0;
    LibusbDevice* device_ = nullptr;  ///< While open; the job thread's, which keeps it as long.
    std::vector<Identity> wentWhileOpening_;
    bool cameMeanwhile_ = false;
    TimerId pollTimer_ = 0;

    // The job thread's.
    Result<std::unique_ptr<LibusbContext>> context_ = nullptr;
    std::unique_ptr<LibusbDevice> ownedDevice_;
    std::vector<usb::DeviceRef> polled_;  ///< What was there at the last look.
    bool looked_ = false;

    std::atomic<bool> ending_{false};
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    const std::weak_ptr<const bool> observedAlive_ = alive_;
    usb::JobThread jobs_;
};

LibusbLink::LibusbLink(Scheduler& scheduler, UsbMatch match, UsbWatchOptions options)
    : scheduler_(scheduler), match_(std::move(match)), options_(options) {
    jobs_.run([this] { startWatching(); });
}

LibusbLink::~LibusbLink() {
    alive_.reset();
    ending_ = true;
    scheduler_.cancel(pollTimer_);
    for (const auto& [id, pending] : pending_)
        scheduler_.cancel(pending.deadline);
    // Devices before their context, and both on the thread that made them. The end of jobs_ waits for this.
    jobs_.run([this] {
        ownedDevice_.reset();
        polled_.clear();
        context_ = nullptr;
    });
}

void LibusbLink::post(std::function<void()> callback) {
    scheduler_.post([alive = observedAlive_, callback = std::move(callback)] {
        if (!alive.expired()) callback();
    });
}

// ---- Opening and closing.

void LibusbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    if (state_ != State::Closed)
        return post([done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
    state_ = State::Opening;
    opened_ = std::move(done);
    wentWhileOpening_.clear();
    cameMeanwhile_ = false;
    jobs_.run([this] { openDevice(); });
}

void LibusbLink::openDevice() {
    if (ending_) return;
    if (!context_) return post([this, error = context_.error()] { openEnded(fail(error), nullptr); });
    auto device = LibusbDevice::open((*context_)->get(), match_, [this](EndedTransfer ended) {
        post([this, ended = std::move(ended)] { transferEnded(ended); });
    });
    if (!device) return post([this, error = device.error()] { openEnded(fail(error), nullptr); });
    ownedDevice_ = std::move(*device);
    // With a copy of the info: should the link be closed before this arrives, the device is gone by then.
    post([this, info = ownedDevice_->info(), opened = ownedDevice_.get()] { openEnded(info, opened); });
}

void LibusbLink::openEnded(Result<UsbDeviceInfo> opened, LibusbDevice* device) {
    if (state_ != State::Opening)
        return;  // Closed meanwhile; the closing that follows takes the device along.
    const bool went = device != nullptr && std::any_of(wentWhileOpening_.begin(), wentWhileOpening_.end(),
                                                       [device](Identity gone) { return device->is(gone); });
    const auto done = std::exchange(opened_, nullptr);
    if (went) {
        shutDevice();
        state_ = State::Closing;
        return done(fail(Errc::Disconnected, opened->port));
    }
    device_ = device;
    state_ = opened ? State::Open : State::Closed;
    // It may have come after it was looked for.
    if (!opened && std::exchange(cameMeanwhile_, false)) post([this] { deviceCame(); });
    done(std::move(opened));
}

void LibusbLink::close(std::function<void()> done) {
    if (!done) done = [] {};
    if (state_ == State::Closed) return post(std::move(done));
    closers_.push_back(std::move(done));
    if (state_ == State::Opening) {
        post([opened = std::exchange(opened_, nullptr)] { opened(fail(Errc::Cancelled, "link")); });
    } else if (state_ != State::Open) {
        return;  // On its way already.
    }
    state_ = State::Closing;
    shutDevice();
}

void LibusbLink::lose() {
    if (state_ != State::Open) return;
    state_ = State::Losing;
    shutDevice();
}

void LibusbLink::shutDevice() {
    device_ = nullptr;
    jobs_.run([this] {
        ownedDevice_.reset();
        post([this] { deviceShut(); });
    });
}

void LibusbLink::deviceShut() {
    const bool lost = state_ == State::Losing;
    state_ = State::Closed;
    const std::weak_ptr alive(alive_);
    for (const auto& closed : std::exchange(closers_, {})) {
        closed();
        if (alive.expired()) return;
    }
    if (lost) tellPresence(false);
    if (!alive.expired() && std::exchange(cameMeanwhile_, false)) deviceCame();
}

// ---- Transfers.

Result<UsbTransferId> LibusbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    TransferRequest request;
    request.endpoint = endpoint;
    request.out = data;
    return submit(request, UsbDirection::Out, data.size(), std::move(done));
}

Result<UsbTransferId> LibusbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    TransferRequest request;
    request.endpoint = endpoint;
    request.size = size;
    return submit(request, UsbDirection::In, size, std::move(done));
}

Result<UsbTransferId> LibusbLink::submit(TransferRequest request, UsbDirection direction, std::size_t size,
                                         UsbCallback done) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    if (const auto allowed = checkUsbPacket(device_->endpoints(), request.endpoint, direction, size);
        !allowed)
        return fail(allowed.error());
    request.id = ++lastId_;
    const int result = device_->submit(request);
    if (result == LIBUSB_SUCCESS) {
        pending_[request.id].done = std::move(done);
        return request.id;
    }
    Error error = usb::toError(result, "endpoint");
    error.endpoint = request.endpoint;
    if (result == LIBUSB_ERROR_NO_DEVICE) {
        error.code = Errc::NotConnected;
        lose();
    }
    return fail(std::move(error));
}

void LibusbLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    if (state_ != State::Open) return refuse(std::move(done), UsbStatus::NoDevice);
    if (!setup.isIn() && data.size() != setup.length) return refuse(std::move(done), UsbStatus::Failed);
    TransferRequest request;
    request.id = ++lastId_;
    request.setup = setup;
    request.out = data;
    request.size = setup.length;
    if (const int result = device_->submit(request); result != LIBUSB_SUCCESS) {
        const bool gone = result == LIBUSB_ERROR_NO_DEVICE;
        refuse(std::move(done), gone ? UsbStatus::NoDevice : UsbStatus::Failed);
        if (gone) lose();
        return;
    }
    Pending& pending = pending_[request.id];
    pending.done = std::move(done);
    pending.deadline = scheduler_.callAfter(deadline, [this, id = request.id] {
        const auto found = pending_.find(id);
        if (found == pending_.end()) return;
        found->second.timedOut = true;
        requestCancel(id);
    });
}

void LibusbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    if (state_ != State::Open) return refuse(std::move(done), UsbStatus::NoDevice);
    const auto& endpoints = device_->endpoints();
    const bool known =
        std::any_of(endpoints.begin(), endpoints.end(),
                    [endpoint](const UsbEndpointInfo& info) { return info.address == endpoint; });
    if (!known) return refuse(std::move(done), UsbStatus::Failed);
    const UsbTransferId id = ++lastId_;
    pending_[id].done = std::move(done);
    jobs_.run([this, id, endpoint] {
        EndedTransfer ended;
        ended.id = id;
        ended.status = ownedDevice_ ? ownedDevice_->clearHalt(endpoint) : UsbStatus::NoDevice;
        post([this, ended = std::move(ended)] { transferEnded(ended); });
    });
}

void LibusbLink::cancel(UsbTransferId id) {
    if (pending_.contains(id)) requestCancel(id);
}

void LibusbLink::requestCancel(UsbTransferId id) {
    // Here, not behind what the job thread may be blocked by: STOP cancels what has not been sent. A device
    // that is being shut ends all its transfers itself.
    if (device_ != nullptr) device_->cancel(id);
}

void LibusbLink::refuse(UsbCallback done, UsbStatus status) {
    if (!done) return;
    post([done = std::move(done), status] { done({.status = status}); });
}

void LibusbLink::transferEnded(const EndedTransfer& ended) {
    const auto found = pending_.find(ended.id);
    if (found == pending_.end()) return;
    const Pending pending = std::move(found->second);
    pending_.erase(found);
    scheduler_.cancel(pending.deadline);
    if (ended.status == UsbStatus::NoDevice) lose();
    if (!pending.done) return;
    const UsbStatus status = statusFor(pending, ended.status);
    const bool moved = status == UsbStatus::Completed;
    pending.done(
        {.status = status, .data = moved ? ByteView(ended.bytes) : ByteView(), .actual = ended.actual});
}

UsbStatus LibusbLink::statusFor(const Pending& pending, UsbStatus status) const {
    if (status == UsbStatus::Completed) return status;
    // However libusb ended it, the reason was that the device is gone.
    if (state_ == State::Losing) return UsbStatus::NoDevice;
    return status == UsbStatus::Cancelled && pending.timedOut ? UsbStatus::TimedOut : status;
}

// ---- Coming and going.

void LibusbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void LibusbLink::startWatching() {
    context_ = LibusbContext::create();
    if (!context_) return;
    const auto told = [this](libusb_device* device, bool arrived) {
        post([this, identity = Identity(device), arrived] { arrived ? deviceCame() : deviceWent(identity); });
    };
    if (!options_.poll && (*context_)->watch(match_, told)) return;
    pollDevices();
}

void LibusbLink::pollDevices() {
    if (ending_) return;
    auto found = usb::findDevices((*context_)->get(), match_);
    post([this] { pollLater(); });
    if (!found) return;
    const auto isIn = [](const std::vector<usb::DeviceRef>& list, const usb::DeviceRef& device) {
        return std::any_of(list.begin(), list.end(),
                           [&](const usb::DeviceRef& other) { return other == device; });
    };
    // What the first look finds has not come: it was there.
    const bool first = !std::exchange(looked_, true);
    for (const usb::DeviceRef& device : polled_) {
        if (!isIn(*found, device)) post([this, gone = Identity(device.get())] { deviceWent(gone); });
    }
    for (const usb::DeviceRef& device : *found) {
        if (!first && !isIn(polled_, device)) post([this] { deviceCame(); });
    }
    polled_ = std::move(*found);
}

void LibusbLink::pollLater() {
    pollTimer_ =
        scheduler_.callAfter(options_.pollInterval, [this] { jobs_.run([this] { pollDevices(); }); });
}

void LibusbLink::deviceCame() {
    if (state_ == State::Closed)
        tellPresence(true);
    else
        cameMeanwhile_ = true;
}

void LibusbLink::deviceWent(Identity device) {
    cameMeanwhile_ = false;
    if (state_ == State::Opening) wentWhileOpening_.push_back(device);
    if (device_ != nullptr && device_->is(device)) lose();
}

void LibusbLink::tellPresence(bool present) {
    // A copy, because the listener may destroy this link.
    if (const auto listener = presence_) listener(present);
}

}  // namespace

std::unique_ptr<UsbLink> makeLibusbLink(Scheduler& scheduler, UsbMatch match, UsbWatchOptions options) {
    return std::make_unique<LibusbLink>(scheduler, std::move(match), options);
}

}  // namespace kickstand
