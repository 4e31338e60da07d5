#pragma once

#include <cstdint>
#include <random>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/hex.h"
#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire::testing {

using Bytes = std::vector<std::uint8_t>;

inline Bytes hex(std::string_view text) {
    return parseHex(text).value();
}

template <class Container>
Bytes bytesOf(const Container& container) {
    return {container.begin(), container.end()};
}
inline Bytes bytesOf(ByteView view) {
    return {view.begin(), view.end()};
}

inline Bytes randomBytes(std::mt19937& random, std::size_t count) {
    Bytes bytes(count);
    for (auto& byte : bytes)
        byte = static_cast<std::uint8_t>(random());
    return bytes;
}

inline int between(std::mt19937& random, int lowest, int highest) {
    return std::uniform_int_distribution<int>(lowest, highest)(random);
}

inline KickTimes randomTimes(std::mt19937& random) {
    const auto step = [&] { return static_cast<std::uint8_t>(between(random, 0, kKickMaxSteps)); };
    return {between(random, 0, 1) == 1, between(random, 0, 1) == 1, step(), step(), step()};
}

inline DriveBlock randomDrive(std::mt19937& random) {
    const auto bit = [&] { return between(random, 0, 1) == 1; };
    DriveBlock block;
    block.run = bit();
    block.charge = bit();
    block.dribble = bit();
    block.autokickArmed = bit();
    block.autokick = randomTimes(random);
    for (auto& wheel : block.wheels)
        wheel = static_cast<std::int16_t>(between(random, -kMaxWheel, kMaxWheel));
    block.testClass = static_cast<std::uint8_t>(between(random, 0, 7));
    block.testTarget = static_cast<std::uint8_t>(between(random, 0, 7));
    return block;
}

/// Expects an error with these facts.
template <class T>
void expectFault(const WireResult<T>& result, WireFault fault, std::string_view field) {
    ASSERT_FALSE(result.has_value()) << "accepted; expected " << name(fault) << ' ' << field;
    EXPECT_STREQ(name(result.error().fault), name(fault));
    EXPECT_EQ(std::string_view(result.error().field), field);
}

}  // namespace kickstand::thunderbots::wire::testing
