#include "core/coach/deadlines.h"

#include <utility>

namespace kickstand::coach {

Deadlines::Deadlines(Scheduler& scheduler, std::function<void(TimerKind)> expired)
    : scheduler_(scheduler), expired_(std::move(expired)) {}

Deadlines::~Deadlines() {
    scheduler_.cancel(armed_);
}

void Deadlines::start(TimerKind kind, Duration span) {
    slot(kind) = RunningTimer{kind, scheduler_.now() + span, span};
    arm();
}

void Deadlines::stop(TimerKind kind) {
    slot(kind).reset();
}

void Deadlines::stopAll() {
    timers_ = {};
}

std::vector<RunningTimer> Deadlines::running() const {
    std::vector<RunningTimer> running;
    for (const auto& timer : timers_) {
        if (timer) running.push_back(*timer);
    }
    return running;
}

void Deadlines::arm() {
    std::optional<TimePoint> first;
    for (const auto& timer : timers_) {
        if (timer && (!first || timer->due < *first)) first = timer->due;
    }
    // One that waits for something earlier looks again by itself.
    if (!first || (armed_ != 0 && armedFor_ <= *first)) return;
    scheduler_.cancel(armed_);
    armedFor_ = *first;
    armed_ = scheduler_.callAt(*first, [this] { expire(); });
}

void Deadlines::expire() {
    armed_ = 0;
    const TimePoint now = scheduler_.now();
    for (auto& timer : timers_) {
        if (!timer || timer->due > now) continue;
        const TimerKind kind = timer->kind;
        timer.reset();
        expired_(kind);
    }
    arm();
}

}  // namespace kickstand::coach
