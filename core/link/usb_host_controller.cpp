#include "core/link/usb_host_controller.h"

#include <algorithm>
#include <utility>

namespace kickstand {
namespace {

using namespace std::chrono_literals;

constexpr Duration kFrameLength = 1ms;

}  // namespace

std::size_t UsbHostController::Pipe::packetSize() const {
    // A descriptor may say 0, which would be no packet at all.
    return std::max<std::size_t>(info.packetSize, 1);
}

ByteView UsbHostController::Pipe::nextPacket(const Transfer& transfer) const {
    const ByteView data = transfer.data;
    const std::size_t begin = std::min(transfer.packetsSent * packetSize(), data.size());
    return data.subspan(begin, std::min(packetSize(), data.size() - begin));
}

UsbHostController::UsbHostController(Scheduler& scheduler, UsbDeviceModel& model, UsbBusOptions options)
    : scheduler_(scheduler), model_(model), options_(options) {
    for (const UsbEndpointInfo& info : model_.descriptors().endpoints)
        pipes_[info.address].info = info;
    model_.setListener(this);
}

UsbHostController::~UsbHostController() {
    model_.setListener(nullptr);
    scheduler_.cancel(frameTimer_);
}

// ---- What is asked for ----

UsbTransferId UsbHostController::control(const UsbSetup& setup, ByteView data, UsbCallback done) {
    Control control;
    const UsbTransferId id = ++lastId_;
    control.setup = setup;
    control.transfer.id = id;
    control.transfer.done = std::move(done);
    if (!setup.isIn()) control.transfer.data.assign(data.begin(), data.end());
    if (model_.attached()) {
        controls_.push_back(std::move(control));
        arm();
    } else {
        finishOut(control.transfer, UsbStatus::NoDevice);
    }
    return id;
}

UsbTransferId UsbHostController::out(std::uint8_t endpoint, ByteView data, bool zeroPacket,
                                     UsbCallback done) {
    Pipe* const pipe = isInEndpoint(endpoint) ? nullptr : pipeAt(endpoint);
    Transfer transfer;
    transfer.data.assign(data.begin(), data.end());
    transfer.done = std::move(done);
    if (pipe && !data.empty()) {
        const std::size_t size = pipe->packetSize();
        transfer.packets = static_cast<std::uint32_t>(data.size() / size);
        if (data.size() % size != 0 || zeroPacket) ++transfer.packets;
    }
    return submit(pipe, std::move(transfer));
}

UsbTransferId UsbHostController::in(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    Transfer transfer;
    transfer.size = size;
    transfer.done = std::move(done);
    return submit(isInEndpoint(endpoint) ? pipeAt(endpoint) : nullptr, std::move(transfer));
}

UsbTransferId UsbHostController::submit(Pipe* pipe, Transfer transfer) {
    const UsbTransferId id = ++lastId_;
    transfer.id = id;
    if (!pipe) {
        finishOut(transfer, UsbStatus::Failed);
    } else if (!model_.attached()) {
        finishOut(transfer, UsbStatus::NoDevice);
    } else {
        pipe->queue.push_back(std::move(transfer));
        arm();
    }
    return id;
}

bool UsbHostController::cancel(UsbTransferId id, UsbStatus status) {
    const auto control =
        std::ranges::find(controls_, id, [](const Control& waiting) { return waiting.transfer.id; });
    if (control != controls_.end()) {
        finishOut(control->transfer, status);
        controls_.erase(control);
        return true;
    }
    for (auto& [address, pipe] : pipes_) {
        const auto found = std::ranges::find(pipe.queue, id, &Transfer::id);
        if (found == pipe.queue.end()) continue;
        finish(pipe, *found, status);
        pipe.queue.erase(found);
        return true;
    }
    return false;
}

void UsbHostController::cancelAll(UsbStatus status) {
    for (Control& control : controls_)
        finishOut(control.transfer, status);
    controls_.clear();
    for (auto& [address, pipe] : pipes_) {
        for (Transfer& transfer : pipe.queue)
            finish(pipe, transfer, status);
        pipe.queue.clear();
    }
}

std::size_t UsbHostController::waiting() const {
    std::size_t count = controls_.size();
    for (const auto& [address, pipe] : pipes_)
        count += pipe.queue.size();
    return count;
}

UsbHostController::Pipe* UsbHostController::pipeAt(std::uint8_t endpoint) {
    const auto found = pipes_.find(endpoint);
    return found == pipes_.end() ? nullptr : &found->second;
}

// ---- What the device says ----

void UsbHostController::setAttachedListener(std::function<void(bool attached)> listener) {
    attachedListener_ = std::move(listener);
}

void UsbHostController::endpointReady(std::uint8_t endpoint) {
    Pipe* const pipe = pipeAt(endpoint);
    if (!pipe) return;
    pipe->ready = true;
    arm();
}

void UsbHostController::attachedChanged(bool attached) {
    if (!attached) {
        ++losses_;
        cancelAll(UsbStatus::NoDevice);
    }
    for (auto& [address, pipe] : pipes_)
        pipe.ready = true;
    if (attachedListener_) attachedListener_(attached);
}

// ---- Frames ----

UsbHostController::Frame UsbHostController::currentFrame() const {
    return scheduler_.now().time_since_epoch() / kFrameLength;
}

void UsbHostController::arm() {
    const Frame current = currentFrame();
    std::optional<Frame> next;
    if (!controls_.empty()) next = current + 1;
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

void UsbHostController::runFrame() {
    frameTimer_ = 0;
    // What ends in this frame is told at its end: nothing is called back while the model is being asked.
    const bool deliverHere = !std::exchange(deliveryAsked_, true);
    if (!controls_.empty()) serviceControl();
    const Frame current = currentFrame();
    for (auto& [address, pipe] : pipes_) {
        if (!pipe.due || *pipe.due > current || pipe.queue.empty()) continue;
        pipe.due.reset();
        servicePipe(pipe);
    }
    arm();
    if (deliverHere) deliver();
}

void UsbHostController::serviceControl() {
    // Out of the queue while the device is asked: it may be pulled out from inside the call. So with packets.
    Control control = std::move(controls_.front());
    controls_.pop_front();
    const std::uint64_t losses = losses_;
    std::vector<std::uint8_t> in;
    const UsbHandshake handshake = model_.control(control.setup, control.transfer.data, in);
    if (handshake == UsbHandshake::Nak && losses == losses_) {
        controls_.push_front(std::move(control));
    } else if (handshake == UsbHandshake::Nak) {
        finishOut(control.transfer, UsbStatus::NoDevice);
    } else if (handshake == UsbHandshake::Stall) {
        finishOut(control.transfer, UsbStatus::Stalled);
    } else if (control.setup.isIn()) {
        in.resize(std::min<std::size_t>(in.size(), control.setup.length));
        control.transfer.data = std::move(in);
        finishIn(control.transfer, UsbStatus::Completed);
    } else {
        finishOut(control.transfer, UsbStatus::Completed, control.transfer.data.size());
    }
}

void UsbHostController::servicePipe(Pipe& pipe) {
    Transfer transfer = std::move(pipe.queue.front());
    pipe.queue.pop_front();
    const bool isIn = isInEndpoint(pipe.info.address);
    const std::uint64_t losses = losses_;
    std::size_t count = 0;
    packet_.resize(pipe.packetSize());
    // Before asking: the device may say from inside the call that it is ready again.
    pipe.ready = false;
    const UsbHandshake handshake = isIn ? model_.in(pipe.info.address, packet_, count)
                                        : model_.out(pipe.info.address, pipe.nextPacket(transfer));
    if (handshake != UsbHandshake::Nak) pipe.ready = true;
    if (handshake == UsbHandshake::Stall) return finish(pipe, transfer, UsbStatus::Stalled);
    if (handshake == UsbHandshake::Ack) {
        const bool ended = isIn ? received(pipe, transfer, count) : sent(pipe, transfer);
        if (ended) return;
    }
    if (losses != losses_) return finish(pipe, transfer, UsbStatus::NoDevice);
    pipe.queue.push_front(std::move(transfer));
}

bool UsbHostController::sent(const Pipe& pipe, Transfer& transfer) {
    if (++transfer.packetsSent < transfer.packets) return false;
    finish(pipe, transfer, UsbStatus::Completed);
    return true;
}

bool UsbHostController::received(const Pipe& pipe, Transfer& transfer, std::size_t count) {
    const bool fits = count <= transfer.size - transfer.data.size();
    if (fits)
        transfer.data.insert(transfer.data.end(), packet_.begin(),
                             packet_.begin() + static_cast<std::ptrdiff_t>(count));
    const bool last = count < pipe.packetSize() || transfer.data.size() == transfer.size;
    if (fits && !last) return false;
    finishIn(transfer, fits ? UsbStatus::Completed : UsbStatus::Overflow);
    return true;
}

// ---- Endings ----

void UsbHostController::finish(const Pipe& pipe, Transfer& transfer, UsbStatus status) {
    if (isInEndpoint(pipe.info.address)) return finishIn(transfer, status);
    finishOut(transfer, status, std::min(transfer.packetsSent * pipe.packetSize(), transfer.data.size()));
}

void UsbHostController::finishIn(Transfer& transfer, UsbStatus status) {
    const std::size_t actual = transfer.data.size();
    if (transfer.done) tell({std::move(transfer.done), status, actual, std::move(transfer.data), {}});
}

void UsbHostController::finishOut(Transfer& transfer, UsbStatus status, std::size_t actual) {
    if (transfer.done) tell({std::move(transfer.done), status, actual, {}, {}});
}

void UsbHostController::later(std::function<void()> callback) {
    Message message;
    message.callback = std::move(callback);
    tell(std::move(message));
}

void UsbHostController::tell(Message message) {
    outbox_.push_back(std::move(message));
    if (std::exchange(deliveryAsked_, true)) return;
    scheduler_.post([this, alive = std::weak_ptr(alive_)] {
        if (!alive.expired()) deliver();
    });
}

void UsbHostController::deliver() {
    const std::weak_ptr alive(alive_);
    // What a callback asks for may end right here too, after that callback has returned.
    for (std::size_t i = 0; i < outbox_.size(); ++i) {
        const Message message = std::move(outbox_[i]);
        if (message.done)
            message.done({.status = message.status, .data = message.data, .actual = message.actual});
        if (message.callback) message.callback();
        if (alive.expired()) return;
    }
    outbox_.clear();
    deliveryAsked_ = false;
}

}  // namespace kickstand
