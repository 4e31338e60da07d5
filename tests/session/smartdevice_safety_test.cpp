#include "tests/session/smartdevice_rig.h"

namespace kickstand::smartdevice::testing {
namespace {

class SmartDeviceSafety : public SmartDeviceRig {};

TEST_F(SmartDeviceSafety, StopWritesZeroDisablesAndBlocksUntilRearmed) {
    start("PolarBear,ServoControl");
    const int bear = numberOf(0);
    const int servo = numberOf(1);
    ASSERT_TRUE(write(servo, "servo0", 0.5));
    ASSERT_TRUE(write(bear, "duty_cycle", 0.8));
    EXPECT_TRUE(session_->active());
    run(1s);
    EXPECT_GT(*wire::toNumber(sim_->board(0).value(11)), 1000);
    pressStop();
    run(20ms);
    EXPECT_FALSE(session_->active());
    EXPECT_EQ(parameter(bear, "duty_cycle").written, wire::Value(0.0F));
    EXPECT_FALSE(parameter(servo, "servo0").written);
    EXPECT_EQ(sim_->board(0).value(0), wire::Value(0.0F));
    EXPECT_TRUE(sim_->board(0).report().disabled);
    EXPECT_TRUE(sim_->board(1).report().disabled);
    EXPECT_EQ(sim_->board(1).value(0), wire::Value(0.5F)) << "a position is a place, not a speed";
    EXPECT_EQ(count(EventKind::Stopped), 2);
    const auto blocked = write(bear, "duty_cycle", 0.1);
    ASSERT_FALSE(blocked);
    EXPECT_EQ(blocked.error().code, Errc::StopLatched);
    EXPECT_TRUE(session_->snapshot().blocked);
    stop_.rearm();
    EXPECT_TRUE(write(bear, "duty_cycle", 0.1));
    EXPECT_FALSE(sim_->board(0).report().disabled);
}

TEST_F(SmartDeviceSafety, AWriteUnderWayEndsWithStop) {
    start("ServoControl");
    sim_->board(0).faults().silent = true;
    const CommandId id = execute(WriteValues{0, {{0, wire::Value(0.5F)}}});
    run(20ms);
    pressStop();
    ASSERT_TRUE(answers_.contains(id));
    EXPECT_EQ(answers_[id].error().code, Errc::StopLatched);
    EXPECT_EQ(parameter(0, "servo0").verdict, WriteVerdict::None);
}

TEST_F(SmartDeviceSafety, WhatDrivesIsStoppedWhenTheProgramStopsResponding) {
    start("PolarBear");
    heartbeatFresh_ = false;
    run(100ms);
    EXPECT_FALSE(stop_.isSet()) << "nothing moved";
    heartbeatFresh_ = true;
    ASSERT_TRUE(write(0, "pid_vel_setpoint", 3000));
    EXPECT_TRUE(session_->active());
    heartbeatFresh_ = false;
    run(20ms);
    EXPECT_EQ(stop_.reason(), StopReason::HeartbeatStale);
}

TEST_F(SmartDeviceSafety, TheSimulatedBatterySagsWhileAMotorSpinsUpAndRecovers) {
    start("PolarBear,BatteryBuzzer");
    constexpr int kBattery = 5;
    const auto volts = [this] { return *wire::toNumber(sim_->board(1).value(kBattery)); };
    const double rest_V = volts();
    ASSERT_TRUE(write(numberOf(0), "duty_cycle", 1));
    run(50ms);
    EXPECT_LT(volts(), rest_V - 0.05);
    pressStop();
    run(10s);
    EXPECT_NEAR(volts(), rest_V, 0.02);
    stop_.rearm();
    ASSERT_TRUE(write(numberOf(0), "duty_cycle", 1));
    run(50ms);
    EXPECT_LT(volts(), rest_V - 0.05);
    ASSERT_TRUE(sim_->perform("plugged", 0, 0));
    EXPECT_NEAR(volts(), rest_V, 0.02) << "what is pulled out draws nothing";
    ASSERT_TRUE(sim_->perform("current", 1, 20));
    EXPECT_NEAR(volts(), rest_V - 1, 0.02);
}

TEST_F(SmartDeviceSafety, APositionDrivesUntilItsDeviceIsDisabled) {
    start("PolarBear,ServoControl");
    const int bear = numberOf(0);
    const int servo = numberOf(1);
    ASSERT_TRUE(write(bear, "pid_pos_setpoint", 0));
    EXPECT_TRUE(device(bear).driving) << "zero is a place";
    ASSERT_TRUE(perform(DisableDevice{bear}));
    EXPECT_FALSE(session_->active());
    EXPECT_FALSE(parameter(bear, "pid_pos_setpoint").written);
    ASSERT_TRUE(write(servo, "servo0", 0.5));
    EXPECT_TRUE(session_->active());
    heartbeatFresh_ = false;
    run(20ms);
    EXPECT_EQ(stop_.reason(), StopReason::HeartbeatStale);
}

TEST_F(SmartDeviceSafety, WhatWasWrittenIsForgottenWhenTheBoardBeginsAnew) {
    start("PolarBear");
    const auto gain = [this] { return parameter(0, "pid_pos_kp").written; };
    ASSERT_TRUE(write(0, "pid_pos_kp", 2));
    pressStop();
    run(20ms);
    EXPECT_TRUE(gain()) << "STOP leaves the gains";
    stop_.rearm();
    ASSERT_TRUE(sim_->perform("plugged", 0, 0));
    ASSERT_TRUE(runUntil([&] { return device(0).presence == Presence::Lost; }, 5s));
    ASSERT_TRUE(sim_->perform("plugged", 0, 1));
    ASSERT_TRUE(runUntil([&] { return device(0).presence == Presence::Live; }, 5s));
    EXPECT_FALSE(gain());
    run(100ms);
    ASSERT_TRUE(write(0, "pid_pos_kp", 2));
    ASSERT_TRUE(write(0, "pid_vel_setpoint", 100));
    ASSERT_TRUE(sim_->perform("reset", 0, 1));
    ASSERT_TRUE(runUntil([&] { return count(EventKind::DeviceReset) == 1; }, 5s));
    EXPECT_FALSE(gain());
    EXPECT_FALSE(device(0).driving);
}

TEST_F(SmartDeviceSafety, AShortSilenceIsNotTakenForANewBeginning) {
    start("PolarBear");
    ASSERT_TRUE(write(0, "duty_cycle", 0.5));
    for (const int delay_ms : {200, 225, 250}) {
        ASSERT_TRUE(perform(Subscribe{0, device(0).wanted, static_cast<std::uint16_t>(delay_ms)}));
        for (Duration silence = 400ms; silence <= 1300ms; silence += 30ms) {
            sim_->board(0).faults().silent = true;
            run(silence);
            sim_->board(0).faults().silent = false;
            // No multiple of anything, so that a silence begins at all points between two updates.
            run(1370ms);
            ASSERT_EQ(count(EventKind::DeviceReset), 0) << delay_ms << " " << silence / 1ms;
            ASSERT_TRUE(device(0).driving);
        }
    }
    ASSERT_TRUE(sim_->perform("reset", 0, 1));
    // Its 600 ms of booting, and the second in which it talks and sends nothing.
    ASSERT_TRUE(runUntil([&] { return count(EventKind::DeviceReset) == 1; }, 2s));
    EXPECT_FALSE(device(0).driving);
}

TEST_F(SmartDeviceSafety, ABoardIsSaidToBeStoppedOnceItWasTold) {
    start("PolarBear,PolarBear");
    ASSERT_TRUE(sim_->perform("plugged", 1, 0));
    ASSERT_TRUE(runUntil([&] { return device(numberOf(1)).presence == Presence::Lost; }, 5s));
    pressStop();
    run(20ms);
    EXPECT_EQ(count(EventKind::Stopped), 1) << "the one that is there";
    ASSERT_TRUE(sim_->perform("plugged", 1, 1));
    ASSERT_TRUE(runUntil([&] { return count(EventKind::Stopped) == 2; }, 10s));
    ASSERT_TRUE(runUntil([&] { return sim_->board(1).report().disabled; }, 1s));
}

TEST_F(SmartDeviceSafety, DisablingOneLeavesTheOthers) {
    start("PolarBear,PolarBear");
    ASSERT_TRUE(write(0, "duty_cycle", 0.5));
    ASSERT_TRUE(write(1, "duty_cycle", 0.5));
    EXPECT_TRUE(perform(DisableDevice{0}));
    run(50ms);
    EXPECT_TRUE(device(0).disabled);
    EXPECT_FALSE(device(0).driving);
    EXPECT_TRUE(device(1).driving);
    EXPECT_EQ(device(1).spec->name, "PolarBear");
}

TEST_F(SmartDeviceSafety, HeartbeatsAreAnsweredAndAPolarBearWithoutThemDisablesItself) {
    start("PolarBear");
    ASSERT_TRUE(write(0, "duty_cycle", 0.5));
    run(5s);
    EXPECT_FALSE(sim_->board(0).report().disabled);
    EXPECT_EQ(sim_->board(0).report().selfDisables, 0U);
    // A program that ends without a word leaves the line closed and the board with its power.
    session_.reset();
    run(3s);
    EXPECT_TRUE(sim_->board(0).report().disabled);
    EXPECT_EQ(sim_->board(0).report().selfDisables, 1U);
    EXPECT_EQ(sim_->board(0).value(0), wire::Value(0.0F));
}

TEST_F(SmartDeviceSafety, APolarBearTakesNothingButAnAnswerForOne) {
    start("PolarBear", {}, false);
    session_.reset();
    sim::BoardSim& board = sim_->board(0);
    board.lineOpened(115200);
    const auto say = [&board](const wire::Message& message) {
        board.hostSent(wire::encodeFrame(wire::Dialect::Current, message).view());
    };
    for (int i = 0; i < 30; ++i) {
        run(100ms);
        say(wire::Ping{});
        say(wire::HeartbeatRequest{1});
    }
    EXPECT_EQ(board.report().selfDisables, 1U);
    board.lineClosed();
}

TEST_F(SmartDeviceSafety, ShutdownStopsWhatWasDrivenAndClosesEveryPort) {
    start("PolarBear,Encoder");
    ASSERT_TRUE(write(numberOf(0), "duty_cycle", 0.5));
    bool done = false;
    session_->shutdown([&] { done = true; });
    EXPECT_TRUE(runUntil([&] { return done; }, 1s));
    EXPECT_EQ(sim_->board(0).value(0), wire::Value(0.0F));
    EXPECT_FALSE(sim_->board(0).report().lineOpen);
    EXPECT_FALSE(sim_->board(1).report().lineOpen);
    const auto late = perform(SearchAgain{});
    EXPECT_FALSE(late);
}

}  // namespace
}  // namespace kickstand::smartdevice::testing
