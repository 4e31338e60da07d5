#include <cmath>

#include "tests/session/smartdevice_rig.h"

namespace kickstand::smartdevice::testing {
namespace {

class SmartDeviceWrites : public SmartDeviceRig {};

TEST_F(SmartDeviceWrites, AWriteIsJudgedDoneRefusedChangedOrUnconfirmed) {
    start("PolarBear,ServoControl");
    const int bear = numberOf(0);
    EXPECT_TRUE(write(bear, "duty_cycle", 0.5));
    EXPECT_EQ(parameter(bear, "duty_cycle").verdict, WriteVerdict::Done);
    EXPECT_EQ(parameter(bear, "duty_cycle").value, wire::Value(0.5F));
    EXPECT_TRUE(write(bear, "pid_pos_kp", 2));
    EXPECT_EQ(parameter(bear, "pid_pos_kp").verdict, WriteVerdict::Unconfirmed);
    sim_->board(0).faults().refuse = 1;
    const auto refused = write(bear, "duty_cycle", 0.25);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::DeviceRefused);
    EXPECT_EQ(refused.error().subject, "duty_cycle");
    EXPECT_EQ(parameter(bear, "duty_cycle").verdict, WriteVerdict::Refused);
    EXPECT_EQ(count(EventKind::WriteRefused), 1);
}

TEST_F(SmartDeviceWrites, AWriteRefusedBeforeTheFirstSampleIsRefused) {
    start("ServoControl");
    ASSERT_FALSE(parameter(0, "servo0").value);
    sim_->board(0).faults().refuse = 1;
    const auto refused = write(0, "servo0", 0.5);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::DeviceRefused);
    EXPECT_EQ(parameter(0, "servo0").verdict, WriteVerdict::Refused);
    EXPECT_EQ(count(EventKind::WriteChanged), 0);
}

TEST_F(SmartDeviceWrites, AWriteRefusedWhileItsParameterIsReadIsRefused) {
    start("ServoControl");
    ASSERT_TRUE(perform(Subscribe{0, 0, 0}));
    ASSERT_TRUE(perform(ReadValues{0, 3}));
    sim_->board(0).faults().refuse = 1;
    const CommandId written = execute(WriteValues{0, {{0, wire::Value(0.5F)}}});
    const CommandId asked = execute(ReadValues{0, 1});
    run(400ms);
    ASSERT_TRUE(answers_.contains(written) && answers_.contains(asked));
    EXPECT_TRUE(answers_[asked]);
    EXPECT_EQ(parameter(0, "servo0").verdict, WriteVerdict::Refused);
}

TEST_F(SmartDeviceWrites, FromSilenceAfterAWriteNothingFollows) {
    start("PolarBear");
    sim_->board(0).faults().silent = true;
    run(100ms);
    const auto written = write(0, "duty_cycle", 0.25);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Errc::TimedOut);
    EXPECT_EQ(parameter(0, "duty_cycle").verdict, WriteVerdict::Unconfirmed);
    EXPECT_EQ(count(EventKind::WriteRefused), 0);
}

TEST_F(SmartDeviceWrites, AWriteThatTheDeviceClampsIsChanged) {
    // A user's catalogue that knows no bounds lets through what the board then clamps.
    catalogue_ =
        R"({"format": "kickstand-smart-devices", "version": 1, "devices": [{"id": 7, "name": "ServoControl",
        "parameters": [{"name": "servo0", "type": "float", "access": "read-write"},
                       {"name": "servo1", "type": "float", "access": "read-write"}]}]})";
    start("ServoControl");
    EXPECT_TRUE(write(0, "servo0", 7));
    EXPECT_EQ(parameter(0, "servo0").verdict, WriteVerdict::Changed);
    EXPECT_EQ(parameter(0, "servo0").value, wire::Value(1.0F));
    EXPECT_EQ(count(EventKind::WriteChanged), 1);
}

TEST_F(SmartDeviceWrites, WritesAreJudgedRightWhileSamplesRace) {
    start("ServoControl");
    ASSERT_TRUE(perform(Subscribe{0, 0xFFFF, 2}));
    for (int i = 0; i < 50; ++i) {
        ASSERT_TRUE(write(0, i % 2 == 0 ? "servo0" : "servo1", (i % 20 - 10) / 10.0));
        EXPECT_EQ(parameter(0, i % 2 == 0 ? "servo0" : "servo1").verdict, WriteVerdict::Done) << i;
        run(std::chrono::milliseconds(i % 7));
    }
    EXPECT_EQ(count(EventKind::WriteChanged) + count(EventKind::WriteRefused), 0);
}

TEST_F(SmartDeviceWrites, ASampleInPiecesIsNoAnswer) {
    options_["data_bytes"] = "1";
    start("TeamFlag,ServoControl,PolarBear");
    const int flag = numberOf(0);
    ASSERT_TRUE(perform(Subscribe{flag, 0xFFFF, 5}));
    run(100ms);
    // What is refused is refused, however many pieces with its old value come meanwhile.
    sim_->board(0).faults().refuse = 1;
    for (const char* name : {"mode", "blue", "led4"}) {
        const bool old = wire::toNumber(*parameter(flag, name).value) != 0.0;
        ASSERT_FALSE(write(flag, name, old ? 0 : 1));
        EXPECT_EQ(parameter(flag, name).verdict, WriteVerdict::Refused) << name;
    }
    sim_->board(0).faults().refuse = 0;
    EXPECT_TRUE(perform(ReadValues{flag, 0x7F}));
    EXPECT_TRUE(perform(WriteValues{flag, {{0, wire::Value(true)}, {6, wire::Value(true)}}}));
    EXPECT_EQ(parameter(flag, "led4").verdict, WriteVerdict::Done);
    EXPECT_EQ(device(flag).delay_ms, 5);
    for (const DeviceState& one : session_->snapshot().devices) {
        for (std::size_t i = 0; i < one.parameters.size(); ++i)
            EXPECT_EQ(one.parameters[i].value.has_value(), one.spec->parameters[i].readable());
    }
}

TEST_F(SmartDeviceWrites, WhatMakesNoSenseIsNotSent) {
    start("PolarBear,Encoder");
    const int bear = numberOf(0);
    const auto codeOf = [&](const Command& command) {
        const auto result = perform(command);
        return result ? Errc::Io : result.error().code;
    };
    EXPECT_EQ(codeOf(WriteValues{bear, {{11, wire::Value(1.0F)}}}), Errc::BadArgument) << "read-only";
    EXPECT_EQ(codeOf(WriteValues{bear, {{0, wire::Value(true)}}}), Errc::BadArgument) << "another type";
    EXPECT_EQ(codeOf(WriteValues{bear, {{0, wire::Value(1.5F)}}}), Errc::OutOfRange);
    EXPECT_EQ(codeOf(WriteValues{bear, {{0, wire::Value(std::nanf(""))}}}), Errc::BadArgument);
    EXPECT_EQ(codeOf(WriteValues{bear, {{0, wire::Value(HUGE_VALF)}}}), Errc::BadArgument);
    // Without an upper bound the lower one is told in words.
    const auto current = perform(WriteValues{bear, {{9, wire::Value(-1.0F)}}});
    ASSERT_FALSE(current);
    EXPECT_EQ(current.error().code, Errc::OutOfRange);
    EXPECT_EQ(current.error().detail, "-1, at least 0");
    EXPECT_EQ(codeOf(WriteValues{bear, {{14, wire::Value(1.0F)}}}), Errc::BadArgument) << "no such parameter";
    EXPECT_EQ(codeOf(WriteValues{bear, {{-1, wire::Value(1.0F)}}}), Errc::BadArgument);
    EXPECT_EQ(codeOf(WriteValues{bear, {}}), Errc::BadArgument);
    EXPECT_EQ(codeOf(WriteValues{7, {{0, wire::Value(1.0F)}}}), Errc::UnknownName);
    EXPECT_EQ(codeOf(ReadValues{bear, 2}), Errc::BadArgument) << "write-only";
    EXPECT_EQ(codeOf(DisableDevice{-3}), Errc::UnknownName);
    EXPECT_EQ(sim_->board(0).report().writes, 0U);
}

}  // namespace
}  // namespace kickstand::smartdevice::testing
