#include "core/motionplan/plan.h"

#include <gtest/gtest.h>

#include "core/motionplan/path.h"

namespace kickstand::motionplan {
namespace {

constexpr double kTrack_cm = 11;
constexpr double kNear = 1e-9;

Pose endOf(const std::vector<Movement>& movements) {
    return corners(movements, kTrack_cm).back();
}

TEST(PlanBytes, AreThoseOfEachMovementAndComeBack) {
    const std::vector<Movement> sample{{Wheels::BothForward, 25},
                                       {Wheels::LeftForward, 84},
                                       {Wheels::BothForward, 50},
                                       {Wheels::LeftBack, 90},
                                       {Wheels::BothBack, 100}};
    const auto bytes = planBytes(sample, PlanUse::Slot);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(*bytes, (std::vector<std::uint8_t>{0x0D, 0x5C, 0x12, 0x7E, 0x37}));
    EXPECT_EQ(movementsOf(*bytes), sample);
}

TEST(PlanBytes, AreLimitedByTheUse) {
    const std::vector<Movement> long_(56, Movement{Wheels::BothForward, 1});
    EXPECT_EQ(planBytes(long_, PlanUse::Slot).error().code, Errc::OutOfRange);
    EXPECT_EQ(planBytes(long_, PlanUse::Trigger)->size(), 56U);
    EXPECT_EQ(planBytes({}, PlanUse::Trigger).error().code, Errc::OutOfRange);
}

TEST(SentPlan, NamesTheZeroBytesOfItsHeaderAndItsSteps) {
    const std::vector<Movement> plan{{Wheels::BothForward, 25}, {Wheels::BothForward, 1000}};
    const auto create = sentPlan(false, 9, 0, plan);
    ASSERT_TRUE(create);
    EXPECT_EQ(create->bytes, (std::vector<std::uint8_t>{0x00, 0x09, 0x00, 0x0D, 0x00}));
    EXPECT_EQ(create->zeros, (std::vector<std::size_t>{0, 2, 4}));
    const auto update = sentPlan(true, 9, 4, {plan.data(), 1});
    ASSERT_TRUE(update);
    EXPECT_EQ(update->bytes, (std::vector<std::uint8_t>{0x02, 0x09, 0x04, 0x0D}));
    EXPECT_TRUE(update->zeros.empty());
    EXPECT_EQ(sentPlan(false, 0, 4, plan).error().code, Errc::OutOfRange);
    EXPECT_EQ(sentPlan(false, 9, 4, {}).error().code, Errc::OutOfRange);
}

TEST(Alternative, NamesTheExactSumOrTheNeighbours) {
    EXPECT_EQ(alternativeTo({Wheels::BothForward, 25}), "");
    EXPECT_EQ(alternativeTo({Wheels::BothForward, 38}), "forward 35, forward 3");
    EXPECT_EQ(alternativeTo({Wheels::RightForward, 120}), "turn left 90, turn left 30");
    EXPECT_EQ(alternativeTo({Wheels::RightForward, 85}), "turn left 84 or turn left 87");
    EXPECT_EQ(alternativeTo({Wheels::RightForward, 1}), "turn left 3");
    // A neighbour past the largest angle is a sum itself, and one that no plan holds is none.
    EXPECT_EQ(alternativeTo({Wheels::RightForward, 91}), "turn left 90 or turn left 90, turn left 3");
    EXPECT_EQ(alternativeTo({Wheels::RightForward, 181}),
              "turn left 90, turn left 90 or turn left 90, turn left 90, turn left 3");
    EXPECT_EQ(alternativeTo({Wheels::BothForward, 54999}), "");
    EXPECT_EQ(alternativeTo({Wheels::BothForward, 100000}), "");
}

TEST(Path, GoesStraightAlongTheHeading) {
    EXPECT_NEAR(endOf({{Wheels::BothForward, 50}}).y_cm, 50, kNear);
    EXPECT_NEAR(endOf({{Wheels::BothForward, 50}, {Wheels::BothBack, 80}}).y_cm, -30, kNear);
    EXPECT_NEAR(along({}, {Wheels::BothForward, 50}, 0.5, kTrack_cm).y_cm, 25, kNear);
}

TEST(Path, TurnsAboutTheWheelThatStands) {
    // The right wheel goes forward about the left one, which stands at -5.5: the middle comes to stand ahead
    // of it.
    const Pose left = endOf({{Wheels::RightForward, 90}});
    EXPECT_NEAR(left.x_cm, -5.5, kNear);
    EXPECT_NEAR(left.y_cm, 5.5, kNear);
    EXPECT_NEAR(left.heading_deg, 90, kNear);
    const Pose right = endOf({{Wheels::LeftForward, 90}});
    EXPECT_NEAR(right.x_cm, 5.5, kNear);
    EXPECT_NEAR(right.y_cm, 5.5, kNear);
    EXPECT_NEAR(right.heading_deg, -90, kNear);
    // Backward about the right wheel, which stands: the nose goes to the left, the middle back.
    const Pose leftBack = endOf({{Wheels::LeftBack, 90}});
    EXPECT_NEAR(leftBack.x_cm, 5.5, kNear);
    EXPECT_NEAR(leftBack.y_cm, -5.5, kNear);
    EXPECT_NEAR(leftBack.heading_deg, 90, kNear);
    const Pose rightBack = endOf({{Wheels::RightBack, 90}});
    EXPECT_NEAR(rightBack.x_cm, -5.5, kNear);
    EXPECT_NEAR(rightBack.y_cm, -5.5, kNear);
    EXPECT_NEAR(rightBack.heading_deg, -90, kNear);
}

TEST(Path, WhatIsDoneAndUndoneEndsWhereItBegan) {
    for (const auto& [there, back] : {std::pair{Wheels::RightForward, Wheels::RightBack},
                                      std::pair{Wheels::LeftForward, Wheels::LeftBack},
                                      std::pair{Wheels::BothForward, Wheels::BothBack}}) {
        const Pose end = endOf({{there, 60}, {back, 60}});
        EXPECT_NEAR(end.x_cm, 0, kNear);
        EXPECT_NEAR(end.y_cm, 0, kNear);
        EXPECT_NEAR(end.heading_deg, 0, kNear);
    }
}

TEST(Path, FourSidesAndFourRightAnglesCloseTheSquare) {
    std::vector<Movement> square;
    for (int side = 0; side < 4; ++side) {
        square.push_back({Wheels::BothForward, 50});
        square.push_back({Wheels::RightForward, 90});
    }
    const Pose end = endOf(square);
    EXPECT_NEAR(end.x_cm, 0, kNear);
    EXPECT_NEAR(end.y_cm, 0, kNear);
    EXPECT_EQ(corners(square, kTrack_cm).size(), 9U);
}

}  // namespace
}  // namespace kickstand::motionplan
