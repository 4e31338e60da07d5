#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

namespace kickstand {

/// The latest state of something: one thread publishes, any others read at their own rate, and states that
/// nobody read in time are dropped. A snapshot never changes once published; whoever holds one keeps it
/// alive.
template <class T>
class SnapshotCell {
  public:
    /// What a reader gets: the snapshot (null before the first), and its version.
    struct Latest {
        std::shared_ptr<const T> value;
        std::uint64_t version = 0;
    };

    /// Replaces the latest snapshot. Writer's thread.
    void publish(std::shared_ptr<const T> value) {
        {
            const std::lock_guard lock(mutex_);
            value_.swap(value);
            version_.store(version_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
        }
        // The one before ends here, if nobody holds it: never under the lock.
    }
    void publish(T value) { publish(std::make_shared<const T>(std::move(value))); }

    /// How many were published; 0 before the first. Any thread, without a lock.
    std::uint64_t version() const { return version_.load(std::memory_order_acquire); }

    /// Any thread.
    Latest latest() const {
        const std::lock_guard lock(mutex_);
        return {value_, version_.load(std::memory_order_relaxed)};
    }

    /// The latest snapshot when its version is not `seen`, which is brought up to date; else null. Costs one
    /// load when nothing is new. Any thread.
    std::shared_ptr<const T> newerThan(std::uint64_t& seen) const {
        if (version() == seen) return nullptr;
        Latest now = latest();
        seen = now.version;
        return std::move(now.value);
    }

  private:
    mutable std::mutex mutex_;
    std::shared_ptr<const T> value_;
    std::atomic<std::uint64_t> version_{0};
};

}  // namespace kickstand
