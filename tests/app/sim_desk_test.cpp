// The control protocol of kickstand-sim, a line in and a line out: no sockets, and time passes by a fake
// scheduler.

#include <QJsonArray>
#include <QJsonDocument>
#include <chrono>
#include <random>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "app/kickstand-sim/control_desk.h"
#include "app/kickstand-sim/thunderbots_simulation.h"
#include "core/base/fake_scheduler.h"
#include "core/thunderbots/wire/kick.h"
#include "core/thunderbots/wire/test_mode.h"

namespace kickstand::sim {
namespace {

using namespace std::chrono_literals;
namespace wire = thunderbots::wire;

constexpr std::uint8_t kRobot = 3;

/// Robot 3 on a cable, and a host that is nothing but this test.
class Desk : public testing::Test {
  protected:
    static thunderbots::sim::ThunderbotsSimOptions options() {
        thunderbots::sim::ThunderbotsSimOptions options;
        options.cableRobot = kRobot;
        options.noise = false;
        return options;
    }

    QJsonObject ask(std::string_view line) { return answerOf(desk, line); }
    static QJsonObject answerOf(ControlDesk& desk, std::string_view line) {
        const QByteArray answer =
            desk.answer({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()});
        EXPECT_FALSE(answer.contains('\n')) << line;
        const QJsonDocument document = QJsonDocument::fromJson(answer);
        EXPECT_TRUE(document.isObject()) << answer.toStdString();
        return document.object();
    }
    /// The code of a refusal that also says what, and what to do.
    static std::string refusal(const QJsonObject& answer) {
        EXPECT_FALSE(answer[QStringLiteral("ok")].toBool(true));
        const QJsonObject error = answer[QStringLiteral("error")].toObject();
        EXPECT_FALSE(error[QStringLiteral("what")].toString().isEmpty());
        EXPECT_FALSE(error[QStringLiteral("remedy")].toString().isEmpty());
        return error[QStringLiteral("code")].toString().toStdString();
    }
    QJsonObject robot() {
        return ask(R"({"request":"show","robot":3})")[QStringLiteral("robots")][0].toObject();
    }

    void configure() {
        std::vector<std::uint8_t> in;
        const UsbSetup setConfiguration{
            .requestType = 0x00, .request = 9, .value = 1, .index = 0, .length = 0};
        ASSERT_EQ(simulation.device().control(setConfiguration, {}, in), UsbHandshake::Ack);
    }
    void drive(const wire::DriveBlock& block) {
        std::vector<std::uint8_t> packet{12, wire::headerByte(kRobot, wire::Pipe::Drive)};
        const auto bytes = wire::encodeDrive(block).value();
        packet.insert(packet.end(), bytes.begin(), bytes.end());
        ASSERT_EQ(simulation.device().out(0x05, packet), UsbHandshake::Ack);
    }
    template <class Bytes>
    void send(wire::Pipe pipe, const Bytes& payload) {
        std::vector<std::uint8_t> packet{wire::headerByte(kRobot, pipe)};
        packet.insert(packet.end(), payload.begin(), payload.end());
        ASSERT_EQ(simulation.device().out(0x06, packet), UsbHandshake::Ack);
    }

    FakeScheduler scheduler;
    ThunderbotsSimulation simulation{scheduler, options()};
    ControlDesk desk{simulation};
};

TEST_F(Desk, ShowsTheLastDriveBlockWithItsFields) {
    EXPECT_TRUE(robot()[QStringLiteral("drive")].isNull());
    configure();
    wire::DriveBlock block{.run = true, .charge = true, .dribble = true, .autokickArmed = true};
    block.wheels = {40, -41, 1023, -1023};
    block.autokick = {.flag1 = true, .flag2 = false, .t1 = 75, .t2 = 42, .dt = 10};
    block.testClass = 2;
    block.testTarget = 5;
    drive(block);
    drive(block);
    QJsonObject shown = robot()[QStringLiteral("drive")].toObject();
    EXPECT_TRUE(shown[QStringLiteral("fresh")].toBool());
    for (const char* flag : {"run", "charge", "dribble", "armed", "mask1"})
        EXPECT_TRUE(shown[QLatin1String(flag)].toBool()) << flag;
    EXPECT_FALSE(shown[QStringLiteral("mask2")].toBool(true));
    EXPECT_EQ(shown[QStringLiteral("wheels")].toArray(), (QJsonArray{40, -41, 1023, -1023}));
    EXPECT_EQ(shown[QStringLiteral("t1")], 75);
    EXPECT_EQ(shown[QStringLiteral("t2")], 42);
    EXPECT_EQ(shown[QStringLiteral("dt")], 10);
    EXPECT_EQ(shown[QStringLiteral("test_class")], 2);
    EXPECT_EQ(shown[QStringLiteral("test_target")], 5);
    EXPECT_EQ(robot()[QStringLiteral("test_mode")][QStringLiteral("class")], QStringLiteral("hall"));
    EXPECT_EQ(robot()[QStringLiteral("drive_blocks")], 2);
    EXPECT_EQ(robot()[QStringLiteral("drive_changes")], 1);
    scheduler.advance(2s);
    shown = robot()[QStringLiteral("drive")].toObject();
    EXPECT_FALSE(shown[QStringLiteral("fresh")].toBool(true));
    EXPECT_EQ(robot()[QStringLiteral("drive_timeouts")], 1);
}

TEST_F(Desk, ShowsKicksWithPulsesAndTimes) {
    configure();
    ask(R"({"request":"perform","action":"capacitor","robot":3,"value":200})");
    scheduler.advance(1500ms);
    send(wire::Pipe::Kick,
         wire::encodeKick({.flag1 = true, .flag2 = false, .t1 = 63, .t2 = 42, .dt = 10}).value());
    const QJsonObject kicks = robot()[QStringLiteral("kicks")].toObject();
    EXPECT_EQ(kicks[QStringLiteral("count")], 1);
    EXPECT_EQ(kicks[QStringLiteral("automatic")], 0);
    const QJsonObject kick = kicks[QStringLiteral("last")][0].toObject();
    EXPECT_EQ(kick[QStringLiteral("number")], 1);
    EXPECT_DOUBLE_EQ(kick[QStringLiteral("time_s")].toDouble(), 1.5);
    EXPECT_EQ(kick[QStringLiteral("start1_us")], 0);
    EXPECT_EQ(kick[QStringLiteral("width1_us")], 2016);
    EXPECT_EQ(kick[QStringLiteral("start2_us")], 320);
    EXPECT_EQ(kick[QStringLiteral("width2_us")], 1024);
    EXPECT_NEAR(kick[QStringLiteral("before_V")].toDouble(), 200, 1);
    EXPECT_LT(kick[QStringLiteral("after_V")].toDouble(), kick[QStringLiteral("before_V")].toDouble());
}

TEST_F(Desk, KeepsTheNewestKicksAndCountsThemAll) {
    configure();
    for (int i = 0; i < 100; ++i)
        send(wire::Pipe::Kick,
             wire::encodeKick({.flag1 = true, .flag2 = true, .t1 = 3, .t2 = 0, .dt = 0}).value());
    const QJsonObject kicks = robot()[QStringLiteral("kicks")].toObject();
    EXPECT_EQ(kicks[QStringLiteral("count")], 100);
    const QJsonArray last = kicks[QStringLiteral("last")].toArray();
    EXPECT_EQ(last.size(), static_cast<qsizetype>(thunderbots::sim::kKickRecords));
    EXPECT_EQ(last.last()[QStringLiteral("number")], 100);
}

TEST_F(Desk, ShowsTestModeAndParameters) {
    configure();
    send(wire::Pipe::TestMode, wire::encodeTestMode({wire::TestClass::Encoder, 2}).value());
    const QJsonObject shown = robot();
    EXPECT_EQ(shown[QStringLiteral("test_mode")][QStringLiteral("class")], QStringLiteral("encoder"));
    EXPECT_EQ(shown[QStringLiteral("test_mode")][QStringLiteral("target")], 2);
    EXPECT_EQ(shown[QStringLiteral("test_mode_messages")], 1);
    for (const char* block : {"shadow", "committed"}) {
        const QJsonObject parameters = shown[QStringLiteral("parameters")][QLatin1String(block)].toObject();
        EXPECT_EQ(parameters[QStringLiteral("robot_number")], 3);
        EXPECT_EQ(parameters[QStringLiteral("dribbler_duty")], 180);
        EXPECT_EQ(parameters[QStringLiteral("channels")].toArray(), (QJsonArray{14, 15}));
        EXPECT_EQ(parameters[QStringLiteral("flash_contents")], QStringLiteral("fpga-bitstream"));
    }
}

TEST_F(Desk, DoesWhatTheActionsSay) {
    const QJsonObject answer = ask(R"({"request":"actions","id":7})");
    EXPECT_TRUE(answer[QStringLiteral("ok")].toBool());
    EXPECT_EQ(answer[QStringLiteral("id")], 7);
    EXPECT_EQ(answer[QStringLiteral("units")].toArray(), QJsonArray{3});
    QStringList names;
    for (const auto& action : answer[QStringLiteral("actions")].toArray())
        names << action[QStringLiteral("name")].toString();
    for (const char* name : {"ball", "battery", "dead", "kill", "revive", "stall", "unplug", "replug"})
        EXPECT_TRUE(names.contains(QLatin1String(name))) << name;
    // A cable has no radio and no e-stop.
    EXPECT_FALSE(names.contains(QStringLiteral("loss")));
    EXPECT_FALSE(names.contains(QStringLiteral("e-stop")));

    EXPECT_TRUE(
        ask(R"({"request":"perform","action":"ball","robot":3,"value":1})")[QStringLiteral("ok")].toBool());
    EXPECT_TRUE(robot()[QStringLiteral("ball")].toBool());
    EXPECT_TRUE(
        ask(R"({"request":"perform","action":"battery","robot":"all","value":14.5})")[QStringLiteral("ok")]
            .toBool());
    EXPECT_NEAR(robot()[QStringLiteral("battery_V")].toDouble(), 14.5, 0.05);
    EXPECT_TRUE(ask(R"({"request":"perform","action":"kill","robot":3})")[QStringLiteral("ok")].toBool());
    EXPECT_EQ(robot()[QStringLiteral("power")], QStringLiteral("off"));
    EXPECT_TRUE(ask(R"({"request":"perform","action":"revive","robot":3})")[QStringLiteral("ok")].toBool());
    EXPECT_EQ(robot()[QStringLiteral("power")], QStringLiteral("booting"));
    scheduler.advance(4s);
    EXPECT_TRUE(simulation.device().attached());
    EXPECT_TRUE(ask(R"({"request":"perform","action":"unplug"})")[QStringLiteral("ok")].toBool());
    EXPECT_FALSE(simulation.device().attached());
}

TEST(DongleDesk, TakesWordsForValues) {
    FakeScheduler scheduler;
    thunderbots::sim::ThunderbotsSimOptions options;
    options.robots = 0x0029;
    ThunderbotsSimulation simulation(scheduler, options);
    ControlDesk desk(simulation);
    const auto ask = [&](std::string_view line) {
        return QJsonDocument::fromJson(
                   desk.answer({reinterpret_cast<const std::uint8_t*>(line.data()), line.size()}))
            .object();
    };
    EXPECT_EQ(ask(R"({"request":"perform","action":"e-stop","value":"stop"})")[QStringLiteral("value")], 2);
    QJsonObject shown = ask(R"({"request":"show"})");
    EXPECT_EQ(shown[QStringLiteral("device")][QStringLiteral("emergency_stop")], QStringLiteral("stop"));
    EXPECT_EQ(shown[QStringLiteral("robots")].toArray().size(), 3);
    EXPECT_EQ(
        ask(R"({"request":"perform","action":"radio-failure","value":"none"})")[QStringLiteral("value")], -1);
    ask(R"({"request":"perform","action":"loss","value":0.25})");
    shown = ask(R"({"request":"show","robot":5})");
    EXPECT_DOUBLE_EQ(shown[QStringLiteral("device")][QStringLiteral("loss")].toDouble(), 0.25);
    EXPECT_EQ(shown[QStringLiteral("robots")].toArray().size(), 1);
}

TEST_F(Desk, RefusesWhatCannotBeMeantAndDoesNothing) {
    const QJsonObject before = robot();
    for (const auto& [line, code] : std::vector<std::pair<const char*, const char*>>{
             {"", "malformed"},
             {"nonsense", "malformed"},
             {"[1,2]", "malformed"},
             {R"({"request":"show")", "malformed"},
             {"{}", "unknown-name"},
             {R"({"request":"format"})", "unknown-name"},
             {R"({"request":3})", "unknown-name"},
             {R"({"request":"show","robots":3})", "unknown-name"},
             {R"({"request":"show","robot":4})", "no-device"},
             {R"({"request":"show","robot":3.5})", "no-device"},
             {R"({"request":"show","robot":"all"})", "bad-argument"},
             {R"({"request":"perform"})", "unknown-name"},
             {R"({"request":"perform","action":"explode","robot":3,"value":1})", "unknown-name"},
             {R"({"request":"perform","action":"ball","value":1})", "bad-argument"},
             {R"({"request":"perform","action":"ball","robot":3})", "bad-argument"},
             {R"({"request":"perform","action":"ball","robot":3,"value":2})", "out-of-range"},
             {R"({"request":"perform","action":"ball","robot":3,"value":0.5})", "bad-argument"},
             {R"({"request":"perform","action":"ball","robot":3,"value":"yes"})", "bad-argument"},
             {R"({"request":"perform","action":"kill","robot":3,"value":1})", "bad-argument"},
             {R"({"request":"perform","action":"unplug","robot":3})", "bad-argument"},
             {R"({"request":"perform","action":"stall","value":17})", "bad-argument"},
             {R"({"request":"flash","robot":3})", "out-of-range"},
             {R"({"request":"flash","robot":3,"address":2097152,"length":1})", "out-of-range"},
             {R"({"request":"flash","robot":3,"address":2097151,"length":2})", "out-of-range"},
             {R"({"request":"flash","robot":3,"address":-1,"length":1})", "out-of-range"},
             {R"({"request":"flash","robot":3,"address":0,"length":65537})", "out-of-range"},
         })
        EXPECT_EQ(refusal(ask(line)), code) << line;
    EXPECT_EQ(robot(), before);
}

TEST_F(Desk, AnswersAnyBytesWithOneLine) {
    std::mt19937 random(4);
    const std::string whole = R"({"request":"perform","action":"ball","robot":3,"value":1})";
    for (int i = 0; i < 3000; ++i) {
        std::string line = whole;
        for (int edits = 0; edits < 3; ++edits)
            line[random() % line.size()] = static_cast<char>(random());
        ask(line);
    }
    ask(std::string(kMaxRequestBytes, '['));
    EXPECT_EQ(refusal(QJsonDocument::fromJson(ControlDesk::answerToTooLong()).object()), "malformed");
}

TEST_F(Desk, GivesTheFlashMemoryInPieces) {
    const QJsonObject answer = ask(R"({"request":"flash","robot":3,"address":256,"length":4})");
    EXPECT_EQ(answer[QStringLiteral("flash_bytes")], 2097152);
    const QByteArray piece = QByteArray::fromBase64(answer[QStringLiteral("base64")].toString().toLatin1());
    std::array<std::uint8_t, 4> expected{};
    simulation.readFlash(kRobot, 256, expected);
    EXPECT_EQ(piece, QByteArray(reinterpret_cast<const char*>(expected.data()), expected.size()));
    const QJsonObject end = ask(R"({"request":"flash","robot":3,"address":2097150,"length":2})");
    EXPECT_EQ(end[QStringLiteral("base64")], QStringLiteral("//8="));
}

}  // namespace
}  // namespace kickstand::sim
