#include "core/motionplan/wire/plan_text.h"

#include <gtest/gtest.h>

namespace kickstand::motionplan::wire {
namespace {

using Movements = std::vector<Movement>;

TEST(PlanText, TheWordsAreThoseOfTheWheels) {
    EXPECT_EQ(parsePlanText("forward 25, back 100, turn right 84, turn left back 90, turn left 3, turn "
                            "right back 30"),
              (Movements{{Wheels::BothForward, 25},
                         {Wheels::BothBack, 100},
                         {Wheels::LeftForward, 84},
                         {Wheels::LeftBack, 90},
                         {Wheels::RightForward, 3},
                         {Wheels::RightBack, 30}}));
}

TEST(PlanText, EveryMovementComesBackThroughItsText) {
    Movements all;
    for (int byte = 0; byte < 256; ++byte) {
        if (const auto movement = decodeMovement(static_cast<std::uint8_t>(byte))) all.push_back(*movement);
    }
    EXPECT_EQ(parsePlanText(toText(all)), all);
}

TEST(PlanText, CaseUnitsLinesAndCommentsAreAPersonsOwnAffair) {
    EXPECT_EQ(parsePlanText("# a square\r\nFORWARD 2 m ; Turn Left Forward 84\u00b0\n\n  back 50cm # home\n"),
              (Movements{{Wheels::BothForward, 200}, {Wheels::RightForward, 84}, {Wheels::BothBack, 50}}));
    EXPECT_EQ(parsePlanText("turn right 9 degrees,turn right 9deg"),
              (Movements{{Wheels::LeftForward, 9}, {Wheels::LeftForward, 9}}));
    EXPECT_EQ(parsePlanText("\xEF\xBB\xBF"
                            "forward 25\r\n"),
              (Movements{{Wheels::BothForward, 25}}));
    EXPECT_EQ(parsePlanText(""), Movements{});
    EXPECT_EQ(parsePlanText("# nothing"), Movements{});
}

TEST(PlanText, AmountsWithoutACodeAreReadAsTheyAre) {
    EXPECT_EQ(parsePlanText("forward 38, turn left 85"),
              (Movements{{Wheels::BothForward, 38}, {Wheels::RightForward, 85}}));
}

TEST(PlanText, UnknownWordsAreNamedWithTheirPlace) {
    const auto error = parsePlanText("forward 25, jump 3").error();
    EXPECT_EQ(error.code, Errc::Malformed);
    EXPECT_EQ(error.detail, "jump");
    EXPECT_EQ(error.got, 12);
    EXPECT_EQ(parsePlanText("turn round 30").error().detail, "round");
    EXPECT_EQ(parsePlanText("forward fast").error().detail, "fast");
    EXPECT_EQ(parsePlanText("forward 25 miles").error().detail, "miles");
    EXPECT_EQ(parsePlanText("forward").error().detail, "the end");
    EXPECT_EQ(parsePlanText("forward -3").error().detail, "-3");
    EXPECT_EQ(parsePlanText("forward 2.5").error().detail, ".5");
    EXPECT_EQ(parsePlanText("turn left 3 m").error().detail, "m");
    EXPECT_EQ(parsePlanText(std::string("\x7f"
                                        "ELF\0\0",
                                        6))
                  .error()
                  .code,
              Errc::Malformed);
}

TEST(PlanText, WhatNoPlanCanHoldIsRefused) {
    EXPECT_EQ(parsePlanText("forward 0").error().code, Errc::OutOfRange);
    EXPECT_EQ(parsePlanText("forward 99999999999999").error().code, Errc::OutOfRange);
    EXPECT_EQ(parsePlanText("forward 2000 m").error().code, Errc::OutOfRange);
    EXPECT_EQ(parsePlanText("forward 99999999").error().got, 99999999);
    EXPECT_EQ(parsePlanText("forward 2000 m").error().got, 200000);
    EXPECT_EQ(parsePlanText("turn left 99999999999999999999").error().detail, "99999999999999999999");
    EXPECT_EQ(parsePlanText("back 9000000000000000000 m").error().detail, "9000000000000000000");
    std::string many;
    for (std::size_t i = 0; i <= kMostPlanSteps; ++i)
        many += "forward 1,";
    EXPECT_EQ(parsePlanText(many).error().code, Errc::OutOfRange);
    EXPECT_EQ(parsePlanText(std::string(kMostPlanTextBytes + 1, ' ')).error().code, Errc::OutOfRange);
}

}  // namespace
}  // namespace kickstand::motionplan::wire
