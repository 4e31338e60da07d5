#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "core/base/bytes.h"

namespace kickstand {

/// Up to `capacity` bytes, held in place: what a codec returns where a message has no fixed length. Never
/// allocates. As thread-safe as an int.
template <std::size_t capacity>
class InlineBytes {
  public:
    /// Empty. What is not held is not written to either: to clear it costs more than most codecs do.
    constexpr InlineBytes() noexcept {
        if (std::is_constant_evaluated()) bytes_.fill(0);
    }
    constexpr InlineBytes(const InlineBytes& other) noexcept : InlineBytes() { append(other.view()); }
    constexpr InlineBytes& operator=(const InlineBytes& other) noexcept {
        if (this == &other) return *this;
        clear();
        append(other.view());
        return *this;
    }

    static constexpr std::size_t maxSize() noexcept { return capacity; }
    constexpr std::size_t size() const noexcept { return size_; }
    constexpr bool empty() const noexcept { return size_ == 0; }
    constexpr const std::uint8_t* data() const noexcept { return bytes_.data(); }
    constexpr std::uint8_t operator[](std::size_t index) const noexcept { return bytes_[index]; }
    constexpr const std::uint8_t* begin() const noexcept { return bytes_.data(); }
    constexpr const std::uint8_t* end() const noexcept { return bytes_.data() + size_; }

    /// The bytes held; valid while this object is neither changed nor destroyed.
    constexpr ByteView view() const noexcept { return {bytes_.data(), size_}; }
    /// The same, to be written into.
    constexpr ByteSpan span() noexcept { return {bytes_.data(), size_}; }

    /// The room behind them, to be written into before take() counts it in.
    constexpr ByteSpan room() noexcept { return ByteSpan(bytes_).subspan(size_); }
    /// Counts in the first bytes of room(), of which there are so many.
    constexpr void take(std::size_t count) noexcept { size_ += count; }

    /// Appends all of `more`, or nothing and gives false where it does not fit.
    constexpr bool append(ByteView more) noexcept {
        if (more.size() > capacity - size_) return false;
        std::copy(more.begin(), more.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(size_));
        size_ += more.size();
        return true;
    }
    constexpr bool append(std::uint8_t byte) noexcept { return append(ByteView{&byte, 1}); }

    /// Makes it `size` bytes long; what is added is zero. False, and nothing done, past the capacity.
    constexpr bool resize(std::size_t size) noexcept {
        if (size > capacity) return false;
        for (std::size_t i = size_; i < size; ++i)
            bytes_[i] = 0;
        size_ = size;
        return true;
    }
    constexpr void clear() noexcept { size_ = 0; }

    friend constexpr bool operator==(const InlineBytes& a, const InlineBytes& b) noexcept {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

  private:
    std::array<std::uint8_t, capacity> bytes_;
    std::size_t size_ = 0;
};

}  // namespace kickstand
