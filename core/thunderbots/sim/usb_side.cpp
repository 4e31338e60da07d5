#include "core/thunderbots/sim/usb_side.h"

#include <algorithm>
#include <utility>

#include "core/link/usb_descriptors.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots::sim {
namespace {

using wire::Endpoint;

constexpr std::size_t kErrorQueueSize = 64;
constexpr std::size_t kTextSize = 256;
constexpr std::size_t kMessagesIn = 16;
constexpr std::uint8_t kLocalInterval_ms = 25;
constexpr std::uint8_t kTransportInterval_ms = 1;

// Codes of the error queue (protocol 7.2).
constexpr std::uint8_t kMicropacketOverflow = 36;
constexpr std::uint8_t kMicropacketToNoPipe = 37;
constexpr std::uint8_t kMicropacketBadLength = 38;
constexpr std::uint8_t kDebugOverflow = 39;
constexpr std::uint8_t kErrorQueueOverflow = 40;

UsbEndpointInfo interrupt(Endpoint endpoint, std::size_t size, std::uint8_t interval_ms) {
    return {.address = address(endpoint),
            .type = UsbEndpointInfo::Type::Interrupt,
            .packetSize = static_cast<std::uint16_t>(size),
            .interval_ms = interval_ms};
}

UsbDescriptors describe(std::uint16_t product, std::string productName) {
    UsbDeviceDescription device{.vendor = wire::kVendorId,
                                .product = product,
                                .release = wire::kDeviceRelease,
                                .manufacturer = wire::kManufacturerName,
                                .productName = std::move(productName),
                                .serialNumber = {},
                                .controlPacketSize = wire::kControlPacketBytes,
                                .power_mA = wire::kMaxCurrent_mA,
                                .interfaces = {}};
    UsbInterfaceDescription local{.name = wire::kLocalDataName, .endpoints = {}};
    local.endpoints = {interrupt(Endpoint::Status, wire::kStatusBytes, kLocalInterval_ms),
                       interrupt(Endpoint::ErrorQueue, wire::kPacketBytes, kLocalInterval_ms),
                       {.address = address(Endpoint::Statistics),
                        .type = UsbEndpointInfo::Type::Bulk,
                        .packetSize = wire::kStatisticsBytes},
                       interrupt(Endpoint::DebugText, wire::kPacketBytes, kLocalInterval_ms)};
    UsbInterfaceDescription transport{.name = wire::kMainTransportName, .endpoints = {}};
    for (const Endpoint endpoint :
         {Endpoint::StateOut, Endpoint::StateIn, Endpoint::MessageOut, Endpoint::MessageIn})
        transport.endpoints.push_back(interrupt(endpoint, wire::kPacketBytes, kTransportInterval_ms));
    device.interfaces = {std::move(local), std::move(transport)};
    return buildUsbDescriptors(device);
}

/// Moves bytes from the front of a queue to where they go.
std::size_t drain(std::deque<std::uint8_t>& queue, ByteSpan into) {
    const std::size_t count = std::min(queue.size(), into.size());
    const auto end = queue.begin() + static_cast<std::ptrdiff_t>(count);
    std::copy(queue.begin(), end, into.begin());
    queue.erase(queue.begin(), end);
    return count;
}

}  // namespace

UsbSide::UsbSide(std::uint16_t product, std::string productName, UsbSideOwner& owner)
    : owner_(owner),
      descriptors_(describe(product, std::move(productName))),
      requests_(descriptors_, {.configured =
                                   [this](std::uint8_t configuration) {
                                       clear();
                                       owner_.configured(configuration != 0);
                                       sentStatus_ = owner_.status();
                                   },
                               .haltCleared = [this](std::uint8_t endpoint) { ready(endpoint); }}) {}

// ---- What the host does ----

UsbHandshake UsbSide::control(const UsbSetup& setup, ByteView out, std::vector<std::uint8_t>& in) {
    if (!attached_) return UsbHandshake::Stall;
    in.clear();
    if (const auto standard = requests_.handle(setup, in)) return *standard;
    const bool toDevice = setup.requestType == wire::kVendorIn || setup.requestType == wire::kVendorOut;
    if (!toDevice || !out.empty()) return UsbHandshake::Stall;
    return owner_.vendorRequest(setup, in);
}

UsbHandshake UsbSide::out(std::uint8_t endpoint, ByteView packet) {
    if (!attached_ || !configured()) return UsbHandshake::Stall;
    if (requests_.isHalted(endpoint)) {
        refused_.set(endpoint);
        return UsbHandshake::Stall;
    }
    switch (static_cast<Endpoint>(endpoint)) {
        case Endpoint::StateOut:
            readStatePacket(packet);
            return UsbHandshake::Ack;
        case Endpoint::MessageOut:
            return readMessage(packet);
        default:
            return UsbHandshake::Stall;
    }
}

UsbHandshake UsbSide::in(std::uint8_t endpoint, ByteSpan buffer, std::size_t& actual) {
    actual = 0;
    if (!attached_ || !configured()) return UsbHandshake::Stall;
    const bool exists = std::ranges::any_of(
        descriptors_.endpoints, [&](const UsbEndpointInfo& info) { return info.address == endpoint; });
    if (!exists || !isInEndpoint(endpoint)) return UsbHandshake::Stall;
    if (requests_.isHalted(endpoint)) {
        refused_.set(endpoint);
        return UsbHandshake::Stall;
    }
    actual = take(static_cast<Endpoint>(endpoint), buffer);
    if (actual == 0) refused_.set(endpoint);
    return actual == 0 ? UsbHandshake::Nak : UsbHandshake::Ack;
}

void UsbSide::readStatePacket(ByteView packet) {
    owner_.statePacketCame();
    wire::MicropacketReader reader(packet, wire::Direction::Out);
    while (const auto micropacket = reader.next()) {
        if (*micropacket) {
            owner_.driveBlockCame((*micropacket)->robot, (*micropacket)->payload);
            continue;
        }
        ++malformed_;
        const std::size_t left = reader.droppedBytes();
        const std::uint8_t length = packet[packet.size() - left];
        if (micropacket->error().fault == wire::WireFault::UnknownKind) {
            queueError(kMicropacketToNoPipe);
        } else {
            queueError(length > left || packet.size() > wire::kMaxStatePacket ? kMicropacketOverflow
                                                                              : kMicropacketBadLength);
        }
    }
}

UsbHandshake UsbSide::readMessage(ByteView packet) {
    if (!owner_.roomForMessage()) {
        refused_.set(address(Endpoint::MessageOut));
        return UsbHandshake::Nak;
    }
    const auto message = wire::decodeMessagePacket(packet, wire::Direction::Out);
    if (message) {
        owner_.messageCame(message->robot, message->pipe, message->payload);
    } else {
        ++malformed_;
        queueError(message.error().fault == wire::WireFault::UnknownKind ? kMicropacketToNoPipe
                                                                         : kMicropacketBadLength);
    }
    return UsbHandshake::Ack;
}

// ---- What waits for the host ----

std::size_t UsbSide::take(Endpoint endpoint, ByteSpan into) {
    switch (endpoint) {
        case Endpoint::Status:
            return takeStatus(into);
        case Endpoint::ErrorQueue:
            return drain(errors_, into.first(std::min(into.size(), wire::kPacketBytes)));
        case Endpoint::DebugText:
            return drain(text_, into.first(std::min(into.size(), wire::kPacketBytes)));
        case Endpoint::StateIn:
            return takeFeedback(into);
        case Endpoint::MessageIn:
            return takeMessage(into);
        default:
            return 0;
    }
}

std::size_t UsbSide::takeStatus(ByteSpan into) {
    if (!statusWaiting_ || into.size() < wire::kStatusBytes) return 0;
    statusWaiting_ = false;
    sentStatus_ = owner_.status();
    std::ranges::copy(wire::encodeStatus(sentStatus_), into.begin());
    return wire::kStatusBytes;
}

std::size_t UsbSide::takeFeedback(ByteSpan into) {
    wire::StatePacketBuilder builder;
    while (!feedbackOrder_.empty() && !builder.full() &&
           builder.packet().size() + wire::kFeedbackMicropacketBytes <= into.size()) {
        const std::uint8_t robot = feedbackOrder_.front();
        feedbackOrder_.pop_front();
        Feedback& feedback = feedback_[robot];
        feedback.waiting = false;
        if (feedback.everSent && feedback.newest == feedback.sent) continue;
        if (!builder.addFeedback(robot, feedback.newest)) continue;
        feedback.sent = feedback.newest;
        feedback.everSent = true;
    }
    std::ranges::copy(builder.packet(), into.begin());
    return builder.packet().size();
}

std::size_t UsbSide::takeMessage(ByteSpan into) {
    if (messages_.empty() || messages_.front().size() > into.size()) return 0;
    const wire::MessagePacket packet = messages_.front();
    messages_.pop_front();
    std::copy(packet.begin(), packet.end(), into.begin());
    owner_.messageTaken();
    return packet.size();
}

void UsbSide::setAttached(bool attached) {
    if (attached == attached_) return;
    attached_ = attached;
    requests_.reset();
    clear();
    if (listener_) listener_->attachedChanged(attached);
}

void UsbSide::statusChanged() {
    if (owner_.status() != sentStatus_) resendStatus();
}

void UsbSide::resendStatus() {
    statusWaiting_ = true;
    ready(address(Endpoint::Status));
}

void UsbSide::queueError(std::uint8_t code) {
    if (errors_.size() < kErrorQueueSize) {
        errors_.push_back(code);
    } else {
        errors_.back() = kErrorQueueOverflow;
    }
    ready(address(Endpoint::ErrorQueue));
}

void UsbSide::queueText(std::string_view text) {
    const std::size_t room = kTextSize - text_.size();
    const std::string_view fits = text.substr(0, room);
    text_.insert(text_.end(), fits.begin(), fits.end());
    if (fits.size() < text.size()) queueError(kDebugOverflow);
    ready(address(Endpoint::DebugText));
}

void UsbSide::queueFeedback(std::uint8_t robot, const FeedbackBytes& bytes) {
    Feedback& feedback = feedback_[robot];
    feedback.newest = bytes;
    if (feedback.waiting || (feedback.everSent && bytes == feedback.sent)) return;
    feedback.waiting = true;
    feedbackOrder_.push_back(robot);
    ready(address(Endpoint::StateIn));
}

void UsbSide::forgetFeedback(std::uint8_t robot) {
    feedback_[robot] = {};
    std::erase(feedbackOrder_, robot);
}

bool UsbSide::queueMessage(std::uint8_t robot, wire::Pipe pipe, const wire::MessagePayload& payload) {
    if (messages_.size() == kMessagesIn) return false;
    const auto packet = wire::encodeMessagePacket(robot, pipe, payload.view());
    if (!packet) return false;
    messages_.push_back(*packet);
    ready(address(Endpoint::MessageIn));
    return true;
}

void UsbSide::halt(std::uint8_t endpoint) {
    requests_.halt(endpoint);
    ready(endpoint);
}

void UsbSide::clear() {
    statusWaiting_ = false;
    errors_.clear();
    text_.clear();
    feedback_ = {};
    feedbackOrder_.clear();
    messages_.clear();
}

void UsbSide::ready(std::uint8_t endpoint) {
    if (!refused_.test(endpoint)) return;
    refused_.reset(endpoint);
    if (listener_ && attached_) listener_->endpointReady(endpoint);
}

}  // namespace kickstand::thunderbots::sim
