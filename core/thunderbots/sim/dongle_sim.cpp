#include "core/thunderbots/sim/dongle_sim.h"

#include <algorithm>
#include <chrono>

namespace kickstand::thunderbots::sim {
namespace {

using std::chrono::milliseconds;

constexpr Duration kDeadMan = std::chrono::seconds(2);
constexpr Duration kRadioStartTime = milliseconds(100);
constexpr wire::RadioVersions kRadioVersions{.radio0 = 0x10E8, .radio1 = 0x10E8};
constexpr wire::Channels kFactoryChannels{};

// Codes of the error queue (protocol 7.2): the first of a pair or row.
constexpr std::uint8_t kRadioResetFailed = 22;
constexpr std::uint8_t kSendFailed = 41;
constexpr std::uint8_t kInboundOverflow = 57;

std::uint8_t codeFor(std::uint8_t first, std::uint8_t index) {
    return static_cast<std::uint8_t>(first + index);
}

}  // namespace

DongleSim::DongleSim(Scheduler& scheduler, RadioMedium& medium, std::vector<RobotRadio>& robots,
                     const DongleSettings& settings)
    : scheduler_(scheduler),
      usb_(wire::kDongleProductId, wire::kProductName, *this),
      radio_(scheduler, medium, settings.pace, robots, *this),
      radioStart_(scheduler),
      deadMan_(scheduler),
      channels_(settings.channels) {
    if (!wire::encodeChannelsValue(channels_)) channels_ = kFactoryChannels;
    for (RobotRadio& robot : robots) {
        robot.robot().setListener(
            {.messageWaiting = [this, &robot] { radio_.messageWaiting(robot.robot().number()); },
             .powerChanged = {}});
    }
}

// ---- Hands from outside ----

void DongleSim::setPlugged(bool plugged) {
    if (plugged == usb_.attached()) return;
    startAfresh();
    usb_.setAttached(plugged);
}

void DongleSim::setEStop(wire::EStop position) {
    eStop_ = position;
    usb_.statusChanged();
}

void DongleSim::setRadioFailure(std::optional<std::uint8_t> radio) {
    failingRadio_ = radio;
    if (radio && radios_ == wire::RadioState::Running) radioFailed(*radio);
}

// ---- Start-up ----

void DongleSim::configured(bool configured) {
    startAfresh();
    if (!configured) return;
    usb_.queueText("Thunderbots XBee Dongle ready\n");
    lastPacket_ = scheduler_.now();
    watchHost();
}

void DongleSim::startAfresh() {
    radioStart_.stop();
    deadMan_.stop();
    radio_.stop();
    radios_ = wire::RadioState::PreInit;
    blocks_ = {};
    messagesHeld_ = 0;
    knownAlive_ = 0;
    refusedMessage_ = 0;
}

UsbHandshake DongleSim::vendorRequest(const UsbSetup& setup, std::vector<std::uint8_t>& in) {
    const auto answer = [&in](const auto& bytes) {
        in.assign(bytes.begin(), bytes.end());
        return UsbHandshake::Ack;
    };
    const auto acceptIf = [](bool accepted) { return accepted ? UsbHandshake::Ack : UsbHandshake::Stall; };
    if (setup.isIn()) {
        switch (static_cast<wire::VendorRequest>(setup.request)) {
            case wire::VendorRequest::ReadRadioVersions:
                return answer(wire::encodeRadioVersions(kRadioVersions));
            case wire::VendorRequest::ReadChannels:
                return answer(std::array{channels_.channel0, channels_.channel1});
            default:
                return UsbHandshake::Stall;
        }
    }
    switch (static_cast<wire::VendorRequest>(setup.request)) {
        case wire::VendorRequest::SetChannels:
            return acceptIf(setChannels(setup.value));
        case wire::VendorRequest::EnableRadios:
            return acceptIf(enableRadios());
        case wire::VendorRequest::ResendStatus:
            usb_.resendStatus();
            return UsbHandshake::Ack;
        default:
            return UsbHandshake::Stall;
    }
}

bool DongleSim::setChannels(std::uint16_t value) {
    const auto channels = wire::decodeChannelsValue(value);
    if (!channels || radios_ != wire::RadioState::PreInit) return false;
    channels_ = *channels;
    return true;
}

bool DongleSim::enableRadios() {
    if (!usb_.configured()) return false;
    if (radios_ == wire::RadioState::PreInit) startRadio(0);
    return true;
}

void DongleSim::startRadio(std::uint8_t radio) {
    setRadios(radio == 0 ? wire::RadioState::InitRadio0 : wire::RadioState::InitRadio1);
    radioStart_.start(kRadioStartTime, [this, radio] {
        if (failingRadio_ == radio) return radioFailed(radio);
        if (radio == 0) return startRadio(1);
        radio_.start(channels_);
        setRadios(wire::RadioState::Running);
    });
}

void DongleSim::radioFailed(std::uint8_t radio) {
    radio_.breakDown();
    usb_.queueError(codeFor(kRadioResetFailed, radio));
    setRadios(radio == 0 ? wire::RadioState::Radio0Failed : wire::RadioState::Radio1Failed);
}

void DongleSim::setRadios(wire::RadioState state) {
    radios_ = state;
    usb_.statusChanged();
}

wire::DongleStatus DongleSim::status() const {
    return {.eStop = eStop_, .radios = radios_, .aliveRobots = radio_.alive()};
}

// ---- From the host ----

void DongleSim::statePacketCame() {
    lastPacket_ = scheduler_.now();
}

void DongleSim::watchHost() {
    // One timer that looks again, rather than one set anew with every packet.
    const TimePoint due = lastPacket_ + kDeadMan;
    if (scheduler_.now() >= due) {
        brakeAll();
        lastPacket_ = scheduler_.now();
    }
    deadMan_.startAt(lastPacket_ + kDeadMan, [this] { watchHost(); });
}

void DongleSim::brakeAll() {
    for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
        if (blocks_[robot][0] == 0) continue;
        blocks_[robot][0] = 0;
        radio_.driveChanged(robot);
    }
}

void DongleSim::driveBlockCame(std::uint8_t robot, ByteView block) {
    DriveBytes& stored = blocks_[robot];
    if (std::ranges::equal(stored, block)) return;
    std::ranges::copy(block, stored.begin());
    radio_.driveChanged(robot);
}

DongleSim::DriveBytes DongleSim::driveBlock(std::uint8_t robot) const {
    DriveBytes block = blocks_[robot];
    if (eStop_ != wire::EStop::Run) block[0] = 0;
    return block;
}

void DongleSim::messageCame(std::uint8_t robot, wire::Pipe pipe, ByteView payload) {
    if (!radio_.alive(robot)) return usb_.queueError(codeFor(kSendFailed, robot));
    ++messagesHeld_;
    radio_.send(robot, pipe, payload);
}

// ---- From the robots ----

void DongleSim::feedbackCame(std::uint8_t robot, const RobotSim::FeedbackBytes& feedback) {
    usb_.queueFeedback(robot, feedback);
}

bool DongleSim::messageCame(std::uint8_t robot, wire::Pipe pipe, const wire::MessagePayload& payload) {
    const auto bit = static_cast<std::uint16_t>(1U << robot);
    const bool taken = usb_.queueMessage(robot, pipe, payload);
    if (!taken && (refusedMessage_ & bit) == 0) usb_.queueError(codeFor(kInboundOverflow, robot));
    refusedMessage_ = static_cast<std::uint16_t>(taken ? refusedMessage_ & ~bit : refusedMessage_ | bit);
    return taken;
}

void DongleSim::messageEnded(std::uint8_t robot, bool delivered) {
    const bool wasFull = messagesHeld_ == kMessageBuffers;
    --messagesHeld_;
    if (!delivered) usb_.queueError(codeFor(kSendFailed, robot));
    if (wasFull) usb_.messageRoom();
}

void DongleSim::aliveChanged() {
    const std::uint16_t alive = radio_.alive();
    for (std::uint8_t robot = 0; robot < wire::kRobotCount; ++robot) {
        // What a robot said in an earlier life is no reason to keep its first word back.
        if (((alive & ~knownAlive_) >> robot & 1) != 0) usb_.forgetFeedback(robot);
    }
    knownAlive_ = alive;
    usb_.statusChanged();
}

}  // namespace kickstand::thunderbots::sim
