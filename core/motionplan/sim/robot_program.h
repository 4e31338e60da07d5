#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/time.h"
#include "core/motionplan/wire/message.h"

namespace kickstand::motionplan::sim {

/// A plan that a robot keeps.
struct KeptPlan {
    int id = 0;
    std::vector<std::uint8_t> movements;

    bool empty() const { return id == 0; }
};

/// What the robot does at this moment.
struct Motion {
    int plan = 0;
    int slot = 0;
    bool trigger = false;  ///< The trigger plan, which has no slot.
    std::vector<std::uint8_t> movements;
    std::size_t step = 0;  ///< From 0.
    double done = 0;       ///< Of this step, 0-1.
};

/// The program of a simulated robot: keeps plans, executes them at a real pace, and answers (protocol 4).
/// Told of messages and of time; what it puts out goes through `put`. One thread.
class RobotProgram {
  public:
    /// How fast wheels are at their full speed, and how often a status is put out (protocol 4.5).
    static constexpr double kSpeed_cm_per_s = 20;
    static constexpr double kTurn_deg_per_s = 60;
    static constexpr Duration kStatusEvery = std::chrono::seconds(1);

    explicit RobotProgram(std::function<void(ByteView)> put) : put_(std::move(put)) {}

    /// A message from the command mailbox; bytes that mean nothing are copied back and otherwise ignored.
    void command(ByteView bytes, TimePoint now);
    /// What lies in the trigger plan's mailbox.
    void triggerPlan(ByteView bytes);
    /// The connection is lost: the trigger plan starts where there is one.
    void connectionLost(TimePoint now);
    /// Time has passed: moves.
    void tick(TimePoint now);
    /// The program was ended and begins anew: nothing is kept.
    void restart();
    /// Puts out an error nobody has earned.
    void putError(int code);
    /// Whether an update is refused (code 3) while nothing executes.
    void setStrictUpdate(bool strict) { strictUpdate_ = strict; }
    bool strictUpdate() const { return strictUpdate_; }
    /// How much faster than real it moves.
    void setPace(double pace) { pace_ = pace; }
    double pace() const { return pace_; }

    const std::array<KeptPlan, wire::kSlots>& kept() const { return slots_; }
    const KeptPlan& trigger() const { return trigger_; }
    const std::optional<Motion>& motion() const { return motion_; }
    /// The wheels' speeds as parts of the full one, left and right.
    std::array<double, 2> speeds() const { return speeds_; }
    std::uint64_t executed() const { return executed_; }

  private:
    void putMessage(const wire::Message& message);
    void putStatus();
    void createOrUpdate(const wire::Message& message);
    void execute(const wire::Message& message, TimePoint now);
    void stop();
    void adjust(const wire::Message& message);
    void start(Motion motion, TimePoint now);
    double stepsPerSecond() const;
    void nextStep(TimePoint now);

    std::function<void(ByteView)> put_;
    std::array<KeptPlan, wire::kSlots> slots_;
    KeptPlan trigger_;
    std::optional<Motion> motion_;
    std::array<double, 2> speeds_{1, 1};
    TimePoint at_{};
    TimePoint statusAt_{};
    double pace_ = 1;
    bool strictUpdate_ = false;
    std::uint64_t executed_ = 0;  ///< Plans that came to their end.
};

}  // namespace kickstand::motionplan::sim
