#include "core/thunderbots/wire/parameters.h"

#include "core/thunderbots/wire/layout_robot.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::parameters;

ParameterBytes encodeParameters(const OperationalParameters& parameters) noexcept {
    ParameterBytes bytes;
    bytes.resize(kDefinedParameterBytes);
    FieldWriter<BitOrder::LsbFirst> out(bytes.span());
    out.put(at::kAlone.flashContents, parameters.flashContents);
    out.put(at::kAlone.channel0, parameters.channel0);
    out.put(at::kAlone.channel1, parameters.channel1);
    out.put(at::kAlone.robotNumber, parameters.robotNumber);
    out.put(at::kAlone.dribblerDuty, parameters.dribblerDuty);
    bytes.append(parameters.tail.view());
    return bytes;
}

WireResult<OperationalParameters> decodeParameters(ByteView block) noexcept {
    if (const auto error = lengthFault(block.size(), kDefinedParameterBytes, kMaxParameterBytes)) {
        return tl::unexpected(*error);
    }
    FieldReader<BitOrder::LsbFirst> in(block);
    OperationalParameters parameters;
    parameters.flashContents = in.byte(at::kAlone.flashContents);
    parameters.channel0 = in.byte(at::kAlone.channel0);
    parameters.channel1 = in.byte(at::kAlone.channel1);
    parameters.robotNumber = in.byte(at::kAlone.robotNumber);
    parameters.dribblerDuty = in.byte(at::kAlone.dribblerDuty);
    parameters.tail.append(block.subspan(kDefinedParameterBytes));
    return in.result(parameters);
}

WireResult<void> checkParameters(const OperationalParameters& parameters) noexcept {
    const auto channelFits = [](std::uint8_t channel) {
        return channel == 0 || (channel >= kLowestChannel && channel <= kHighestChannel);
    };
    const auto refuse = [](const FieldSpec& field, std::int32_t lowest, std::uint8_t got) {
        return tl::unexpected(WireError{WireFault::OutOfRange, field.name, lowest, field.highest, got});
    };
    if (!channelFits(parameters.channel0)) {
        return refuse(at::kAlone.channel0, kLowestChannel, parameters.channel0);
    }
    if (!channelFits(parameters.channel1)) {
        return refuse(at::kAlone.channel1, kLowestChannel, parameters.channel1);
    }
    if (parameters.robotNumber >= kRobotCount) {
        return refuse(at::kAlone.robotNumber, 0, parameters.robotNumber);
    }
    return {};
}

}  // namespace kickstand::thunderbots::wire
