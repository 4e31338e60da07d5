#include "app/kickstandctl/diagnosis.h"

#include <gtest/gtest.h>

namespace kickstand::ctl {
namespace {

using State = Finding::State;

const HolderFinder kNobody = [](const std::string&) { return std::nullopt; };

FoundDevice dongle(std::optional<Errc> obstacle = std::nullopt) {
    FoundDevice device;
    device.uri.scheme = "usb";
    device.info.port = "1-2.3";
    if (obstacle) device.obstacle = Error{.code = *obstacle};
    return device;
}

const Finding& find(const std::vector<Finding>& findings, std::string_view check) {
    static const Finding kNone{"none", State::NotChecked, {}};
    for (const Finding& finding : findings) {
        if (finding.check == check) return finding;
    }
    ADD_FAILURE() << "nothing said about " << check;
    return kNone;
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
    const auto findings = diagnoseDevices({}, kNobody);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(find(findings, "device").state, State::Problem);
    EXPECT_FALSE(findings[0].text.remedy.isEmpty());
}

TEST(DiagnoseDevices, AllWell) {
    for (const Finding& finding : diagnoseDevices({dongle()}, kNobody))
        EXPECT_EQ(finding.state, State::Ok) << finding.check;
}

TEST(DiagnoseDevices, PermissionComesWithItsCommand) {
    const auto findings = diagnoseDevices({dongle(Errc::PermissionDenied)}, kNobody);
    EXPECT_EQ(find(findings, "permission").state, State::Problem);
    EXPECT_TRUE(find(findings, "permission").text.remedyCommand.contains(QStringLiteral("udevadm")));
    EXPECT_EQ(find(findings, "claim").state, State::NotChecked);
}

TEST(DiagnoseDevices, NamesWhoHoldsIt) {
    std::string asked;
    const auto findings =
        diagnoseDevices({dongle(Errc::ClaimedElsewhere)}, [&asked](const std::string& port) {
            asked = port;
            return std::optional(Holder{4242, "soccer"});
        });
    EXPECT_EQ(asked, "1-2.3");
    EXPECT_EQ(find(findings, "claim").state, State::Problem);
    EXPECT_TRUE(find(findings, "claim").text.what.contains(QStringLiteral("soccer (process 4242)")));
}

TEST(DiagnoseDevices, SaysWhenItCannotSeeWho) {
    const auto findings = diagnoseDevices({dongle(Errc::ClaimedElsewhere)}, kNobody);
    EXPECT_EQ(find(findings, "claim").state, State::Problem);
    EXPECT_TRUE(find(findings, "claim").text.remedy.contains(QStringLiteral("root")));
}

TEST(DiagnoseLink, AllWell) {
    for (const Finding& finding : diagnoseLink(healthy()))
        EXPECT_EQ(finding.state, State::Ok) << finding.check;
    EXPECT_TRUE(find(diagnoseLink(healthy()), "robots").text.what.contains(QStringLiteral("1, 3")));
}

TEST(DiagnoseLink, TheEmergencyStop) {
    for (const auto position : {thunderbots::wire::EStop::Disconnected, thunderbots::wire::EStop::Stop}) {
        auto state = healthy();
        state.eStop = position;
        const Finding finding = find(diagnoseLink(state), "e-stop");
        EXPECT_EQ(finding.state, State::Problem);
        EXPECT_FALSE(finding.text.remedy.isEmpty());
    }
}

TEST(DiagnoseLink, NoRobotLeavesFeedbackOpen) {
    auto state = healthy();
    state.robots = {};
    EXPECT_EQ(find(diagnoseLink(state), "robots").state, State::Problem);
    EXPECT_EQ(find(diagnoseLink(state), "feedback").state, State::NotChecked);
}

TEST(DiagnoseLink, ARobotWithoutReadings) {
    auto state = healthy();
    state.robots[3].freshness = thunderbots::Freshness::Waiting;
    const Finding finding = find(diagnoseLink(state), "feedback");
    EXPECT_EQ(finding.state, State::Problem);
    EXPECT_TRUE(finding.text.what.endsWith(QStringLiteral("robot 3.")));
}

TEST(DiagnoseLink, ALowBatteryAndDamageOnlyWarn) {
    auto state = healthy();
    state.robots[1].readings.battery_V = 14.5;
    state.traffic.malformed = 2;
    EXPECT_EQ(find(diagnoseLink(state), "battery").state, State::Warning);
    EXPECT_EQ(find(diagnoseLink(state), "traffic").state, State::Warning);
}

TEST(DiagnoseLink, ACableNeedsNoRadios) {
    auto state = healthy();
    state.cable = true;
    state.radios = thunderbots::wire::RadioState::PreInit;
    EXPECT_EQ(find(diagnoseLink(state), "radios").state, State::Ok);
}

}  // namespace
}  // namespace kickstand::ctl
