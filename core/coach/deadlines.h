#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "core/base/scheduler.h"
#include "core/coach/types.h"

namespace kickstand::coach {

/// The timers of one side: each runs or does not, and tells once when it is over. The scheduler's thread.
class Deadlines {
  public:
    Deadlines(Scheduler& scheduler, std::function<void(TimerKind)> expired);
    ~Deadlines();
    Deadlines(const Deadlines&) = delete;
    Deadlines& operator=(const Deadlines&) = delete;

    /// Starts it anew.
    void start(TimerKind kind, Duration span);
    void stop(TimerKind kind);
    void stopAll();
    bool runs(TimerKind kind) const { return slot(kind).has_value(); }
    /// When it is over; the timer runs.
    TimePoint due(TimerKind kind) const { return slot(kind)->due; }
    std::vector<RunningTimer> running() const;

  private:
    static constexpr std::size_t kKinds = static_cast<std::size_t>(TimerKind::MoraleStep) + 1;

    std::optional<RunningTimer>& slot(TimerKind kind) { return timers_[static_cast<std::size_t>(kind)]; }
    const std::optional<RunningTimer>& slot(TimerKind kind) const {
        return timers_[static_cast<std::size_t>(kind)];
    }
    void arm();
    void expire();

    Scheduler& scheduler_;
    std::function<void(TimerKind)> expired_;
    std::array<std::optional<RunningTimer>, kKinds> timers_;
    TimerId armed_ = 0;
    TimePoint armedFor_{};
};

}  // namespace kickstand::coach
