#pragma once

#include <cstdint>
#include <functional>

#include "core/base/latch.h"
#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/base/signal_id.h"

namespace kickstand {

/// Identifies a command from when it is submitted until it is answered. Zero is never given out.
using CommandId = std::uint64_t;

/// Takes the readings of a session. Engine thread.
class SampleSink {
  public:
    virtual ~SampleSink() = default;
    /// The signal has this value from `time` on, until the next sample.
    virtual void sample(SignalId signal, TimePoint time, float value) = 0;
    /// From `time` on nobody knows the signal's value.
    virtual void gap(SignalId signal, TimePoint time) = 0;
};

/// What the engine gives a session of any system to work with. Everything in it outlives the session and is
/// used on the engine thread, but for `stop`, which anyone may set at any time.
template <class Event>
struct SessionHost {
    Scheduler& scheduler;
    StopLatch& stop;
    SampleSink& samples;
    /// Something happened that a person should be able to read later.
    std::function<void(const Event&)> event;
    /// The one answer to a command.
    std::function<void(CommandId, Result<void>)> answer;
};

}  // namespace kickstand
