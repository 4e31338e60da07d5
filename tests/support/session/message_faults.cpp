#include "tests/support/session/message_faults.h"

#include <algorithm>
#include <utility>

#include "core/thunderbots/wire/dongle.h"

namespace kickstand::testing {
namespace {

namespace wire = thunderbots::wire;
using wire::Direction;

constexpr std::uint8_t kOut = wire::address(wire::Endpoint::MessageOut);
constexpr std::uint8_t kIn = wire::address(wire::Endpoint::MessageIn);
constexpr Duration kFrame = std::chrono::milliseconds(1);

bool isFirmware(ByteView packet, wire::Pipe pipe) {
    return !packet.empty() && wire::pipeNumberOfHeader(packet[0]) == static_cast<std::uint8_t>(pipe);
}

}  // namespace

MessageFaults::MessageFaults(std::unique_ptr<UsbLink> inner, Scheduler& scheduler, Judge judge)
    : scheduler_(scheduler), judge_(std::move(judge)), inner_(std::move(inner)) {}

MessageFaults::~MessageFaults() = default;

MessageFate MessageFaults::judge(Direction direction, ByteView packet) {
    return judge_(PassingMessage{index_++, direction, packet});
}

void MessageFaults::callLater(Duration delay, std::function<void()> call) {
    scheduler_.callAfter(delay, [alive = std::weak_ptr(alive_), call = std::move(call)] {
        if (!alive.expired()) call();
    });
}

Result<UsbTransferId> MessageFaults::submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) {
    const UsbTransferId id = ++lastId_;
    if (endpoint != kOut || !isFirmware(data, wire::Pipe::FirmwareRequest)) {
        auto inner = inner_->submitOut(endpoint, data, std::move(done));
        if (!inner) return inner;
        innerIds_[id] = *inner;
        return id;
    }
    const MessageFate fate = judge(Direction::Out, data);
    Bytes packet(data.begin(), data.end());
    if (!fate.replacement.empty()) packet = fate.replacement;
    callLater(fate.delay,
              [this, endpoint, packet = std::move(packet), copies = fate.copies,
               done = std::move(done)]() mutable { sendCopies(endpoint, packet, copies, std::move(done)); });
    return id;
}

void MessageFaults::sendCopies(std::uint8_t endpoint, const Bytes& packet, int copies, UsbCallback done) {
    if (copies == 0) {
        callLater(kFrame, [done = std::move(done), size = packet.size()] {
            done({.status = UsbStatus::Completed, .actual = size});
        });
        return;
    }
    const auto sent = inner_->submitOut(
        endpoint, packet, [this, endpoint, packet, copies, done](const UsbCompletion& completion) mutable {
            if (copies == 1 || completion.status != UsbStatus::Completed) {
                done(completion);
            } else {
                sendCopies(endpoint, packet, copies - 1, std::move(done));
            }
        });
    if (!sent) callLater({}, [done] { done({.status = UsbStatus::NoDevice}); });
}

Result<UsbTransferId> MessageFaults::submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) {
    const UsbTransferId id = ++lastId_;
    if (endpoint != kIn) {
        auto inner = inner_->submitIn(endpoint, size, std::move(done));
        if (!inner) return inner;
        innerIds_[id] = *inner;
        return id;
    }
    asked_.push_back({size, std::move(done)});
    callLater({}, [this] {
        deliver();
        askInner();
    });
    return id;
}

void MessageFaults::askInner() {
    while (asking_ < asked_.size()) {
        ++asking_;
        const auto inner =
            inner_->submitIn(kIn, asked_[asking_ - 1].size,
                             [this](const UsbCompletion& completion) { innerEnded(completion); });
        if (!inner) callLater({}, [this] { innerEnded({.status = UsbStatus::NoDevice}); });
    }
}

void MessageFaults::innerEnded(const UsbCompletion& completion) {
    --asking_;
    if (completion.status == UsbStatus::Completed) {
        arrive(completion);
        deliver();
        askInner();
        return;
    }
    if (asked_.empty()) return;
    const Asked asked = std::move(asked_.front());
    asked_.pop_front();
    asked.done({.status = completion.status});
}

void MessageFaults::arrive(const UsbCompletion& completion) {
    MessageFate fate;
    Bytes packet(completion.data.begin(), completion.data.end());
    if (isFirmware(packet, wire::Pipe::FirmwareResponse)) fate = judge(Direction::In, packet);
    if (!fate.replacement.empty()) packet = fate.replacement;
    TimePoint due = scheduler_.now() + fate.delay;
    if (!arrived_.empty()) due = std::max(due, arrived_.back().due);
    for (int i = 0; i < fate.copies; ++i)
        arrived_.push_back({due, packet});
    if (fate.delay > Duration::zero()) callLater(fate.delay, [this] { deliver(); });
    if (!fate.echo) return;
    callLater(*fate.echo, [this, packet] {
        arrived_.push_front({scheduler_.now(), packet});
        deliver();
    });
}

void MessageFaults::deliver() {
    while (!arrived_.empty() && !asked_.empty() && arrived_.front().due <= scheduler_.now()) {
        const Bytes packet = std::move(arrived_.front().packet);
        arrived_.pop_front();
        const Asked asked = std::move(asked_.front());
        asked_.pop_front();
        asked.done({.status = UsbStatus::Completed, .data = packet, .actual = packet.size()});
    }
}

void MessageFaults::open(std::function<void(Result<UsbDeviceInfo>)> done) {
    arrived_.clear();
    inner_->open(std::move(done));
}

void MessageFaults::close(std::function<void()> done) {
    arrived_.clear();
    inner_->close(std::move(done));
}

void MessageFaults::control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) {
    inner_->control(setup, data, deadline, std::move(done));
}

void MessageFaults::cancel(UsbTransferId id) {
    const auto found = innerIds_.find(id);
    if (found != innerIds_.end()) inner_->cancel(found->second);
}

void MessageFaults::clearHalt(std::uint8_t endpoint, UsbCallback done) {
    inner_->clearHalt(endpoint, std::move(done));
}

void MessageFaults::setPresenceListener(std::function<void(bool present)> listener) {
    inner_->setPresenceListener(std::move(listener));
}

}  // namespace kickstand::testing
