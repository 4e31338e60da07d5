#include "core/thunderbots/wire/kick.h"

#include "core/thunderbots/wire/layout_drive.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::kick;

WireResult<std::array<std::uint8_t, kKickBytes>> encodeKick(const KickTimes& times) noexcept {
    std::array<std::uint8_t, kKickBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.number(at::kT1, times.t1);
    out.number(at::kMask1, times.flag1);
    out.number(at::kT2, times.t2);
    out.number(at::kMask2, times.flag2);
    out.number(at::kDt, times.dt);
    return out.result(bytes);
}

WireResult<KickTimes> decodeKick(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kKickBytes, kKickBytes)) return tl::unexpected(*error);
    FieldReader<BitOrder::LsbFirst> in(payload);
    KickTimes times;
    times.t1 = in.byte(at::kT1);
    times.flag1 = in.flag(at::kMask1);
    times.t2 = in.byte(at::kT2);
    times.flag2 = in.flag(at::kMask2);
    times.dt = in.byte(at::kDt);
    return in.result(times);
}

}  // namespace kickstand::thunderbots::wire
