// A gamepad to the bytes on the wire: drives, kicks, stops, is lost and comes back.

#include "ui/thunderbots/drive_pad.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QSpinBox>
#include <QTest>

#include "tests/ui/bench_rig.h"
#include "ui/thunderbots/drive_control.h"
#include "ui/thunderbots/drive_pad_panel.h"
#include "ui/thunderbots/kick_settings.h"
#include "ui/widgets/state_label.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using wire::DriveBlock;

/// What is plugged in, and how it stands: the test's to change.
struct FakePads {
    std::vector<ui::PadInfo> plugged{{1, "Fake pad", "0011", true}};
    ui::PadState state{std::vector<double>(6, 0.0), std::vector<bool>(15, false)};
};

class FakeSource final : public ui::PadSource {
  public:
    explicit FakeSource(FakePads& pads) : pads_(pads) {}

    void update() override { seen_ = pads_; }
    std::vector<ui::PadInfo> pads() const override { return seen_.plugged; }
    std::optional<ui::PadState> state(int id) const override {
        for (const ui::PadInfo& pad : seen_.plugged) {
            if (pad.id == id) return seen_.state;
        }
        return std::nullopt;
    }

  private:
    FakePads& pads_;
    FakePads seen_;
};

constexpr int kKickButton = 10;
constexpr int kStopButton = 1;
constexpr int kDribblerButton = 0;

class PadTest : public BenchTest {
  protected:
    void SetUp() override {
        BenchTest::SetUp();
        auto& view = *static_cast<const ui::ThunderbotsView*>(rig.bench().view());
        control = std::make_unique<ui::DriveControl>(view.choice());
        control->attach(rig.bench());
        kick.attach(rig.settings());
        pad = new ui::DrivePad(rig.bench(), *control, kick,
                               [this] { return std::make_unique<FakeSource>(pads); });
        panel = std::make_unique<ui::DrivePadPanel>(rig.bench(), *control, pad);
        panel->resize(640, 320);
        panel->show();
        rig.clickRobot(3);
        ASSERT_TRUE(rig.settle());
        ASSERT_TRUE(waitUntil([this] { return pad->isThere(); }));
        button("padOn")->click();
        ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
        rig.wire().clear();
    }

    QAbstractButton* button(const char* name) {
        auto* found = panel->findChild<QAbstractButton*>(QLatin1String(name));
        EXPECT_NE(found, nullptr) << name;
        return found;
    }
    bool warns() { return panel->findChild<ui::StateLabel*>(QStringLiteral("padSign"))->isVisible(); }
    QString says() { return panel->findChild<QLabel*>(QStringLiteral("padState"))->text(); }
    void push(int axis, double to) { pads.state.axes[static_cast<std::size_t>(axis)] = to; }
    void hold(int which, bool down) { pads.state.buttons[static_cast<std::size_t>(which)] = down; }
    bool waitForward() {
        return rig.waitForBlock(3, [](const DriveBlock& b) { return b.wheels[3] > 0 && b.wheels[0] < 0; });
    }
    bool waitZero() {
        return rig.waitForBlock(
            3, [](const DriveBlock& b) { return b.wheels == std::array<std::int16_t, 4>{}; });
    }
    /// Waits until the pad has been looked at some more.
    bool look() {
        int seen = 0;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, &timer, [&seen] { ++seen; });
        timer.start(std::chrono::milliseconds(8));
        return waitUntil([&seen] { return seen >= 6; }) && rig.settle();
    }

    FakePads pads;
    ui::KickSettings kick;
    std::unique_ptr<ui::DriveControl> control;
    ui::DrivePad* pad = nullptr;
    std::unique_ptr<ui::DrivePadPanel> panel;
};

TEST_F(PadTest, AStickDrivesTheBodyAndLettingItGoStops) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& b) { return b.wheels[3] == 100; }));
    push(1, 0);
    EXPECT_TRUE(waitZero());
}

TEST_F(PadTest, InTheOtherWayEachStickDrivesTheWheelsOfItsSide) {
    button("padWheels")->click();
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    push(1, -1);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& b) {
        return b.wheels == std::array<std::int16_t, 4>{-100, -100, 0, 0};
    }));
    push(1, 0);
    push(3, -1);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& b) {
        return b.wheels == std::array<std::int16_t, 4>{0, 0, 100, 100};
    }));
    push(3, 0);
    button("padBody")->click();
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    push(1, -1);
    EXPECT_TRUE(waitForward());
}

TEST_F(PadTest, OneOfSeveralIsChosenAndOnlyThatDrives) {
    pads.plugged.push_back({2, "Another pad", "0022", true});
    auto* names = panel->findChild<QComboBox*>(QStringLiteral("pads"));
    ASSERT_TRUE(waitUntil([names] { return names->count() == 2; }));
    EXPECT_EQ(names->currentText(), QStringLiteral("Fake pad"));
    names->setCurrentIndex(1);
    emit names->activated(1);
    ASSERT_TRUE(waitUntil([this] { return pad->chosen().id == 2 && pad->isThere(); }));
    EXPECT_EQ(names->currentText(), QStringLiteral("Another pad"));
    pads.plugged.erase(pads.plugged.begin() + 1);
    ASSERT_TRUE(waitUntil([this] { return !pad->isThere(); }));
    push(1, -1);
    ASSERT_TRUE(look());
    EXPECT_FALSE(rig.wire().last(3) && rig.wire().last(3)->run) << "the other one is not taken for it";
}

TEST_F(PadTest, OneThatIsLostBrakesAtOnceAndMustPassNeutralWhenItIsBack) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    rig.wire().clear();
    pads.plugged.clear();
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.run; }));
    EXPECT_TRUE(says().contains(QStringLiteral("gone"))) << says().toStdString();
    EXPECT_TRUE(warns());
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    pads.plugged = {{2, "Fake pad", "0011", true}};
    ASSERT_TRUE(waitUntil([this] { return pad->isThere(); }));
    ASSERT_TRUE(look());
    EXPECT_TRUE(pad->awaitsNeutral());
    EXPECT_TRUE(says().contains(QStringLiteral("Let go of both sticks"))) << says().toStdString();
    EXPECT_TRUE(warns());
    EXPECT_FALSE(rig.wire().last(3).has_value());
    push(1, 0);
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    push(1, -1);
    EXPECT_TRUE(waitForward());
    EXPECT_TRUE(says().contains(QStringLiteral("It drives"))) << says().toStdString();
    EXPECT_FALSE(warns());
}

TEST_F(PadTest, BackWithAStickThatIsHeldItNeitherKicksNorDribbles) {
    rig.bench().submit(SystemCommand{ArmHighVoltage{maskOf(3), true}});
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.intents[3].highVoltageArmed; }));
    push(1, -1);
    ASSERT_TRUE(waitForward());
    pads.plugged.clear();
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.run; }));
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    pads.plugged = {{2, "Fake pad", "0011", true}};
    ASSERT_TRUE(waitUntil([this] { return pad->isThere(); }));
    ASSERT_TRUE(look());
    hold(kKickButton, true);
    hold(kDribblerButton, true);
    ASSERT_TRUE(look());
    EXPECT_TRUE(pad->awaitsNeutral());
    EXPECT_TRUE(rig.wire().kicks().empty());
    EXPECT_FALSE(rig.wire().last(3) && rig.wire().last(3)->dribble);
    hold(kKickButton, false);
    hold(kDribblerButton, false);
    push(1, 0);
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    hold(kKickButton, true);
    EXPECT_TRUE(waitUntil([this] { return rig.wire().kicks() == std::vector<int>{3}; }));
}

TEST_F(PadTest, AnotherModelDoesNotTakeItsPlaceUnasked) {
    pads.plugged = {{5, "Other pad", "0022", true}};
    ASSERT_TRUE(waitUntil([this] { return !pad->isThere(); }));
    ASSERT_TRUE(look());
    EXPECT_FALSE(pad->isThere());
}

TEST_F(PadTest, StopByItsButtonWhetherItDrivesOrNot) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    hold(kStopButton, true);
    ASSERT_TRUE(rig.waitForStop());
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
    hold(kStopButton, false);
    ASSERT_TRUE(look());
    ASSERT_TRUE(rig.rearm());
    button("padOn")->click();
    ASSERT_TRUE(look());
    EXPECT_FALSE(rig.client().isStopped());
    hold(kStopButton, true);
    EXPECT_TRUE(rig.waitForStop());
}

TEST_F(PadTest, AfterStopAStickThatIsStillHeldCountsForNothing) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    rig.client().stop(StopReason::Person);
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block == wire::brakedBlock(); }));
    ASSERT_TRUE(rig.rearm());
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    ASSERT_TRUE(look());
    EXPECT_FALSE(rig.wire().last(3).has_value());
    EXPECT_TRUE(says().contains(QStringLiteral("Let go of both sticks"))) << says().toStdString();
}

TEST_F(PadTest, OfSeveralReasonsNotToDriveTheOneThatCanBeMendedFirstIsSaid) {
    const auto reason = [this] { return control->reasonNotToDrive(); };
    rig.simulate("e-stop", -1, 2);
    ASSERT_TRUE(rig.waitForStop());
    ASSERT_TRUE(rig.settle());
    EXPECT_TRUE(reason().contains(QStringLiteral("Turn it to run"))) << reason().toStdString();
    rig.simulate("e-stop", -1, 3);
    EXPECT_TRUE(waitUntil([&] { return reason().contains(QStringLiteral("Re-arm")); }));
    rig.simulate("plugged", -1, 0);
    EXPECT_TRUE(waitUntil([&] { return reason().contains(QStringLiteral("Plug it in")); }));
}

TEST_F(PadTest, TheDribblerIsSwitchedByItsButton) {
    hold(kDribblerButton, true);
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.dribble; }));
    hold(kDribblerButton, false);
    ASSERT_TRUE(look());
    hold(kDribblerButton, true);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.dribble; }));
}

TEST_F(PadTest, LostItSwitchesOffTheDribblerThatItSwitchedOn) {
    hold(kDribblerButton, true);
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.dribble; }));
    ASSERT_TRUE(rig.settle());
    pads.plugged.clear();
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.dribble && !block.run; }));
}

TEST_F(PadTest, AKickNeedsTheHighVoltageArmedAndThenGoesOut) {
    hold(kKickButton, true);
    ASSERT_TRUE(waitUntil([this] { return says().contains(QStringLiteral("armed")); }));
    EXPECT_TRUE(rig.wire().kicks().empty());
    hold(kKickButton, false);
    rig.bench().submit(SystemCommand{ArmHighVoltage{maskOf(3), true}});
    ASSERT_TRUE(rig.waitForSnapshot([](const Snapshot& s) { return s.intents[3].highVoltageArmed; }));
    hold(kKickButton, true);
    EXPECT_TRUE(waitUntil([this] { return rig.wire().kicks() == std::vector<int>{3}; }));
    ASSERT_TRUE(look());
    EXPECT_EQ(rig.wire().kicks().size(), 1U);
}

TEST_F(PadTest, SwitchedOffOrClosedItDrivesNoMore) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    panel->closed();
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.run; }));
    ASSERT_TRUE(rig.settle());
    rig.wire().clear();
    ASSERT_TRUE(look());
    EXPECT_FALSE(rig.wire().last(3).has_value());
}

TEST_F(PadTest, AnInputIsChosenByMovingItAndNothingIsDrivenMeanwhile) {
    auto* forward = button("padInput1");
    forward->click();
    EXPECT_TRUE(says().contains(QStringLiteral("Nothing is driven")));
    push(4, 1);
    ASSERT_TRUE(waitUntil([this] { return !pad->learning().has_value(); }));
    EXPECT_EQ(forward->text(), QStringLiteral("left trigger"));
    EXPECT_FALSE(rig.wire().last(3).has_value());
    push(4, 0);
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    push(4, 1);
    EXPECT_TRUE(waitForward());
    push(4, 0);
    EXPECT_TRUE(waitZero());
    EXPECT_TRUE(rig.settings()
                    .value(QStringLiteral("gamepad/map/0011"))
                    .toString()
                    .startsWith(QStringLiteral("a4+")));
    button("padStandard")->click();
    EXPECT_EQ(forward->text(), QStringLiteral("left stick up"));
}

TEST_F(PadTest, StopCountsWhileAnInputIsChosenAndItsButtonCannotBeTakenAway) {
    ASSERT_TRUE(control->setWheels(ui::DriveInput::Keys, {5, 5, 5, 5}, true));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 5; }));
    pad->learn(ui::PadAction::Dribbler);
    hold(kStopButton, true);
    ASSERT_TRUE(rig.waitForStop());
    EXPECT_FALSE(pad->learning().has_value());
    EXPECT_TRUE(says().contains(QStringLiteral("STOP button"))) << says().toStdString();
    EXPECT_EQ(pad->map().input(ui::PadAction::Stop), ui::PadMap().input(ui::PadAction::Stop));
    EXPECT_EQ(pad->map().input(ui::PadAction::Dribbler), ui::PadMap().input(ui::PadAction::Dribbler));
}

TEST_F(PadTest, OneThatTellsNothingNewWhileAStickIsOffTheMiddleBrakes) {
    push(1, -1);
    ASSERT_TRUE(waitForward());
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return !block.run; }));
    EXPECT_TRUE(says().contains(QStringLiteral("Nothing has moved"))) << says().toStdString();
    EXPECT_TRUE(warns());
    rig.wire().clear();
    push(1, -0.9);
    ASSERT_TRUE(look());
    EXPECT_FALSE(rig.wire().last(3) && rig.wire().last(3)->run) << "not before the stick was let go";
    push(1, 0);
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    EXPECT_FALSE(says().contains(QStringLiteral("Nothing has moved"))) << says().toStdString();
    push(1, -1);
    EXPECT_TRUE(waitForward());
}

TEST_F(PadTest, DeadZoneAndSpeedShapeWhatReachesTheWheels) {
    panel->findChild<QSpinBox*>(QStringLiteral("padSpeed"))->setValue(50);
    push(1, -1);
    EXPECT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[3] == 50; }));
    push(1, 0);
    ASSERT_TRUE(waitZero());
    panel->findChild<QSpinBox*>(QStringLiteral("padDeadZone"))->setValue(50);
    ASSERT_TRUE(look());
    rig.wire().clear();
    push(1, -0.45);
    ASSERT_TRUE(look());
    constexpr std::array<std::int16_t, 4> kStill{};
    EXPECT_EQ(rig.wire().last(3).value_or(DriveBlock{}).wheels, kStill);
}

TEST_F(PadTest, TheCurveMakesTheMiddleOfAStickFiner) {
    panel->findChild<QSpinBox*>(QStringLiteral("padDeadZone"))->setValue(10);
    constexpr std::array<std::pair<int, int>, 2> kSpeedByBend_percent{{{0, 50}, {100, 13}}};
    for (const auto& [bend_percent, speed] : kSpeedByBend_percent) {
        panel->findChild<QSpinBox*>(QStringLiteral("padBend"))->setValue(bend_percent);
        rig.wire().clear();
        push(1, -0.55);
        ASSERT_TRUE(look());
        // Past the look the stick has been read; the ramp still has to reach what it asks for, and stay
        // there.
        EXPECT_TRUE(rig.waitForBlock(3, [speed = speed](const DriveBlock& b) {
            return b.wheels[3] == speed;
        })) << bend_percent;
        ASSERT_TRUE(look());
        EXPECT_EQ(rig.wire().last(3).value_or(DriveBlock{}).wheels[3], speed) << bend_percent;
        push(1, 0);
        ASSERT_TRUE(waitZero());
    }
    EXPECT_EQ(rig.settings().value(QStringLiteral("gamepad/bend")).toDouble(), 1.0);
}

TEST_F(PadTest, WhileAnotherInputDrivesTheStickCountsForNothing) {
    ASSERT_TRUE(control->setWheels(ui::DriveInput::Keys, {5, 5, 5, 5}, true));
    ASSERT_TRUE(rig.waitForBlock(3, [](const DriveBlock& block) { return block.wheels[0] == 5; }));
    push(1, -1);
    ASSERT_TRUE(look());
    EXPECT_EQ(rig.wire().last(3)->wheels[0], 5);
    EXPECT_TRUE(pad->awaitsNeutral());
    EXPECT_TRUE(says().contains(QStringLiteral("Something else"))) << says().toStdString();
    push(1, 0);
    ASSERT_TRUE(waitUntil([this] { return !pad->awaitsNeutral(); }));
    EXPECT_FALSE(says().contains(QStringLiteral("Something else"))) << says().toStdString();
}

}  // namespace
}  // namespace kickstand::test
