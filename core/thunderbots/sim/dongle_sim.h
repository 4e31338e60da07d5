#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/thunderbots/sim/radio_sim.h"
#include "core/thunderbots/sim/usb_side.h"

namespace kickstand::thunderbots::sim {

/// How a dongle is made.
struct DongleSettings {
    RadioPace pace = RadioPace::True;
    wire::Channels channels;  ///< Stored in it; values that do not exist are replaced when it starts.
};

/// The dongle (protocol 3): stored drive blocks with the dead-man and the e-stop over them, six message
/// buffers, the start-up of its radios, and the radio hop behind them. On the scheduler's thread.
class DongleSim final : private UsbSideOwner, private RadioHost {
  public:
    /// Messages that it holds for robots; then it answers Nak.
    static constexpr std::size_t kMessageBuffers = 6;

    /// `medium` and `robots` must outlive it.
    DongleSim(Scheduler& scheduler, RadioMedium& medium, std::vector<RobotRadio>& robots,
              const DongleSettings& settings);

    UsbSide& usb() { return usb_; }
    const UsbSide& usb() const { return usb_; }

    // For a hand from outside.
    /// Pulls the plug or puts it back; without it the dongle has no power and forgets.
    void setPlugged(bool plugged);
    /// Turns the emergency stop switch.
    void setEStop(wire::EStop position);
    wire::EStop eStop() const { return eStop_; }
    /// Which radio fails, now and at every start; none: both work, from the next start on.
    void setRadioFailure(std::optional<std::uint8_t> radio);
    std::optional<std::uint8_t> radioFailure() const { return failingRadio_; }

    // For a look.
    wire::DongleStatus status() const override;
    wire::Channels channels() const { return channels_; }
    /// The block that goes to a robot now, dead-man and e-stop applied.
    DriveBytes driveBlock(std::uint8_t robot) const override;
    std::size_t messagesHeld() const { return messagesHeld_; }

  private:
    void configured(bool configured) override;
    UsbHandshake vendorRequest(const UsbSetup& setup, std::vector<std::uint8_t>& in) override;
    void statePacketCame() override;
    void driveBlockCame(std::uint8_t robot, ByteView block) override;
    bool roomForMessage() const override { return messagesHeld_ < kMessageBuffers; }
    void messageCame(std::uint8_t robot, wire::Pipe pipe, ByteView payload) override;
    void messageTaken() override {}

    void feedbackCame(std::uint8_t robot, const RobotSim::FeedbackBytes& feedback) override;
    bool messageCame(std::uint8_t robot, wire::Pipe pipe, const wire::MessagePayload& payload) override;
    void messageEnded(std::uint8_t robot, bool delivered) override;
    void aliveChanged() override;

    bool setChannels(std::uint16_t value);
    bool enableRadios();
    void startRadio(std::uint8_t radio);
    void radioFailed(std::uint8_t radio);
    void setRadios(wire::RadioState state);
    void startAfresh();
    void watchHost();
    void brakeAll();

    Scheduler& scheduler_;
    UsbSide usb_;
    RadioSim radio_;
    Timer radioStart_;
    Timer deadMan_;
    wire::Channels channels_;
    wire::EStop eStop_ = wire::EStop::Run;
    std::optional<std::uint8_t> failingRadio_;

    wire::RadioState radios_ = wire::RadioState::PreInit;
    std::array<DriveBytes, wire::kRobotCount> blocks_{};
    TimePoint lastPacket_{};
    std::size_t messagesHeld_ = 0;
    std::uint16_t knownAlive_ = 0;
    std::uint16_t refusedMessage_ = 0;  ///< Bit n: robot n's message found no room; said once.
};

}  // namespace kickstand::thunderbots::sim
