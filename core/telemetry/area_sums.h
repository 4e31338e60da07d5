#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/base/time.h"
#include "core/telemetry/ring_cells.h"

namespace kickstand {

/// The integral of a value over time, and for how long there was one.
struct Area {
    double value_s = 0;  ///< The value's unit times seconds.
    Duration held{};

    /// `value` held for `span`; NaN means that there was none.
    void add(float value, Duration span) {
        if (std::isnan(value)) return;
        value_s += static_cast<double>(value) * seconds(span);
        held += span;
    }
    friend Area operator+(const Area& a, const Area& b) { return {a.value_s + b.value_s, a.held + b.held}; }
    friend Area operator-(const Area& a, const Area& b) { return {a.value_s - b.value_s, a.held - b.held}; }
};

/// The area from the beginning of a series up to every 64th of its samples, so that the area of any stretch
/// is a difference and some sixty samples at either end. One thread writes, others read.
class AreaSums {
  public:
    /// A sum stands at indices that divide by this.
    static constexpr std::uint64_t kStep = 64;

    /// For a ring of `cells` samples: a power of two, at least kStep.
    explicit AreaSums(std::size_t cells) : values_(cells / kStep), held_(cells / kStep) {}

    /// The area up to sample `index`, kept where one stands. Writer's thread, before the sample is published.
    void append(std::uint64_t index, const Area& upToHere) {
        if (index % kStep != 0) return;
        values_.store(index / kStep, upToHere.value_s);
        held_.store(index / kStep, upToHere.held.count());
    }
    /// Any thread; `index` divides by kStep.
    Area load(std::uint64_t index) const {
        return {values_.load(index / kStep), Duration(held_.load(index / kStep))};
    }
    std::size_t bytes() const { return values_.bytes() + held_.bytes(); }

  private:
    RingCells<double> values_;
    RingCells<std::int64_t> held_;
};

}  // namespace kickstand
