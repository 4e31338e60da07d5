#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace kickstand {

/// A ring of plain values that one thread writes while others read it in place. Stores release and loads
/// acquire, so whoever sees a value also sees everything that the writer did before it; RingIndex builds on
/// that. The memory is reserved at once and left untouched: a page is really taken when the first value lands
/// in it.
template <class T>
class RingCells {
    static_assert(std::is_trivially_copyable_v<T> && std::atomic_ref<T>::is_always_lock_free);
    static_assert(alignof(T) >= std::atomic_ref<T>::required_alignment);

  public:
    /// `size` is a power of two.
    explicit RingCells(std::size_t size)
        : cells_(std::make_unique_for_overwrite<T[]>(size)), mask_(size - 1) {}

    /// Any thread, for an index that has been stored.
    T load(std::uint64_t index) const {
        return std::atomic_ref<T>(cells_[index & mask_]).load(std::memory_order_acquire);
    }
    /// Writer's thread.
    void store(std::uint64_t index, T value) {
        std::atomic_ref<T>(cells_[index & mask_]).store(value, std::memory_order_release);
    }
    std::size_t bytes() const { return (mask_ + 1) * sizeof(T); }

  private:
    std::unique_ptr<T[]> cells_;
    std::size_t mask_;
};

/// The first index in [first, end) whose entry does not satisfy `before`, or `end`. Entries that satisfy it
/// come first. Looks near `guess` first and gallops from there, so a good guess is cheap however long the
/// ring.
template <class Before>
std::uint64_t partitionRing(std::uint64_t first, std::uint64_t end, std::uint64_t guess, Before before) {
    if (first >= end) return end;
    std::uint64_t last = std::clamp(guess, first, end - 1);
    if (before(last)) {
        first = last + 1;
        for (std::uint64_t step = 1; last < end; step *= 2) {
            last = std::min(last + step, end);
            if (last == end || !before(last)) break;
            first = last + 1;
        }
    } else {
        for (std::uint64_t step = 1; last > first; step *= 2) {
            const std::uint64_t probe = last - std::min(step, last - first);
            if (before(probe)) {
                first = probe + 1;
                break;
            }
            last = probe;
        }
    }
    while (first < last) {
        const std::uint64_t middle = first + (last - first) / 2;
        if (before(middle))
            first = middle + 1;
        else
            last = middle;
    }
    return first;
}

}  // namespace kickstand
