#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace kickstand {

/// A first-in, first-out queue of fixed size: commands on their way into the engine. Any number of threads
/// push, one takes. It refuses what does not fit, so that whoever asked can be told, and takes no memory
/// after construction beyond what the values themselves hold. Its lock is held for one move of a value,
/// nothing more.
template <class T>
class BoundedQueue {
  public:
    /// Room for `capacity` values, at least one.
    explicit BoundedQueue(std::size_t capacity) : slots_(capacity > 0 ? capacity : 1) {}

    /// False when it is full: then the value is dropped, and counted as refused. Any thread.
    [[nodiscard]] bool tryPush(T value) {
        const std::lock_guard lock(mutex_);
        if (count_ == slots_.size()) {
            ++refused_;
            return false;
        }
        slots_[(first_ + count_) % slots_.size()] = std::move(value);
        ++count_;
        return true;
    }

    /// The oldest value, if there is one. The consumer's thread.
    std::optional<T> tryPop() {
        std::optional<T> oldest;
        const std::lock_guard lock(mutex_);
        if (count_ == 0) return oldest;
        // Emptied here and now: what a value holds must not live on in the slot.
        oldest.swap(slots_[first_]);
        first_ = (first_ + 1) % slots_.size();
        --count_;
        return oldest;
    }

    std::size_t capacity() const { return slots_.size(); }
    /// How many wait. Any thread.
    std::size_t size() const {
        const std::lock_guard lock(mutex_);
        return count_;
    }
    /// How many were turned away for want of room, ever. Any thread.
    std::uint64_t refused() const {
        const std::lock_guard lock(mutex_);
        return refused_;
    }

  private:
    mutable std::mutex mutex_;
    std::vector<std::optional<T>> slots_;
    std::size_t first_ = 0;
    std::size_t count_ = 0;
    std::uint64_t refused_ = 0;
};

}  // namespace kickstand
