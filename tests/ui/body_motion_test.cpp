#include "ui/thunderbots/body_motion.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

using namespace thunderbots;

TEST(BodyMotion, AMetreASecondForwardIsTheReferencesFortyThreeAndThirtySix) {
    EXPECT_EQ(wheelsOf({1, 0, 0}, 1023).wheels, (WheelSpeeds{-43, -36, 36, 43}));
    EXPECT_EQ(wheelsOf({0, 1, 0}, 1023).wheels, (WheelSpeeds{28, -36, -36, 28}));
    EXPECT_EQ(wheelsOf({0, 0, 10}, 1023).wheels, (WheelSpeeds{43, 43, 43, 43}));
    EXPECT_EQ(wheelsOf({}, 1023).wheels, WheelSpeeds{});
}

TEST(BodyMotion, WhatNoWheelCanDoIsSlowedDownAndKeepsItsDirection) {
    const BodyMotion wanted{2, 2, 10};
    const MadeWheels free = wheelsOf(wanted, kFastestWheel);
    EXPECT_EQ(free.scale, 1);
    const MadeWheels made = wheelsOf(wanted, 100);
    ASSERT_LT(made.scale, 1);
    int fastest = 0;
    for (std::size_t i = 0; i < made.wheels.size(); ++i) {
        fastest = std::max(fastest, std::abs(made.wheels.at(i)));
        EXPECT_NEAR(made.wheels.at(i), free.wheels.at(i) * made.scale, 1) << i;
    }
    EXPECT_EQ(fastest, 100);
}

TEST(BodyMotion, NoWheelEverPassesTheLimit) {
    for (const int limit : {0, 1, 7, 100, 1023}) {
        for (double x = -30; x <= 30; x += 7.3) {
            for (double y = -30; y <= 30; y += 6.1) {
                for (double turn = -300; turn <= 300; turn += 43) {
                    for (const int wheel : wheelsOf({x, y, turn}, limit).wheels)
                        ASSERT_LE(std::abs(wheel), limit) << x << ' ' << y << ' ' << turn;
                }
            }
        }
    }
}

TEST(BodyMotion, TheFastestAloneIsNotSlowedDown) {
    for (const int limit : {100, 1023}) {
        const BodyMotion most = fastestMotion(limit);
        EXPECT_EQ(wheelsOf({most.x_m_per_s, 0, 0}, limit).scale, 1);
        EXPECT_EQ(wheelsOf({0, most.y_m_per_s, 0}, limit).scale, 1);
        EXPECT_EQ(wheelsOf({0, 0, most.turn_rad_per_s}, limit).scale, 1);
    }
}

TEST(BodyMotion, TheMotionOfWheelsIsWhatMadeThem) {
    for (const BodyMotion motion : {BodyMotion{1.5, -0.7, 3}, BodyMotion{0, 2, -9}, BodyMotion{-2, 0, 0}}) {
        const BodyMotion back = motionOf(wheelsOf(motion, kFastestWheel).wheels);
        // Whole set points: half a one is 12 mm/s.
        EXPECT_NEAR(back.x_m_per_s, motion.x_m_per_s, 0.012);
        EXPECT_NEAR(back.y_m_per_s, motion.y_m_per_s, 0.02);
        EXPECT_NEAR(back.turn_rad_per_s, motion.turn_rad_per_s, 0.15);
    }
}

TEST(BodyMotion, WheelsThatPullAgainstEachOtherMoveNothing) {
    const BodyMotion motion = motionOf({36, -43, 43, -36});
    EXPECT_LT(std::abs(motion.x_m_per_s), 0.02);
    EXPECT_NEAR(motion.y_m_per_s, 0, 1e-9);
}

TEST(BodyMotion, WhatIsNoNumberStandsStill) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinite = std::numeric_limits<double>::infinity();
    EXPECT_EQ(wheelsOf({nan, 0, 0}, 100).wheels, WheelSpeeds{});
    EXPECT_EQ(wheelsOf({0, infinite, 0}, 100).wheels, WheelSpeeds{});
}

}  // namespace
}  // namespace kickstand::ui
