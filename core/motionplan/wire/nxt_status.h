#pragma once

#include <cstdint>
#include <span>

namespace kickstand::motionplan::wire {

/// One status byte of an NXT's reply (protocol 2.4).
struct NxtStatus {
    std::uint8_t code = 0;
    const char* id = "unknown";                    ///< Stable and hyphenated: "mailbox-empty".
    const char* text = "a status not known here";  ///< English, as a part of a sentence.
};

inline constexpr std::uint8_t kStatusSuccess = 0x00;
/// It is still busy with something before: to be asked again.
inline constexpr std::uint8_t kStatusPending = 0x20;
/// What MessageRead answers where there is nothing to read.
inline constexpr std::uint8_t kStatusMailboxEmpty = 0x40;
/// No program runs on the robot: nobody fills or empties its mailboxes.
inline constexpr std::uint8_t kStatusNoProgram = 0xEC;
inline constexpr std::uint8_t kStatusBadSize = 0xED;
inline constexpr std::uint8_t kStatusBadMailbox = 0xEE;
inline constexpr std::uint8_t kStatusUnknownCommand = 0xBE;

/// All that the NXT knows, ascending. Any thread.
std::span<const NxtStatus> nxtStatuses() noexcept;
/// That of a code; one that is not known keeps its number and says so. Any thread.
NxtStatus nxtStatus(std::uint8_t code) noexcept;

}  // namespace kickstand::motionplan::wire
