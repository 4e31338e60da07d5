#pragma once

#include <cstdint>
#include <memory>

#include "core/thunderbots/bench_check.h"
#include "core/thunderbots/snapshot.h"

namespace kickstand::thunderbots {

/// What a robot under check is to do now; the default is nothing, braked.
struct CheckDemand {
    WheelSpeeds wheels{};
    bool dribbler = false;
    bool charger = false;
    bool discharge = false;
    bool kick = false;  ///< Once: it stands in a single demand.
    wire::TestMode lights;

    friend bool operator==(const CheckDemand&, const CheckDemand&) = default;
};

/// What there is to see of the robot under check.
struct CheckView {
    const RobotState& state;
    const KickRecord* lastKick = nullptr;  ///< The robot's newest; null for none.
    bool discharging = false;
    bool kickFree = true;  ///< Whether no kick is on its way to the dongle.
};

/// Works through a check, one step after another. It decides what the robot is to do and what comes of it;
/// the session does it, by its rules. A robot that is not heard fails by itself, and the next one's turn
/// comes. Engine thread.
class BenchChecker {
  public:
    /// From here on look() has demands. `steps` is what planCheck() made of the plan, not empty.
    void begin(const CheckPlan& plan, const std::vector<CheckStep>& steps, TimePoint now);
    /// No more steps, for this reason.
    void end(Errc why);
    bool running() const { return progress_ && progress_->running(); }
    bool running(int robot) const { return running() && row().step.robot == robot; }
    /// The robot at work, or -1.
    int robot() const { return running() ? row().step.robot : -1; }
    /// Looks at the robot at work and goes on where that is possible. What it gives back is for that robot,
    /// unless robot() is another one afterwards: then it is done with.
    CheckDemand look(const CheckView& view, TimePoint now);
    /// A person answers the question of a row. Errors: BadArgument when that is not what is asked now, or
    /// cannot be repeated.
    Result<void> answer(std::size_t row, CheckAnswer answer, TimePoint now);
    /// The step at work cannot be done.
    void failStep(Errc why) { judge(CheckVerdict::Failed, why); }
    /// The robot at work is not there any more: it has failed, and the next one's turn comes.
    void robotLost(Errc why) { leaveRobot(CheckVerdict::Failed, why); }

    /// Never null; immutable once given out. Empty rows: there was none.
    std::shared_ptr<const CheckProgress> progress() const;
    /// Rises whenever progress() would give something else.
    std::uint64_t version() const { return version_; }

  private:
    enum class Phase : std::uint8_t { Start, Prepare, Await, Run, Ask };

    CheckRow& row() { return progress_->rows[progress_->current]; }
    const CheckRow& row() const { return progress_->rows[progress_->current]; }
    const CheckLimits& limits() const { return progress_->plan.limits; }
    void enter(Phase phase, TimePoint now);
    void ask(TimePoint now) { enter(Phase::Ask, now); }
    bool ranLongEnough(TimePoint now) const { return now - phaseBegan_ >= fromSeconds(limits().run_s); }
    void judge(CheckVerdict verdict, std::optional<Errc> why = {});
    void judgeValue(double value, double limit, bool good);
    void leaveRobot(CheckVerdict verdict, Errc why);
    void goOn();
    bool charged() const;

    CheckDemand act(const CheckView& view, TimePoint now);
    CheckDemand spinWheel(TimePoint now);
    CheckDemand dribble(const CheckView& view, TimePoint now);
    CheckDemand load(const CheckView& view, TimePoint now);
    CheckDemand charge(const CheckView& view, TimePoint now);
    CheckDemand kick(const CheckView& view, TimePoint now);
    CheckDemand measureKick(const CheckView& view, TimePoint now);
    CheckDemand discharge(const CheckView& view, TimePoint now);
    CheckDemand showLights(TimePoint now);

    std::optional<CheckProgress> progress_;
    std::uint64_t version_ = 0;
    mutable std::shared_ptr<const CheckProgress> shown_ = std::make_shared<const CheckProgress>();
    mutable std::uint64_t shownVersion_ = 0;
    Phase phase_ = Phase::Start;
    TimePoint phaseBegan_{};
    double rest_V_ = 0;
    double lowest_V_ = 0;
    std::uint64_t kicksBefore_ = 0;
};

}  // namespace kickstand::thunderbots
