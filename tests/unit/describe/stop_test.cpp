// What the banner says that STOP has done.

#include <gtest/gtest.h>

#include "core/engine/describe_stop.h"

namespace kickstand {
namespace {

using namespace smartdevice;

DeviceState board(const char* kind, Presence presence) {
    const auto catalogue = makeCatalogue();
    DeviceState state;
    state.spec = catalogue->find(kind);
    state.port = std::string("/dev/") + kind;
    state.presence = presence;
    state.disabled = presence == Presence::Live;
    return state;
}

QString said(const Snapshot& snapshot) {
    return stoppedText(snapshot, StopReason::Person);
}

TEST(DescribeStop, EveryBoardIsSaidToBeToldOnlyWhereAllWere) {
    Snapshot snapshot;
    EXPECT_TRUE(said(snapshot).contains(QStringLiteral("no board"))) << qPrintable(said(snapshot));
    snapshot.devices = {board("PolarBear", Presence::Live), board("ServoControl", Presence::Live)};
    const QString all = said(snapshot);
    EXPECT_TRUE(all.contains(QStringLiteral("every board was disabled"))) << qPrintable(all);
    snapshot.devices[1].disabled = false;
    const QString owed = said(snapshot);
    EXPECT_FALSE(owed.contains(QStringLiteral("every board"))) << qPrintable(owed);
    EXPECT_TRUE(owed.contains(QStringLiteral("ServoControl at /dev/ServoControl (its port takes nothing)")))
        << qPrintable(owed);
    EXPECT_FALSE(owed.contains(QStringLiteral("PolarBear"))) << qPrintable(owed);
    EXPECT_TRUE(owed.contains(QStringLiteral("all others"))) << qPrintable(owed);
}

TEST(DescribeStop, BoardsThatAreLostOrSilentAndBusyPortsAreNamed) {
    Snapshot snapshot;
    snapshot.devices = {board("PolarBear", Presence::Lost), board("ServoControl", Presence::Quiet)};
    snapshot.ports.resize(2);
    snapshot.ports[1].name = "/dev/busy";
    snapshot.ports[1].error = Error{.code = Errc::ClaimedElsewhere, .port = "/dev/busy"};
    const QString text = said(snapshot);
    for (const char* named : {"PolarBear at /dev/PolarBear (lost)", "ServoControl", "/dev/busy"})
        EXPECT_TRUE(text.contains(QLatin1String(named))) << named << ": " << qPrintable(text);
    EXPECT_FALSE(text.contains(QStringLiteral("disabled"))) << "nobody was told: " << qPrintable(text);
}

TEST(StoppedText, ARobotThatIsNoLongerHeardIsNamedAsPerhapsNotTold) {
    thunderbots::Snapshot robots;
    robots.robots[3].live = true;
    robots.robots[3].feedback.emplace();
    robots.robots[5].feedback.emplace();
    const QString text = stoppedText(robots, StopReason::RobotLost);
    EXPECT_TRUE(text.contains(QStringLiteral("perhaps not told: robot 5."))) << text.toStdString();
    EXPECT_TRUE(text.contains(QStringLiteral("kick that the dongle already held"))) << text.toStdString();
    robots.robots[5].live = true;
    EXPECT_TRUE(
        stoppedText(robots, StopReason::RobotLost).startsWith(QStringLiteral("Every robot was told")));
}

}  // namespace
}  // namespace kickstand
