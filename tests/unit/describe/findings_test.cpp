#include <algorithm>

#include <gtest/gtest.h>

#include "core/engine/describe_findings.h"

namespace kickstand {
namespace {

using State = CheckState;

FoundDevice dongle(std::optional<Errc> obstacle = std::nullopt) {
    FoundDevice device;
    device.uri.scheme = "usb";
    device.info.port = "1-2.3";
    if (obstacle) device.obstacle = Error{.code = *obstacle};
    return device;
}

Finding find(const std::vector<Finding>& findings, Check check) {
    for (const Finding& finding : findings) {
        if (finding.check == check) return finding;
    }
    ADD_FAILURE() << "nothing said about " << name(check);
    return {};
}

/// A link on which all is well, with robots 1 and 3.
thunderbots::Snapshot healthy() {
    thunderbots::Snapshot state;
    state.link = thunderbots::LinkState::Running;
    state.eStop = thunderbots::wire::EStop::Run;
    state.radios = thunderbots::wire::RadioState::Running;
    for (const std::size_t number : {1U, 3U}) {
        state.robots[number].live = true;
        state.robots[number].freshness = thunderbots::Freshness::Current;
        state.robots[number].readings.battery_V = 16;
    }
    return state;
}

TEST(DiagnoseDevices, NothingPluggedIn) {
    const auto findings = diagnoseDevices({});
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(find(findings, Check::Device).state, State::Problem);
    EXPECT_FALSE(describe(findings[0]).remedy.isEmpty());
}

TEST(DiagnoseDevices, AllWell) {
    for (const Finding& finding : diagnoseDevices({dongle()}))
        EXPECT_EQ(finding.state, State::Ok) << name(finding.check);
}

TEST(DiagnoseDevices, PermissionComesWithItsCommand) {
    const auto findings = diagnoseDevices({dongle(Errc::PermissionDenied)});
    EXPECT_EQ(find(findings, Check::Permission).state, State::Problem);
    EXPECT_TRUE(
        describe(find(findings, Check::Permission)).remedyCommand.contains(QStringLiteral("udevadm")));
    EXPECT_EQ(find(findings, Check::Claim).state, State::NotChecked);
}

TEST(DiagnoseDevices, ARuleThatIsThereIsNotToBeInstalledAgain) {
    FoundDevice found = dongle(Errc::PermissionDenied);
    found.rule = "/etc/udev/rules.d/60-kickstand.rules";
    const Description words = describe(find(diagnoseDevices({found}), Check::Permission));
    EXPECT_TRUE(words.what.contains(QStringLiteral("/etc/udev/rules.d/60-kickstand.rules")));
    EXPECT_TRUE(words.remedyCommand.contains(QStringLiteral("plugdev")));
    EXPECT_FALSE(words.remedyCommand.contains(QStringLiteral("tee")));
}

TEST(DiagnoseDevices, SaysWhichRuleLetsTheUserIn) {
    FoundDevice found = dongle();
    EXPECT_TRUE(
        describe(find(diagnoseDevices({found}), Check::Permission)).what.contains(QStringLiteral("without")));
    found.rule = "/lib/udev/rules.d/60-kickstand.rules";
    EXPECT_TRUE(describe(find(diagnoseDevices({found}), Check::Permission))
                    .what.contains(QStringLiteral("/lib/udev")));
}

TEST(DiagnoseDevices, NamesWhoHoldsIt) {
    FoundDevice held = dongle(Errc::ClaimedElsewhere);
    held.holder = DeviceHolder{4242, "soccer"};
    const auto findings = diagnoseDevices({held});
    EXPECT_EQ(find(findings, Check::Claim).state, State::Problem);
    EXPECT_TRUE(
        describe(find(findings, Check::Claim)).what.contains(QStringLiteral("soccer (process 4242)")));
}

TEST(DiagnoseDevices, SaysWhenItCannotSeeWho) {
    const auto findings = diagnoseDevices({dongle(Errc::ClaimedElsewhere)});
    EXPECT_EQ(find(findings, Check::Claim).state, State::Problem);
    EXPECT_TRUE(describe(find(findings, Check::Claim)).remedy.contains(QStringLiteral("root")));
}

TEST(DiagnoseLink, AllWell) {
    for (const Finding& finding : diagnoseLink(healthy()))
        EXPECT_EQ(finding.state, State::Ok) << name(finding.check);
    EXPECT_TRUE(describe(find(diagnoseLink(healthy()), Check::Robots)).what.contains(QStringLiteral("1, 3")));
}

TEST(DiagnoseLink, TheEmergencyStop) {
    for (const auto position : {thunderbots::wire::EStop::Disconnected, thunderbots::wire::EStop::Stop}) {
        auto state = healthy();
        state.eStop = position;
        const Finding finding = find(diagnoseLink(state), Check::EmergencyStop);
        EXPECT_EQ(finding.state, State::Problem);
        EXPECT_FALSE(describe(finding).remedy.isEmpty());
    }
}

TEST(DiagnoseLink, NoRobotLeavesFeedbackOpen) {
    auto state = healthy();
    state.robots = {};
    EXPECT_EQ(find(diagnoseLink(state), Check::Robots).state, State::Problem);
    EXPECT_EQ(find(diagnoseLink(state), Check::Feedback).state, State::NotChecked);
}

TEST(DiagnoseLink, ARobotWithoutReadings) {
    auto state = healthy();
    state.robots[3].freshness = thunderbots::Freshness::Waiting;
    const Finding finding = find(diagnoseLink(state), Check::Feedback);
    EXPECT_EQ(finding.state, State::Problem);
    EXPECT_TRUE(describe(finding).what.endsWith(QStringLiteral("robot 3.")));
}

TEST(DiagnoseLink, ALowBatteryAndDamageOnlyWarn) {
    auto state = healthy();
    state.robots[1].readings.battery_V = 14.5;
    state.traffic.malformed = 2;
    EXPECT_EQ(find(diagnoseLink(state), Check::Battery).state, State::Warning);
    EXPECT_EQ(find(diagnoseLink(state), Check::Traffic).state, State::Warning);
}

TEST(DiagnoseLink, ACableNeedsNoRadios) {
    auto state = healthy();
    state.cable = true;
    state.radios = thunderbots::wire::RadioState::PreInit;
    EXPECT_EQ(find(diagnoseLink(state), Check::Radios).state, State::Ok);
}

template <class State>
std::vector<Finding> diagnosed(const char* uri, State state) {
    SessionSnapshot snapshot;
    snapshot.uri = *parseLinkUri(uri);
    snapshot.system = std::move(state);
    return diagnoseSession(snapshot);
}

constexpr const char* kNxt = "serial:/dev/rfcomm0?protocol=motionplan";

TEST(DiagnoseSerial, AnNxtThatAnswersIsWellAndNothingIsSaidOfRadiosAndRobots) {
    motionplan::Snapshot state;
    state.link = motionplan::LinkState::Running;
    state.port.port = "/dev/rfcomm0";
    state.answers = true;
    const auto findings = diagnosed(kNxt, state);
    std::vector<std::string> checks;
    for (const Finding& finding : findings) {
        checks.emplace_back(name(finding.check));
        EXPECT_EQ(finding.state, State::Ok) << name(finding.check);
        EXPECT_TRUE(describe(finding).what.endsWith(QLatin1Char('.'))) << name(finding.check);
    }
    EXPECT_EQ(checks, (std::vector<std::string>{"device", "permission", "claim", "link", "answers"}));
    EXPECT_TRUE(describe(find(findings, Check::Device)).what.contains(QStringLiteral("/dev/rfcomm0")));
}

TEST(DiagnoseSerial, WhatIsWrongWithThePortIsSaidWhereItBelongs) {
    const std::pair<Errc, Check> cases[] = {{Errc::NoDevice, Check::Device},
                                            {Errc::PermissionDenied, Check::Permission},
                                            {Errc::ClaimedElsewhere, Check::Claim},
                                            {Errc::Io, Check::Link}};
    for (const auto& [code, check] : cases) {
        motionplan::Snapshot state;
        state.link =
            code == Errc::NoDevice ? motionplan::LinkState::Searching : motionplan::LinkState::Failed;
        state.error = Error{.code = code, .port = "/dev/rfcomm0"};
        const auto findings = diagnosed(kNxt, state);
        bool after = false;
        for (const Finding& finding : findings) {
            const State expected = after                    ? State::NotChecked
                                   : finding.check == check ? State::Problem
                                                            : State::Ok;
            EXPECT_EQ(finding.state, expected) << name(code) << ' ' << name(finding.check);
            after = after || finding.check == check;
        }
        const Description words = describe(find(findings, check));
        EXPECT_TRUE(words.what.contains(QStringLiteral("/dev/rfcomm0"))) << words.what.toStdString();
        EXPECT_FALSE(words.remedy.isEmpty());
    }
}

TEST(DiagnoseSerial, AnNxtThatIsSilentOrRunsNoProgramIsWrong) {
    motionplan::Snapshot state;
    state.link = motionplan::LinkState::Running;
    Finding answers = find(diagnosed(kNxt, state), Check::Answers);
    EXPECT_EQ(answers.state, State::Problem);
    EXPECT_TRUE(describe(answers).what.contains(QStringLiteral("no NXT answers")));
    state.answers = true;
    state.nxtStatus = 0xEC;
    answers = find(diagnosed(kNxt, state), Check::Answers);
    EXPECT_EQ(answers.state, State::Problem);
    EXPECT_TRUE(describe(answers).remedy.contains(QStringLiteral("Start the robot's program")));
}

TEST(DiagnoseSerial, APortWithoutARadioModuleIsOpenAndDoesNotAnswer) {
    coach::Snapshot state;
    state.link = coach::LinkState::NoModule;
    const auto findings = diagnosed("serial:/dev/ttyUSB0?protocol=coach", state);
    EXPECT_EQ(find(findings, Check::Link).state, State::Ok);
    EXPECT_EQ(find(findings, Check::Answers).state, State::Problem);
    state.link = coach::LinkState::Running;
    EXPECT_EQ(find(diagnosed("sim:coach", state), Check::Answers).state, State::Ok);
}

TEST(DiagnoseSerial, BoardsAreCountedAndPortsThatCannotBeOpenedNamed) {
    smartdevice::Snapshot state;
    state.link = smartdevice::LinkState::Running;
    EXPECT_EQ(find(diagnosed("serial:", state), Check::Answers).state, State::Problem);
    EXPECT_EQ(find(diagnosed("serial:/dev/ttyACM0", state), Check::Device).state, State::Problem);
    EXPECT_EQ(find(diagnosed("serial:/dev/ttyACM0", state), Check::Answers).state, State::NotChecked);
    state.devices.resize(2);
    state.devices[1].presence = smartdevice::Presence::Live;
    smartdevice::PortState& port = state.ports.emplace_back();
    port.name = "/dev/ttyACM1";
    port.error = Error{.code = Errc::PermissionDenied, .port = "/dev/ttyACM1"};
    const auto findings = diagnosed("serial:", state);
    EXPECT_EQ(find(findings, Check::Permission).state, State::Problem);
    EXPECT_TRUE(describe(find(findings, Check::Permission)).what.contains(QStringLiteral("ttyACM1")));
    EXPECT_EQ(find(findings, Check::Answers).state, State::Ok);
    EXPECT_TRUE(describe(find(findings, Check::Answers)).what.contains(QStringLiteral(": 1")));
}

TEST(Diagnose, ASessionOnASerialPortIsNotAskedForItsDongle) {
    SessionSnapshot snapshot;
    snapshot.uri = *parseLinkUri(kNxt);
    motionplan::Snapshot state;
    state.link = motionplan::LinkState::Searching;
    state.error = Error{.code = Errc::NoDevice, .port = "/dev/rfcomm0"};
    snapshot.system = state;
    EngineSnapshot engine;
    engine.discovered = true;
    const auto findings = diagnose(engine, &snapshot);
    EXPECT_EQ(std::ranges::count(findings, Check::Device, &Finding::check), 1);
    EXPECT_TRUE(describe(find(findings, Check::Device)).what.contains(QStringLiteral("serial port")));
    EXPECT_EQ(std::ranges::count(findings, Check::Stop, &Finding::check), 1);
    EXPECT_EQ(std::ranges::count(findings, Check::Radios, &Finding::check), 0);
}

SessionSnapshot session(const char* uri, thunderbots::Snapshot state) {
    SessionSnapshot snapshot;
    snapshot.id = 1;
    snapshot.uri = *parseLinkUri(uri);
    snapshot.system = std::move(state);
    return snapshot;
}

TEST(Diagnose, NothingIsKnownBeforeTheFirstLook) {
    const auto findings = diagnose(EngineSnapshot{}, nullptr);
    EXPECT_EQ(find(findings, Check::Device).state, State::NotChecked);
    EXPECT_EQ(find(findings, Check::Link).state, State::Problem);
    EXPECT_EQ(find(findings, Check::Robots).state, State::NotChecked);
    EXPECT_FALSE(isWell(findings));
}

TEST(Diagnose, WithoutALinkTheDevicesAreLookedAt) {
    EngineSnapshot engine;
    engine.discovered = true;
    engine.found = {dongle(Errc::PermissionDenied)};
    const auto findings = diagnose(engine, nullptr);
    EXPECT_EQ(find(findings, Check::Permission).state, State::Problem);
    EXPECT_EQ(describe(find(findings, Check::Link)).remedy, QStringLiteral("Connect first."));
}

TEST(Diagnose, ASimulatedLinkNeedsNoDevice) {
    const SessionSnapshot shown = session("sim:thunderbots", healthy());
    const auto findings = diagnose(EngineSnapshot{}, &shown);
    EXPECT_TRUE(isWell(findings));
    for (const Finding& finding : findings) {
        EXPECT_EQ(finding.state, State::Ok) << name(finding.check);
        EXPECT_NE(finding.check, Check::Device);
        EXPECT_FALSE(describe(finding).what.isEmpty()) << name(finding.check);
    }
}

TEST(Diagnose, ALatchedStopIsSaidWithItsRemedy) {
    EngineSnapshot engine;
    engine.stop = StopReason::RobotLost;
    const SessionSnapshot shown = session("usb:", healthy());
    const Finding stop = find(diagnose(engine, &shown), Check::Stop);
    EXPECT_EQ(stop.state, State::Problem);
    EXPECT_TRUE(describe(stop).remedy.contains(QStringLiteral("re-arm")));
}

TEST(Diagnose, AFailedLinkLeavesWhatIsBehindItOpen) {
    thunderbots::Snapshot state;
    state.link = thunderbots::LinkState::Failed;
    state.error = Error{.code = Errc::RadioFailed, .got = 1};
    const SessionSnapshot shown = session("usb:", state);
    EngineSnapshot engine;
    engine.discovered = true;
    engine.found = {dongle()};
    const auto findings = diagnose(engine, &shown);
    EXPECT_EQ(find(findings, Check::Claim).state, State::Ok);
    EXPECT_EQ(find(findings, Check::Link).state, State::Problem);
    EXPECT_EQ(find(findings, Check::Radios).state, State::NotChecked);
}

TEST(Diagnose, ALinkOnItsWayIsNoFailure) {
    thunderbots::Snapshot state;
    state.link = thunderbots::LinkState::Searching;
    const SessionSnapshot shown = session("sim:thunderbots", state);
    EXPECT_EQ(find(diagnose(EngineSnapshot{}, &shown), Check::Link).state, State::Warning);
}

}  // namespace
}  // namespace kickstand
