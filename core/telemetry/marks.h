#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/base/time.h"
#include "core/telemetry/ring_cells.h"
#include "core/telemetry/ring_index.h"

namespace kickstand {

/// What happened at a moment that a plot marks on its time axis.
enum class MarkKind : std::uint16_t {
    Kick,         ///< A kick was given to the device; value: the longer pulse, µs.
    Autokick,     ///< A robot kicked by itself.
    DeviceError,  ///< The device reported a fault; value: its code.
    Stop,         ///< STOP was latched; value: the StopReason's number.
    Rearmed,      ///< A person re-armed after STOP.
    LinkUp,
    LinkDown,
    UnitHeard,  ///< A robot came alive.
    UnitLost,   ///< A robot was lost.
};

/// For a mark that concerns no one unit.
inline constexpr std::uint16_t kNoUnit = 0xFFFF;

/// One annotation on the time axis.
struct Mark {
    TimePoint time{};
    MarkKind kind = MarkKind::Kick;
    std::uint16_t unit = kNoUnit;  ///< The robot, as in SignalId.
    float value = 0;               ///< As its kind says; else 0.

    friend bool operator==(const Mark&, const Mark&) = default;
};

/// The last so many marks in the order they were made. One thread writes, any others read in place without
/// locks.
class Marks {
  public:
    /// Keeps the last `capacity` marks.
    explicit Marks(std::size_t capacity);

    /// Adds a mark; a time before the last one is taken as the last one. Writer's thread.
    void append(Mark mark);

    /// How many were ever made. Any thread.
    std::uint64_t total() const { return index_.end(); }
    std::size_t capacity() const { return index_.capacity(); }
    /// The marks in [from, to); nothing when they were overwritten while they were read, again and again. Any
    /// thread.
    std::optional<std::vector<Mark>> between(TimePoint from, TimePoint to) const;
    /// Copies marks from index `from` (counted like total()) on. Any thread.
    RingCopy copy(std::uint64_t from, std::span<Mark> out) const;

  private:
    Mark markAt(std::uint64_t index) const;
    std::uint64_t firstAtOrAfter(TimePoint time, RingWindow window) const;

    RingIndex index_;
    RingCells<std::int64_t> times_;
    RingCells<std::uint64_t> what_;
    TimePoint last_ = TimePoint::min();
};

}  // namespace kickstand
