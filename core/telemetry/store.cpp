#include "core/telemetry/store.h"

namespace kickstand {

TelemetryStore::TelemetryStore(const TelemetryLimits& limits)
    : limits_(limits), slots_(std::make_unique<Slot[]>(limits.series)), marks_(limits.marks) {}

// A walk over some hundred keys: they are few, and whoever appends keeps the pointer.
TimeSeries* TelemetryStore::lookUp(SignalId key) const {
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i)
        if (slots_[i].key == key) return slots_[i].series.get();
    return nullptr;
}

TimeSeries* TelemetryStore::series(SignalId key) {
    if (TimeSeries* found = lookUp(key)) return found;
    const std::size_t count = size();
    if (count == limits_.series) {
        refused_.fetch_add(1, std::memory_order_relaxed);
        return nullptr;
    }
    slots_[count] = {key, std::make_unique<TimeSeries>(limits_.samples, limits_.pastBlocks)};
    count_.store(count + 1, std::memory_order_release);
    return slots_[count].series.get();
}

bool TelemetryStore::append(SignalId key, TimePoint time, float value) {
    TimeSeries* found = series(key);
    return found != nullptr && found->append(time, value);
}

void TelemetryStore::gap(std::uint16_t unit, TimePoint time) {
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i)
        if (slots_[i].key.unit == unit) slots_[i].series->gap(time);
}

void TelemetryStore::gapAll(TimePoint time) {
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i)
        slots_[i].series->gap(time);
}

const TimeSeries* TelemetryStore::find(SignalId key) const {
    return lookUp(key);
}

std::vector<SignalId> TelemetryStore::keys() const {
    std::vector<SignalId> result(size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = slots_[i].key;
    return result;
}

std::size_t TelemetryStore::bytes() const {
    std::size_t sum = 0;
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i)
        sum += slots_[i].series->bytes();
    return sum;
}

}  // namespace kickstand
