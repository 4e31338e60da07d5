#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "core/engine/flow/bounded_queue.h"
#include "core/engine/flow/event_ring.h"
#include "core/engine/flow/heartbeat.h"
#include "core/engine/flow/snapshot_cell.h"

namespace kickstand {
namespace {

struct Command {
    int producer = 0;
    int number = 0;
};

TEST(FlowThreads, AQueueKeepsEachProducersOrderAndLosesNothing) {
    constexpr int kProducers = 4;
    constexpr int kEach = 5000;
    BoundedQueue<Command> queue(16);
    std::vector<std::thread> producers;
    producers.reserve(kProducers);
    for (int producer = 0; producer < kProducers; ++producer)
        producers.emplace_back([&queue, producer] {
            for (int i = 0; i < kEach; ++i)
                while (!queue.tryPush(Command{producer, i}))
                    std::this_thread::yield();
        });
    std::array<int, kProducers> next{};
    bool inOrder = true;
    for (int taken = 0; taken < kProducers * kEach;) {
        const auto command = queue.tryPop();
        if (!command) {
            std::this_thread::yield();
            continue;
        }
        inOrder &= command->number == next.at(static_cast<std::size_t>(command->producer))++;
        ++taken;
    }
    for (std::thread& producer : producers)
        producer.join();
    EXPECT_TRUE(inOrder);
    EXPECT_EQ(queue.size(), 0U);
}

TEST(FlowThreads, EveryReaderOfEventsSeesOrCountsEachOfThem) {
    constexpr std::uint64_t kEvents = 50'000;
    EventRing<std::string> ring(64);
    std::array<std::uint64_t, 3> accounted{};
    std::array<bool, 3> wrong{};
    std::vector<std::thread> readers;
    for (std::size_t reader = 0; reader < accounted.size(); ++reader)
        readers.emplace_back([&, reader] {
            EventRing<std::string>::Cursor cursor = 0;
            std::uint64_t expected = 0;
            while (expected < kEvents) {
                const auto read = ring.read(cursor, 16 + reader);
                expected += read.lost;
                for (const auto& event : read.events) {
                    wrong[reader] |= event.sequence != expected || event.value != std::to_string(expected);
                    ++expected;
                }
            }
            accounted[reader] = expected;
        });
    for (std::uint64_t i = 0; i < kEvents; ++i)
        ring.append(std::to_string(i));
    for (std::thread& reader : readers)
        reader.join();
    for (std::size_t reader = 0; reader < accounted.size(); ++reader) {
        EXPECT_EQ(accounted[reader], kEvents);
        EXPECT_FALSE(wrong[reader]);
    }
}

TEST(FlowThreads, SnapshotsAreWholeAndNeverGoBack) {
    constexpr std::uint64_t kSnapshots = 20'000;
    struct State {
        std::uint64_t number = 0;
        std::vector<std::uint64_t> copies;
    };
    SnapshotCell<State> cell;
    std::array<bool, 2> wrong{};
    std::vector<std::thread> readers;
    for (std::size_t reader = 0; reader < wrong.size(); ++reader)
        readers.emplace_back([&, reader] {
            std::uint64_t seen = 0;
            std::uint64_t last = 0;
            while (last < kSnapshots) {
                const auto state = cell.newerThan(seen);
                if (!state) continue;
                wrong[reader] |= state->number <= last || state->number != seen;
                for (const std::uint64_t copy : state->copies)
                    wrong[reader] |= copy != state->number;
                last = state->number;
            }
        });
    for (std::uint64_t i = 1; i <= kSnapshots; ++i)
        cell.publish(State{i, std::vector<std::uint64_t>(8, i)});
    for (std::thread& reader : readers)
        reader.join();
    EXPECT_FALSE(wrong[0]);
    EXPECT_FALSE(wrong[1]);
}

TEST(FlowThreads, TheLatestOfManyThreadsBeatsStands) {
    Heartbeat heartbeat;
    std::vector<std::thread> threads;
    threads.reserve(3);
    for (int thread = 0; thread < 3; ++thread)
        threads.emplace_back([&heartbeat, thread] {
            for (int i = 0; i < 20'000; ++i)
                heartbeat.beat(TimePoint(Duration(i * 3 + thread)));
        });
    bool backwards = false;
    TimePoint before(Duration(-1));
    while (before < TimePoint(Duration(59'999))) {
        const TimePoint last = heartbeat.last().value_or(before);
        backwards |= last < before;
        before = last;
    }
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_FALSE(backwards);
    EXPECT_EQ(heartbeat.last(), TimePoint(Duration(59'999)));
}

}  // namespace
}  // namespace kickstand
