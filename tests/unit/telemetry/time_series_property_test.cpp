// Holds the series against a plain list of its samples: columns, stats and look-ups of random spans, on
// series that have wrapped, with gaps and several changes at one time.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "core/telemetry/time_series.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;

/// The same questions, answered by looking at everything.
class PlainSeries {
  public:
    explicit PlainSeries(std::vector<Sample> samples) : samples_(std::move(samples)) {}

    Column column(TimePoint from, TimePoint to) const {
        Column result;
        bool begun = false;
        const auto hold = [&](float value) {
            result.last = value;
            if (!begun) result.first = value;
            begun = true;
            result.min = std::fmin(result.min, value);
            result.max = std::fmax(result.max, value);
        };
        const float carried = valueBefore(from);
        const bool fresh =
            std::any_of(samples_.begin(), samples_.end(), [&](auto& s) { return s.time == from; });
        if (!fresh) hold(carried);
        for (const Sample& sample : samples_) {
            if (sample.time < from || sample.time >= to) continue;
            hold(sample.value);
            ++result.count;
        }
        return result;
    }

    /// Mean over the span and how long a value held in it.
    std::pair<double, Duration> mean(TimePoint from, TimePoint to) const {
        double sum = 0;
        Duration held{};
        for (std::size_t i = 0; i < samples_.size(); ++i) {
            const TimePoint begin = std::max(samples_[i].time, from);
            const TimePoint end = i + 1 < samples_.size() ? std::min(samples_[i + 1].time, to) : to;
            if (end <= begin || std::isnan(samples_[i].value)) continue;
            sum += static_cast<double>(samples_[i].value) * seconds(end - begin);
            held += end - begin;
        }
        return {sum / seconds(held), held};
    }

  private:
    float valueBefore(TimePoint time) const {
        float value = kNoValue;
        for (const Sample& sample : samples_)
            if (sample.time < time) value = sample.value;
        return value;
    }

    std::vector<Sample> samples_;
};

bool same(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

class TimeSeriesProperty : public testing::TestWithParam<unsigned> {
  protected:
    TimeSeriesProperty() : random_(GetParam()), series_(pick(1, 900)) {
        TimePoint time(Duration(pick(0, 1'000'000)));
        const int count = pick(0, 5000);
        for (int i = 0; i < count; ++i) {
            time += Duration(pick(0, 3) == 0 ? 0 : pick(1, 20'000'000));
            if (pick(0, 40) == 0)
                series_.gap(time);
            else
                series_.append(time, static_cast<float>(pick(-3000, 3000)) / 16);
        }
        samples_.resize(series_.capacity());
        samples_.resize(series_.copy(0, samples_).count);
    }

    int pick(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
    /// A time inside what there is or somewhat outside, now and then exactly that of a sample.
    TimePoint pickTime() {
        if (samples_.empty()) return TimePoint(Duration(pick(-1000, 1000)));
        const Sample& sample =
            samples_[static_cast<std::size_t>(pick(0, static_cast<int>(samples_.size()) - 1))];
        return sample.time + Duration(pick(0, 2) == 0 ? 0 : pick(-200'000'000, 200'000'000));
    }

    std::mt19937 random_;
    TimeSeries series_;
    std::vector<Sample> samples_;
};

TEST_P(TimeSeriesProperty, ColumnsAreThoseOfThePlainList) {
    const PlainSeries plain(samples_);
    for (int round = 0; round < 20; ++round) {
        const TimePoint start = pickTime();
        const Duration width(pick(1, 2) == 1 ? pick(1, 3'000'000) : pick(3'000'000, 900'000'000));
        std::vector<Column> columns(static_cast<std::size_t>(pick(1, 40)));
        ASSERT_TRUE(series_.columns(start, width, columns));
        for (std::size_t i = 0; i < columns.size(); ++i) {
            const TimePoint left = start + width * static_cast<std::int64_t>(i);
            const Column expected = plain.column(left, left + width);
            ASSERT_EQ(columns[i].count, expected.count);
            ASSERT_TRUE(same(columns[i].first, expected.first)) << columns[i].first << ' ' << expected.first;
            ASSERT_TRUE(same(columns[i].last, expected.last)) << columns[i].last << ' ' << expected.last;
            ASSERT_TRUE(same(columns[i].min, expected.min)) << columns[i].min << ' ' << expected.min;
            ASSERT_TRUE(same(columns[i].max, expected.max)) << columns[i].max << ' ' << expected.max;
        }
    }
}

TEST_P(TimeSeriesProperty, StatsAreThoseOfThePlainList) {
    const PlainSeries plain(samples_);
    for (int round = 0; round < 60; ++round) {
        const TimePoint from = pickTime();
        const TimePoint to = from + Duration(pick(1, 2'000'000'000));
        const auto stats = series_.stats(from, to);
        const auto [mean, held] = plain.mean(from, to);
        if (held == Duration::zero()) {
            ASSERT_EQ(stats.error(), Miss::NoValue);
            continue;
        }
        ASSERT_TRUE(stats);
        const Column column = plain.column(from, to);
        ASSERT_NEAR(stats->mean, mean, 1e-6);
        ASSERT_EQ(stats->held, held);
        ASSERT_EQ(stats->min, column.min);
        ASSERT_EQ(stats->max, column.max);
        ASSERT_EQ(stats->count, column.count);
    }
}

TEST_P(TimeSeriesProperty, LookUpsAreThoseOfThePlainList) {
    for (int round = 0; round < 100; ++round) {
        const TimePoint time = pickTime();
        Sample holding;
        Duration distance = Duration::max();
        for (const Sample& sample : samples_) {
            if (sample.time <= time) holding = sample;
            if (!std::isnan(sample.value))
                distance = std::min(distance, Duration(std::chrono::abs(sample.time - time)));
        }
        const auto found = series_.at(time);
        ASSERT_EQ(found.has_value(), !std::isnan(holding.value));
        if (found) {
            ASSERT_EQ(found->time, holding.time);
            ASSERT_EQ(found->value, holding.value);
        }
        const auto nearest = series_.nearest(time);
        ASSERT_EQ(nearest.has_value(), distance != Duration::max());
        if (nearest) {
            ASSERT_EQ(std::chrono::abs(nearest->time - time), distance);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Seeds, TimeSeriesProperty, testing::Range(1U, 41U));

}  // namespace
}  // namespace kickstand
