// What of the firmware wizard needs no window: what keeps a robot or a page back, what is sent to whom, and
// how a run is followed to its end.

#include <gtest/gtest.h>

#include "ui/thunderbots/flash_words.h"

namespace kickstand::test {
namespace {

using namespace thunderbots;
using image::FlashTarget;
using ui::FlashHold;
using ui::FlashObstacle;
using ui::FlashOutcome;
using ui::FlashReview;
using ui::FlashStep;
using ui::FlashWizardState;
using Kind = ui::FlashHold::Kind;

constexpr int kRobot = 3;

/// A file of one page, which either target would take.
ui::FlashFile makeFile(FlashTarget target, std::uint8_t filling, const char* path) {
    const std::vector<std::uint8_t> bytes(300, filling);
    ui::FlashFile file = ui::makeFlashFile(QString::fromLatin1(path), bytes);
    file.target = target;
    return file;
}

/// A wizard with a robot at rest, and a link that runs.
class FlashWizardTest : public testing::Test {
  protected:
    FlashWizardTest() {
        snapshot.link = LinkState::Running;
        state.robots = maskOf(kRobot);
        robot().live = true;
        robot().freshness = Freshness::Current;
        robot().readings.battery_V = 16;
        robot().capacitor = CapacitorMemory{12, {}};
    }
    RobotState& robot() { return snapshot.robots[kRobot]; }
    RobotIntent& intent() { return snapshot.intents[kRobot]; }
    FlashObstacle obstacle() { return ui::obstacleOf(snapshot, kRobot, state.options); }
    std::optional<FlashHold> hold(FlashStep step, bool stopped = false) {
        state.step = step;
        return state.hold(&snapshot, stopped);
    }
    std::optional<Kind> kind(FlashStep step, bool stopped = false) {
        const auto held = hold(step, stopped);
        return held ? std::optional(held->kind) : std::nullopt;
    }
    void addMicrocontroller() { state.addFile(makeFile(FlashTarget::Microcontroller, 0x11, "pic.bin")); }
    void addFpga() { state.addFile(makeFile(FlashTarget::Fpga, 0x22, "fpga.bin")); }
    /// The robot has answered with these signatures.
    void answer(std::uint16_t microcontroller, std::uint16_t flash,
                wire::FlashContents contents = wire::FlashContents::FpgaBitstream) {
        FlashReview& review = state.reviews[kRobot];
        review.state = FlashReview::State::Reading;
        ParameterState& known = snapshot.parameters[kRobot];
        known.signatures = wire::ReadSignaturesResponse{microcontroller, flash};
        known.robot.emplace();
        known.robot->flashContents = static_cast<std::uint8_t>(contents);
        state.takeReviews(snapshot);
    }
    std::uint16_t firmwareSignature() { return state.plans().front()->signatures().microcontroller; }
    std::uint16_t flashSignature() { return state.plans().back()->signatures().flash; }

    Snapshot snapshot;
    FlashWizardState state;
};

TEST_F(FlashWizardTest, ARobotAtRestHasNoObstacle) {
    EXPECT_EQ(obstacle(), FlashObstacle::None);
    EXPECT_EQ(kind(FlashStep::Robots), std::nullopt);
}

TEST_F(FlashWizardTest, EverythingThatIsUpIsAnObstacleWithItsRemedy) {
    struct Case {
        bool RobotIntent::*what;
        FlashObstacle obstacle;
        std::size_t remedies;
    };
    const Case cases[] = {{&RobotIntent::run, FlashObstacle::Wheels, 1},
                          {&RobotIntent::dribbler, FlashObstacle::Dribbler, 1},
                          {&RobotIntent::charger, FlashObstacle::Charger, 1},
                          {&RobotIntent::autokick, FlashObstacle::Autokick, 1},
                          {&RobotIntent::sweeping, FlashObstacle::Sweeping, 1},
                          {&RobotIntent::checking, FlashObstacle::Checking, 1},
                          {&RobotIntent::discharging, FlashObstacle::Discharging, 0},
                          {&RobotIntent::highVoltageArmed, FlashObstacle::Armed, 1}};
    for (const Case& each : cases) {
        intent() = {};
        intent().*each.what = true;
        EXPECT_EQ(obstacle(), each.obstacle);
        EXPECT_EQ(ui::remedyOf(each.obstacle, kRobot).size(), each.remedies);
        EXPECT_EQ(ui::remedyText(each.obstacle).isEmpty(), each.remedies == 0);
        EXPECT_FALSE(ui::obstacleText(each.obstacle, snapshot, kRobot).isEmpty());
        EXPECT_EQ(hold(FlashStep::Robots), (FlashHold{Kind::Robot, kRobot, each.obstacle}));
    }
}

TEST_F(FlashWizardTest, ALiveCapacitorIsDischargedBeforeItIsDisarmed) {
    robot().capacitor->last_V = 50;
    intent().highVoltageArmed = true;
    EXPECT_EQ(obstacle(), FlashObstacle::CapacitorLive);
    const auto remedy = ui::remedyOf(obstacle(), kRobot);
    ASSERT_EQ(remedy.size(), 2U);
    EXPECT_TRUE(std::get<ArmHighVoltage>(remedy[0]).armed);
    EXPECT_TRUE(std::get<Discharge>(remedy[1]).on);
    robot().capacitor->last_V = 49;
    EXPECT_EQ(obstacle(), FlashObstacle::Armed);
}

TEST_F(FlashWizardTest, ACapacitorThatNobodyMeasuresCountsAsItWasUnlessAPersonSaysOtherwise) {
    robot().freshness = Freshness::Stale;
    EXPECT_EQ(obstacle(), FlashObstacle::None) << "it was empty when last seen";
    robot().capacitor->last_V = 212;
    EXPECT_EQ(obstacle(), FlashObstacle::CapacitorUnknown);
    state.options.capacitorUnknown = true;
    EXPECT_EQ(obstacle(), FlashObstacle::None);
    robot().freshness = Freshness::Current;
    EXPECT_EQ(obstacle(), FlashObstacle::CapacitorLive) << "what is measured counts";
}

TEST_F(FlashWizardTest, ALowBatteryHoldsUntilAPersonAccepts) {
    robot().readings.battery_V = 13.9;
    EXPECT_EQ(obstacle(), FlashObstacle::BatteryLow);
    state.options.lowBattery = true;
    EXPECT_EQ(obstacle(), FlashObstacle::None);
}

TEST_F(FlashWizardTest, WhatWouldBeLostAndWhoIsAskedSomethingHold) {
    snapshot.parameters[kRobot].standing = ParameterStanding::Applied;
    EXPECT_EQ(obstacle(), FlashObstacle::Uncommitted);
    snapshot.parameters[kRobot].standing = ParameterStanding::Committed;
    snapshot.requests[kRobot].op = wire::FirmwareOp::ReadParameters;
    EXPECT_EQ(obstacle(), FlashObstacle::Asked);
    snapshot.flash[kRobot] = FlashProgress{};
    EXPECT_EQ(obstacle(), FlashObstacle::Uploading);
}

TEST_F(FlashWizardTest, TheRobotsPageHoldsWithoutALinkARobotOrWhenStopped) {
    EXPECT_EQ(state.hold(nullptr, false)->kind, Kind::NotConnected);
    EXPECT_EQ(kind(FlashStep::Robots, true), Kind::Stopped);
    snapshot.link = LinkState::Searching;
    EXPECT_EQ(kind(FlashStep::Robots), Kind::LinkNotRunning);
    snapshot.link = LinkState::Running;
    robot().live = false;
    EXPECT_EQ(hold(FlashStep::Robots), (FlashHold{Kind::Robot, kRobot, FlashObstacle::NotHeard}));
    state.robots = 0;
    EXPECT_EQ(kind(FlashStep::Robots), Kind::NoRobot);
}

TEST_F(FlashWizardTest, TheFilesPageHoldsForEachThingThatIsWrong) {
    EXPECT_EQ(kind(FlashStep::Files), Kind::NoFile);
    state.reading = 1;
    EXPECT_EQ(kind(FlashStep::Files), Kind::Reading);
    state.reading = 0;
    state.addFile(ui::makeFlashFile(QStringLiteral("blank.bin"), std::vector<std::uint8_t>(64, 0xFF)));
    EXPECT_EQ(hold(FlashStep::Files)->kind, Kind::File) << "there is nothing to send";
    EXPECT_FALSE(ui::fileProblem(state.files[0]).isEmpty());
    state.files.clear();
    addFpga();
    EXPECT_EQ(kind(FlashStep::Files), std::nullopt);
    addMicrocontroller();
    EXPECT_EQ(kind(FlashStep::Files), std::nullopt);
    state.files[0].target = FlashTarget::Microcontroller;
    EXPECT_EQ(kind(FlashStep::Files), Kind::SameTarget);
}

TEST_F(FlashWizardTest, AThirdFileIsNotTakenAndTheSameOneIsTakenAnew) {
    addFpga();
    addMicrocontroller();
    EXPECT_FALSE(state.addFile(makeFile(FlashTarget::Fpga, 0x33, "third.bin")));
    EXPECT_TRUE(state.addFile(makeFile(FlashTarget::Fpga, 0x44, "fpga.bin")));
    ASSERT_EQ(state.files.size(), 2U);
    EXPECT_EQ(state.files[0].plan()->image().bytes.front(), 0x44);
}

TEST_F(FlashWizardTest, TheMicrocontrollerGoesFirstWhicheverWasChosenFirst) {
    addFpga();
    EXPECT_FALSE(state.losesBitstream());
    addMicrocontroller();
    const auto plans = state.plans();
    ASSERT_EQ(plans.size(), 2U);
    EXPECT_EQ(plans[0]->target(), FlashTarget::Microcontroller);
    EXPECT_EQ(plans[1]->target(), FlashTarget::Fpga);
    EXPECT_FALSE(state.losesBitstream());
    EXPECT_TRUE(ui::filesNotice(state).contains(QStringLiteral("first")));
    state.files.erase(state.files.begin());
    EXPECT_TRUE(state.losesBitstream());
    EXPECT_TRUE(ui::filesNotice(state).contains(QStringLiteral("will not drive")));
}

TEST_F(FlashWizardTest, TheReviewHoldsUntilEveryRobotHasTold) {
    addFpga();
    EXPECT_EQ(kind(FlashStep::Review), Kind::ReadingRobots);
    state.reviews[kRobot].state = FlashReview::State::Failed;
    EXPECT_EQ(kind(FlashStep::Review), Kind::RobotUnread);
    answer(1, 2);
    EXPECT_EQ(kind(FlashStep::Review), std::nullopt);
    EXPECT_EQ(kind(FlashStep::Review, true), Kind::Stopped) << "all is checked again before it begins";
    snapshot.requests[kRobot].op = wire::FirmwareOp::ReadParameters;
    EXPECT_EQ(hold(FlashStep::Review), (FlashHold{Kind::Robot, kRobot, FlashObstacle::Asked}));
}

TEST_F(FlashWizardTest, AnAnswerFromBeforeTheQuestionCountsForNothing) {
    addFpga();
    state.reviews[kRobot].askedAt = TimePoint{std::chrono::seconds(5)};
    answer(1, 2);
    EXPECT_EQ(state.reviews[kRobot].state, FlashReview::State::Reading);
    snapshot.parameters[kRobot].signaturesAt = TimePoint{std::chrono::seconds(6)};
    state.takeReviews(snapshot);
    EXPECT_EQ(state.reviews[kRobot].state, FlashReview::State::Read);
}

TEST_F(FlashWizardTest, WhatIsThereAlreadyIsLeftOutUnlessAPersonWantsIt) {
    addFpga();
    answer(1, flashSignature());
    EXPECT_EQ(kind(FlashStep::Review), Kind::NothingToDo);
    EXPECT_TRUE(ui::thereText(state, kRobot).contains(QStringLiteral("already there")));
    state.reviews[kRobot].leaveOut = false;
    EXPECT_EQ(kind(FlashStep::Review), std::nullopt);
    EXPECT_EQ(state.plansFor(kRobot).size(), 1U);
}

TEST_F(FlashWizardTest, ABitstreamThatTheRobotDoesNotNameIsNotThere) {
    addFpga();
    answer(1, flashSignature(), wire::FlashContents::NoData);
    EXPECT_FALSE(state.canLeaveOut(kRobot));
    EXPECT_EQ(kind(FlashStep::Review), std::nullopt);
}

TEST_F(FlashWizardTest, OfTwoImagesOnlyTheFirstCanBeThereAlone) {
    addMicrocontroller();
    addFpga();
    answer(firmwareSignature(), 0);
    ASSERT_EQ(state.plansFor(kRobot).size(), 1U);
    EXPECT_EQ(state.plansFor(kRobot)[0]->target(), FlashTarget::Fpga);
    answer(static_cast<std::uint16_t>(firmwareSignature() ^ 1), flashSignature());
    EXPECT_EQ(state.plansFor(kRobot).size(), 2U) << "sending the first erases the second";
    answer(firmwareSignature(), flashSignature());
    EXPECT_TRUE(state.plansFor(kRobot).empty());
}

TEST_F(FlashWizardTest, SeveralRobotsTakeLongerByWhatTheyShare) {
    addFpga();
    const Duration one = state.estimate();
    EXPECT_GT(one, std::chrono::seconds(8)) << "the erase alone";
    state.robots |= maskOf(4);
    EXPECT_EQ(state.estimate() - one, std::chrono::milliseconds(12)) << "two pages on the wire";
}

class FlashRunTest : public testing::Test {
  protected:
    FlashRunTest() {
        run.begin(TimePoint{std::chrono::seconds(100)});
        run.add(1, {});
        run.add(2, {});
        show(1, FlashStage::Writing);
        show(2, FlashStage::Writing);
    }
    void show(int robot, FlashStage stage, int began_s = 101) {
        FlashProgress progress;
        progress.stage = stage;
        progress.left = FlashLeft::NoData;
        progress.beganAt = TimePoint{std::chrono::seconds(began_s)};
        snapshot.flash[static_cast<std::size_t>(robot)] = progress;
        run.take(snapshot);
    }

    Snapshot snapshot;
    ui::FlashRun run;
};

TEST_F(FlashRunTest, TheUploadBeforeIsNotTakenForThisOne) {
    run.begin(TimePoint{std::chrono::seconds(200)});
    run.add(1, {});
    run.take(snapshot);
    EXPECT_EQ(run.at(1).outcome(), FlashOutcome::Asked);
    show(1, FlashStage::Erasing, 200);
    EXPECT_EQ(run.at(1).outcome(), FlashOutcome::Running);
}

TEST_F(FlashRunTest, EachRobotComesToItsOwnEnd) {
    EXPECT_TRUE(run.running());
    show(1, FlashStage::Done);
    show(2, FlashStage::Failed);
    EXPECT_FALSE(run.running());
    EXPECT_EQ(run.with(FlashOutcome::Done), maskOf(1));
    EXPECT_EQ(run.unfinished(), maskOf(2));
}

TEST_F(FlashRunTest, ARefusalIsAnEndWithItsReason) {
    run.add(3, {});
    run.refuse(3, Error{.code = Errc::RobotNotAlive, .robot = 3});
    EXPECT_EQ(run.at(3).outcome(), FlashOutcome::Refused);
    EXPECT_TRUE(ui::outcomeText(3, run.at(3)).contains(QStringLiteral("Robot 3 is not heard")));
    EXPECT_EQ(run.unfinished(), maskOf(3));
}

TEST_F(FlashRunTest, WhatIsKnownOutlivesTheLink) {
    show(1, FlashStage::Done);
    run.letGo();
    EXPECT_EQ(run.at(1).outcome(), FlashOutcome::Done);
    EXPECT_EQ(run.at(2).outcome(), FlashOutcome::Gone);
    EXPECT_TRUE(ui::outcomeText(2, run.at(2)).contains(QStringLiteral("no data")));
    EXPECT_FALSE(run.running());
    show(2, FlashStage::Done, 300);
    EXPECT_EQ(run.at(2).outcome(), FlashOutcome::Gone) << "of another session";
}

}  // namespace
}  // namespace kickstand::test
