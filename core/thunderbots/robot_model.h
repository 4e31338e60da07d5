#pragma once

#include <functional>

#include "core/base/session_host.h"
#include "core/thunderbots/events.h"
#include "core/thunderbots/snapshot.h"
#include "core/thunderbots/wire/indicator.h"

namespace kickstand::thunderbots {

/// One robot as it is known from the bytes that passed, in both directions. Passive: it is told, it never
/// asks. Times come with what it is told, so a recording feeds it as well as a live link. Engine thread.
class RobotModel {
  public:
    /// As FleetModel's, for one robot.
    RobotModel(int robot, SampleSink& samples, const std::function<void(const Event&)>& event);

    const RobotState& state() const { return state_; }

    /// A new connection: what the dongle knew is gone, what was last seen of the robot is remembered as
    /// stale.
    void connectionBegan();
    /// The dongle's live bit together with the health of the link: both are needed for readings to be current
    /// (protocol 6.9).
    void setLive(bool live, TimePoint time);
    void feedback(const wire::FeedbackBlock& block, TimePoint time);
    void indicator(const wire::IndicatorMessage& message, TimePoint time);
    /// An experiment message whose offset is past the last legal one.
    void experimentRejected();
    /// Forgets what has arrived of the experiment buffer.
    void clearExperiment();

    /// What the link took from the host.
    void told(const wire::DriveBlock& block, TimePoint time);
    void kickGiven(const wire::KickTimes& times, TimePoint time);
    void testModeGiven(const wire::TestMode& mode, TimePoint time);

  private:
    void sampleReadings(TimePoint time);
    void watchBattery(TimePoint time);
    void markStale(TimePoint time);
    void raise(EventKind kind, TimePoint time, std::int64_t code = 0, std::int64_t previous = 0,
               double value = 0);

    const int robot_;
    SampleSink& samples_;
    const std::function<void(const Event&)>& event_;
    RobotState state_;
    bool heardThisConnection_ = false;  ///< Valid readings have come since the connection began.
    int batteryMark_ = 0;               ///< 0 well, 1 low, 2 at its end: the last one that was said.
    bool chargedSaid_ = false;
};

}  // namespace kickstand::thunderbots
