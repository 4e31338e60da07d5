// Smart devices on the command line, over simulated boards.

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <csignal>
#include <set>

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
    QList<QJsonValue> values;
    for (const QJsonValue& value : ended.values())
        values.append(value);
    const QJsonValue granted = values.takeFirst();
    EXPECT_EQ(granted[QStringLiteral("type")].toString(), QStringLiteral("subscribed"));
    EXPECT_EQ(granted[QStringLiteral("delay_ms")].toInt(), 20);
    EXPECT_EQ(granted[QStringLiteral("parameters")].toArray(), QJsonArray{QStringLiteral("v_batt")});
    for (const QJsonValue& value : values) {
        EXPECT_EQ(value[QStringLiteral("type")].toString(), QStringLiteral("update"));
        EXPECT_TRUE(value[QStringLiteral("values")][QStringLiteral("v_batt")].isDouble());
    }
}

TEST(ProgramSmartDevice, SubscribeTellsEveryUpdateOfAFastOne) {
    const Ended ended = onBoards(
        {"--json", "smartdevice", "subscribe", "BatteryBuzzer", "v_batt", "--delay", "5", "--for", "1"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    int lost = 0;
    int close = 0;
    QDateTime last;
    for (const QJsonValue& value : ended.values()) {
        if (value[QStringLiteral("type")] == QStringLiteral("lost"))
            lost += value[QStringLiteral("count")].toInt();
        if (value[QStringLiteral("type")] != QStringLiteral("update")) continue;
        const auto time = QDateTime::fromString(value[QStringLiteral("time")].toString(), Qt::ISODateWithMs);
        close += last.isValid() && last.msecsTo(time) < 9 ? 1 : 0;
        last = time;
    }
    EXPECT_EQ(lost, 0);
    // Snapshots, which come every 10 ms, could not have told of two so close to each other.
    EXPECT_GT(close, 0);
}

TEST(ProgramSmartDevice, ASplitSampleIsToldPieceByPiece) {
    const Ended ended = run({"--json", "--link", "sim:smartdevice?devices=TeamFlag&boot_ms=50&data_bytes=4",
                             "smartdevice", "subscribe", "TeamFlag", "--for", "2"});
    EXPECT_EQ(ended.exitCode, 0) << ended.err;
    std::set<qsizetype> sizes;
    for (const QJsonValue& value : ended.values()) {
        if (value[QStringLiteral("type")] == QStringLiteral("update"))
            sizes.insert(value[QStringLiteral("values")].toObject().size());
    }
    EXPECT_EQ(sizes, (std::set<qsizetype>{3, 4}));
}

/// Settings and a catalogue of one's own.
class ProgramOwnBoards : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_TRUE(folder_.isValid());
        qputenv("XDG_CONFIG_HOME", folder_.path().toUtf8());
    }
    void TearDown() override {
        qunsetenv("XDG_CONFIG_HOME");
        qunsetenv("KICKSTAND_DEVICES");
    }
    void write(const QString& name, const QByteArray& text) const {
        QFile file(folder_.filePath(name));
        ASSERT_TRUE(QDir().mkpath(QFileInfo(file).path()) && file.open(QIODevice::WriteOnly));
        file.write(text);
    }
    QTemporaryDir folder_;
};

TEST_F(ProgramOwnBoards, ABoardIsFoundByTheNameThatItWasGivenInTheWindow) {
    write(QStringLiteral("kickstand/kickstand.conf"),
          "[smartdevice]\nnames\\0c-08-01131415161718191a=left arm\n");
    const QJsonObject list = json({"smartdevice", "list"});
    for (const QJsonValue& device : list[QStringLiteral("devices")].toArray()) {
        const bool named = device[QStringLiteral("name")] == QStringLiteral("PolarBear");
        EXPECT_EQ(device[QStringLiteral("own_name")].toString(),
                  named ? QStringLiteral("left arm") : QString());
    }
    EXPECT_TRUE(json({"smartdevice", "read", "left arm", "enc_pos"}).contains(QStringLiteral("enc_pos")));
    expectRefused(onBoards({"smartdevice", "read", "right arm"}), 1, "left arm");
}

TEST_F(ProgramOwnBoards, ACatalogueThatIsNoneIsToldAndLeftOut) {
    write(QStringLiteral("devices.json"), "{ not json");
    qputenv("KICKSTAND_DEVICES", folder_.filePath(QStringLiteral("devices.json")).toUtf8());
    const Ended asked = onBoards({"smartdevice", "read", "PolarBear", "enc_pos"});
    EXPECT_EQ(asked.exitCode, 0) << "the one of the program is used";
    EXPECT_NE(asked.err.find("devices.json: it is not JSON"), std::string::npos) << asked.err;
    EXPECT_EQ(
        json({"smartdevice", "list"})[QStringLiteral("catalogue_error")][QStringLiteral("code")].toString(),
        QStringLiteral("malformed"));
    const Ended doctor = run({"--link", kBoards, "doctor"});
    EXPECT_NE(doctor.out.find("it is not JSON"), std::string::npos) << doctor.out;
}

TEST(ProgramSmartDevice, PingAndDisable) {
    const QJsonObject pinged = json({"smartdevice", "ping", "PolarBear"});
    EXPECT_GT(pinged[QStringLiteral("latency_ms")].toDouble(), 0);
    EXPECT_TRUE(json({"smartdevice", "disable", "PolarBear"})[QStringLiteral("disabled")].toBool());
}

TEST(ProgramSmartDevice, WhatMakesNoSenseIsRefusedWithWhatThereIs) {
    expectRefused(onBoards({"smartdevice", "read", "Grizzly"}), 1, "PolarBear");
    expectRefused(onBoards({"smartdevice", "read", "PolarBear", "speed"}), 2, "duty_cycle");
    expectRefused(onBoards({"smartdevice", "write", "BatteryBuzzer", "v_batt=12"}), 2, "only be read");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=fast"}), 2, "It is a number.");
    expectRefused(run({"--link", "sim:smartdevice?devices=TeamFlag&boot_ms=50", "smartdevice", "write",
                       "TeamFlag", "mode=2"}),
                  2, "It is on or off.");
    expectRefused(run({"--link", kWithUnknown, "smartdevice", "write", "Device66", "parameter0=0708"}), 2,
                  "bytes in hex, 1 of them");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle=2", "--for", "1"}), 1,
                  "-1 to 1");
    expectRefused(onBoards({"smartdevice", "write", "PolarBear", "duty_cycle"}), 2, "NAME=VALUE");
    expectRefused(run({"--link", "sim:smartdevice?devices=Toaster", "smartdevice", "list"}), 2, "PolarBear");
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"list"}, {"read", "PolarBear"}, {"ping", "PolarBear"}}) {
        std::vector<std::string> arguments{"--link", "serial:/no/such/port?protocol=smartdevice",
                                           "smartdevice"};
        arguments.insert(arguments.end(), command.begin(), command.end());
        expectRefused(run(arguments), 1, "no serial port /no/such/port");
    }
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
