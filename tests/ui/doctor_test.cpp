// "Why does it not work?": reached from everywhere, right at once, and right again when something changes.

#include <QAbstractButton>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QMenu>

#include "tests/ui/bench_rig.h"
#include "ui/shell/doctor_window.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;

class DoctorTest : public testing::Test {
  protected:
    ui::DoctorWindow* doctor() { return rig.find<ui::DoctorWindow>(QStringLiteral("doctor")); }
    /// The line about a check.
    QWidget* line(const char* check) {
        return doctor()->findChild<QWidget*>(QLatin1String("doctor-") + QLatin1String(check));
    }
    bool waitFor(const char* check, const QString& words) {
        return waitUntil([this, check, &words] {
            const QWidget* found = line(check);
            return found != nullptr && found->accessibleName().contains(words);
        });
    }
    ui::Tone verdict() { return doctor()->findChild<ui::StateLabel*>(QStringLiteral("verdict"))->tone(); }

    BenchRig rig;
};

TEST_F(DoctorTest, FromTheStartPageItSaysWhatIsMissing) {
    rig.click(QStringLiteral("startDoctor"));
    EXPECT_TRUE(doctor()->isVisible());
    EXPECT_TRUE(waitFor("device", QStringLiteral("wrong. No dongle or cabled robot is plugged in")));
    EXPECT_TRUE(waitFor("link", QStringLiteral("Connect first")));
    EXPECT_TRUE(waitFor("robots", QStringLiteral("unknown")));
    EXPECT_EQ(verdict(), ui::Tone::Danger);
}

TEST_F(DoctorTest, TheRemedyOfAForbiddenDeviceIsCopied) {
    FoundDevice found;
    found.uri.scheme = "usb";
    found.info.port = "1-2.3";
    found.obstacle = Error{.code = Errc::PermissionDenied};
    rig.board().setFound({found});
    rig.click(QStringLiteral("startDoctor"));
    ASSERT_TRUE(waitFor("permission", QStringLiteral("may not open it")));
    auto* copy = line("permission")->findChild<QAbstractButton*>(QStringLiteral("copyCommand"));
    ASSERT_TRUE(copy->isVisible());
    copy->click();
    EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("udevadm")));
}

TEST_F(DoctorTest, FromTheStatusStripEverythingIsWell) {
    ASSERT_TRUE(rig.connectTo());
    rig.click(QStringLiteral("doctorButton"));
    EXPECT_TRUE(waitFor("link", QStringLiteral("ok. sim:thunderbots?robots=0-5 runs: simulated dongle.")));
    EXPECT_TRUE(waitFor("robots", QStringLiteral("Heard: robots 0-5")));
    // Robot 5's battery is low from the beginning: nothing that keeps anything from working.
    EXPECT_TRUE(waitUntil([this] { return verdict() == ui::Tone::Warning; }));
    EXPECT_EQ(line("device"), nullptr);
}

TEST_F(DoctorTest, ItFollowsWhatHappensWhileItIsOpen) {
    ASSERT_TRUE(rig.connectTo());
    for (QAction* action : rig.find<QMenu>(QStringLiteral("helpMenu"))->actions()) {
        if (action->objectName() == QStringLiteral("doctorAction")) action->trigger();
    }
    ASSERT_TRUE(waitFor("e-stop", QStringLiteral("ok")));
    rig.simulate("e-stop", -1, 2);
    EXPECT_TRUE(waitFor("e-stop", QStringLiteral("wrong")));
    EXPECT_EQ(verdict(), ui::Tone::Danger);
    rig.simulate("e-stop", -1, 3);
    EXPECT_TRUE(waitFor("e-stop", QStringLiteral("ok")));
    EXPECT_TRUE(waitFor("stop", QStringLiteral("wrong. Everything is stopped: the emergency stop left")));
    ASSERT_TRUE(rig.rearm());
    EXPECT_TRUE(waitFor("stop", QStringLiteral("ok")));
    rig.client().stop(StopReason::Person);
    EXPECT_TRUE(waitFor("stop", QStringLiteral("wrong. Everything is stopped: by hand.")));
    ASSERT_TRUE(rig.rearm());
    EXPECT_TRUE(waitFor("stop", QStringLiteral("ok")));
    rig.simulate("battery", 1, 14.5);
    EXPECT_TRUE(waitFor("battery", QStringLiteral("look. The battery is low: robot")));
    rig.simulate("plugged", -1, 0);
    EXPECT_TRUE(waitFor("link", QStringLiteral("plug")));
    EXPECT_TRUE(waitFor("robots", QStringLiteral("unknown")));
}

TEST_F(DoctorTest, TheWholeReportIsCopied) {
    ASSERT_TRUE(rig.connectTo());
    rig.click(QStringLiteral("doctorButton"));
    ASSERT_TRUE(waitFor("traffic", QStringLiteral("ok")));
    doctor()->findChild<QAbstractButton*>(QStringLiteral("copyReport"))->click();
    const QString report = QApplication::clipboard()->text();
    EXPECT_EQ(report.count(u'\n'), 8);
    EXPECT_TRUE(report.contains(QStringLiteral("Emergency stop")));
}

}  // namespace
}  // namespace kickstand::test
