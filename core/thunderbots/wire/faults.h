#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::wire {

/// What a fault code is about.
enum class FaultSubject : std::uint8_t {
    None,
    Motor,  ///< Index 1-5: 1-4 the wheels, 5 the dribbler.
    Radio,  ///< Index 0 or 1.
    Robot,  ///< Index 0-15.
};

/// A run of consecutive codes that say the same thing of one subject after another.
struct FaultFamily {
    std::uint8_t firstCode = 0;
    std::uint8_t count = 1;
    FaultSubject subject = FaultSubject::None;
    std::uint8_t firstIndex = 0;  ///< The index that `firstCode` is about.
    const char* id = "";          ///< Stable and hyphenated: "send-failed".
    const char* text = "";        ///< English: "Message could not be sent". The subject is not part of it.
};

/// One fault code, explained.
struct Fault {
    std::uint8_t code = 0;
    bool known = false;
    FaultSubject subject = FaultSubject::None;
    std::uint8_t index = 0;  ///< Without meaning where there is no subject.
    const char* id = "unknown";
    const char* text = "Unknown fault code";
};

/// The robot's codes, 0-47, in order and without a gap (protocol 7.1). No pipe carries them yet. Any thread.
std::span<const FaultFamily> robotFaultFamilies() noexcept;
inline constexpr std::uint8_t kRobotFaultCount = 48;
/// The codes of the dongle's error queue, 0-111 (protocol 7.2, 3.9). Any thread.
std::span<const FaultFamily> dongleFaultFamilies() noexcept;
inline constexpr std::uint8_t kDongleFaultCount = 112;

/// Explains a code; one that does not exist gives `known` false. Any thread.
Fault robotFault(std::uint8_t code) noexcept;
Fault dongleFault(std::uint8_t code) noexcept;

/// The robot that a message could not be sent to, where a dongle code says that (protocol 7.2). Any thread.
std::optional<std::uint8_t> sendFailedRobot(std::uint8_t dongleCode) noexcept;

/// "Radio 1: Serial framing error", "Robot 7: Message could not be sent", "Debug text overflow", "Unknown
/// fault code 200". Allocates. Any thread.
std::string describe(const Fault& fault);

}  // namespace kickstand::thunderbots::wire
