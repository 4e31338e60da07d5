#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

namespace kickstand {

/// The entries of a ring that may be read: indices first to end - 1, counted from the first ever written.
struct RingWindow {
    std::uint64_t first = 0;
    std::uint64_t end = 0;
};

/// What a copy out of a ring brought.
struct RingCopy {
    std::size_t count = 0;   ///< Entries copied, oldest first.
    std::uint64_t next = 0;  ///< Where the next copy goes on.
    std::uint64_t lost = 0;  ///< Entries that were asked for and had been overwritten.
};

/// Counts what has been written into the cells of a ring, and tells a reader whether what it read was still
/// there.
///
/// The ring has more cells than it promises entries, by at least kGuard: a reader comes out wrong only when
/// the writer laps that many entries while it reads, and then overrun() says so. The proof needs one counter:
/// the writer stores entry i into its cell after it published i entries, so a reader that met entry i where
/// it looked for i - cells() finds end() >= i afterwards.
class RingIndex {
  public:
    static constexpr std::size_t kGuard = 64;

    /// Promises the last `capacity` entries, at least one.
    explicit RingIndex(std::size_t capacity)
        : capacity_(std::max<std::size_t>(capacity, 1)), cells_(std::bit_ceil(capacity_ + kGuard)) {}

    std::size_t capacity() const { return capacity_; }
    /// How many cells a ring of single entries needs: a power of two.
    std::size_t cells() const { return cells_; }
    /// How many entries were ever written. Any thread.
    std::uint64_t end() const { return end_.load(std::memory_order_acquire); }
    /// What may be read now. Any thread.
    RingWindow window() const {
        const std::uint64_t written = end();
        return {written > capacity_ ? written - capacity_ : 0, written};
    }
    /// Whether entry `first` may have been overwritten before the reads that precede this call. While it was
    /// not, none after it was.
    bool overrun(std::uint64_t first) const { return first + cells_ <= end(); }
    /// Shows readers the entry that has just been stored. Writer's thread.
    void publish() { end_.store(end_.load(std::memory_order_relaxed) + 1, std::memory_order_release); }

    /// Runs `read` on the window until no entry of it was overwritten meanwhile; gives up after a few times,
    /// with nothing. Any thread.
    template <class Read>
    std::optional<std::invoke_result_t<Read, RingWindow>> consistently(Read read) const {
        constexpr int kAttempts = 4;
        for (int attempt = 0; attempt < kAttempts; ++attempt) {
            const RingWindow now = window();
            auto result = read(now);
            if (!overrun(now.first)) return result;
        }
        return std::nullopt;
    }

    /// Copies entries from index `from` on into `out`; `load` gives the entry at an index. Every entry that
    /// comes back is whole; the others are counted. Any thread.
    template <class T, class Load>
    RingCopy copy(std::uint64_t from, std::span<T> out, Load load) const {
        const RingWindow now = window();
        const std::uint64_t wanted = std::min(from, now.end);
        const std::uint64_t start = std::max(wanted, now.first);
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), now.end - start));
        for (std::size_t i = 0; i < count; ++i)
            out[i] = load(start + i);

        const std::uint64_t written = end();
        const std::uint64_t intact = written >= cells_ ? written - cells_ + 1 : 0;
        const auto torn =
            static_cast<std::size_t>(std::min<std::uint64_t>(count, intact > start ? intact - start : 0));
        if (torn > 0) std::copy(out.begin() + torn, out.begin() + count, out.begin());
        return {count - torn, start + count, start - wanted + torn};
    }

  private:
    /// On a cache line that the writer's own members do not share.
    alignas(64) std::atomic<std::uint64_t> end_{0};
    std::size_t capacity_;
    std::size_t cells_;
};

}  // namespace kickstand
