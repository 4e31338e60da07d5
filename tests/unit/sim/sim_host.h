#pragma once

#include <array>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/link/usb_device_model.h"
#include "core/thunderbots/sim/thunderbots_sim.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/firmware.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::sim::test {

using namespace std::chrono_literals;

/// What came in on the message endpoint.
struct InMessage {
    std::uint8_t robot = 0;
    wire::Pipe pipe = wire::Pipe::Indicator;
    std::vector<std::uint8_t> payload;
};

/// A bare host: talks to the simulated device as a host controller would, without any of the program's own
/// logic, and keeps what it heard.
class SimHost final : private UsbDeviceListener {
  public:
    explicit SimHost(const ThunderbotsSimOptions& options);
    ~SimHost() override;
    SimHost(const SimHost&) = delete;
    SimHost& operator=(const SimHost&) = delete;

    /// Configures the device and enables the radios.
    void configure();
    /// The same, and waits until `robots` are alive.
    bool start(std::uint16_t robots);
    UsbHandshake vendor(std::uint8_t requestType, wire::VendorRequest request, std::uint16_t value = 0);
    UsbHandshake setConfiguration(std::uint16_t value);

    /// Lets time pass with a keep-alive every 300 ms, reading everything that comes.
    void run(Duration span);
    /// run() until it holds, at most for `limit`.
    bool runUntil(const std::function<bool()>& done, Duration limit);
    /// Lets time pass without sending anything, reading everything that comes.
    void stayQuiet(Duration span);
    /// Reads every IN endpoint until it has nothing more.
    void drain();

    UsbHandshake out(wire::Endpoint endpoint, ByteView packet);
    UsbHandshake keepAlive() { return out(wire::Endpoint::StateOut, {}); }
    UsbHandshake drive(std::uint8_t robot, const wire::DriveBlock& block);
    UsbHandshake message(std::uint8_t robot, wire::Pipe pipe, ByteView payload);
    UsbHandshake kick(std::uint8_t robot, const wire::KickTimes& times);
    UsbHandshake firmware(std::uint8_t robot, const wire::FirmwareRequest& request);
    /// Sends a request and waits for its response.
    std::optional<wire::FirmwareResponse> ask(std::uint8_t robot, const wire::FirmwareRequest& request,
                                              Duration limit = 1s);

    bool perform(std::string_view action, int unit, double value);
    std::size_t count(wire::Pipe pipe) const;

    FakeScheduler scheduler;
    ThunderbotsSim sim;
    UsbDeviceModel& device;

    std::vector<wire::DongleStatus> statuses;
    std::vector<std::uint8_t> errors;
    std::string text;
    std::map<std::uint8_t, std::vector<wire::FeedbackBlock>> feedback;
    std::vector<std::size_t> statePackets;  ///< Micropackets in each.
    std::vector<InMessage> messages;
    std::vector<std::uint8_t> readyEndpoints;
    std::vector<bool> attachments;

  private:
    void endpointReady(std::uint8_t endpoint) override { readyEndpoints.push_back(endpoint); }
    void attachedChanged(bool attached) override { attachments.push_back(attached); }
    std::optional<std::vector<std::uint8_t>> read(wire::Endpoint endpoint);

    TimePoint lastPacket_{};
};

/// Ideal radio, exact converters: what most tests want.
ThunderbotsSimOptions quietOptions(std::uint16_t robots = 0x0001);

/// A block that runs all wheels at one speed.
wire::DriveBlock running(std::int16_t speed);

}  // namespace kickstand::thunderbots::sim::test
