#include "core/thunderbots/wire/kick_timing.h"

#include <algorithm>
#include <optional>

namespace kickstand::thunderbots::wire {
namespace {

/// The nearest whole step, half-way towards zero.
constexpr std::int64_t steps(std::int64_t value_us) noexcept {
    constexpr std::int64_t half = kKickStep_us / 2;
    return value_us >= 0 ? (value_us + half - 1) / kKickStep_us : -((-value_us + half - 1) / kKickStep_us);
}

/// A pulse as it was asked for: not on the grid yet, and perhaps impossible.
struct AskedPulse {
    int solenoid;
    std::int64_t start_us;
    std::int64_t width_us;
};

std::optional<KickTimingError> whyImpossible(const AskedPulse& pulse) noexcept {
    if (pulse.width_us < 0) {
        return KickTimingError{KickTimingError::Reason::NegativeWidth, pulse.solenoid, pulse.width_us, 0};
    }
    const std::int64_t edge_us = pulse.start_us + pulse.width_us;
    if (edge_us <= kKickMax_us) return std::nullopt;
    return KickTimingError{KickTimingError::Reason::EdgeTooLate, pulse.solenoid, edge_us,
                           edge_us - kKickMax_us};
}

}  // namespace

tl::expected<KickEncoding, KickTimingError> encodePulses(const KickPulses& asked) noexcept {
    const bool both = steps(asked.width1_us) > 0 && steps(asked.width2_us) > 0;
    const std::int64_t offset_us = both ? asked.offset_us : 0;
    const AskedPulse first{1, std::max<std::int64_t>(0, -offset_us), asked.width1_us};
    const AskedPulse second{2, std::max<std::int64_t>(0, offset_us), asked.width2_us};
    for (const AskedPulse& pulse : {first, second}) {
        if (const auto error = whyImpossible(pulse)) return tl::unexpected(*error);
    }

    // Nothing below can leave the range: what fits before rounding half-way values down fits after it.
    const std::int64_t start1 = steps(first.start_us);
    const std::int64_t start2 = steps(second.start_us);
    const std::int64_t width1 = steps(first.width_us);
    const std::int64_t width2 = steps(second.width_us);
    KickEncoding result;
    result.times.flag1 = start1 == 0;
    result.times.flag2 = start2 == 0;
    result.times.t1 = static_cast<std::uint8_t>(start1 + width1);
    result.times.t2 = static_cast<std::uint8_t>(start2 + width2);
    result.times.dt = static_cast<std::uint8_t>(start1 + start2);
    result.sent = personTermsOf(result.times);
    result.snapped = result.sent != asked;
    return result;
}

std::array<Pulse, 2> pulsesOf(const KickTimes& times) noexcept {
    const auto pulse = [&times](bool flag, int end) {
        const int start = flag ? 0 : times.dt;
        if (end <= start) return Pulse{};
        return Pulse{start * kKickStep_us, (end - start) * kKickStep_us};
    };
    return {pulse(times.flag1, times.t1), pulse(times.flag2, times.t2)};
}

KickPulses personTermsOf(const KickTimes& times) noexcept {
    const auto [first, second] = pulsesOf(times);
    const bool both = first.width_us > 0 && second.width_us > 0;
    return {first.width_us, second.width_us, both ? second.start_us - first.start_us : 0};
}

Error toError(const KickTimingError& error) {
    Error result;
    const bool negative = error.reason == KickTimingError::Reason::NegativeWidth;
    result.code = negative ? Errc::OutOfRange : Errc::NoEncoding;
    result.subject = error.solenoid == 1 ? "solenoid 1" : "solenoid 2";
    result.lowest = 0;
    result.highest = kKickMax_us;
    result.got = error.at_us;
    result.detail = negative ? "pulse width in µs" : "falling edge in µs";
    return result;
}

}  // namespace kickstand::thunderbots::wire
