// What the telemetry store costs, as JSON on standard output: sixteen robots with five signals each at 200 Hz
// for ten minutes (9.6 million samples), appended, drawn and summed up. The peer is a std::vector per series,
// which is appended to by push_back and drawn by walking over all of its samples.

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/telemetry/store.h"

namespace {

using namespace kickstand;
using Clock = std::chrono::steady_clock;

constexpr std::uint16_t kUnits = 16;
constexpr std::uint16_t kSignals = 5;
constexpr std::size_t kSeries = std::size_t{kUnits} * kSignals;
constexpr int kTicks = 600 * 200;
constexpr Duration kTick = std::chrono::milliseconds(5);
constexpr std::size_t kColumns = 1100;
constexpr int kRounds = 30;

SignalId keyOf(std::size_t series) {
    return {static_cast<std::uint16_t>(series / kSignals), static_cast<std::uint16_t>(series % kSignals)};
}

/// Noise that never repeats the value before, so that every sample is kept.
float valueOf(int tick, std::size_t series) {
    const auto mixed =
        (static_cast<std::uint32_t>(tick) * 2654435761U) ^ (static_cast<std::uint32_t>(series) * 40503U);
    return static_cast<float>(mixed >> 20) + static_cast<float>(tick & 1) / 2;
}

/// Feedback comes when it comes: each tick's time is up to 2 ms off.
TimePoint timeOf(int tick) {
    const auto mixed = static_cast<std::uint32_t>(tick) * 2246822519U;
    return TimePoint(kTick * tick + std::chrono::microseconds(mixed % 2000));
}

/// How long each of `rounds` calls took, in microseconds, in rising order.
template <class Work>
std::vector<double> times_us(int rounds, Work work) {
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(rounds));
    for (int round = 0; round < rounds; ++round) {
        const auto start = Clock::now();
        work(round);
        times.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    }
    std::sort(times.begin(), times.end());
    return times;
}

double at(const std::vector<double>& sorted, double share) {
    return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void row(std::string_view name, const std::vector<double>& own_us, const std::vector<double>& peer_us) {
    std::printf("    {\"name\": \"%.*s\", \"p50_us\": %.3f, \"p99_us\": %.3f, \"worst_us\": %.3f",
                static_cast<int>(name.size()), name.data(), at(own_us, 0.5), at(own_us, 0.99), own_us.back());
    if (!peer_us.empty())
        std::printf(", \"peer_p50_us\": %.3f, \"peer_p99_us\": %.3f, \"peer_to_own\": %.2f", at(peer_us, 0.5),
                    at(peer_us, 0.99), at(peer_us, 0.5) / at(own_us, 0.5));
    std::printf("},\n");
}

using Plain = std::vector<Sample>;

void drawPlain(const Plain& samples, TimePoint start, Duration width, std::vector<Column>& columns) {
    std::fill(columns.begin(), columns.end(), Column{});
    for (const Sample& sample : samples) {
        const auto place = (sample.time - start) / width;
        if (sample.time < start || place >= static_cast<std::int64_t>(columns.size())) continue;
        Column& column = columns[static_cast<std::size_t>(place)];
        column.min = column.count == 0 ? sample.value : std::min(column.min, sample.value);
        column.max = column.count == 0 ? sample.value : std::max(column.max, sample.value);
        ++column.count;
    }
}

}  // namespace

int main() {
    TelemetryStore store({.series = kSeries, .samples = 131'000, .marks = 1000});
    std::vector<Plain> plain(kSeries);
    std::vector<Column> columns(kColumns);
    const TimePoint start{};
    const Duration window = kTick * kTicks;
    const Duration width = window / kColumns;
    double sum = 0;

    std::printf("{\n  \"bench\": \"telemetry\",\n  \"series\": %zu,\n  \"samples\": %zu,\n  \"rows\": [\n",
                kSeries, kSeries * kTicks);
    const auto appended = times_us(kTicks, [&](int tick) {
        for (std::size_t i = 0; i < kSeries; ++i)
            store.append(keyOf(i), timeOf(tick), valueOf(tick, i));
    });
    const auto pushed = times_us(kTicks, [&](int tick) {
        for (std::size_t i = 0; i < kSeries; ++i)
            plain[i].push_back({timeOf(tick), valueOf(tick, i)});
    });
    row("append one sample to each of 80 series, by key", appended, pushed);

    std::vector<const TimeSeries*> series;
    for (std::size_t i = 0; i < kSeries; ++i)
        series.push_back(store.find(keyOf(i)));
    const auto drawn = times_us(kRounds, [&](int) {
        for (const TimeSeries* each : series)
            if (each->columns(start, width, columns)) sum += static_cast<double>(columns[kColumns / 2].max);
    });
    const auto walked = times_us(3, [&](int) {
        for (const Plain& each : plain) {
            drawPlain(each, start, width, columns);
            sum += static_cast<double>(columns[kColumns / 2].max);
        }
    });
    row("1100 columns over 600 s, 80 series", drawn, walked);

    const auto followed = times_us(kRounds, [&](int) {
        for (const TimeSeries* each : series)
            if (each->columns(start + window - 2 * width, width, std::span(columns).first(2)))
                sum += static_cast<double>(columns[1].max);
    });
    row("the newest two columns, 80 series", followed, {});

    const auto summed = times_us(kRounds, [&](int) {
        for (const TimeSeries* each : series)
            if (const auto stats = each->stats(start + width / 3, start + window - width / 3))
                sum += stats->mean;
    });
    row("min, max and mean over 600 s, 80 series", summed, {});

    std::printf("    {\"name\": \"memory\", \"own_bytes\": %zu, \"peer_bytes\": %zu}\n  ]\n}\n",
                store.bytes(), kSeries * plain.front().capacity() * sizeof(Sample));
    return sum > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
