// What the panels of the smart devices say when something does not go as it should.
#include <QLineEdit>

#include "tests/ui/board_window.h"
#include "ui/smartdevice/device_list.h"

namespace kickstand::test {
namespace {

class BoardsTrouble : public BoardWindow {
  protected:
    /// Connects to one that hears everything and says nothing any more.
    void connectToMute(const char* kind) {
        connectTo(kind);
        choose(QLatin1String(kind));
        simulate("silent", 0, 1);
        ASSERT_TRUE(waitFor([&] {
            return std::ranges::any_of(bench->session()->simReadings, [](const SimReading& reading) {
                return reading.action == "silent" && reading.value == 1;
            });
        }));
    }
};

TEST_F(BoardsTrouble, ABusyPortSaysSoWithTheRemedy) {
    connectInVain(Errc::ClaimedElsewhere);
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text == QStringLiteral("busy"); }));
    EXPECT_EQ(line(0).standing.tone, ui::Tone::Danger);
    const QString remedy = text(QStringLiteral("boardsRemedy"));
    EXPECT_TRUE(remedy.contains(QStringLiteral("simulated-0"))) << remedy.toStdString();
    EXPECT_TRUE(remedy.contains(QStringLiteral("Close"))) << remedy.toStdString();
}

TEST_F(BoardsTrouble, APortThatIsNotPermittedSaysSoWithTheRemedy) {
    connectInVain(Errc::PermissionDenied);
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text == QStringLiteral("not permitted"); }));
    const QString remedy = text(QStringLiteral("boardsRemedy"));
    EXPECT_TRUE(remedy.contains(QStringLiteral("dialout"))) << remedy.toStdString();
}

TEST_F(BoardsTrouble, BytesOfABoardThatNobodyKnowsAreShownAndWritten) {
    connectTo("Unknown");
    choose(QStringLiteral("Device66"));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value2")) == QStringLiteral("34 12"); }));
    type(2, QStringLiteral("nothing"));
    ASSERT_TRUE(waitForVerdict(2, "not sent"));
    EXPECT_TRUE(writes.messages().empty());
    type(2, QStringLiteral("CD ab"));
    ASSERT_TRUE(waitForWrite("14 04 04 00 cd ab 72"));
    ASSERT_TRUE(waitForVerdict(2, "done"));
    ASSERT_TRUE(waitFor([&] { return text(QStringLiteral("value2")) == QStringLiteral("cd ab"); }));
    // Too many bytes.
    type(2, QStringLiteral("01 02 03"));
    ASSERT_TRUE(waitForVerdict(2, "not sent"));
}

TEST_F(BoardsTrouble, WhatWasSentAndNotAnsweredIsNotSaidToBeUnsent) {
    connectToMute("PolarBear");
    type(0, QStringLiteral("0.25"));
    ASSERT_TRUE(waitForWrite("14 06 01 00 00 00 80 3e ad"));
    ASSERT_TRUE(waitForVerdict(0, "sent, no answer"));
    // A board that is not there any more is not written to.
    ASSERT_TRUE(waitFor([&] { return !editor(0)->isEnabled(); }));
    EXPECT_EQ(verdict(0), QStringLiteral("sent, no answer"));
}

TEST_F(BoardsTrouble, AWriteWhoseBoardIsPulledOutIsSaidToHaveLostIt) {
    connectToMute("PolarBear");
    type(0, QStringLiteral("0.25"));
    simulate("plugged", 0, 0);
    ASSERT_TRUE(waitForVerdict(0, "lost before it answered"));
    EXPECT_EQ(writes.last(), "14 06 01 00 00 00 80 3e ad");
    ASSERT_TRUE(waitFor([&] { return line(0).standing.text.startsWith(QStringLiteral("lost")); }));
    EXPECT_EQ(verdict(0), QStringLiteral("lost before it answered"));
}

TEST_F(BoardsTrouble, AWriteThatEndsWithStopIsSaidToBeStopped) {
    connectToMute("PolarBear");
    type(0, QStringLiteral("0.25"));
    client->stop(StopReason::Person);
    ASSERT_TRUE(waitForVerdict(0, "stopped"));
    ASSERT_TRUE(waitForWrite("16 00 16"));
}

TEST_F(BoardsTrouble, APositionDrivesTooAndIsStoppedWithThePanel) {
    connectTo("ServoControl");
    choose(QStringLiteral("ServoControl"));
    type(0, QStringLiteral("0.5"));
    ASSERT_TRUE(waitFor([&] { return bench->isMoving(); }));
    EXPECT_TRUE(waitFor([&] { return line(0).standing.text == QStringLiteral("drives"); }));
    click(QStringLiteral("boardDisable"));
    ASSERT_TRUE(waitForWrite("16 00 16"));
    EXPECT_TRUE(waitFor([&] { return !bench->isMoving(); }));
}

}  // namespace
}  // namespace kickstand::test
