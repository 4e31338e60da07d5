#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/base/session_host.h"
#include "core/link/tapped_usb_link.h"
#include "core/thunderbots/dongle_controller.h"
#include "core/thunderbots/fleet_model.h"
#include "core/thunderbots/robot_requests.h"
#include "core/thunderbots/sim/thunderbots_sim.h"
#include "tests/support/session/message_faults.h"

namespace kickstand::testing {

/// Requests to simulated robots with nothing around them but the link, on a fake clock.
class RequestRig final : private UsbTapObserver, private SampleSink {
  public:
    /// `judge` decides what becomes of firmware messages; without it nothing goes wrong.
    explicit RequestRig(const thunderbots::sim::ThunderbotsSimOptions& options,
                        MessageFaults::Judge judge = {});

    /// Starts the link and waits for the robots. False when that takes more than 20 s.
    bool connect();
    /// Asks, and waits for the end of it, for at most ten minutes.
    Result<thunderbots::wire::FirmwareResponse> ask(int robot,
                                                    const thunderbots::wire::FirmwareRequest& request);
    Result<thunderbots::wire::FirmwareResponse> program(
        int robot, const std::vector<thunderbots::wire::FillPageRequest>& fills,
        const thunderbots::wire::ProgramPageRequest& request);
    /// How many messages the link took since connect().
    std::size_t messagesOut() const { return messagesOut_; }

    FakeScheduler scheduler;
    thunderbots::sim::ThunderbotsSim sim;

  private:
    using Ended = std::shared_ptr<std::optional<Result<thunderbots::wire::FirmwareResponse>>>;

    void observe(const UsbTapRecord& record) override;
    void sample(SignalId, TimePoint, float) override {}
    void gap(SignalId, TimePoint) override {}
    void happened(const thunderbots::Event& event);
    Result<thunderbots::wire::FirmwareResponse> waitFor(const Result<void>& begun, const Ended& ended);
    thunderbots::RobotRequests::Done keepIn(const Ended& ended);

    StopLatch stop_;
    TappedUsbLink link_;
    thunderbots::FleetModel model_;
    thunderbots::DongleController controller_;
    std::size_t messagesOut_ = 0;

  public:
    thunderbots::RobotRequests requests;
};

}  // namespace kickstand::testing
