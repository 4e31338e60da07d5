#include <gtest/gtest.h>

#include "tests/session/coach_testing.h"

namespace kickstand::coach::testing {
namespace {

using wire::TeamColor;

TEST(CoachSession, ConnectsReadsTheModuleAndPlaysNothingByItself) {
    CoachBench bench(boats({5}));
    EXPECT_EQ(bench[0].state().link, LinkState::Running);
    ASSERT_TRUE(bench[0].state().radio);
    EXPECT_EQ(bench[0].state().radio->settings.address, 0xBC05);
    EXPECT_FALSE(bench[0].state().role);
    bench.wait(10000);
    EXPECT_EQ(bench.sim.module(0).packetsSent(), 0U);
}

TEST(CoachSession, StartsUpDrivesAndIsAnswered) {
    CoachBench bench(boats({3, 5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    ASSERT_TRUE(bench.within(2000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
    ASSERT_TRUE(bench[0].give(Steer{{6, -2}}));
    EXPECT_TRUE(bench.within(500, [&] { return bench.sim.boat(5)->velocity() == wire::Velocity{6, -2}; }));
    EXPECT_TRUE(bench.within(500, [&] { return bench[0].state().coach.answered == wire::Velocity{6, -2}; }));
    EXPECT_EQ(bench.sim.boat(3)->velocity(), wire::Velocity{});
    EXPECT_GT(bench[0].state().traffic.acknowledged, 1U);
    EXPECT_EQ(bench[0].state().traffic.strayStatuses, 0U);
    EXPECT_TRUE(bench[0].session().active());
    bench.wait(60000);
    EXPECT_EQ(bench[0].state().coach.state, CoachState::Paired);
    EXPECT_GT(bench[0].samples.size(), 200U);
}

TEST(CoachSession, WithoutItsOwnBoatItScansAndPairsWithAnother) {
    CoachBench bench(boats({3, 7}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    ASSERT_TRUE(bench.within(6000, [&] { return bench[0].state().coach.state == CoachState::NotPaired; }));
    bench.wait(600);
    ASSERT_EQ(bench[0].state().coach.boats.size(), 2U);
    EXPECT_EQ(bench[0].give(Pair{5}).error().code, Errc::RobotNotAlive);
    ASSERT_TRUE(bench[0].give(Pair{7}));
    EXPECT_TRUE(bench.within(1000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
    EXPECT_EQ(bench.sim.boat(7)->coach(), 5);
    ASSERT_TRUE(bench[0].give(FreeDigital{}));
    ASSERT_TRUE(bench[0].give(FreeAnalog{-42}));
    bench.wait(1000);
    EXPECT_EQ(bench.sim.boat(7)->freeDigital(), 1U);
    EXPECT_EQ(bench.sim.boat(7)->freeAnalog(), -42);
    ASSERT_TRUE(bench[0].give(Jettison{}));
    EXPECT_EQ(bench[0].state().coach.state, CoachState::NotPaired);
    EXPECT_TRUE(bench.within(500, [&] { return !bench.sim.boat(7)->coach(); }));
}

TEST(CoachSession, ASimulatedCrewMutiniesAndIsQuelledByTheSeries) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(SetSeries{{"up", "down"}}));
    EXPECT_EQ(bench[0].give(SetSeries{{}}).error().code, Errc::BadArgument);
    EXPECT_EQ(bench[0].give(SetSeries{{""}}).error().code, Errc::BadArgument);
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ASSERT_TRUE(bench.sim.perform("morale", 5, -10));
    ASSERT_TRUE(bench.within(1000, [&] { return bench[0].state().coach.mutiny.has_value(); }));
    ASSERT_TRUE(bench[0].give(Act{0}));
    ASSERT_TRUE(bench[0].give(Act{1}));
    EXPECT_TRUE(bench.within(1500, [&] { return bench[0].state().coach.morale == -5; }));
    EXPECT_FALSE(bench[0].state().coach.mutiny);
    EXPECT_FALSE(bench.sim.boat(5)->mutinies());
    bench.wait(4000);
    EXPECT_EQ(bench[0].state().coach.state, CoachState::Paired);
}

TEST(CoachSession, EndingTheRoleStopsTheBoat) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    ASSERT_TRUE(bench.within(6000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
    ASSERT_TRUE(bench[0].give(Steer{wire::Velocity{7, 0}, false}));
    ASSERT_TRUE(bench.within(1000, [&] { return !bench.sim.boat(5)->velocity().isZero(); }));
    ASSERT_TRUE(bench[0].give(EndRole{}));
    EXPECT_EQ(bench[0].state().coach.state, CoachState::Off);
    EXPECT_TRUE(bench.within(400, [&] { return bench.sim.boat(5)->velocity().isZero(); }));
}

TEST(CoachSession, RolesNeedTheRightRadio) {
    CoachBench bench(boats({5}));
    EXPECT_EQ(bench[0].give(StartCoach{6, TeamColor::Red}).error().code, Errc::RadioNotSet);
    EXPECT_EQ(bench[0].give(StartTowrp{5}).error().code, Errc::RadioNotSet);
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    EXPECT_EQ(bench[0].give(StartCoach{5, TeamColor::Red}).error().code, Errc::RoleRunning);
    EXPECT_EQ(bench[0].give(FindRadio{}).error().code, Errc::RoleRunning);
    EXPECT_EQ(bench[0].give(SetMorale{3}).error().code, Errc::NotPaired);
    ASSERT_TRUE(bench[0].give(EndRole{}));
    EXPECT_TRUE(bench[0].give(FindRadio{}));
}

TEST(CoachSession, AFreshModuleIsMadeReadyHere) {
    sim::CoachSimOptions options = boats({5});
    options.fresh = true;
    CoachBench bench(options);
    EXPECT_EQ(bench[0].state().link, LinkState::NoModule);
    EXPECT_EQ(bench[0].give(StartCoach{5, TeamColor::Red}).error().code, Errc::RadioNotReady);
    EXPECT_EQ(bench[0].give(ApplyRadio{}).error().code, Errc::RadioNotReady);
    ASSERT_TRUE(bench[0].give(FindRadio{}));
    ASSERT_TRUE(bench[0].state().radio);
    EXPECT_EQ(bench[0].state().radio->settings.mode, ModuleMode::Transparent);
    const RadioSettings wanted = presetFor(wire::Role::Coach, 5, bench[0].state().radio->settings);
    ASSERT_TRUE(bench[0].give(ApplyRadio{wanted}));
    EXPECT_EQ(bench[0].state().link, LinkState::Running);
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    EXPECT_TRUE(bench.within(2000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
}

// STOP.

TEST(CoachSession, StopIsZeroInTheNextSlotAndHeldUntilRearmed) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ASSERT_TRUE(bench[0].give(Steer{{7, 0}}));
    ASSERT_TRUE(bench.within(300, [&] { return bench.sim.boat(5)->velocity().forward == 7; }));
    bench[0].press();
    EXPECT_TRUE(bench.within(250, [&] { return bench.sim.boat(5)->velocity().isZero(); }));
    EXPECT_EQ(bench[0].give(Steer{{1, 0}}).error().code, Errc::StopLatched);
    bench.wait(10000);
    EXPECT_EQ(bench[0].state().coach.state, CoachState::Paired);
    EXPECT_TRUE(bench.sim.boat(5)->velocity().isZero());
    bench[0].stop().rearm();
    bench.wait(20);
    EXPECT_EQ(bench[0].give(Steer{{1, 0}, true}).error().code, Errc::MustPassZero);
    EXPECT_TRUE(bench[0].give(Steer{{0, 0}, true}));
    EXPECT_TRUE(bench[0].give(Steer{{1, 0}, true}));
    EXPECT_TRUE(bench.within(600, [&] { return bench.sim.boat(5)->velocity().forward == 1; }));
}

TEST(CoachSession, AStaleHeartbeatStops) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    bench[0].heartbeat = false;
    bench.wait(100);
    EXPECT_FALSE(bench[0].stop().isSet()) << "nothing moved";
    bench[0].heartbeat = true;
    bench.wait(100);
    ASSERT_TRUE(bench[0].give(Steer{{7, 0}}));
    bench[0].heartbeat = false;
    bench.wait(300);
    EXPECT_EQ(bench[0].stop().reason(), StopReason::HeartbeatStale);
    EXPECT_TRUE(bench.sim.boat(5)->velocity().isZero());
}

TEST(CoachSession, ALostLinkEndsTheRoleAndTheBoatStopsByItself) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ASSERT_TRUE(bench[0].give(Steer{{7, 0}}));
    ASSERT_TRUE(bench.within(300, [&] { return bench.sim.boat(5)->velocity().forward == 7; }));
    ASSERT_TRUE(bench.sim.perform("plugged", -1, 0));
    bench.wait(50);
    EXPECT_EQ(bench[0].state().link, LinkState::Searching);
    EXPECT_FALSE(bench[0].state().role);
    EXPECT_EQ(bench[0].stop().reason(), StopReason::LinkLost);
    EXPECT_EQ(bench[0].count(EventKind::LinkLost), 1U);
    bench.wait(1000);
    EXPECT_TRUE(bench.sim.boat(5)->velocity().isZero()) << "its own timer";
    EXPECT_EQ(bench[0].give(Steer{{1, 0}}).error().code, Errc::NotConnected);
    ASSERT_TRUE(bench.sim.perform("plugged", -1, 1));
    EXPECT_TRUE(bench.within(5000, [&] { return bench[0].state().link == LinkState::Running; }));
    EXPECT_FALSE(bench[0].state().role) << "nothing is taken up again";
}

TEST(CoachSession, ClosingSaysZeroFirst) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ASSERT_TRUE(bench[0].give(Steer{{7, 0}}));
    ASSERT_TRUE(bench.within(300, [&] { return bench.sim.boat(5)->velocity().forward == 7; }));
    bool closed = false;
    bench[0].session().shutdown([&] { closed = true; });
    EXPECT_TRUE(bench.within(1000, [&] { return closed; }));
    bench.wait(30);
    EXPECT_TRUE(bench.sim.boat(5)->velocity().isZero());
    EXPECT_EQ(bench[0].give(Steer{{1, 0}}).error().code, Errc::NotConnected);
}

TEST(CoachSession, AModuleThatStartsAnewIsToldAndTheGameGoesOn) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ASSERT_TRUE(bench.sim.perform("restart", -1, 1));
    bench.wait(1000);
    EXPECT_EQ(bench[0].count(EventKind::ModuleReset), 1U);
    EXPECT_EQ(bench[0].state().coach.state, CoachState::Paired);
}

TEST(CoachSession, BadBytesOnTheLineAreCountedAndLivedThrough) {
    CoachBench bench(boats({5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    bench.wait(1000);
    ByteFaultOptions faults;
    faults.damage = 0.01;
    faults.lose = 0.005;
    faults.insert = 0.005;
    bench[0].link().setFaults(faults);
    bench.wait(600000);
    EXPECT_GT(bench[0].state().traffic.frames.damaged(), 10U);
    EXPECT_GT(bench[0].state().traffic.frames.frames, 1000U);
    bench[0].link().setFaults({});
    if (bench[0].state().coach.state == CoachState::Paired) {
        bench.wait(3000);
        EXPECT_EQ(bench[0].state().coach.state, CoachState::Paired);
    }
}

TEST(CoachSession, ARivalTakesThisProgramsBoat) {
    sim::CoachSimOptions options = boats({});
    options.modules = {0xAF05};
    options.rivals = {4};
    CoachBench bench(options);
    ASSERT_TRUE(bench[0].give(StartTowrp{5}));
    ASSERT_TRUE(bench.within(3000, [&] { return bench[0].state().towrp.state == TowrpState::Paired; }));
    EXPECT_EQ(bench[0].state().towrp.coach, 4);
    EXPECT_TRUE(bench.within(3000, [&] { return !bench[0].state().towrp.velocity.isZero(); }));
    ASSERT_TRUE(bench[0].give(SetMorale{-10}));
    EXPECT_EQ(bench[0].state().towrp.state, TowrpState::Mutiny);
    EXPECT_TRUE(bench.within(3000, [&] { return bench[0].state().towrp.morale == -5; }));
}

// Both sides are this program's.

/// The whole game, each step within the five seconds that the protocol allows. False where one was not.
::testing::AssertionResult playsThrough(CoachBench& bench) {
    SessionBench& console = bench[0];
    SessionBench& boat = bench[1];
    const auto step = [&](const char* what, int ms, const std::function<bool()>& done) {
        return bench.within(ms, done) ? std::string() : std::string(what);
    };
    const auto bothPaired = [&] {
        return console.state().coach.state == CoachState::Paired &&
               boat.state().towrp.state == TowrpState::Paired;
    };
    const auto bothFree = [&] {
        return console.state().coach.state == CoachState::NotPaired &&
               boat.state().towrp.state == TowrpState::NotPaired;
    };
    std::string failed;
    const auto run = [&](const char* what, int ms, const std::function<bool()>& done) {
        if (failed.empty()) failed = step(what, ms, done);
    };
    static_cast<void>(boat.give(StartTowrp{5}));
    static_cast<void>(console.give(StartCoach{5, TeamColor::Blue}));
    run("startup", 5000, bothPaired);
    static_cast<void>(console.give(Steer{{5, -5}}));
    run("velocity", 1000, [&] { return boat.state().towrp.velocity == wire::Velocity{5, -5}; });
    run("morale", 1000, [&] { return console.state().coach.answered == wire::Velocity{5, -5}; });
    console.press();
    run("stop", 500, [&] { return boat.state().towrp.velocity.isZero(); });
    run("stop answered", 1000, [&] { return console.state().coach.answered == wire::Velocity{}; });
    console.stop().rearm();
    bench.wait(20);
    static_cast<void>(console.give(Steer{{1, 0}}));
    run("velocity after stop", 1000, [&] { return boat.state().towrp.velocity == wire::Velocity{1, 0}; });
    static_cast<void>(boat.give(SetMorale{-10}));
    run("mutiny", 1000, [&] { return console.state().coach.mutiny.has_value(); });
    static_cast<void>(console.give(Suppress{}));
    run("suppress", 2000, [&] { return boat.state().towrp.morale == -5; });
    run("quelled", 2000, [&] { return !console.state().coach.mutiny; });
    static_cast<void>(console.give(Jettison{}));
    run("jettison", 5200, bothFree);
    run("available", 2000, [&] { return console.give(Pair{5}).has_value(); });
    run("assertion", 3000, bothPaired);
    if (!failed.empty()) return ::testing::AssertionFailure() << failed;
    return ::testing::AssertionSuccess();
}

TEST(CoachSession, EveryPacketOfTheGameMayBeLostOnce) {
    std::size_t packets = 0;
    {
        CoachBench bench(twoSides());
        bench.sim.medium().setWitness([&](const sim::AirPacket&) { ++packets; });
        ASSERT_TRUE(playsThrough(bench));
    }
    ASSERT_GE(packets, 12U);
    for (std::size_t lost = 0; lost < packets; ++lost) {
        CoachBench bench(twoSides());
        std::size_t seen = 0;
        bench.sim.medium().setThief([&](const sim::AirPacket&) { return seen++ == lost; });
        EXPECT_TRUE(playsThrough(bench)) << "without packet " << lost;
        EXPECT_GT(seen, lost);
    }
}

TEST(CoachSession, AZeroVelocityOfStopThatIsLostIsSaidAgainBeforeTheBoatsOwnTimer) {
    CoachBench bench(twoSides());
    ASSERT_TRUE(bench[1].give(StartTowrp{5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    ASSERT_TRUE(bench.within(5000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
    ASSERT_TRUE(bench[0].give(Steer{{7, 0}}));
    ASSERT_TRUE(bench.within(1000, [&] { return bench[1].state().towrp.velocity.forward == 7; }));
    std::size_t zeros = 0;
    bench.sim.medium().setThief([&](const sim::AirPacket& packet) {
        const auto message = wire::decodeMessage(packet.payload);
        return message == wire::Message{wire::Opcode::Velocity, 0} && zeros++ == 0;
    });
    bench[0].press();
    EXPECT_TRUE(bench.within(500, [&] { return bench[1].state().towrp.velocity.isZero(); }));
    EXPECT_EQ(zeros, 2U);
    EXPECT_FALSE(bench[1].state().towrp.stoppedItself);
}

TEST(CoachSession, OnlyTheTeamWithABadRadioLosesPackets) {
    sim::CoachSimOptions options = boats({5, 7});
    options.lossy = {{7, 0.3}};
    CoachBench bench(options);
    const auto lostWith = [&](Team team) {
        EXPECT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
        EXPECT_TRUE(bench.within(6000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
        if (team != 5) {
            EXPECT_TRUE(bench[0].give(Jettison{}));
            EXPECT_TRUE(bench.within(20000, [&] {
                if (bench[0].state().coach.state == CoachState::NotPaired)
                    static_cast<void>(bench[0].give(Pair{team}));
                return bench[0].state().coach.state == CoachState::Paired;
            }));
        }
        const TrafficCounters before = bench[0].state().traffic;
        bench.wait(60000);
        const TrafficCounters after = bench[0].state().traffic;
        EXPECT_TRUE(bench[0].give(EndRole{}));
        bench.wait(6000);
        EXPECT_GT(after.acknowledged - before.acknowledged, 100U);
        return after.failed - before.failed;
    };
    EXPECT_EQ(lostWith(5), 0U);
    EXPECT_GT(lostWith(7), 20U);
    EXPECT_EQ(bench.sim.value("boat-loss", 7), 0.3);
    ASSERT_TRUE(bench.sim.perform("boat-loss", 7, 0));
    EXPECT_EQ(lostWith(7), 0U);
}

TEST(CoachSession, AFifthOfThePacketsMayBeLostForAnHour) {
    sim::CoachSimOptions options = twoSides();
    options.loss = 0.2;
    CoachBench bench(options);
    std::vector<TimePoint> times[2];
    bench.sim.medium().setWitness([&](const sim::AirPacket& packet) {
        times[packet.source == 0xBC05 ? 0 : 1].push_back(bench.scheduler.now());
    });
    ASSERT_TRUE(bench[1].give(StartTowrp{5}));
    ASSERT_TRUE(bench[0].give(StartCoach{5, TeamColor::Red}));
    ASSERT_TRUE(bench.within(5000, [&] { return bench[0].state().coach.state == CoachState::Paired; }));
    int quelled = 0;
    for (int minute = 0; minute < 60; ++minute) {
        ASSERT_TRUE(bench[0].give(Steer{{1 + minute % 7, 0}}));
        EXPECT_TRUE(
            bench.within(2000, [&] { return bench[1].state().towrp.velocity.forward == 1 + minute % 7; }));
        static_cast<void>(bench[1].give(SetMorale{-10}));
        if (bench.within(2000, [&] { return bench[0].state().coach.mutiny.has_value(); }))
            static_cast<void>(bench[0].give(Suppress{}));
        if (bench.within(1500, [&] { return bench[1].state().towrp.morale == -5; })) ++quelled;
        bench.wait(55000);
        ASSERT_EQ(bench[0].state().coach.state, CoachState::Paired) << minute;
    }
    EXPECT_EQ(quelled, 60);
    EXPECT_GT(bench[0].state().traffic.failed, 500U);
    for (const auto& side : times) {
        ASSERT_GT(side.size(), 5000U);
        for (std::size_t i = 1; i < side.size(); ++i)
            ASSERT_GE(side[i] - side[i - 1], std::chrono::milliseconds(199));
    }
}

}  // namespace
}  // namespace kickstand::coach::testing
