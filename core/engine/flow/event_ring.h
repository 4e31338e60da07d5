#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace kickstand {

/// A value with its place in the order of all that were ever appended, counted from 0.
template <class T>
struct Sequenced {
    std::uint64_t sequence = 0;
    T value;
};

/// The last so many events, numbered without a break: what the engine tells. One thread appends. Any number
/// of readers, each with a cursor of its own, read from any thread; one that fell behind is told how many
/// events it missed, so nothing is lost silently.
template <class T>
class EventRing {
  public:
    struct Read {
        std::vector<Sequenced<T>> events;  ///< Oldest first.
        std::uint64_t lost = 0;            ///< Events before these that this reader will never see.
    };
    /// Where a reader stands: the sequence number that it reads next. A new one begins with the oldest event
    /// still there and counts those before as lost; one that begins at end() hears only what is to come.
    using Cursor = std::uint64_t;

    /// Keeps the last `capacity` events, at least one.
    explicit EventRing(std::size_t capacity) : slots_(std::max<std::size_t>(capacity, 1)) {}

    /// Adds an event and gives its sequence number. Writer's thread.
    std::uint64_t append(T value) {
        std::optional<T> fresh(std::move(value));
        const std::lock_guard lock(mutex_);
        const std::uint64_t sequence = end_.load(std::memory_order_relaxed);
        // What is overwritten comes out by the swap and ends after the lock.
        fresh.swap(slots_[sequence % slots_.size()]);
        end_.store(sequence + 1, std::memory_order_release);
        return sequence;
    }

    /// The events from `cursor` on, at most `most` of them, so that the writer never waits long; moves the
    /// cursor behind them. Takes no lock when there is nothing new. Any thread.
    Read read(Cursor& cursor, std::size_t most = kMostAtOnce) const {
        Read result;
        const std::uint64_t seen = end();
        if (cursor >= seen) return result;
        const auto room =
            static_cast<std::size_t>(std::min<std::uint64_t>({most, seen - cursor, slots_.size()}));
        result.events.reserve(room);  // Memory is taken before the lock.

        const std::lock_guard lock(mutex_);
        const std::uint64_t written = end_.load(std::memory_order_relaxed);
        const std::uint64_t oldest = written > slots_.size() ? written - slots_.size() : 0;
        if (cursor < oldest) {
            result.lost = oldest - cursor;
            cursor = oldest;
        }
        for (; cursor < written && result.events.size() < room; ++cursor)
            result.events.push_back({cursor, *slots_[cursor % slots_.size()]});
        return result;
    }

    /// The sequence number of the next event to come. Any thread, without a lock.
    std::uint64_t end() const { return end_.load(std::memory_order_acquire); }
    std::size_t capacity() const { return slots_.size(); }

    static constexpr std::size_t kMostAtOnce = 256;

  private:
    mutable std::mutex mutex_;
    std::vector<std::optional<T>> slots_;
    std::atomic<std::uint64_t> end_{0};
};

}  // namespace kickstand
