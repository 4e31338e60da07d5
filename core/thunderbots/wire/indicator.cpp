#include "core/thunderbots/wire/indicator.h"

#include <algorithm>

#include "core/thunderbots/wire/layout_robot.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::experiment;
namespace {

constexpr std::size_t kExperimentBytes = 1 + kExperimentPieceBytes;

}  // namespace

WireResult<MessagePayload> encodeIndicator(const IndicatorMessage& message) noexcept {
    MessagePayload payload;
    const auto* const experiment = std::get_if<ExperimentData>(&message);
    if (experiment == nullptr) return payload;
    payload.resize(1);
    FieldWriter<BitOrder::LsbFirst> out(payload.span());
    out.number(at::kOffset, experiment->offset);
    payload.append(experiment->data);
    return out.result(payload);
}

WireResult<IndicatorMessage> decodeIndicator(ByteView payload) noexcept {
    if (payload.empty()) return IndicatorMessage{AutokickFired{}};
    if (payload.size() != kExperimentBytes) {
        return tl::unexpected(WireError{WireFault::BadLength, "length", 0, kExperimentBytes,
                                        static_cast<std::int32_t>(payload.size())});
    }
    FieldReader<BitOrder::LsbFirst> in(payload);
    ExperimentData experiment;
    experiment.offset = in.byte(at::kOffset);
    std::copy(payload.begin() + 1, payload.end(), experiment.data.begin());
    return in.result(IndicatorMessage{experiment});
}

}  // namespace kickstand::thunderbots::wire
