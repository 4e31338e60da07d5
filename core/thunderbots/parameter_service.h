#pragma once

#include <array>
#include <functional>
#include <string>

#include "core/thunderbots/events.h"
#include "core/thunderbots/parameter_keeper.h"
#include "core/thunderbots/robot_requests.h"

namespace kickstand::thunderbots {

/// Reads and changes what robots keep: their parameters, and the reboot that shows what they have kept
/// (protocol 4.7, 4.8). Hears what others ask of them too, so that its knowledge holds. Engine thread.
class ParameterService {
  public:
    using Done = std::function<void(Result<void>)>;

    /// `requests` outlives it, as does what `event` needs.
    ParameterService(Scheduler& scheduler, RobotRequests& requests, std::function<void(const Event&)> event);
    ~ParameterService();
    ParameterService(const ParameterService&) = delete;
    ParameterService& operator=(const ParameterService&) = delete;

    const ParameterState& state(int robot) const { return keeper_.state(robot); }
    std::uint64_t version() const { return keeper_.version(); }

    // Each is answered once, never from inside the call. Errors: RobotRequests'.

    void read(int robot, Done done);
    void readSignatures(int robot, Done done);
    /// Sets the volatile copy and reads it again; answered with NotVerified where the robot then has
    /// something else.
    void apply(int robot, const wire::OperationalParameters& parameters, const Done& done);
    void commit(int robot, Done done);
    /// `still`: whether it may still be sent, where the robot had to be waited for.
    void reboot(int robot, RobotRequests::Gate still, Done done);

    /// The dongle has found a robot: a commit that waits for its proof is read again.
    void found(int robot);
    /// The dongle has lost it; `others` are alive. After RobotRequests::lost().
    void lost(int robot, RobotMask others) { keeper_.lost(robot, others); }

  private:
    /// Asks; `done` comes whether or not it could be asked.
    void ask(int robot, const wire::FirmwareRequest& request, Done done, RobotRequests::Gate still = {});
    void heard(int robot, const wire::FirmwareResponse& response);
    void proveSoon(int robot);
    void prove(int robot);
    void readHeard(int robot, const wire::OperationalParameters& parameters);
    void raise(EventKind kind, int robot, std::int64_t code = 0, std::int64_t previous = 0,
               std::string text = {});

    Scheduler& scheduler_;
    RobotRequests& requests_;
    std::function<void(const Event&)> event_;
    ParameterKeeper keeper_;

    /// A proof that is still to be read.
    struct Proof {
        TimerId timer = 0;
        int tries = 0;  ///< That are left.
    };
    std::array<Proof, kRobots> proofs_;
};

}  // namespace kickstand::thunderbots
