#include "core/motionplan/wire/movement.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

#include "core/motionplan/wire/denominations.h"

namespace kickstand::motionplan::wire {
namespace {

constexpr unsigned kCodeBits = 5;
constexpr unsigned kCodeMask = (1U << kCodeBits) - 1;

const char* subjectOf(Wheels wheels) {
    return isTurn(wheels) ? "angle" : "distance";
}

std::optional<unsigned> codeOf(const Movement& movement) {
    if (isTurn(movement.wheels)) {
        const bool legal = movement.amount >= kAngleStep_deg && movement.amount <= kLargestAngle_deg &&
                           movement.amount % kAngleStep_deg == 0;
        if (!legal) return std::nullopt;
        return static_cast<unsigned>(movement.amount / kAngleStep_deg);
    }
    const auto* const found = std::ranges::find(kDenominations_cm, movement.amount);
    if (found == kDenominations_cm.end()) return std::nullopt;
    return static_cast<unsigned>(found - kDenominations_cm.begin());
}

/// Every amount that one movement of that kind can have, ascending.
std::vector<int> amountsOf(Wheels wheels) {
    std::vector<int> amounts;
    if (isTurn(wheels)) {
        for (int angle_deg = kAngleStep_deg; angle_deg <= kLargestAngle_deg; angle_deg += kAngleStep_deg)
            amounts.push_back(angle_deg);
    } else {
        amounts.assign(kDenominations_cm.begin(), kDenominations_cm.end());
        std::ranges::sort(amounts);
    }
    return amounts;
}

/// How many amounts each whole number takes at least, and the largest of them; for 0 to `sum`.
struct Sums {
    static constexpr int kImpossible = std::numeric_limits<int>::max() / 2;
    std::vector<int> count;
    std::vector<int> last;

    Sums(int sum, const std::vector<int>& amounts)
        : count(static_cast<std::size_t>(sum) + 1, kImpossible), last(count.size(), 0) {
        count[0] = 0;
        for (std::size_t reached = 1; reached < count.size(); ++reached) {
            for (const int amount : amounts) {
                const auto step = static_cast<std::size_t>(amount);
                if (step > reached) break;
                if (count[reached - step] + 1 > count[reached]) continue;
                count[reached] = count[reached - step] + 1;
                last[reached] = amount;
            }
        }
    }
};

}  // namespace

const char* name(Wheels wheels) noexcept {
    constexpr std::array<const char*, kWheelsCount> kNames{"both-forward", "both-back",     "left-forward",
                                                           "left-back",    "right-forward", "right-back"};
    const auto index = static_cast<std::size_t>(wheels);
    return index < kNames.size() ? kNames[index] : "unknown";
}

Result<std::uint8_t> encodeMovement(const Movement& movement) {
    const auto code = codeOf(movement);
    if (!code || static_cast<int>(movement.wheels) >= kWheelsCount)
        return fail(
            {.code = Errc::NoEncoding, .subject = subjectOf(movement.wheels), .got = movement.amount});
    return static_cast<std::uint8_t>(static_cast<unsigned>(movement.wheels) << kCodeBits | *code);
}

std::optional<Movement> decodeMovement(std::uint8_t byte) noexcept {
    const unsigned wheelCode = byte >> kCodeBits;
    if (wheelCode >= kWheelsCount) return std::nullopt;
    const auto wheels = static_cast<Wheels>(wheelCode);
    const unsigned code = byte & kCodeMask;
    if (!isTurn(wheels)) return Movement{wheels, kDenominations_cm[code]};
    const int angle_deg = static_cast<int>(code) * kAngleStep_deg;
    if (angle_deg < kAngleStep_deg || angle_deg > kLargestAngle_deg) return std::nullopt;
    return Movement{wheels, angle_deg};
}

Result<std::vector<Movement>> exactSum(Wheels wheels, int amount, int most) {
    const std::vector<int> amounts = amountsOf(wheels);
    const int reach = amounts.back() * most;
    if (amount < 1 || amount > reach)
        return fail({.code = Errc::OutOfRange,
                     .subject = subjectOf(wheels),
                     .lowest = amounts.front(),
                     .highest = reach,
                     .got = amount});
    // Whole largest ones first; only what is left of them, and one more, can be put together better or worse.
    const int largest = std::max(amount / amounts.back() - 1, 0);
    const auto rest = static_cast<std::size_t>(amount - largest * amounts.back());
    const Sums sums(static_cast<int>(rest), amounts);
    if (sums.count[rest] == Sums::kImpossible) {
        const int below = amount / kAngleStep_deg * kAngleStep_deg;
        return fail({.code = Errc::NoEncoding,
                     .subject = subjectOf(wheels),
                     .lowest = std::max(below, kAngleStep_deg),
                     .highest = below + kAngleStep_deg,
                     .got = amount});
    }
    if (largest + sums.count[rest] > most)
        return fail({.code = Errc::OutOfRange,
                     .subject = subjectOf(wheels),
                     .lowest = amounts.front(),
                     .highest = reach,
                     .got = amount});
    std::vector<Movement> movements(static_cast<std::size_t>(largest), Movement{wheels, amounts.back()});
    for (std::size_t left = rest; left > 0; left -= static_cast<std::size_t>(sums.last[left]))
        movements.push_back({wheels, sums.last[left]});
    std::ranges::sort(movements, std::greater<>{}, &Movement::amount);
    return movements;
}

}  // namespace kickstand::motionplan::wire
