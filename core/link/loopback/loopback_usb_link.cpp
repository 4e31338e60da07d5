#include "core/link/loopback/loopback_usb_link.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

constexpr Duration kFrameLength = 1ms;
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
    : scheduler_(scheduler), model_(model), options_(std::move(options)) {
    model_.setListener(this);
}

LoopbackUsbLink::~LoopbackUsbLink() {
    model_.setListener(nullptr);
    scheduler_.cancel(frameTimer_);
    for (const Control& control : controls_)
        scheduler_.cancel(control.deadline);
}

void LoopbackUsbLink::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    if (state_ != State::Closed) {
        later([done = std::move(done)] { done(fail(Errc::BadArgument, "link", "already open")); });
        return;
    }
    state_ = State::Opening;
    opened_ = std::move(done);
    nextConfiguration_ = 0;
    arm();
}

void LoopbackUsbLink::close(std::function<void()> done) {
    if (state_ == State::Opening) {
        finishOpen(fail(Errc::Cancelled, "link"));
    } else if (state_ == State::Open) {
        state_ = State::Closing;
        endAll(UsbStatus::Cancelled);
        later([this] { state_ = State::Closed; });
    }
    if (done) later(std::move(done));
}

void LoopbackUsbLink::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    if (state_ != State::Open) return finish(std::move(done), UsbStatus::NoDevice);
    if (!setup.isIn() && data.size() != setup.length) return finish(std::move(done), UsbStatus::Failed);
    Control control;
    control.setup = setup;
    if (!setup.isIn()) control.transfer.data.assign(data.begin(), data.end());
    control.transfer.done = std::move(done);
    queueControl(std::move(control), deadline);
}

void LoopbackUsbLink::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    if (state_ != State::Open) return finish(std::move(done), UsbStatus::NoDevice);
    if (!pipes_.contains(endpoint)) return finish(std::move(done), UsbStatus::Failed);
    Control control;
    control.setup.requestType = kToEndpoint;
    control.setup.request = kClearFeature;
    control.setup.index = endpoint;
    control.transfer.done = std::move(done);
    queueControl(std::move(control), kClearHaltDeadline);
}

Result<UsbTransferId> LoopbackUsbLink::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    Transfer transfer;
    transfer.size = data.size();
    transfer.data.assign(data.begin(), data.end());
    transfer.done = std::move(done);
    return submit(endpoint, UsbDirection::Out, std::move(transfer));
}

Result<UsbTransferId> LoopbackUsbLink::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    Transfer transfer;
    transfer.size = size;
    transfer.done = std::move(done);
    return submit(endpoint, UsbDirection::In, std::move(transfer));
}

Result<UsbTransferId> LoopbackUsbLink::submit(std::uint8_t endpoint, UsbDirection direction,
                                              Transfer transfer) {
    if (state_ != State::Open) return fail(Errc::NotConnected, "link");
    const auto allowed = checkUsbPacket(model_.descriptors().endpoints, endpoint, direction, transfer.size);
    if (!allowed) return fail(allowed.error());
    const UsbTransferId id = ++lastId_;
    transfer.id = id;
    pipes_.at(endpoint).queue.push_back(std::move(transfer));
    arm();
    return id;
}

void LoopbackUsbLink::cancel(UsbTransferId id) {
    for (auto& [address, pipe] : pipes_) {
        const auto found = std::find_if(pipe.queue.begin(), pipe.queue.end(),
                                        [id](const Transfer& transfer) { return transfer.id == id; });
        if (found == pipe.queue.end()) continue;
        finish(std::move(found->done), UsbStatus::Cancelled);
        pipe.queue.erase(found);
        return;
    }
}

void LoopbackUsbLink::setPresenceListener(std::function<void(bool present)> listener) {
    presence_ = std::move(listener);
}

void LoopbackUsbLink::queueControl(Control control, Duration deadline) {
    const UsbTransferId id = ++lastId_;
    control.transfer.id = id;
    control.deadline = scheduler_.callAfter(deadline, [this, id] {
        const auto found = std::find_if(controls_.begin(), controls_.end(),
                                        [id](const Control& waiting) { return waiting.transfer.id == id; });
        if (found == controls_.end()) return;
        finish(std::move(found->transfer.done), UsbStatus::TimedOut);
        controls_.erase(found);
    });
    controls_.push_back(std::move(control));
    arm();
}

void LoopbackUsbLink::endpointReady(std::uint8_t endpoint) {
    const auto found = pipes_.find(endpoint);
    if (found == pipes_.end()) return;
    found->second.ready = true;
    arm();
}

void LoopbackUsbLink::attachedChanged(bool attached) {
    if (attached) {
        later([this] {
            if (state_ != State::Closed || !model_.attached()) return;
            if (const auto listener = presence_) listener(true);
        });
    } else if (state_ == State::Opening) {
        finishOpen(fail(Errc::Disconnected, options_.port));
    } else if (state_ == State::Open) {
        state_ = State::Losing;
        endAll(UsbStatus::NoDevice);
        later([this] {
            state_ = State::Closed;
            if (const auto listener = presence_) listener(false);
        });
    }
}

LoopbackUsbLink::Frame LoopbackUsbLink::currentFrame() const {
    return scheduler_.now().time_since_epoch() / kFrameLength;
}

void LoopbackUsbLink::arm() {
    const Frame current = currentFrame();
    std::optional<Frame> next;
    if (state_ == State::Opening || !controls_.empty()) next = current + 1;
    for (auto& [address, pipe] : pipes_) {
        const bool moves = !pipe.queue.empty() && (pipe.ready || !isInEndpoint(address));
        if (!moves) {
            pipe.due.reset();
            continue;
        }
        const bool everyFrame = options_.everyFrame || pipe.info.type != UsbEndpointInfo::Type::Interrupt;
        const Frame interval = everyFrame ? 1 : std::max<Frame>(pipe.info.interval_ms, 1);
        if (!pipe.due) pipe.due = (current / interval + 1) * interval;
        next = next ? std::min(*next, *pipe.due) : *pipe.due;
    }
    if (!next || (frameTimer_ != 0 && armedFor_ <= *next)) return;
    scheduler_.cancel(frameTimer_);
    armedFor_ = *next;
    frameTimer_ = scheduler_.callAt(TimePoint(*next * kFrameLength), [this] { runFrame(); });
}

void LoopbackUsbLink::runFrame() {
    frameTimer_ = 0;
    // What ends in this frame is told at its end: nothing is called back while the model is being asked.
    const bool deliverHere = !std::exchange(deliveryAsked_, true);
    if (state_ == State::Opening) openStep();
    if (state_ == State::Open && !controls_.empty()) serviceControl();
    const Frame current = currentFrame();
    for (auto& [address, pipe] : pipes_) {
        if (state_ != State::Open) break;
        if (!pipe.due || *pipe.due > current || pipe.queue.empty()) continue;
        pipe.due.reset();
        servicePipe(pipe);
    }
    arm();
    if (deliverHere) deliver();
}

void LoopbackUsbLink::openStep() {
    if (!model_.attached()) return finishOpen(fail(Errc::NoDevice, options_.port));
    UsbSetup setup;
    setup.request = kSetConfiguration;
    setup.value = nextConfiguration_;
    std::vector<std::uint8_t> unused;
    const UsbHandshake handshake = model_.control(setup, {}, unused);
    if (state_ != State::Opening) return;  // Unplugged by what the request did.
    if (handshake != UsbHandshake::Ack)
        return finishOpen(fail(Errc::Io, options_.port, "set configuration refused"));
    if (nextConfiguration_ == kConfigurationValue) return finishOpen(configured());
    nextConfiguration_ = kConfigurationValue;
}

Result<UsbDeviceInfo> LoopbackUsbLink::configured() {
    pipes_.clear();
    for (const UsbEndpointInfo& info : model_.descriptors().endpoints)
        pipes_[info.address].info = info;
    return describe(model_.descriptors(), options_.port);
}

void LoopbackUsbLink::finishOpen(Result<UsbDeviceInfo> result) {
    state_ = result ? State::Open : State::Closed;
    later([opened = std::exchange(opened_, nullptr), result = std::move(result)]() mutable {
        opened(std::move(result));
    });
}

void LoopbackUsbLink::serviceControl() {
    Control control = std::move(controls_.front());
    controls_.pop_front();
    std::vector<std::uint8_t> in;
    const UsbHandshake handshake = model_.control(control.setup, control.transfer.data, in);
    if (handshake == UsbHandshake::Nak && state_ == State::Open) {
        controls_.push_front(std::move(control));
        return;
    }
    scheduler_.cancel(control.deadline);
    UsbCallback done = std::move(control.transfer.done);
    if (handshake == UsbHandshake::Nak) return finish(std::move(done), UsbStatus::NoDevice);
    if (handshake == UsbHandshake::Stall) return finish(std::move(done), UsbStatus::Stalled);
    if (!control.setup.isIn())
        return finish(std::move(done), UsbStatus::Completed, control.transfer.data.size());
    const std::size_t actual = std::min<std::size_t>(in.size(), control.setup.length);
    finish(std::move(done), UsbStatus::Completed, actual, ByteView(in).first(actual));
}

void LoopbackUsbLink::servicePipe(Pipe& pipe) {
    Transfer transfer = std::move(pipe.queue.front());
    pipe.queue.pop_front();
    const bool isIn = isInEndpoint(pipe.info.address);
    std::size_t actual = transfer.data.size();
    packet_.resize(pipe.info.packetSize);
    // Before asking: the device may say from inside the call that it is ready again.
    pipe.ready = false;
    const UsbHandshake handshake =
        isIn ? model_.in(pipe.info.address, packet_, actual) : model_.out(pipe.info.address, transfer.data);
    if (handshake == UsbHandshake::Nak && state_ == State::Open) {
        pipe.queue.push_front(std::move(transfer));
        return;
    }
    pipe.ready = true;
    if (handshake == UsbHandshake::Nak) return finish(std::move(transfer.done), UsbStatus::NoDevice);
    if (handshake == UsbHandshake::Stall) return finish(std::move(transfer.done), UsbStatus::Stalled);
    if (!isIn) return finish(std::move(transfer.done), UsbStatus::Completed, actual);
    if (actual > transfer.size) return finish(std::move(transfer.done), UsbStatus::Overflow);
    finish(std::move(transfer.done), UsbStatus::Completed, actual, ByteView(packet_).first(actual));
}

void LoopbackUsbLink::endAll(UsbStatus status) {
    for (Control& control : controls_) {
        scheduler_.cancel(control.deadline);
        finish(std::move(control.transfer.done), status);
    }
    controls_.clear();
    for (auto& [address, pipe] : pipes_) {
        for (Transfer& transfer : pipe.queue)
            finish(std::move(transfer.done), status);
        pipe.queue.clear();
    }
}

void LoopbackUsbLink::finish(UsbCallback done, UsbStatus status, std::size_t actual, ByteView data) {
    if (!done) return;
    later([done = std::move(done), status, actual,
           bytes = std::vector<std::uint8_t>(data.begin(), data.end())] {
        done({.status = status, .data = bytes, .actual = actual});
    });
}

void LoopbackUsbLink::later(std::function<void()> callback) {
    outbox_.push_back(std::move(callback));
    if (std::exchange(deliveryAsked_, true)) return;
    scheduler_.post([this, alive = std::weak_ptr(alive_)] {
        if (!alive.expired()) deliver();
    });
}

void LoopbackUsbLink::deliver() {
    const std::weak_ptr alive(alive_);
    // What a callback asks for may end right here too, after that callback has returned.
    while (!outbox_.empty()) {
        const auto callback = std::move(outbox_.front());
        outbox_.pop_front();
        callback();
        if (alive.expired()) return;
    }
    deliveryAsked_ = false;
}

}  // namespace kickstand
