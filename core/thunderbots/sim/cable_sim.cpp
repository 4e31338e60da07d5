#include "core/thunderbots/sim/cable_sim.h"

#include <chrono>

namespace kickstand::thunderbots::sim {
namespace {

constexpr const char* kRobotProductName = "Thunderbots Robot";
constexpr Duration kPeriod = std::chrono::milliseconds(5);
constexpr std::uint8_t kSendFailed = 41;

}  // namespace

CableSim::CableSim(Scheduler& scheduler, RobotSim& robot)
    : robot_(robot),
      usb_(wire::kCableProductId, kRobotProductName, *this),
      tick_(scheduler),
      soon_(scheduler) {
    // Either may be heard from inside a call of the host: what follows from it waits until that is over.
    robot_.setListener(
        {.messageWaiting = [this] { soon_.after(Duration::zero(), [this] { offerMessage(); }); },
         .powerChanged = [this] { soon_.after(Duration::zero(), [this] { updateAttachment(); }); }});
}

void CableSim::setPlugged(bool plugged) {
    plugged_ = plugged;
    updateAttachment();
}

void CableSim::updateAttachment() {
    const bool attached = plugged_ && robot_.up();
    if (attached == usb_.attached()) return;
    tick_.stop();
    messageOffered_ = false;
    usb_.setAttached(attached);
}

void CableSim::configured(bool configured) {
    tick_.stop();
    messageOffered_ = false;
    if (!configured) return;
    usb_.queueText("Thunderbots robot ready\n");
    tick_.start(Duration::zero(), [this] { tick(); });
}

UsbHandshake CableSim::vendorRequest(const UsbSetup& setup, std::vector<std::uint8_t>& /*in*/) {
    // There are no radios to ask about, to set or to enable.
    const bool resend =
        !setup.isIn() && setup.request == static_cast<std::uint8_t>(wire::VendorRequest::ResendStatus);
    if (!resend) return UsbHandshake::Stall;
    usb_.resendStatus();
    return UsbHandshake::Ack;
}

wire::DongleStatus CableSim::status() const {
    return {.eStop = wire::EStop::Run,
            .radios = wire::RadioState::Running,
            .aliveRobots = static_cast<std::uint16_t>(1U << (robot_.number() & 0x0F))};
}

void CableSim::driveBlockCame(std::uint8_t robot, ByteView block) {
    // A host that has not learnt the number yet brakes all sixteen: blocks for others are no error.
    if (robot == (robot_.number() & 0x0F)) robot_.takeDrive(block);
}

void CableSim::messageCame(std::uint8_t robot, wire::Pipe pipe, ByteView payload) {
    if (robot == (robot_.number() & 0x0F)) {
        robot_.takeMessage(pipe, payload);
    } else {
        usb_.queueError(static_cast<std::uint8_t>(kSendFailed + robot));
    }
}

void CableSim::messageTaken() {
    soon_.after(Duration::zero(), [this] {
        if (!messageOffered_) return;
        messageOffered_ = false;
        robot_.outgoingDelivered();
        offerMessage();
    });
}

void CableSim::offerMessage() {
    const OutgoingMessage* message = robot_.outgoing();
    if (!message || messageOffered_ || !usb_.configured()) return;
    messageOffered_ = usb_.queueMessage(robot_.number() & 0x0F, message->pipe, message->payload);
}

void CableSim::tick() {
    if (const auto feedback = robot_.feedback()) usb_.queueFeedback(robot_.number() & 0x0F, *feedback);
    offerMessage();
    tick_.start(kPeriod, [this] { tick(); });
}

}  // namespace kickstand::thunderbots::sim
