#include "core/thunderbots/wire/message_packet.h"

#include "core/thunderbots/wire/layout_dongle.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::message;

WireResult<MessagePacket> encodeMessagePacket(std::uint8_t robot, Pipe pipe, ByteView payload) noexcept {
    if (robot >= kRobotCount) return tl::unexpected(fault(WireFault::OutOfRange, at::kRobot, robot));
    if (typeOf(pipe) != PipeType::Message || static_cast<std::uint8_t>(pipe) >= kPipeCount) {
        return tl::unexpected(fault(WireFault::UnknownKind, at::kPipe, static_cast<std::int32_t>(pipe)));
    }
    if (const auto error = lengthFault(payload.size(), 0, kMaxMessagePayload)) return tl::unexpected(*error);
    MessagePacket packet;
    packet.append(headerByte(robot, pipe));
    packet.append(payload);
    return packet;
}

WireResult<MessageView> decodeMessagePacket(ByteView packet, Direction direction) noexcept {
    if (const auto error = lengthFault(packet.size(), 1, kMaxMessagePacket)) return tl::unexpected(*error);
    const std::uint8_t number = pipeNumberOfHeader(packet[0]);
    const auto pipe = pipeFromNumber(number);
    if (!pipe || typeOf(*pipe) != PipeType::Message || directionOf(*pipe) != direction) {
        return tl::unexpected(fault(WireFault::UnknownKind, at::kPipe, number));
    }
    return MessageView{robotOfHeader(packet[0]), *pipe, packet.subspan(1)};
}

}  // namespace kickstand::thunderbots::wire
