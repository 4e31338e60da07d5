#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/signal_id.h"
#include "core/telemetry/marks.h"
#include "core/telemetry/time_series.h"

namespace kickstand {

/// How much a store holds.
struct TelemetryLimits {
    std::size_t series = 128;
    /// Of each series: eleven minutes of changes at 200 Hz, five hours at the pace of a true radio.
    std::size_t samples = 131'000;
    /// Of each series, of what was before: four and a half hours and more at any pace.
    std::size_t pastBlocks = 16'000;
    std::size_t marks = 8'000;
};

/// The series and marks of one session. One thread writes: it makes series as they are first heard of, up to
/// the limit, and appends. Any others find and read them meanwhile, in place and without locks. Nothing is
/// ever removed: what is found stays valid as long as the store, which sessions and views share.
class TelemetryStore {
  public:
    /// Memory is taken as series are made, up to the limits. Any thread.
    explicit TelemetryStore(const TelemetryLimits& limits = {});

    /// The series of a key, made on first use; nullptr, and counted, when there are as many as may be. Keep
    /// what it gives rather than asking again for every sample. Writer's thread.
    TimeSeries* series(SignalId key);
    /// The same to append in one call: false when it was not kept, for whichever reason. Writer's thread.
    bool append(SignalId key, TimePoint time, float value);
    /// Begins a gap in every series of a unit: nothing more is known of it. Writer's thread.
    void gap(std::uint16_t unit, TimePoint time);
    /// Begins a gap in every series: the link is lost. Writer's thread.
    void gapAll(TimePoint time);
    /// Marks a moment on the time axis. Writer's thread.
    void mark(const Mark& mark) { marks_.append(mark); }

    /// The series of a key, or nullptr while there is none. Any thread.
    const TimeSeries* find(SignalId key) const;
    /// The keys of all series in the order they were made. Any thread.
    std::vector<SignalId> keys() const;
    /// How many series there are; they only ever become more. Any thread.
    std::size_t size() const { return count_.load(std::memory_order_acquire); }
    /// How often a series was refused for want of room. Any thread.
    std::uint64_t refused() const { return refused_.load(std::memory_order_relaxed); }
    /// Any thread.
    const Marks& marks() const { return marks_; }
    /// Bytes reserved by all series so far. Any thread.
    std::size_t bytes() const;

  private:
    struct Slot {
        SignalId key;
        std::unique_ptr<TimeSeries> series;
    };

    TimeSeries* lookUp(SignalId key) const;

    TelemetryLimits limits_;
    std::unique_ptr<Slot[]> slots_;
    /// Slots below it are complete and never change again.
    std::atomic<std::size_t> count_{0};
    std::atomic<std::uint64_t> refused_{0};
    Marks marks_;
};

}  // namespace kickstand
