#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kickstand::thunderbots::wire {

/// Robots of one universe, numbered 0-15 (protocol 1).
inline constexpr std::uint8_t kRobotCount = 16;
/// Pipes that have a meaning; the other numbers up to 15 are reserved (protocol 4).
inline constexpr std::uint8_t kPipeCount = 7;

/// The pipes between host and robot, by number (protocol 4).
enum class Pipe : std::uint8_t {
    Drive = 0,             ///< State transport, out (4.1).
    Feedback = 1,          ///< State transport, in (4.3).
    Kick = 2,              ///< Message, out (4.4).
    FirmwareRequest = 3,   ///< Message, out (4.7).
    FirmwareResponse = 4,  ///< Message, in (4.7).
    TestMode = 5,          ///< Message, out (4.5).
    Indicator = 6,         ///< Message, in: autokick indicator or experiment data (4.6).
};

/// Out is from host to robot, in from robot to host (protocol 1).
enum class Direction : std::uint8_t { Out, In };

/// How a pipe carries its data (protocol 1).
enum class PipeType : std::uint8_t {
    StateTransport,  ///< The newest value replaces all older ones; loss is tolerable.
    Message,         ///< Delivered once, in order.
};

/// Which way a pipe goes (protocol 1).
constexpr Direction directionOf(Pipe pipe) noexcept {
    return pipe == Pipe::Feedback || pipe == Pipe::FirmwareResponse || pipe == Pipe::Indicator
               ? Direction::In
               : Direction::Out;
}
/// Whether a pipe keeps the latest state or a queue of messages (protocol 1).
constexpr PipeType typeOf(Pipe pipe) noexcept {
    return pipe == Pipe::Drive || pipe == Pipe::Feedback ? PipeType::StateTransport : PipeType::Message;
}

/// The pipe of a number from the wire; none for the reserved numbers.
constexpr std::optional<Pipe> pipeFromNumber(std::uint8_t number) noexcept {
    if (number >= kPipeCount) return std::nullopt;
    return static_cast<Pipe>(number);
}

/// The header byte of a micropacket and of a message packet: robot in the high nibble, pipe in the low one
/// (protocol 3.6, 3.7). `robot` is 0-15.
constexpr std::uint8_t headerByte(std::uint8_t robot, Pipe pipe) noexcept {
    return static_cast<std::uint8_t>(robot << 4 | static_cast<std::uint8_t>(pipe));
}
/// The robot in a micropacket's or message's header (protocol 3.6, 3.7).
constexpr std::uint8_t robotOfHeader(std::uint8_t header) noexcept {
    return header >> 4;
}
/// The pipe's number in it, which may be none of the pipes.
constexpr std::uint8_t pipeNumberOfHeader(std::uint8_t header) noexcept {
    return header & 0x0F;
}

/// "drive", "feedback", "kick", …: stable names for logs and JSON. Any thread.
const char* name(Pipe pipe) noexcept;

}  // namespace kickstand::thunderbots::wire
