#pragma once

#include <array>
#include <cstdint>

namespace kickstand::coach::wire {

/// The highest level either way; there are eight with zero (coach protocol 4.2).
inline constexpr int kTopLevel = 7;
/// What the levels 0 to 7 mean, in percent of the most.
inline constexpr std::array<int, kTopLevel + 1> kLevelPercent{0, 15, 29, 45, 59, 75, 89, 100};

/// How a boat is to move: levels −7 to 7 (coach protocol 4.2).
struct Velocity {
    int forward = 0;  ///< Positive: forward.
    int turn = 0;     ///< Positive: counterclockwise.

    bool isZero() const { return forward == 0 && turn == 0; }
    friend bool operator==(const Velocity&, const Velocity&) = default;
};

/// Whether both levels are −7 to 7. Any thread.
constexpr bool isVelocity(const Velocity& velocity) noexcept {
    const auto isLevel = [](int level) { return level >= -kTopLevel && level <= kTopLevel; };
    return isLevel(velocity.forward) && isLevel(velocity.turn);
}

/// A level in percent, with its sign; the caller has checked it. Any thread.
constexpr int percentOf(int level) noexcept {
    const int percent = kLevelPercent[static_cast<std::size_t>(level < 0 ? -level : level)];
    return level < 0 ? -percent : percent;
}

/// The level that is nearest to so many percent; beyond ±100 the last one. Any thread.
constexpr int nearestLevel(double percent) noexcept {
    const double size = percent < 0 ? -percent : percent;
    int level = 0;
    while (level < kTopLevel && size > (kLevelPercent[static_cast<std::size_t>(level)] +
                                        kLevelPercent[static_cast<std::size_t>(level) + 1]) /
                                           2.0)
        ++level;
    return percent < 0 ? -level : level;
}

namespace detail {
constexpr unsigned nibbleOf(int level) noexcept {
    return level < 0 ? 8U | static_cast<unsigned>(-level) : static_cast<unsigned>(level);
}
constexpr int levelOf(unsigned nibble) noexcept {
    const int size = static_cast<int>(nibble & 7U);
    return (nibble & 8U) != 0 ? -size : size;
}
}  // namespace detail

/// The parameter of a velocity command: two nibbles of sign and magnitude. The caller has checked it. Any
/// thread.
constexpr std::uint8_t parameterOf(const Velocity& velocity) noexcept {
    return static_cast<std::uint8_t>(detail::nibbleOf(velocity.forward) << 4 |
                                     detail::nibbleOf(velocity.turn));
}

/// What such a parameter says; minus zero is zero. Any thread.
constexpr Velocity velocityOf(std::uint8_t parameter) noexcept {
    return {detail::levelOf(parameter >> 4), detail::levelOf(parameter & 0xFU)};
}

}  // namespace kickstand::coach::wire
