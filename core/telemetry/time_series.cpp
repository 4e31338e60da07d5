#include "core/telemetry/time_series.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kickstand {

namespace {

template <class T>
TimeSeries::Read<T> orOverrun(std::optional<TimeSeries::Read<T>> result) {
    if (!result) return tl::unexpected(Miss::Overrun);
    return *std::move(result);
}

/// One column out of its two halves.
Column joined(const Column& older, const Column& newer) {
    Extremes held = Extremes::none();
    held.add(Extremes{older.min, older.max});
    held.add(Extremes{newer.min, newer.max});
    Column result = newer;
    result.first = older.first;
    result.count += older.count;
    if (!held.empty()) {
        result.min = held.min;
        result.max = held.max;
    }
    return result;
}

// A block that is still growing is never older than the ring.
constexpr std::size_t kBlocksOfRing = 4;

}  // namespace

TimeSeries::TimeSeries(std::size_t capacity, std::size_t pastBlocks)
    : index_(capacity), times_(index_.cells()), values_(index_.cells()), areas_(index_.cells()) {
    if (pastBlocks > 0) past_.emplace(pastBlocks, capacity / kBlocksOfRing);
}

bool TimeSeries::append(TimePoint time, float value) {
    if (!std::isfinite(value)) value = kNoValue;
    if (value == holding_.value || (std::isnan(value) && std::isnan(holding_.value))) return false;

    const std::uint64_t index = index_.end();
    if (index > 0 && time < holding_.time) {
        time = holding_.time;
        outOfOrder_.store(outOfOrder_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    areaSoFar_.add(holding_.value, time - holding_.time);
    holding_ = {time, value};

    times_.store(index, time.time_since_epoch().count());
    values_.append(index, value);
    areas_.append(index, areaSoFar_);
    if (past_) past_->append(index, holding_, areaSoFar_);
    index_.publish();
    return true;
}

std::uint64_t TimeSeries::firstAtOrAfter(TimePoint time, std::uint64_t first, std::uint64_t end,
                                         std::uint64_t guess) const {
    return partitionRing(first, end, guess, [&](std::uint64_t index) { return timeAt(index) < time; });
}

std::uint64_t TimeSeries::firstAfter(TimePoint time, RingWindow window) const {
    return partitionRing(window.first, window.end, window.end,
                         [&](std::uint64_t index) { return timeAt(index) <= time; });
}

Sample TimeSeries::nearestOf(std::uint64_t first, std::uint64_t end, TimePoint time) const {
    Sample best;
    for (std::uint64_t index = first; index < end; ++index) {
        const Sample sample = sampleAt(index);
        if (std::isnan(sample.value)) continue;
        const bool nearer = std::chrono::abs(sample.time - time) < std::chrono::abs(best.time - time);
        if (std::isnan(best.value) || nearer) best = sample;
    }
    return best;
}

Column TimeSeries::column(RingWindow window, std::uint64_t first, std::uint64_t end, TimePoint start) const {
    const bool changes = first < end;
    const bool fresh = changes && timeAt(first) == start;
    const float carried = !fresh && first > window.first ? values_.load(first - 1) : kNoValue;

    Extremes held = values_.extremes(first, end);
    held.add(carried);
    Column result;
    result.count = end - first;
    result.first = fresh ? values_.load(first) : carried;
    result.last = changes ? values_.load(end - 1) : carried;
    if (!held.empty()) {
        result.min = held.min;
        result.max = held.max;
    }
    return result;
}

// The area from the time of one sample to that of another. Whole steps come from the running sums, the rest
// is added up.
Area TimeSeries::areaBetween(std::uint64_t first, std::uint64_t last) const {
    const auto addUp = [&](std::uint64_t from, std::uint64_t to) {
        Area sum;
        for (; from < to; ++from)
            sum.add(values_.load(from), timeAt(from + 1) - timeAt(from));
        return sum;
    };
    constexpr std::uint64_t kStep = AreaSums::kStep;
    const std::uint64_t firstStep = (first + kStep - 1) / kStep * kStep;
    const std::uint64_t lastStep = last / kStep * kStep;
    if (firstStep >= lastStep) return addUp(first, last);
    return addUp(first, firstStep) + (areas_.load(lastStep) - areas_.load(firstStep)) + addUp(lastStep, last);
}

Area TimeSeries::area(RingWindow window, std::uint64_t first, std::uint64_t end, TimePoint from,
                      TimePoint to) const {
    Area result;
    const bool changes = first < end;
    if (first > window.first) result.add(values_.load(first - 1), (changes ? timeAt(first) : to) - from);
    if (!changes) return result;
    result = result + areaBetween(first, end - 1);
    result.add(values_.load(end - 1), to - timeAt(end - 1));
    return result;
}

TimePoint TimeSeries::forgottenUntil(RingWindow window) const {
    return past_ && window.first > 0 ? timeAt(window.first) : TimePoint::min();
}

TimeSeries::Read<SampleRange> TimeSeries::available() const {
    return orOverrun(index_.consistently([&](RingWindow window) -> Read<SampleRange> {
        if (window.first == window.end) return tl::unexpected(Miss::NoValue);
        const TimePoint first = timeAt(window.first);
        const auto coarse = past_ ? past_->begin() : std::nullopt;
        return SampleRange{window.first, window.end, first, timeAt(window.end - 1),
                           coarse ? std::min(first, *coarse) : first};
    }));
}

TimeSeries::Read<Sample> TimeSeries::at(TimePoint time) const {
    return orOverrun(index_.consistently([&](RingWindow window) -> Read<Sample> {
        const std::uint64_t next = firstAfter(time, window);
        Sample sample;
        if (time < forgottenUntil(window)) {
            const auto past = past_->at(time);
            if (!past) return tl::unexpected(Miss::Overrun);
            sample = *past;
        } else if (next > window.first) {
            sample = sampleAt(next - 1);
        }
        if (std::isnan(sample.value)) return tl::unexpected(Miss::NoValue);
        return sample;
    }));
}

TimeSeries::Read<Sample> TimeSeries::nearest(TimePoint time) const {
    return orOverrun(index_.consistently([&](RingWindow window) -> Read<Sample> {
        if (window.first == window.end) return tl::unexpected(Miss::NoValue);
        const TimePoint within = std::max(std::min(time, timeAt(window.end - 1)), timeAt(window.first));
        const std::uint64_t next = firstAfter(within, window);
        // Two gaps never stand side by side: of two neighbours on either side one is a value.
        const std::uint64_t first = next - std::min<std::uint64_t>(next - window.first, 2);
        const Sample best = nearestOf(first, std::min(next + 2, window.end), within);
        if (std::isnan(best.value)) return tl::unexpected(Miss::NoValue);
        return best;
    }));
}

TimeSeries::Read<void> TimeSeries::columns(TimePoint start, Duration width, std::span<Column> out) const {
    width = std::max(width, Duration(1));
    return orOverrun(index_.consistently([&](RingWindow window) -> Read<void> {
        const TimePoint forgotten = forgottenUntil(window);
        std::span<Column> rest = out;
        TimePoint left = start;
        if (left < forgotten) {
            const auto whole = std::min<std::uint64_t>((forgotten - left) / width, out.size());
            std::fill_n(out.begin(), whole, Column{});
            if (!past_->columns(left, width, forgotten, out.first(whole)))
                return tl::unexpected(Miss::Overrun);
            rest = out.subspan(whole);
            left += width * static_cast<std::int64_t>(whole);
        }
        std::uint64_t first = firstAtOrAfter(left, window.first, window.end, window.end);
        std::uint64_t guess = first;
        for (Column& filled : rest) {
            const TimePoint right = left + width;
            const std::uint64_t end = firstAtOrAfter(right, first, window.end, guess);
            filled = column(window, first, end, left);
            if (left < forgotten) {
                Column older;
                if (!past_->columns(left, width, forgotten, {&older, 1}))
                    return tl::unexpected(Miss::Overrun);
                filled = joined(older, filled);
            }
            // Most columns hold about as many samples as the one before.
            guess = end + (end - first);
            left = right;
            first = end;
        }
        return {};
    }));
}

TimeSeries::Read<SpanStats> TimeSeries::stats(TimePoint from, TimePoint to) const {
    if (to <= from) return tl::unexpected(Miss::NoValue);
    return orOverrun(index_.consistently([&](RingWindow window) -> Read<SpanStats> {
        const TimePoint fine = std::clamp(forgottenUntil(window), from, to);
        Column all;
        Area sum;
        if (from < fine) {
            const auto area = past_->area(from, fine);
            if (!area || !past_->columns(from, fine - from, fine, {&all, 1}))
                return tl::unexpected(Miss::Overrun);
            sum = *area;
        }
        if (fine < to) {
            const std::uint64_t first = firstAtOrAfter(fine, window.first, window.end, window.end);
            const std::uint64_t end = firstAtOrAfter(to, first, window.end, window.end);
            all = joined(all, column(window, first, end, fine));
            sum = sum + area(window, first, end, fine, to);
        }
        if (std::isnan(all.min) || sum.held <= Duration::zero()) return tl::unexpected(Miss::NoValue);
        // The running sums round: a mean never leaves the values that it is the mean of.
        const double mean = std::clamp(sum.value_s / seconds(sum.held), static_cast<double>(all.min),
                                       static_cast<double>(all.max));
        return SpanStats{all.min, all.max, mean, sum.held, all.count};
    }));
}

RingCopy TimeSeries::copy(std::uint64_t from, std::span<Sample> out) const {
    return index_.copy(from, out, [&](std::uint64_t index) { return sampleAt(index); });
}

}  // namespace kickstand
