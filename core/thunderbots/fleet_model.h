#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/link/tap.h"
#include "core/thunderbots/robot_model.h"

namespace kickstand::thunderbots {

/// Everything that is known of a dongle (or cable) and its robots, learnt only from what passes on the link.
/// It sends nothing: a live link and a recording feed it alike. Engine thread.
class FleetModel final : public UsbTapObserver {
  public:
    /// `samples` takes the readings, `event` what is worth telling; both outlive the model.
    FleetModel(SampleSink& samples, std::function<void(const Event&)> event);

    /// One thing that happened on the link.
    void observe(const UsbTapRecord& record) override;
    /// As RobotModel's.
    void clearExperiment(int robot) { at(robot).clearExperiment(); }
    /// Time has passed: figures over time are brought up to date, and damage that was only counted is told.
    void tick(TimePoint now);

    /// Whether the link is open: between its opening and its end.
    bool isOpen() const { return open_; }
    const RobotState& robot(int robot) const { return robots_[static_cast<std::size_t>(robot)].state(); }
    const wire::DongleStatus& status() const { return status_; }
    const std::optional<wire::Channels>& channels() const { return channels_; }
    const std::optional<wire::RadioVersions>& radioVersions() const { return radioVersions_; }
    const TrafficCounters& traffic() const { return traffic_; }
    /// Rises whenever something to be shown has changed.
    std::uint64_t version() const { return version_; }

  private:
    void connectionBegan();
    void connectionEnded(TimePoint time);
    void completedOut(const UsbTapRecord& record);
    void completedIn(const UsbTapRecord& record);
    void completedControl(const UsbTapRecord& record);
    void statusReceived(ByteView packet, TimePoint time);
    void errorsReceived(ByteView packet, TimePoint time);
    void textReceived(ByteView packet, TimePoint time);
    void stateReceived(ByteView packet, TimePoint time);
    void messageReceived(ByteView packet, TimePoint time);
    void stateSent(ByteView packet, TimePoint time);
    void messageSent(ByteView packet, TimePoint time);
    void refreshLive(TimePoint time);
    void malformed(std::uint8_t endpoint, const wire::WireError& error, TimePoint time);
    void tellMalformed(TimePoint time);
    void raise(EventKind kind, TimePoint time, std::int64_t code = 0, std::int64_t previous = 0,
               std::string text = {});
    RobotModel& at(int robot) { return robots_[static_cast<std::size_t>(robot)]; }

    std::function<void(const Event&)> event_;
    std::array<RobotModel, kRobots> robots_;
    bool open_ = false;
    wire::DongleStatus status_;
    std::optional<wire::Channels> channels_;
    std::optional<wire::RadioVersions> radioVersions_;
    TrafficCounters traffic_;
    std::uint64_t version_ = 0;
    std::string text_;  ///< The dongle's debug text, until its line ends.

    std::uint64_t malformedUntold_ = 0;
    std::uint8_t malformedEndpoint_ = 0;
    std::string malformedText_;
    std::optional<TimePoint> malformedToldAt_;
    TimePoint rateSince_{};
    std::uint64_t rateFrom_ = 0;
};

}  // namespace kickstand::thunderbots
