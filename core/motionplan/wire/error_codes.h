#pragma once

#include <cstdint>
#include <span>

namespace kickstand::motionplan::wire {

/// The command that an error code belongs to; its number is the message's first byte (protocol 4).
enum class MessageKind : std::uint8_t {
    Create,
    Stop,
    Update,
    Execute,
    Status,
    Query,
    Adjust,
    Error,
    Trigger,
};
inline constexpr int kMessageKinds = 9;

/// "create", …: stable names. Any thread.
const char* name(MessageKind kind) noexcept;

// The codes of an Error Message (protocol 4.10).
inline constexpr int kErrorSlotFull = 0;
inline constexpr int kErrorUpdateOtherPlan = 1;
inline constexpr int kErrorUpdateEmptySlot = 2;
inline constexpr int kErrorUpdateIdle = 3;
inline constexpr int kErrorExecuteOtherPlan = 4;
inline constexpr int kErrorExecuteEmptySlot = 5;
inline constexpr int kErrorStopIdle = 6;
inline constexpr int kErrorAdjustIdle = 7;
inline constexpr int kErrorCodes = 8;

/// Why the robot refused.
struct ErrorCode {
    int code = 0;
    MessageKind about = MessageKind::Error;  ///< The command that it refused; Error where that is unknown.
    const char* id = "unknown";              ///< Stable: "slot-full".
    const char* text = "an error code not known here";  ///< English, as a part of a sentence.
};

/// All of them, ascending. Any thread.
std::span<const ErrorCode> errorCodes() noexcept;
/// That of a number; one that does not exist keeps its number and says so. Any thread.
ErrorCode errorCode(int code) noexcept;

}  // namespace kickstand::motionplan::wire
