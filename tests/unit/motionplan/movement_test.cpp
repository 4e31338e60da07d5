#include "core/motionplan/wire/movement.h"

#include <numeric>
#include <set>

#include <gtest/gtest.h>

#include "core/motionplan/wire/denominations.h"

namespace kickstand::motionplan::wire {
namespace {

// The denomination table of the protocol, written out a second time (protocol 5.2).
constexpr std::pair<int, int> kTable[] = {
    {1, 0b00001},   {2, 0b00010},   {3, 0b00011},   {4, 0b00100},   {5, 0b00101},   {6, 0b00110},
    {7, 0b00111},   {8, 0b01000},   {9, 0b01001},   {10, 0b01010},  {15, 0b01011},  {20, 0b01100},
    {25, 0b01101},  {30, 0b01110},  {35, 0b01111},  {40, 0b10000},  {45, 0b10001},  {50, 0b10010},
    {60, 0b10011},  {70, 0b10100},  {80, 0b10101},  {90, 0b10110},  {100, 0b10111}, {200, 0b11000},
    {300, 0b11001}, {400, 0b11010}, {500, 0b11011}, {600, 0b11100}, {700, 0b11101}, {800, 0b11110},
    {900, 0b11111}, {1000, 0b00000}};

TEST(Movement, DistancesAreThoseOfTheTable) {
    ASSERT_EQ(std::size(kTable), kDenominationCount);
    for (const auto& [distance_cm, code] : kTable) {
        EXPECT_EQ(encodeMovement({Wheels::BothForward, distance_cm}), code) << distance_cm;
        EXPECT_EQ(encodeMovement({Wheels::BothBack, distance_cm}), 0b00100000 | code) << distance_cm;
    }
}

TEST(Movement, EveryByteThatMeansSomethingComesBack) {
    int known = 0;
    std::set<std::pair<int, int>> seen;
    for (int byte = 0; byte < 256; ++byte) {
        const auto movement = decodeMovement(static_cast<std::uint8_t>(byte));
        if (!movement) continue;
        ++known;
        EXPECT_EQ(encodeMovement(*movement), byte);
        EXPECT_TRUE(seen.emplace(static_cast<int>(movement->wheels), movement->amount).second);
    }
    // Two straight codes with 32 distances, four turning ones with 30 angles.
    EXPECT_EQ(known, 2 * 32 + 4 * 30);
}

TEST(Movement, WheelCodesSixAndSevenDoNotExist) {
    for (int byte = 0xC0; byte < 256; ++byte)
        EXPECT_FALSE(decodeMovement(static_cast<std::uint8_t>(byte))) << byte;
}

TEST(Movement, TurnsByNothingOrByMoreThanNinetyDegreesDoNotExist) {
    for (const int wheelCode : {2, 3, 4, 5}) {
        EXPECT_FALSE(decodeMovement(static_cast<std::uint8_t>(wheelCode << 5)));
        EXPECT_FALSE(decodeMovement(static_cast<std::uint8_t>(wheelCode << 5 | 31)));
    }
}

TEST(Movement, WhatHasNoCodeIsRefusedWithItsAmount) {
    for (const Movement movement : {Movement{Wheels::BothForward, 38}, Movement{Wheels::BothBack, 0},
                                    Movement{Wheels::LeftBack, 85}, Movement{Wheels::RightForward, 93},
                                    Movement{Wheels::RightBack, 0}, Movement{Wheels::BothForward, -25}}) {
        const auto byte = encodeMovement(movement);
        ASSERT_FALSE(byte);
        EXPECT_EQ(byte.error().code, Errc::NoEncoding);
        EXPECT_EQ(byte.error().got, movement.amount);
        EXPECT_EQ(byte.error().subject, isTurn(movement.wheels) ? "angle" : "distance");
    }
}

TEST(Movement, DirectionsAreThoseOfTheWheels) {
    EXPECT_TRUE(turnsLeft(Wheels::RightForward));
    EXPECT_TRUE(turnsLeft(Wheels::LeftBack));
    EXPECT_FALSE(turnsLeft(Wheels::LeftForward));
    EXPECT_FALSE(turnsLeft(Wheels::RightBack));
    EXPECT_TRUE(isBack(Wheels::BothBack));
    EXPECT_FALSE(isTurn(Wheels::BothBack));
}

int total(const std::vector<Movement>& movements) {
    return std::accumulate(movements.begin(), movements.end(), 0,
                           [](int sum, const Movement& one) { return sum + one.amount; });
}

TEST(ExactSum, IsExactForEveryDistanceAndEveryPartHasACode) {
    for (int distance_cm = 1; distance_cm <= 2500; ++distance_cm) {
        const auto sum = exactSum(Wheels::BothBack, distance_cm, 55);
        ASSERT_TRUE(sum) << distance_cm;
        EXPECT_EQ(total(*sum), distance_cm);
        for (const Movement& part : *sum) {
            EXPECT_EQ(part.wheels, Wheels::BothBack);
            EXPECT_TRUE(encodeMovement(part)) << part.amount;
        }
    }
}

TEST(ExactSum, IsAsShortAsItCanBe) {
    EXPECT_EQ(exactSum(Wheels::BothForward, 25, 55), (std::vector<Movement>{{Wheels::BothForward, 25}}));
    EXPECT_EQ(exactSum(Wheels::BothForward, 38, 55),
              (std::vector<Movement>{{Wheels::BothForward, 35}, {Wheels::BothForward, 3}}));
    EXPECT_EQ(exactSum(Wheels::BothForward, 1000, 55)->size(), 1U);
    EXPECT_EQ(exactSum(Wheels::LeftForward, 180, 55),
              (std::vector<Movement>{{Wheels::LeftForward, 90}, {Wheels::LeftForward, 90}}));
}

TEST(ExactSum, OfWholeLargestOnesAndARestIsAsShortAsAnyOther) {
    // What a table over every amount says, for straight lines and for turns.
    for (const auto& [wheels, reach] :
         {std::pair{Wheels::BothForward, 6000}, std::pair{Wheels::RightBack, 4950}}) {
        std::vector<int> parts;
        for (int byte = 0; byte < 256; ++byte) {
            const auto one = decodeMovement(static_cast<std::uint8_t>(byte));
            if (one && one->wheels == wheels) parts.push_back(one->amount);
        }
        std::vector<int> fewest(static_cast<std::size_t>(reach) + 1, reach + 1);
        fewest[0] = 0;
        for (int amount = 1; amount <= reach; ++amount) {
            auto& count = fewest[static_cast<std::size_t>(amount)];
            for (const int part : parts) {
                if (part <= amount)
                    count = std::min(count, fewest[static_cast<std::size_t>(amount - part)] + 1);
            }
            const auto sum = exactSum(wheels, amount, 1000);
            const int expected = fewest[static_cast<std::size_t>(amount)];
            ASSERT_EQ(sum ? static_cast<int>(sum->size()) : reach + 1, expected) << amount;
            if (sum) {
                ASSERT_EQ(total(*sum), amount);
            }
        }
    }
}

TEST(ExactSum, AnAngleBetweenTheStepsHasNoSumAndItsNeighboursAreNamed) {
    const auto sum = exactSum(Wheels::RightBack, 100, 55);
    ASSERT_FALSE(sum);
    EXPECT_EQ(sum.error().code, Errc::NoEncoding);
    EXPECT_EQ(sum.error().lowest, 99);
    EXPECT_EQ(sum.error().highest, 102);
    EXPECT_EQ(exactSum(Wheels::RightBack, 2, 55).error().lowest, 3);
}

TEST(ExactSum, WhatNoPlanCanReachIsOutOfRange) {
    EXPECT_EQ(exactSum(Wheels::BothForward, 55001, 55).error().code, Errc::OutOfRange);
    EXPECT_EQ(exactSum(Wheels::BothForward, 0, 55).error().code, Errc::OutOfRange);
    EXPECT_EQ(exactSum(Wheels::BothForward, 999, 1).error().code, Errc::OutOfRange);
    EXPECT_TRUE(exactSum(Wheels::BothForward, 55000, 55));
}

}  // namespace
}  // namespace kickstand::motionplan::wire
