#include "tests/session/smartdevice_rig.h"

namespace kickstand::smartdevice::testing {
namespace {

class SmartDeviceTest : public SmartDeviceRig {};

TEST_F(SmartDeviceTest, EveryKindIsFoundInBothDialectsAndSendsWhatItHas) {
    std::string devices;
    for (const sim::BodyKind& kind : sim::bodyKinds()) {
        if (std::string_view(kind.name) == "Unknown") continue;
        devices += (devices.empty() ? "" : ",") + std::string(kind.name) + "," + kind.name + ".hibike";
    }
    start(devices);
    run(2s);
    const Snapshot now = session_->snapshot();
    ASSERT_EQ(now.devices.size(), 20U);
    for (const DeviceState& device : now.devices) {
        EXPECT_TRUE(device.spec->known) << device.spec->name;
        EXPECT_EQ(device.delay_ms, 40);
        EXPECT_EQ(device.subscribed, device.spec->readable());
        ASSERT_TRUE(device.latency);
        EXPECT_LT(device.latency->median, 20ms);
        EXPECT_EQ(device.line.faults(), 0U);
        for (std::size_t i = 0; i < device.parameters.size(); ++i)
            EXPECT_EQ(device.parameters[i].value.has_value(), device.spec->parameters[i].readable());
        EXPECT_GT(samples_[(SignalId{static_cast<std::uint16_t>(device.number), 10})] +
                      samples_[(SignalId{static_cast<std::uint16_t>(device.number), 0})],
                  40);
    }
}

TEST_F(SmartDeviceTest, ThirtyTwoBoardsAtOnce) {
    std::string devices = "PolarBear";
    for (int i = 1; i < 32; ++i)
        devices += i % 2 == 0 ? ",PolarBear" : ",BatteryBuzzer.hibike";
    start(devices);
    for (int i = 0; i < 32; ++i)
        execute(Subscribe{i, 0xFFFF, 5});
    run(1s);
    for (const DeviceState& device : session_->snapshot().devices) {
        EXPECT_EQ(device.presence, Presence::Live);
        EXPECT_EQ(device.delay_ms, 5);
        EXPECT_GT(device.samples, 150U);
    }
}

TEST_F(SmartDeviceTest, TheLimitIsOfBoardsThatArePluggedIn) {
    sim::SmartDeviceSimOptions options;
    options.boards.assign(kMostKnownDevices + 3, {"Encoder"});
    options.boot = 50ms;
    sim_ = std::make_unique<sim::SmartDeviceSim>(scheduler_, options);
    ASSERT_TRUE(sim_->perform("plugged", -1, 0));
    makeSession();
    for (int i = 0; i < sim_->count(); ++i) {
        ASSERT_TRUE(sim_->perform("plugged", i, 1));
        ASSERT_TRUE(runUntil([&] { return numberOf(i) >= 0; }, 5s)) << i;
        EXPECT_EQ(device(numberOf(i)).presence, Presence::Live);
        ASSERT_TRUE(sim_->perform("plugged", i, 0));
        run(20ms);
    }
    EXPECT_EQ(session_->snapshot().devices.size(), static_cast<std::size_t>(kMostKnownDevices));
    EXPECT_EQ(numberOf(0), -1) << "its number went to another";
    for (int i = 0; i <= kMostDevices; ++i)
        ASSERT_TRUE(sim_->perform("plugged", i, 1));
    ASSERT_TRUE(runUntil([this] { return live() == kMostDevices; }, 10s));
    run(1s);
    EXPECT_EQ(live(), kMostDevices);
    const auto ports = session_->snapshot().ports;
    EXPECT_EQ(std::ranges::count_if(ports, [](const PortState& port) { return port.error.has_value(); }), 1);
}

TEST_F(SmartDeviceTest, TheBoardsResetIsWaitedOut) {
    LinkUri uri{
        .scheme = "sim", .target = "smartdevice", .options = {{"devices", "PolarBear"}, {"boot_ms", "2000"}}};
    sim_ = std::make_unique<sim::SmartDeviceSim>(scheduler_, *sim::parseSimOptions(uri));
    makeSession();
    run(1900ms);
    EXPECT_EQ(live(), 0);
    EXPECT_EQ(session_->snapshot().ports.at(0).phase, PortPhase::Asking);
    run(800ms);
    EXPECT_EQ(live(), 1);
    EXPECT_EQ(session_->snapshot().ports.at(0).phase, PortPhase::Talking);
}

TEST_F(SmartDeviceTest, APortWhereNobodyAnswersIsSilentAndCanBeTriedAgain) {
    start("PolarBear", {}, false);
    sim_->board(0).faults().silent = true;
    run(6s);
    EXPECT_EQ(session_->snapshot().ports.at(0).phase, PortPhase::Silent);
    EXPECT_EQ(count(EventKind::PortSilent), 1);
    EXPECT_FALSE(sim_->board(0).report().lineOpen);
    sim_->board(0).faults().silent = false;
    EXPECT_TRUE(perform(SearchAgain{}));
    EXPECT_TRUE(runUntil([this] { return live() == 1; }, 3s));
}

TEST_F(SmartDeviceTest, AReadWhoseAnswerIsLostIsAskedAgain) {
    start("PolarBear");
    ASSERT_TRUE(perform(Subscribe{0, 0, 0}));
    sim_->board(0).faults().silent = true;
    const CommandId id = execute(ReadValues{0, 1});
    run(150ms);
    sim_->board(0).faults().silent = false;
    ASSERT_TRUE(runUntil([&] { return answers_.contains(id); }, 1s));
    EXPECT_TRUE(answers_[id]);
    sim_->board(0).faults().silent = true;
    const auto lost = perform(ReadValues{0, 1});
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code, Errc::TimedOut);
}

TEST_F(SmartDeviceTest, SeveralRequestsAreInFlightAtOnce) {
    start("ServoControl,PolarBear");
    std::vector<CommandId> ids;
    const int servo = numberOf(0);
    ids.push_back(execute(WriteValues{servo, {{0, wire::Value(0.5F)}}}));
    ids.push_back(execute(WriteValues{servo, {{1, wire::Value(-0.5F)}}}));
    ids.push_back(execute(ReadValues{servo, 3}));
    ids.push_back(execute(ReadValues{numberOf(1), 1}));
    ids.push_back(execute(Subscribe{servo, 3, 100}));
    run(600ms);
    for (const CommandId id : ids) {
        ASSERT_TRUE(answers_.contains(id));
        EXPECT_TRUE(answers_[id]);
    }
    EXPECT_EQ(parameter(servo, "servo0").value, wire::Value(0.5F));
    EXPECT_EQ(parameter(servo, "servo1").value, wire::Value(-0.5F));
    EXPECT_EQ(device(servo).delay_ms, 100);
}

TEST_F(SmartDeviceTest, ABoardIsKnownAgainByItsUidAndNothingIsWritten) {
    start("PolarBear,Encoder");
    const int bear = numberOf(0);
    ASSERT_TRUE(perform(Subscribe{bear, 1, 20}));
    ASSERT_TRUE(write(bear, "duty_cycle", 0.5));
    const auto writes = sim_->board(0).report().writes;
    for (int round = 0; round < 3; ++round) {
        ASSERT_TRUE(sim_->perform("plugged", 0, 0));
        ASSERT_TRUE(runUntil([&] { return device(bear).presence == Presence::Lost; }, 2s));
        EXPECT_FALSE(session_->active());
        const auto gone = write(bear, "duty_cycle", 0.5);
        ASSERT_FALSE(gone);
        EXPECT_EQ(gone.error().code, Errc::NotConnected);
        ASSERT_TRUE(sim_->perform("plugged", 0, 1));
        ASSERT_TRUE(runUntil([&] { return device(bear).presence == Presence::Live; }, 5s));
    }
    run(500ms);
    EXPECT_EQ(session_->snapshot().devices.size(), 2U);
    EXPECT_EQ(count(EventKind::DeviceBack), 3);
    EXPECT_EQ(device(bear).subscribed, 1);
    EXPECT_EQ(device(bear).delay_ms, 20);
    EXPECT_EQ(sim_->board(0).report().writes, writes);
    EXPECT_EQ(sim_->board(0).value(0), wire::Value(0.0F));
}

TEST_F(SmartDeviceTest, AQuietBoardIsQuietThenLostThenFoundAgain) {
    start("Encoder");
    sim_->board(0).faults().silent = true;
    run(1500ms);
    EXPECT_EQ(device(0).presence, Presence::Quiet);
    EXPECT_EQ(count(EventKind::DeviceQuiet), 1);
    run(2s);
    EXPECT_EQ(device(0).presence, Presence::Lost);
    EXPECT_EQ(count(EventKind::DeviceLost), 1);
    sim_->board(0).faults().silent = false;
    EXPECT_TRUE(runUntil([this] { return live() == 1; }, 5s));
    EXPECT_EQ(count(EventKind::DeviceBack), 1);
}

TEST_F(SmartDeviceTest, ABoardThatResetsItselfIsSubscribedAgain) {
    start("BatteryBuzzer");
    ASSERT_TRUE(sim_->perform("reset", 0, 1));
    run(3s);
    EXPECT_EQ(device(0).presence, Presence::Live);
    EXPECT_EQ(count(EventKind::DeviceReset), 1);
    EXPECT_EQ(sim_->board(0).report().subscription.delay_ms, 40);
}

TEST_F(SmartDeviceTest, ALostRequestForUpdatesIsAskedAgain) {
    start("Encoder", {}, false);
    sim_->board(0).faults().deafToSubscriptions = true;
    ASSERT_TRUE(runUntil([this] { return live() == 1; }, 5s));
    run(1200ms);
    EXPECT_EQ(device(0).delay_ms, 0);
    sim_->board(0).faults().deafToSubscriptions = false;
    EXPECT_TRUE(runUntil([this] { return device(0).delay_ms == 40; }, 1s));
    sim_->board(0).faults().deafToSubscriptions = true;
    const CommandId id = execute(Subscribe{0, 1, 100});
    run(700ms);
    sim_->board(0).faults().deafToSubscriptions = false;
    ASSERT_TRUE(runUntil([&] { return answers_.contains(id); }, 1s));
    EXPECT_TRUE(answers_[id]);
    EXPECT_EQ(device(0).delay_ms, 100);
    EXPECT_EQ(count(EventKind::Ungranted), 0);
}

TEST_F(SmartDeviceTest, ABoardThatGrantsNoUpdatesIsToldAndNotAskedForEver) {
    start("Encoder", {}, false);
    sim_->board(0).faults().deafToSubscriptions = true;
    ASSERT_TRUE(runUntil([this] { return live() == 1; }, 5s));
    ASSERT_TRUE(runUntil([this] { return count(EventKind::Ungranted) == 1; }, 8s));
    EXPECT_TRUE(device(0).ungranted);
    const auto heard = sim_->board(0).report().heard.messages;
    run(10s);
    EXPECT_EQ(count(EventKind::Ungranted), 1);
    EXPECT_LT(sim_->board(0).report().heard.messages - heard, 60U) << "heartbeats, and nothing else";
    const auto refused = perform(Subscribe{0, 1, 40});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::TimedOut);
}

TEST_F(SmartDeviceTest, EveryUpdateIsToldToWhoAsksForThat) {
    start("BatteryBuzzer");
    ASSERT_TRUE(perform(Subscribe{0, 0xFFFF, 5, true}));
    run(1s);
    std::int64_t next = -1;
    for (const Event& event : events_) {
        if (event.kind != EventKind::Update) continue;
        EXPECT_TRUE(next < 0 || event.previous == next) << event.previous;
        next = event.previous + 1;
        EXPECT_EQ(event.text.size(), 26U);
    }
    EXPECT_GE(count(EventKind::Update), 190);
}

TEST_F(SmartDeviceTest, AnUnknownKindIsFoundOutAndShownAsBytes) {
    start("Unknown,Unknown.hibike");
    ASSERT_TRUE(runUntil([this] { return !device(0).learning && !device(1).learning; }, 5s));
    run(200ms);
    for (int number = 0; number < 2; ++number) {
        const DeviceState unknown = device(number);
        EXPECT_FALSE(unknown.spec->known);
        EXPECT_EQ(unknown.spec->name, "Device66");
        ASSERT_EQ(unknown.parameters.size(), 3U);
        EXPECT_EQ(wire::toText(*unknown.parameters[0].value), "07");
        EXPECT_EQ(wire::toText(*unknown.parameters[2].value), "34 12");
        wire::RawValue raw;
        raw.append(ByteView(std::vector<std::uint8_t>{0xCD, 0xAB}));
        EXPECT_TRUE(perform(WriteValues{number, {{2, wire::Value(raw)}}}));
        EXPECT_EQ(wire::toText(*device(number).parameters[2].value), "cd ab");
    }
}

TEST_F(SmartDeviceTest, ABadCatalogueFileIsToldAndTheBuiltInOneUsed) {
    catalogue_ = "{ not json";
    start("PolarBear");
    EXPECT_EQ(count(EventKind::CatalogueBad), 1);
    EXPECT_EQ(device(0).spec->name, "PolarBear");
}

TEST_F(SmartDeviceTest, DataThatDoNotFitTheKindAreToldOnceAndDropped) {
    catalogue_ =
        R"({"format": "kickstand-smart-devices", "version": 1, "devices": [{"id": 3, "name": "Encoder",
        "parameters": [{"name": "rotation", "type": "double", "access": "read"}]}]})";
    start("Encoder");
    run(2s);
    EXPECT_EQ(count(EventKind::Misfit), 1);
    EXPECT_FALSE(parameter(0, "rotation").value);
}

TEST_F(SmartDeviceTest, ASessionThatIsDestroyedLeavesNoTimers) {
    start("PolarBear,Encoder,Unknown");
    session_.reset();
    sim_.reset();
    run(1s);
    EXPECT_LE(scheduler_.pending(), 1U) << "the rig's own";
}

/// Noise, truncation and wrong checksums of every strength: nothing is ever believed that was not so, and
/// what is asked for long enough comes.
class SmartDeviceFaults : public SmartDeviceRig, public ::testing::WithParamInterface<double> {};

TEST_P(SmartDeviceFaults, ALineWithFaultsWorksOrSaysSo) {
    start("PolarBear,LimitSwitch.hibike,ServoControl",
          {.lose = GetParam(), .damage = GetParam(), .insert = GetParam()}, false);
    ASSERT_TRUE(runUntil([this] { return session_->snapshot().devices.size() >= 3; }, 300s));
    sim_->board(0).faults() = {.silent = false, .checksum = GetParam(), .truncate = GetParam(), .refuse = 0};
    int written = 0;
    for (int i = 0; i < 100; ++i) {
        run(200ms);
        const int servo = numberOf(2);
        if (servo < 0) continue;
        const double target = (i % 20 - 10) / 10.0;
        if (!write(servo, "servo0", target)) continue;
        if (parameter(servo, "servo0").verdict != WriteVerdict::Done) continue;
        EXPECT_EQ(sim_->board(2).value(0), wire::Value(static_cast<float>(target)));
        ++written;
    }
    EXPECT_GT(written, 30);
    std::uint64_t faults = 0;
    for (const DeviceState& device : session_->snapshot().devices)
        faults += device.line.faults() + device.line.dropped;
    EXPECT_GT(faults, 0U) << "damage is counted";
}

INSTANTIATE_TEST_SUITE_P(Strengths, SmartDeviceFaults, ::testing::Values(0.0005, 0.003, 0.01));

}  // namespace
}  // namespace kickstand::smartdevice::testing
