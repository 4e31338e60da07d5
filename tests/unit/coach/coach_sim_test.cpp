#include "core/coach/sim/coach_sim.h"

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"

namespace kickstand::coach::sim {
namespace {

Result<CoachSimOptions> read(std::map<std::string, std::string> options) {
    return parseSimOptions({.scheme = "sim", .target = "coach", .options = std::move(options)});
}

TEST(CoachSimOptions, EveryOptionIsRead) {
    const auto options = read({{"address", "0xBC01,0xAF02"},
                               {"fresh", "1"},
                               {"towrps", "3,7"},
                               {"coaches", "4"},
                               {"loss", "0.05"},
                               {"lossy", "7:0.3,3:1"},
                               {"seed", "9"},
                               {"fall", "2.5"}});
    ASSERT_TRUE(options);
    EXPECT_EQ(options->modules, (std::vector<std::uint16_t>{0xBC01, 0xAF02}));
    EXPECT_TRUE(options->fresh);
    EXPECT_EQ(options->boats, (std::vector<wire::Team>{3, 7}));
    EXPECT_EQ(options->rivals, (std::vector<wire::Team>{4}));
    EXPECT_EQ(options->loss, 0.05);
    EXPECT_EQ(options->lossy, (std::map<wire::Team, double>{{3, 1}, {7, 0.3}}));
    EXPECT_EQ(options->seed, 9U);
    EXPECT_EQ(options->fall, std::chrono::milliseconds(2500));
}

TEST(CoachSimOptions, WhatIsWrongIsRefused) {
    const auto code = [](std::map<std::string, std::string> options) {
        const auto result = read(std::move(options));
        return result ? Errc::Io : result.error().code;
    };
    for (const char* lossy : {"", "7", "7:", ":0.3", "7:x", "7:0.3,", "7:0.3,7:0.4", "4:0.3", "7:0.3:1"})
        EXPECT_EQ(code({{"lossy", lossy}}), Errc::BadArgument) << lossy;
    EXPECT_EQ(code({{"lossy", "7:1.1"}}), Errc::OutOfRange);
    EXPECT_EQ(code({{"lossy", "256:0.1"}}), Errc::OutOfRange);
    EXPECT_EQ(code({{"towrps", "1,1"}}), Errc::BadArgument);
    EXPECT_EQ(code({{"address", ""}}), Errc::BadArgument);
    EXPECT_EQ(code({{"boats", "3"}}), Errc::UnknownName);
}

TEST(CoachSim, WhatAHandCanDoIsChecked) {
    FakeScheduler scheduler;
    CoachSim sim(scheduler, {});
    EXPECT_EQ(sim.units(), (std::vector<int>{3, 5, 7}));
    EXPECT_EQ(sim.perform("boat-loss", 4, 0.5).error().code, Errc::BadArgument);
    EXPECT_EQ(sim.perform("boat-loss", 5, 1.5).error().code, Errc::OutOfRange);
    EXPECT_EQ(sim.perform("sink", 5, 1).error().code, Errc::UnknownName);
    ASSERT_TRUE(sim.perform("boat-loss", -1, 0.5)) << "all of them";
    for (const int team : sim.units())
        EXPECT_EQ(sim.value("boat-loss", team), 0.5);
    EXPECT_EQ(sim.value("loss", -1), 0);
}

}  // namespace
}  // namespace kickstand::coach::sim
