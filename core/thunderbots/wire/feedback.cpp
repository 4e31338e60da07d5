#include "core/thunderbots/wire/feedback.h"

#include "core/thunderbots/wire/layout_robot.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::feedback;

WireResult<std::array<std::uint8_t, kFeedbackBytes>> encodeFeedback(const FeedbackBlock& block) noexcept {
    std::array<std::uint8_t, kFeedbackBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.number(at::kValid, block.valid);
    out.number(at::kBall, block.ball);
    out.number(at::kBallLoad, block.ballLoad);
    out.number(at::kCharged, block.charged);
    out.number(at::kBattery, block.battery_adc);
    out.number(at::kCapacitor, block.capacitor_adc);
    out.number(at::kThermistor, block.thermistor_adc);
    out.number(at::kLight, block.light_adc);
    return out.result(bytes);
}

WireResult<FeedbackBlock> decodeFeedback(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kFeedbackBytes, kFeedbackBytes)) {
        return tl::unexpected(*error);
    }
    FieldReader<BitOrder::LsbFirst> in(payload);
    FeedbackBlock block;
    block.valid = in.flag(at::kValid);
    block.ball = in.flag(at::kBall);
    block.ballLoad = in.flag(at::kBallLoad);
    block.charged = in.flag(at::kCharged);
    block.battery_adc = in.word(at::kBattery);
    block.capacitor_adc = in.word(at::kCapacitor);
    block.thermistor_adc = in.word(at::kThermistor);
    block.light_adc = in.word(at::kLight);
    return in.result(block);
}

}  // namespace kickstand::thunderbots::wire
