#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// Bytes of a message on the test mode pipe (protocol 4.5).
inline constexpr std::size_t kTestModeBytes = 2;

/// What the four LEDs of a robot show (protocol 4.2).
enum class TestClass : std::uint8_t {
    None = 0,
    Lamp = 1,          ///< All four on.
    Hall = 2,          ///< LED 0-2: the three Hall sensors of motor 1-5 (5 is the dribbler).
    Encoder = 3,       ///< LED 0-1: the two encoder lines of wheel 1-4.
    EncoderCount = 4,  ///< The low four bits of the count of wheel 1-4, LED 0 lowest.
    Charger = 5,       ///< LED 0: charge pulses, LED 1: time-out.
};
inline constexpr std::uint8_t kTestClassCount = 6;

/// The targets that a class has; none where `first` is 0, and then the target is without meaning.
struct TestTargets {
    std::uint8_t first = 0;
    std::uint8_t last = 0;

    constexpr bool any() const noexcept { return first != 0; }
};
/// The targets that a test class has, and what they are (protocol 4.2).
constexpr TestTargets targetsOf(TestClass testClass) noexcept {
    switch (testClass) {
        case TestClass::Hall:
            return {1, 5};
        case TestClass::Encoder:
        case TestClass::EncoderCount:
            return {1, 4};
        default:
            return {};
    }
}

/// A message on the test mode pipe.
struct TestMode {
    TestClass testClass = TestClass::None;
    std::uint8_t target = 0;

    friend constexpr bool operator==(const TestMode&, const TestMode&) = default;
};

/// The class of a number from the wire; none for the undefined ones.
constexpr std::optional<TestClass> testClassFromNumber(std::uint8_t number) noexcept {
    if (number >= kTestClassCount) return std::nullopt;
    return static_cast<TestClass>(number);
}

/// "none", "lamp", "hall", "encoder", "encoder-count", "charger": stable names, for the command line and
/// JSON. Any thread.
const char* name(TestClass testClass) noexcept;
std::optional<TestClass> testClassFromName(std::string_view name) noexcept;

/// The message's bytes (protocol 4.5). Errors: OutOfRange naming class, or target where the class has targets
/// and this is none of them. Any thread.
WireResult<std::array<std::uint8_t, kTestModeBytes>> encodeTestMode(const TestMode& mode) noexcept;

/// Reads a message of the test mode pipe. Errors: TooShort, TooLong; UnknownKind for an undefined class,
/// BadValue for a target that its class does not have. Any thread.
WireResult<TestMode> decodeTestMode(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
