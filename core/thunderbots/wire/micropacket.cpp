#include "core/thunderbots/wire/micropacket.h"

#include "core/thunderbots/wire/layout_dongle.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::micropacket;
namespace {

constexpr Pipe pipeOf(Direction direction) noexcept {
    return direction == Direction::Out ? Pipe::Drive : Pipe::Feedback;
}
constexpr std::size_t lengthOf(Direction direction) noexcept {
    return direction == Direction::Out ? kDriveMicropacketBytes : kFeedbackMicropacketBytes;
}

}  // namespace

WireResult<Micropacket> MicropacketReader::giveUp(WireError error) noexcept {
    droppedBytes_ = rest_.size();
    rest_ = {};
    return tl::unexpected(error);
}

std::optional<WireResult<Micropacket>> MicropacketReader::next() noexcept {
    if (rest_.empty()) return std::nullopt;
    const auto available = static_cast<std::int32_t>(rest_.size());
    if (first_ && rest_.size() > kMaxStatePacket) {
        return giveUp({WireFault::TooLong, "length", 0, kMaxStatePacket, available});
    }
    first_ = false;
    const auto expected = static_cast<std::int32_t>(lengthOf(direction_));
    if (rest_.size() < kMicropacketHeaderBytes) {
        return giveUp({WireFault::TooShort, at::kLength.name, expected, expected, available});
    }
    const std::uint8_t header = rest_[1];
    const auto pipe = static_cast<std::int32_t>(pipeOf(direction_));
    if (pipeNumberOfHeader(header) != pipe) {
        return giveUp({WireFault::UnknownKind, at::kPipe.name, pipe, pipe, pipeNumberOfHeader(header)});
    }
    const std::uint8_t length = rest_[0];
    if (length != expected || length > rest_.size()) {
        return giveUp({WireFault::BadLength, at::kLength.name, expected, expected,
                       length != expected ? length : available});
    }
    const Micropacket micropacket{robotOfHeader(header),
                                  rest_.subspan(kMicropacketHeaderBytes, length - kMicropacketHeaderBytes)};
    rest_ = rest_.subspan(length);
    return micropacket;
}

WireResult<void> StatePacketBuilder::append(std::uint8_t robot, Pipe pipe, ByteView payload) noexcept {
    if (robot >= kRobotCount) return tl::unexpected(fault(WireFault::OutOfRange, at::kRobot, robot));
    const std::size_t length = kMicropacketHeaderBytes + payload.size();
    if (full() || packet_.size() + length > packet_.maxSize()) {
        return tl::unexpected(WireError{WireFault::TooLong, "length", 0, kMaxStatePacket,
                                        static_cast<std::int32_t>(packet_.size() + length)});
    }
    packet_.append(static_cast<std::uint8_t>(length));
    packet_.append(headerByte(robot, pipe));
    packet_.append(payload);
    ++count_;
    return {};
}

WireResult<void> StatePacketBuilder::add(std::uint8_t robot, const DriveBlock& block) noexcept {
    const auto bytes = encodeDrive(block);
    if (!bytes) return tl::unexpected(bytes.error());
    return addDrive(robot, *bytes);
}

WireResult<void> StatePacketBuilder::add(std::uint8_t robot, const FeedbackBlock& block) noexcept {
    const auto bytes = encodeFeedback(block);
    if (!bytes) return tl::unexpected(bytes.error());
    return addFeedback(robot, *bytes);
}

WireResult<void> StatePacketBuilder::addDrive(std::uint8_t robot,
                                              const std::array<std::uint8_t, kDriveBytes>& block) noexcept {
    return append(robot, Pipe::Drive, block);
}

WireResult<void> StatePacketBuilder::addFeedback(
    std::uint8_t robot, const std::array<std::uint8_t, kFeedbackBytes>& block) noexcept {
    return append(robot, Pipe::Feedback, block);
}

void StatePacketBuilder::clear() noexcept {
    packet_.clear();
    count_ = 0;
}

}  // namespace kickstand::thunderbots::wire
