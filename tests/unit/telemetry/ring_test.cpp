#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "core/telemetry/ring_cells.h"
#include "core/telemetry/ring_index.h"
#include "core/telemetry/value_pyramid.h"

namespace kickstand {
namespace {

void publish(RingIndex& index, std::size_t times) {
    for (std::size_t i = 0; i < times; ++i)
        index.publish();
}

TEST(RingIndex, HasMoreCellsThanItPromisesEntries) {
    for (const std::size_t capacity : {0U, 1U, 63U, 64U, 65U, 1000U, 131'000U}) {
        const RingIndex index(capacity);
        EXPECT_GE(index.capacity(), 1U);
        EXPECT_GE(index.cells(), index.capacity() + RingIndex::kGuard);
        EXPECT_TRUE(std::has_single_bit(index.cells()));
    }
}

TEST(RingIndex, WindowIsTheLastEntries) {
    RingIndex index(10);
    EXPECT_EQ(index.window().end, 0U);
    publish(index, 7);
    EXPECT_EQ(index.window().first, 0U);
    EXPECT_EQ(index.window().end, 7U);
    publish(index, 100);
    EXPECT_EQ(index.window().first, 97U);
    EXPECT_EQ(index.window().end, 107U);
}

TEST(RingIndex, AnEntryCountsAsOverwrittenFromTheMomentItsCellMayBeWrittenTo) {
    RingIndex index(10);
    publish(index, index.cells() - 1);
    EXPECT_FALSE(index.overrun(0));
    index.publish();
    // The writer may be storing entry cells() into the cell of entry 0 right now.
    EXPECT_TRUE(index.overrun(0));
    EXPECT_FALSE(index.overrun(1));
}

TEST(RingIndex, ReadsAgainWhenTheWriterLappedTheFirstRead) {
    RingIndex index(10);
    publish(index, 10);
    int reads = 0;
    const auto result = index.consistently([&](RingWindow window) {
        if (++reads == 1) publish(index, index.cells());
        return window.first;
    });
    EXPECT_EQ(reads, 2);
    ASSERT_TRUE(result.has_value());
    EXPECT_EQ(*result, index.end() - 10);
}

TEST(RingIndex, SaysSoWhenTheWriterLapsEveryRead) {
    RingIndex index(10);
    publish(index, 10);
    const auto result = index.consistently([&](RingWindow window) {
        publish(index, index.cells());
        return window.first;
    });
    EXPECT_FALSE(result.has_value());
}

TEST(RingIndex, CopyCountsWhatWasGoneBefore) {
    RingIndex index(10);
    publish(index, 25);
    std::array<std::uint64_t, 4> out{};
    const RingCopy copied = index.copy(3, std::span<std::uint64_t>(out), [](std::uint64_t i) { return i; });
    EXPECT_EQ(copied.count, 4U);
    EXPECT_EQ(copied.lost, 12U);
    EXPECT_EQ(copied.next, 19U);
    EXPECT_EQ(out, (std::array<std::uint64_t, 4>{15, 16, 17, 18}));
}

TEST(RingIndex, CopyKeepsOnlyWhatWasWholeWhenTheWriterOvertookIt) {
    RingIndex index(10);
    publish(index, 10);
    std::array<std::uint64_t, 10> out{};
    const RingCopy copied = index.copy(0, std::span<std::uint64_t>(out), [&](std::uint64_t i) {
        // By the end of the copy entries 0 to 3 may have been written over.
        if (i == 9) publish(index, index.cells() - 10 + 3);
        return i;
    });
    EXPECT_EQ(copied.count, 6U);
    EXPECT_EQ(copied.lost, 4U);
    EXPECT_EQ(copied.next, 10U);
    EXPECT_EQ(std::vector(out.begin(), out.begin() + 6), (std::vector<std::uint64_t>{4, 5, 6, 7, 8, 9}));
}

TEST(RingIndex, CopyFromBeyondTheEndBringsNothing) {
    RingIndex index(10);
    publish(index, 5);
    std::array<std::uint64_t, 4> out{};
    const RingCopy copied = index.copy(99, std::span<std::uint64_t>(out), [](std::uint64_t i) { return i; });
    EXPECT_EQ(copied.count, 0U);
    EXPECT_EQ(copied.lost, 0U);
    EXPECT_EQ(copied.next, 5U);
}

TEST(PartitionRing, FindsTheBorderWhereverItIsAndWhateverTheGuess) {
    for (std::uint64_t first = 0; first < 3; ++first)
        for (std::uint64_t end = first; end < first + 40; ++end)
            for (std::uint64_t border = first; border <= end; ++border)
                for (std::uint64_t guess = 0; guess < end + 2; ++guess) {
                    const auto found = partitionRing(first, end, guess, [&](std::uint64_t i) {
                        EXPECT_TRUE(i >= first && i < end) << "looked outside of its range";
                        return i < border;
                    });
                    ASSERT_EQ(found, border) << first << ' ' << end << ' ' << guess;
                }
}

TEST(PartitionRing, AGoodGuessCostsTwoLooks) {
    for (std::uint64_t border = 1; border < 10'000; border += 100) {
        int looks = 0;
        const auto found = partitionRing(0, 10'000, border, [&](std::uint64_t i) {
            ++looks;
            return i < border;
        });
        EXPECT_EQ(found, border);
        EXPECT_LE(looks, 2);
    }
}

TEST(ValuePyramid, GivesTheExtremesOfEveryStretch) {
    constexpr std::size_t kCells = 1024;
    ValuePyramid pyramid(kCells);
    const auto value = [](std::uint64_t i) { return static_cast<float>(i * 2654435761U % 10007); };
    constexpr std::uint64_t kEnd = 3 * kCells + 5;
    for (std::uint64_t i = 0; i < kEnd; ++i)
        pyramid.append(i, value(i));

    for (std::uint64_t first = kEnd - kCells + 1; first < kEnd; first += 7) {
        Extremes expected = Extremes::none();
        for (std::uint64_t end = first; end <= kEnd; ++end) {
            const Extremes found = pyramid.extremes(first, end);
            ASSERT_EQ(found.min, expected.min) << first << " to " << end;
            ASSERT_EQ(found.max, expected.max) << first << " to " << end;
            if (end < kEnd) expected.add(value(end));
        }
    }
}

}  // namespace
}  // namespace kickstand
