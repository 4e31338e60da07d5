#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/thunderbots/wire/readings.h"
#include "tests/unit/sim/sim_host.h"

namespace kickstand::thunderbots::sim::test {
namespace {

TEST(SimActions, EveryActionTakesItsBoundsAndNothingOutside) {
    SimHost host(quietOptions());
    ASSERT_TRUE(host.start(0x0001));
    SimControl& control = host.sim.control();
    const auto actions = control.actions();
    EXPECT_EQ(actions.size(), 16U);
    EXPECT_EQ(control.units(), std::vector<int>{0});
    for (const SimAction& action : actions) {
        const int unit = action.perUnit ? 0 : -1;
        if (action.name != "stall") {
            EXPECT_TRUE(control.perform(action.name, unit, action.lowest)) << action.name;
            EXPECT_TRUE(control.perform(action.name, unit, action.highest)) << action.name;
        }
        for (const double wrong :
             {action.lowest - 1, action.highest + 1, std::nan(""), std::numeric_limits<double>::infinity()}) {
            const auto result = control.perform(action.name, unit, wrong);
            ASSERT_FALSE(result) << action.name << ' ' << wrong;
            EXPECT_EQ(result.error().code, Errc::OutOfRange);
            EXPECT_EQ(result.error().subject, action.name);
            EXPECT_TRUE(result.error().lowest && result.error().highest);
        }
    }
}

TEST(SimActions, WhatWasSetCanBeRead) {
    SimHost host(quietOptions());
    SimControl& control = host.sim.control();
    for (const auto& [name, unit, value] :
         std::vector<std::tuple<const char*, int, double>>{{"ball", 0, 1},
                                                           {"battery", 0, 14.5},
                                                           {"capacitor", 0, 120},
                                                           {"temperature", 0, 60},
                                                           {"dead", 0, 1},
                                                           {"e-stop", -1, 2},
                                                           {"radio-failure", -1, 1},
                                                           {"loss", -1, 0.25},
                                                           {"duplicate", -1, 0.5},
                                                           {"delay", -1, 12},
                                                           {"plugged", -1, 0}}) {
        ASSERT_TRUE(control.perform(name, unit, value)) << name;
        ASSERT_TRUE(control.value(name, unit)) << name;
        EXPECT_NEAR(*control.value(name, unit), value, 0.01) << name;
    }
    EXPECT_FALSE(control.value("experiment", 0));
    EXPECT_FALSE(control.value("ball", 1));
    EXPECT_FALSE(control.value("nonsense", 0));
}

TEST(SimActions, UnknownActionsAndRobotsAreErrors) {
    SimHost host(quietOptions());
    SimControl& control = host.sim.control();
    EXPECT_EQ(control.perform("explode", 0, 1).error().code, Errc::UnknownName);
    const auto missing = control.perform("ball", 7, 1);
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, Errc::BadArgument);
    EXPECT_EQ(missing.error().robot, 7);
    EXPECT_EQ(control.perform("ball", 0, 0.5).error().code, Errc::BadArgument);
    EXPECT_EQ(control.perform("stall", -1, 0x10).error().code, Errc::BadArgument);
}

TEST(SimActions, MinusOneMeansAllRobots) {
    SimHost host(quietOptions(0x0007));
    ASSERT_TRUE(host.perform("battery", -1, 15));
    for (int robot = 0; robot < 3; ++robot)
        EXPECT_EQ(host.sim.control().value("battery", robot), 15);
}

TEST(SimActions, ADeadRobotLeavesAndComesBack) {
    SimHost host(quietOptions(0x0003));
    ASSERT_TRUE(host.start(0x0003));
    host.perform("dead", 0, 1);
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.aliveRobots == 0x0002; }, 5s));
    host.perform("dead", 0, 0);
    EXPECT_TRUE(host.runUntil([&] { return host.sim.deviceReport().status.aliveRobots == 0x0003; }, 5s));
}

TEST(Robots, LookAliveAndDifferentFromTheStart) {
    ThunderbotsSimOptions options;
    FakeScheduler scheduler;
    ThunderbotsSim sim(scheduler, options);
    std::vector<double> batteries;
    for (int robot = 0; robot < 16; ++robot) {
        const RobotReport report = sim.robot(robot);
        EXPECT_GE(report.battery_V, 14.2);
        EXPECT_LE(report.battery_V, 16.4);
        EXPECT_EQ(report.capacitor_V, 0);
        EXPECT_EQ(report.number, robot);
        batteries.push_back(report.battery_V);
    }
    EXPECT_EQ(std::ranges::count_if(batteries, [](double volts) { return volts < wire::kBatteryLow_V; }), 1);
    std::ranges::sort(batteries);
    EXPECT_EQ(std::ranges::adjacent_find(batteries), batteries.end());
}

}  // namespace
}  // namespace kickstand::thunderbots::sim::test
