// Smart devices on the command line, over simulated boards.

#include <csignal>

#include <gtest/gtest.h>

#include "tests/app/program.h"

namespace kickstand::test {
namespace {

constexpr const char* kBoards =
    "sim:smartdevice?devices=PolarBear,BatteryBuzzer,ServoControl.hibike&boot_ms=50";
/// Finding out what the last one has takes a while.
constexpr const char* kWithUnknown =
    "sim:smartdevice?devices=PolarBear,BatteryBuzzer.hibike,Unknown&boot_ms=50";

Ended onBoards(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"--link", kBoards});
    return run(std::move(arguments));
}

QJsonObject json(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "--json");
    const Ended ended = onBoards(std::move(arguments));
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    return ended.object();
}

void expectRefused(const Ended& ended, int exitCode, const char* said) {
    EXPECT_EQ(ended.exitCode, exitCode);
    EXPECT_TRUE(ended.oneComplaint()) << ended.err;
    EXPECT_NE(ended.err.find(said), std::string::npos) << ended.err;
}

TEST(ProgramSmartDevice, ListTellsOfEveryBoardAndItsPort) {
    const QJsonObject list = run({"--json", "--link", kWithUnknown, "smartdevice", "list"}).object();
    const QJsonArray devices = list[QStringLiteral("devices")].toArray();
    ASSERT_EQ(devices.size(), 3);
    QStringList names;
    for (const QJsonValue& device : devices) {
        names << device[QStringLiteral("name")].toString();
        EXPECT_EQ(device[QStringLiteral("presence")].toString(), QStringLiteral("live"));
        EXPECT_FALSE(device[QStringLiteral("uid")].toString().isEmpty());
    }
    for (const char* name : {"PolarBear", "BatteryBuzzer", "Device66"})
        EXPECT_TRUE(names.contains(QLatin1String(name))) << name;
    EXPECT_EQ(list[QStringLiteral("ports")].toArray().size(), 3);
}

TEST(ProgramSmartDevice, ReadGivesTypedValuesByName) {
    const QJsonObject values = json({"smartdevice", "read", "BatteryBuzzer", "v_batt", "is_unsafe"});
    EXPECT_EQ(values.size(), 2);
    EXPECT_NEAR(values[QStringLiteral("v_batt")].toDouble(), 11.8, 0.5);
    EXPECT_TRUE(values[QStringLiteral("is_unsafe")].isBool());
    const QJsonObject raw =
        run({"--json", "--link", kWithUnknown, "smartdevice", "read", "Device66"}).object();
    EXPECT_EQ(raw[QStringLiteral("parameter0")].toString(), QStringLiteral("07"));
}

TEST(ProgramSmartDevice, WriteSaysWhatBecameOfEachValue) {
    const QJsonObject written =
        json({"smartdevice", "write", "ServoControl", "servo0=0.5", "servo1=-0.25", "--for", "0.1"});
    const QJsonObject verdicts = written[QStringLiteral("verdicts")].toObject();
    EXPECT_EQ(verdicts[QStringLiteral("servo0")].toString(), QStringLiteral("done"));
    EXPECT_EQ(written[QStringLiteral("values")][QStringLiteral("servo1")].toDouble(), -0.25);
    const QJsonObject gain = json({"smartdevice", "write", "PolarBear", "pid_pos_kp=2"});
    EXPECT_EQ(gain[QStringLiteral("verdicts")][QStringLiteral("pid_pos_kp")].toString(),
              QStringLiteral("unconfirmed"));
}

TEST(ProgramSmartDevice, WhatMovesNeedsATimeAndStopsAfterIt) {
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=0.5"}), 2, "--for");
    expectRefused(onBoards({"smartdevice", "write", "ServoControl", "servo0=0"}), 2, "--for");
    const Ended ended = onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=0.5", "--for", "0.2"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    EXPECT_NE(ended.out.find("told to stop"), std::string::npos) << ended.out;
    // Zero moves nothing.
    EXPECT_EQ(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=0"}).exitCode, 0);
}

TEST(ProgramSmartDevice, SubscribeStreamsUpdatesUntilItIsEnded) {
    Program program({"--link", kBoards, "--json", "smartdevice", "subscribe", "BatteryBuzzer", "v_batt",
                     "--delay", "20"});
    ASSERT_TRUE(program.waitFor("\"update\""));
    program.signal(SIGINT);
    const Ended ended = program.end();
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    for (const QJsonValue& value : ended.values()) {
        EXPECT_EQ(value[QStringLiteral("type")].toString(), QStringLiteral("update"));
        EXPECT_TRUE(value[QStringLiteral("values")][QStringLiteral("v_batt")].isDouble());
    }
}

TEST(ProgramSmartDevice, PingAndDisable) {
    const QJsonObject pinged = json({"smartdevice", "ping", "PolarBear"});
    EXPECT_GT(pinged[QStringLiteral("latency_ms")].toDouble(), 0);
    EXPECT_TRUE(json({"smartdevice", "disable", "PolarBear"})[QStringLiteral("disabled")].toBool());
}

TEST(ProgramSmartDevice, WhatMakesNoSenseIsRefusedWithWhatThereIs) {
    expectRefused(onBoards({"smartdevice", "read", "Grizzly"}), 1, "PolarBear");
    expectRefused(onBoards({"smartdevice", "read", "PolarBear", "speed"}), 2, "duty_cycle");
    expectRefused(onBoards({"smartdevice", "write", "BatteryBuzzer", "v_batt=12"}), 1, "only be read");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=fast"}), 2, "duty_cycle");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=2", "--for", "1"}), 1,
                  "-1 to 1");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle"}), 2, "NAME=VALUE");
    expectRefused(run({"--link", "sim:smartdevice?devices=Toaster", "smartdevice", "list"}), 2, "PolarBear");
    expectRefused(run({"--link", "serial:/no/such/port", "smartdevice", "read", "PolarBear"}), 1,
                  "no device");
}

TEST(ProgramSmartDevice, FramesAreEncodedAndDecoded) {
    const Ended encoded =
        run({"encode", "smartdevice.frame", "message=subscription-request", "parameters=5", "delay_ms=40"});
    EXPECT_EQ(encoded.out, "04 11 03 05 03 28 3f 00\n");
    const QJsonObject decoded =
        run({"--json", "decode", "smartdevice.frame", "04 11 03 05 03 28 3f 00"}).object();
    EXPECT_EQ(decoded[QStringLiteral("parameters")].toInt(), 5);
    EXPECT_EQ(decoded[QStringLiteral("delay_ms")].toInt(), 40);
    EXPECT_EQ(run({"decode", "smartdevice.frame-hibike", "000402100210"}).exitCode, 0);
    EXPECT_EQ(run({"decode", "smartdevice.frame", "000402100210"}).exitCode, 2);
}

}  // namespace
}  // namespace kickstand::test
