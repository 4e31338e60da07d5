// One writer at full speed, several readers at the same time. Every sample's value follows from its time, so
// a reader can tell a right answer from one that mixes laps of the ring.

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/telemetry/store.h"

namespace kickstand {
namespace {

constexpr std::size_t kCapacity = 3000;
constexpr std::size_t kPastBlocks = 200;
constexpr std::int64_t kStep_ns = 1000;
constexpr std::uint64_t kLaps = 10;
/// Bounds a run on which readers never get an answer; far more than they need.
constexpr std::uint64_t kMostAppends = 200'000'000;
constexpr int kAnswersWanted = 2000;

constexpr float valueOf(std::uint64_t index) {
    return static_cast<float>(index * 7919 % 10007);
}
constexpr TimePoint timeOf(std::uint64_t index) {
    return TimePoint(Duration(static_cast<std::int64_t>(index) * kStep_ns));
}

/// Appends until every reader has what it wants.
void writeUntil(TimeSeries& series, const std::atomic<int>& readersLeft) {
    for (std::uint64_t i = 0; i < kMostAppends; ++i) {
        series.append(timeOf(i), valueOf(i));
        if (i > kLaps * kCapacity && readersLeft.load() == 0) return;
    }
}

/// Runs `read` until it has given enough answers or the series has ended; gives how many.
template <class Read>
int answers(const TimeSeries& series, std::atomic<int>& readersLeft, Read read) {
    int count = 0;
    while (count < kAnswersWanted && series.total() < kMostAppends)
        if (read()) ++count;
    --readersLeft;
    return count;
}

bool columnsAreRight(const TimeSeries& series, bool& wrong) {
    const auto range = series.available();
    if (!range || range->endIndex < kCapacity) return false;
    constexpr std::uint64_t kPerColumn = 100;
    std::array<Column, 5> columns;
    const std::uint64_t first = range->endIndex - columns.size() * kPerColumn;
    const auto done = series.columns(timeOf(first), Duration(kPerColumn * kStep_ns), columns);
    // Without an answer, or when part of the span had been forgotten by then, there is nothing to compare.
    if (!done || series.total() > first + kCapacity) return false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        Extremes expected = Extremes::none();
        const std::uint64_t begin = first + i * kPerColumn;
        for (std::uint64_t k = begin; k < begin + kPerColumn; ++k)
            expected.add(valueOf(k));
        wrong |= columns[i].min != expected.min || columns[i].max != expected.max ||
                 columns[i].count != kPerColumn || columns[i].first != valueOf(begin) ||
                 columns[i].last != valueOf(begin + kPerColumn - 1);
    }
    return true;
}

bool statsAreRight(const TimeSeries& series, bool& wrong) {
    const auto range = series.available();
    if (!range || range->endIndex < kCapacity) return false;
    const std::uint64_t first = range->endIndex - 1000;
    const std::uint64_t end = range->endIndex - 200;
    const auto stats = series.stats(timeOf(first), timeOf(end));
    if (!stats || series.total() > first + kCapacity) return false;
    double sum = 0;
    for (std::uint64_t k = first; k < end; ++k)
        sum += static_cast<double>(valueOf(k));
    wrong |=
        std::abs(stats->mean - sum / static_cast<double>(end - first)) > 1e-3 || stats->count != end - first;
    return true;
}

bool pastIsRight(const TimeSeries& series, bool& wrong) {
    constexpr std::uint64_t kPerColumn = 1000;
    constexpr std::uint64_t kBack = 15'000;
    const auto range = series.available();
    if (!range || range->endIndex < 2 * kBack) return false;
    std::array<Column, 5> columns;
    const std::uint64_t first = range->endIndex - kBack;
    if (!series.columns(timeOf(first), Duration(kPerColumn * kStep_ns), columns)) return false;
    // The writer may have gone on so far that the blocks were forgotten too.
    if (series.available()->coarse > timeOf(first - kPerColumn)) return false;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        Extremes least = Extremes::none();
        Extremes most = Extremes::none();
        const std::uint64_t begin = first + i * kPerColumn;
        for (std::uint64_t k = begin - kPerColumn; k < begin + 2 * kPerColumn; ++k) {
            most.add(valueOf(k));
            if (k >= begin && k < begin + kPerColumn) least.add(valueOf(k));
        }
        wrong |= columns[i].min > least.min || columns[i].max < least.max || columns[i].min < most.min ||
                 columns[i].max > most.max;
    }
    return true;
}

bool lookUpIsRight(const TimeSeries& series, bool& wrong) {
    const auto range = series.available();
    if (!range) return false;
    wrong |= range->first != timeOf(range->firstIndex) || range->last != timeOf(range->endIndex - 1);
    const std::uint64_t index = range->endIndex - 1;
    const auto sample = series.at(timeOf(index) + Duration(kStep_ns / 2));
    if (!sample) return false;
    wrong |= sample->time != timeOf(index) || sample->value != valueOf(index);
    return true;
}

TEST(TelemetryThreads, ReadersOfARingInFullUseGetRightAnswersOrNone) {
    TimeSeries series(kCapacity, kPastBlocks);
    std::atomic<int> readersLeft{4};
    std::array<bool, 4> wrong{};
    std::array<int, 4> count{};
    std::vector<std::thread> readers;
    readers.emplace_back(
        [&] { count[0] = answers(series, readersLeft, [&] { return columnsAreRight(series, wrong[0]); }); });
    readers.emplace_back(
        [&] { count[1] = answers(series, readersLeft, [&] { return statsAreRight(series, wrong[1]); }); });
    readers.emplace_back(
        [&] { count[2] = answers(series, readersLeft, [&] { return lookUpIsRight(series, wrong[2]); }); });
    readers.emplace_back(
        [&] { count[3] = answers(series, readersLeft, [&] { return pastIsRight(series, wrong[3]); }); });
    writeUntil(series, readersLeft);
    for (std::thread& reader : readers)
        reader.join();
    for (std::size_t i = 0; i < readers.size(); ++i) {
        EXPECT_FALSE(wrong[i]) << "reader " << i;
        EXPECT_EQ(count[i], kAnswersWanted) << "reader " << i;
    }
}

TEST(TelemetryThreads, ACopyOutOfARingInFullUseIsWholeAndCountsTheRest) {
    TimeSeries series(kCapacity);
    std::atomic<bool> writing{true};
    std::thread writer([&] {
        for (std::uint64_t i = 0; i < 3'000'000; ++i)
            series.append(timeOf(i), valueOf(i));
        writing = false;
    });
    std::array<Sample, 256> out;
    std::uint64_t next = 0;
    std::uint64_t seen = 0;
    std::uint64_t lost = 0;
    bool wrong = false;
    for (bool last = false; !last;) {
        last = !writing;  // What is copied after this was seen is the end of it.
        for (RingCopy copied{1, next, 0}; copied.count + copied.lost > 0;) {
            copied = series.copy(next, out);
            const std::uint64_t first = copied.next - copied.count;
            for (std::size_t i = 0; i < copied.count; ++i)
                wrong |= out[i].time != timeOf(first + i) || out[i].value != valueOf(first + i);
            wrong |= copied.next != next + copied.lost + copied.count;
            next = copied.next;
            seen += copied.count;
            lost += copied.lost;
        }
    }
    writer.join();
    EXPECT_FALSE(wrong);
    EXPECT_EQ(next, 3'000'000U);
    EXPECT_EQ(seen + lost, 3'000'000U);
    EXPECT_GE(seen, kCapacity);
}

TEST(TelemetryThreads, ReadersFindSeriesWhileTheWriterMakesThem) {
    constexpr std::uint16_t kSeries = 100;
    TelemetryStore store({.series = kSeries, .samples = 100, .marks = 100});
    bool wrong = false;
    std::thread reader([&] {
        while (store.size() < kSeries) {
            for (const SignalId key : store.keys()) {
                // A series is shown before its first sample, so it may have no value yet, but never
                // another's.
                const TimeSeries* found = store.find(key);
                const auto sample =
                    found == nullptr ? TimeSeries::Read<Sample>{} : found->at(TimePoint::max());
                wrong |= found == nullptr || (sample && sample->value != static_cast<float>(key.unit));
            }
        }
    });
    for (std::uint16_t unit = 0; unit < kSeries; ++unit) {
        store.append({unit, 7}, TimePoint(Duration(1)), unit);
        store.mark({TimePoint(Duration(unit)), MarkKind::UnitHeard, unit, 0});
    }
    reader.join();
    EXPECT_FALSE(wrong);
    EXPECT_EQ(store.keys().size(), kSeries);
}

TEST(TelemetryThreads, MarksAreReadWhole) {
    Marks marks(200);
    std::atomic<bool> writing{true};
    std::thread writer([&] {
        for (std::uint32_t i = 0; i < 500'000; ++i)
            marks.append({TimePoint(Duration(i)), static_cast<MarkKind>(i % 9),
                          static_cast<std::uint16_t>(i % 16), static_cast<float>(i % 1000)});
        writing = false;
    });
    bool wrong = false;
    std::uint64_t seen = 0;
    for (bool last = false; !last;) {
        last = !writing;
        const auto found = marks.between(TimePoint::min(), TimePoint::max());
        if (!found) continue;
        for (const Mark& mark : *found) {
            const auto i = static_cast<std::uint64_t>(mark.time.time_since_epoch().count());
            wrong |= mark.kind != static_cast<MarkKind>(i % 9) || mark.unit != i % 16 ||
                     mark.value != static_cast<float>(i % 1000);
            ++seen;
        }
    }
    writer.join();
    EXPECT_FALSE(wrong);
    EXPECT_GE(seen, 200U);
}

}  // namespace
}  // namespace kickstand
