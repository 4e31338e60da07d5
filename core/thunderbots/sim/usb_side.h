#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/usb_device_model.h"
#include "core/link/usb_standard_requests.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/message_packet.h"

namespace kickstand::thunderbots::sim {

/// What stands behind the USB side of a simulated device: a dongle, or a robot on a cable.
class UsbSideOwner {
  public:
    virtual ~UsbSideOwner() = default;
    /// The host configured the device, or took the configuration away: everything starts afresh.
    virtual void configured(bool configured) = 0;
    /// A vendor request to the device. For IN, `in` is empty and takes the answer.
    virtual UsbHandshake vendorRequest(const UsbSetup& setup, std::vector<std::uint8_t>& in) = 0;
    virtual wire::DongleStatus status() const = 0;
    /// A state transport packet came, of whatever content; its blocks follow.
    virtual void statePacketCame() = 0;
    /// `block` has the length of a drive block; its content was not looked at.
    virtual void driveBlockCame(std::uint8_t robot, ByteView block) = 0;
    virtual bool roomForMessage() const = 0;
    virtual void messageCame(std::uint8_t robot, wire::Pipe pipe, ByteView payload) = 0;
    /// The host has taken the oldest message that waited for it. It is still inside that call.
    virtual void messageTaken() = 0;
};

/// The USB side that dongle and cable share (protocol 3): descriptors, endpoints with what waits on them, and
/// the reading of OUT packets, which may hold anything. On the scheduler's thread.
class UsbSide final : public UsbDeviceModel {
  public:
    using FeedbackBytes = std::array<std::uint8_t, wire::kFeedbackBytes>;

    /// `owner` must outlive it. It begins attached.
    UsbSide(std::uint16_t product, std::string productName, UsbSideOwner& owner);
    UsbSide(const UsbSide&) = delete;
    UsbSide& operator=(const UsbSide&) = delete;

    const UsbDescriptors& descriptors() const override { return descriptors_; }
    bool attached() const override { return attached_; }
    void setListener(UsbDeviceListener* listener) override { listener_ = listener; }
    UsbHandshake control(const UsbSetup& setup, ByteView out, std::vector<std::uint8_t>& in) override;
    UsbHandshake out(std::uint8_t endpoint, ByteView packet) override;
    UsbHandshake in(std::uint8_t endpoint, ByteSpan buffer, std::size_t& actual) override;

    // For the owner.
    bool configured() const { return requests_.configuration() != 0; }
    /// Plugs the device in or pulls it out; what waited is gone.
    void setAttached(bool attached);
    /// Sends the status if it is not what the host knows, or in any case.
    void statusChanged();
    void resendStatus();
    /// Puts a code into the error queue (protocol 3.9, 7.2); a full queue ends with the code that says so.
    void queueError(std::uint8_t code);
    /// Adds to the debug text (protocol 3.10).
    void queueText(std::string_view text);
    /// Sends a feedback block if it differs from the robot's last; the newest replaces one that still waits.
    void queueFeedback(std::uint8_t robot, const FeedbackBytes& feedback);
    /// The robot's next block is sent whatever it holds.
    void forgetFeedback(std::uint8_t robot);
    /// False, and nothing done, where there is no room.
    bool queueMessage(std::uint8_t robot, wire::Pipe pipe, const wire::MessagePayload& payload);
    /// The owner has room for a message again.
    void messageRoom() { ready(address(wire::Endpoint::MessageOut)); }
    /// Halts an endpoint until the host clears it.
    void halt(std::uint8_t endpoint);
    /// Packets and micropackets that made no sense.
    std::uint64_t malformed() const { return malformed_; }

  private:
    struct Feedback {
        FeedbackBytes newest{};
        FeedbackBytes sent{};
        bool everSent = false;
        bool waiting = false;
    };

    void clear();
    void ready(std::uint8_t endpoint);
    void readStatePacket(ByteView packet);
    UsbHandshake readMessage(ByteView packet);
    std::size_t take(wire::Endpoint endpoint, ByteSpan into);
    std::size_t takeStatus(ByteSpan into);
    std::size_t takeFeedback(ByteSpan into);
    std::size_t takeMessage(ByteSpan into);

    UsbSideOwner& owner_;
    const UsbDescriptors descriptors_;
    UsbStandardRequests requests_;
    UsbDeviceListener* listener_ = nullptr;
    bool attached_ = true;
    std::bitset<256> refused_;  ///< Endpoints by address that could not move a packet when last asked.

    wire::DongleStatus sentStatus_;
    bool statusWaiting_ = false;
    std::deque<std::uint8_t> errors_;
    std::deque<std::uint8_t> text_;
    std::array<Feedback, wire::kRobotCount> feedback_{};
    std::deque<std::uint8_t> feedbackOrder_;
    std::deque<wire::MessagePacket> messages_;
    std::uint64_t malformed_ = 0;
};

}  // namespace kickstand::thunderbots::sim
