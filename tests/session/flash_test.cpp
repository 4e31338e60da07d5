// Uploads over a whole session: what goes over the wire, in which order, and what the robot is left with.

#include "tests/session/flash_testing.h"

namespace kickstand::thunderbots::testing {
namespace {

using namespace std::chrono_literals;
using kickstand::testing::MessageFate;
using kickstand::testing::PassingMessage;
using wire::Direction;
using wire::FirmwareOp;

class Flash : public FlashTest {};

TEST_F(Flash, UploadsABitstreamAndTheRobotRunsIt) {
    const auto plan = densePlan(40, kFpga);
    ASSERT_TRUE(start(maskOf(2), {plan}));
    const FlashProgress end = waitForEnd(2);
    EXPECT_EQ(end.stage, FlashStage::Done) << (end.error ? name(end.error->code) : "");
    EXPECT_EQ(end.left, FlashLeft::Complete);
    EXPECT_EQ(end.pagesSent, 40U);
    EXPECT_TRUE(holds(2, *plan));
    EXPECT_EQ(contents(2), static_cast<std::uint8_t>(wire::FlashContents::FpgaBitstream));
    EXPECT_EQ(rig.robot(2).boots, 2U);
    EXPECT_TRUE(rig.robot(2).fpgaConfigured);
    EXPECT_EQ(rig.robot(2).wrongCrcs, 0U);
    EXPECT_EQ(rig.robot(2).malformed, 0U);
    EXPECT_EQ(rig.count(EventKind::FlashStarted), 1U);
    EXPECT_EQ(rig.last(EventKind::FlashEnded)->code, 0);
    EXPECT_EQ(rig.flows().stop.reason(), StopReason::None) << "a robot that reboots is no surprise";
}

TEST_F(Flash, UploadsTheMicrocontrollerAndThenTheBitstream) {
    const auto firmware = densePlan(30, kMicrocontroller, 1);
    const auto bitstream = densePlan(20, kFpga, 2);
    ASSERT_TRUE(start(maskOf(0), {firmware, bitstream}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Rebooting));
    EXPECT_EQ(contents(0), static_cast<std::uint8_t>(wire::FlashContents::Microcontroller));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Done) << (end.error ? name(end.error->code) : "");
    EXPECT_TRUE(holds(0, *bitstream));
    EXPECT_EQ(rig.robot(0).boots, 3U);
    EXPECT_EQ(countNotes(end, FlashNote::Signatures), 2U);
}

TEST_F(Flash, KeepsTheOrderThatLeavesNoHalfImageNamed) {
    const auto plan = densePlan(3, kFpga);
    rig.forgetPackets();
    ASSERT_TRUE(start(maskOf(1), {plan}));
    waitForEnd(1);
    std::vector<FirmwareOp> order;
    for (const auto& request : requestsTo(1)) {
        if (order.empty() || order.back() != wire::opOf(request)) order.push_back(wire::opOf(request));
    }
    using enum wire::FirmwareOp;
    // A sign of life; marking; the upload; its verification; activation; a look whether the robot is gone;
    // and when it is back a sign of life again.
    const std::vector<FirmwareOp> expected{
        BlockCrc,       ReadParameters, SetParameters,  CommitParameters, EraseChip,   FillPage,
        ProgramPage,    FillPage,       ProgramPage,    FillPage,         ProgramPage, BlockCrc,
        ReadParameters, SetParameters,  ReadParameters, CommitParameters, Reboot,      ReadParameters,
        BlockCrc,       ReadParameters, ReadSignatures};
    EXPECT_EQ(order, expected);
}

TEST_F(Flash, NeverSendsBlankPagesNorBytesThatTheBufferHolds) {
    std::vector<std::uint8_t> bytes(64 * wire::kFlashPageBytes, 0xFF);
    for (std::size_t i = 0; i < wire::kFlashPageBytes; ++i) {
        bytes[3 * wire::kFlashPageBytes + i] = static_cast<std::uint8_t>(i);
        bytes[9 * wire::kFlashPageBytes + i] = static_cast<std::uint8_t>(i);
        bytes[50 * wire::kFlashPageBytes + i] = static_cast<std::uint8_t>(i);
    }
    bytes[50 * wire::kFlashPageBytes + 7] = 0x42;
    const auto plan = std::make_shared<const FlashPlan>(imageOf(bytes, kFpga));
    rig.forgetPackets();
    ASSERT_TRUE(start(maskOf(0), {plan}));
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
    EXPECT_EQ(countOf(0, FirmwareOp::ProgramPage), 3U);
    EXPECT_EQ(countOf(0, FirmwareOp::FillPage), 5U + 0U + 1U);
}

TEST_F(Flash, SeveralRobotsAtOnceAndOneFailureStopsOnlyThatOne) {
    const auto plan = densePlan(30, kFpga);
    ASSERT_TRUE(start(0x000F, {plan}));
    ASSERT_TRUE(waitForStage(1, FlashStage::Writing));
    rig.simulate("dead", 1, 1);
    for (const int robot : {0, 2, 3}) {
        EXPECT_EQ(waitForEnd(robot).stage, FlashStage::Done) << robot;
        EXPECT_TRUE(holds(robot, *plan));
    }
    const FlashProgress lost = waitForEnd(1);
    EXPECT_EQ(lost.stage, FlashStage::Failed);
    EXPECT_EQ(lost.error->code, Errc::RobotNotAlive);
    EXPECT_EQ(lost.left, FlashLeft::NoData);
    EXPECT_EQ(contents(1), kNoDataByte);
}

TEST_F(Flash, AsksForAPersonsWordWhereACapacitorWasNeverMeasured) {
    const auto plan = densePlan(3, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    // Half an image: after a reboot the robot has no bitstream and measures nothing, and the program that
    // runs now has never heard of its capacitor.
    rig.killHost();
    rig.advance(15s);
    rig.simulate("dead", 1, 0);
    rig.advance(3s);
    rig.simulate("dead", 0, 0);
    rig.core().start();
    rig.beginConnect();
    rig.advance(10s);
    ASSERT_TRUE(rig.state().robots[0].live);
    ASSERT_FALSE(rig.state().robots[0].capacitor);

    const auto refused = start(maskOf(0), {plan});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, Errc::ReadingsUnknown);
    EXPECT_TRUE(start(maskOf(0), {plan}, {.capacitorUnknown = true}));
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
}

TEST_F(Flash, RefusesRobotsThatAreNotAtRestOrNotSafe) {
    const auto plan = densePlan(3, kFpga);
    const auto refusal = [&](int robot, FlashOptions options = {}) {
        const auto started = start(maskOf(robot), {plan}, options);
        return started ? std::optional<Errc>() : started.error().code;
    };
    EXPECT_EQ(refusal(9), Errc::RobotNotAlive);
    ASSERT_TRUE(rig.arm(0));
    EXPECT_EQ(refusal(0), Errc::NotBraked);
    ASSERT_TRUE(rig.ask(SetWheels{maskOf(1), {10, 10, 10, 10}}));
    EXPECT_EQ(refusal(1), Errc::NotBraked);
    rig.simulate("capacitor", 80, 2);
    rig.simulate("battery", 13.7, 3);
    rig.advance(100ms);
    EXPECT_EQ(refusal(2), Errc::CapacitorLive);
    EXPECT_EQ(refusal(3), Errc::BatteryLow);
    EXPECT_FALSE(refusal(3, FlashOptions{.lowBattery = true}));
    EXPECT_EQ(refusal(3), Errc::FlashRunning);
    rig.stop();
    rig.advance(20ms);
    EXPECT_EQ(refusal(2), Errc::StopLatched);
    for (const int robot : {0, 1, 2})
        EXPECT_EQ(countOf(robot, FirmwareOp::ReadParameters), 0U) << robot;
}

TEST_F(Flash, RefusesImagesThatMakeNoSense) {
    const auto firmware = densePlan(3, kMicrocontroller);
    const auto bitstream = densePlan(3, kFpga);
    const auto blank = std::make_shared<const FlashPlan>(imageOf({0xFF, 0xFF}, kFpga));
    using Plans = std::vector<SharedFlashPlan>;
    for (const Plans& plans : {Plans{}, Plans{nullptr}, Plans{blank}, Plans{bitstream, firmware},
                               Plans{bitstream, bitstream}, Plans{firmware, bitstream, firmware}})
        EXPECT_EQ(start(maskOf(0), plans).error().code, Errc::BadArgument);
}

TEST_F(Flash, ItsRobotTakesNothingElseMeanwhile) {
    ASSERT_TRUE(start(maskOf(0), {densePlan(3, kFpga)}));
    EXPECT_EQ(rig.refusal(SetWheels{maskOf(0), {5, 5, 5, 5}}), Errc::FlashRunning);
    EXPECT_EQ(rig.refusal(ArmHighVoltage{maskOf(0), true}), Errc::FlashRunning);
    EXPECT_EQ(rig.refusal(SetDribbler{maskOf(0), true}), Errc::FlashRunning);
    EXPECT_EQ(rig.refusal(ReadParameters{0}), Errc::FlashRunning);
    EXPECT_EQ(rig.refusal(RebootRobot{0, true}), Errc::FlashRunning);
    EXPECT_FALSE(rig.refusal(SetWheels{maskOf(1), {5, 5, 5, 5}})) << "others are free";
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
    EXPECT_EQ(rig.flows().stop.reason(), StopReason::None) << "robot 1 drives on while robot 0 reboots";
    EXPECT_TRUE(rig.robot(1).lastDrive.run);
}

TEST_F(Flash, StopFinishesThePageAndPausesUntilAPersonResumes) {
    const auto plan = densePlan(60, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    rig.advance(50ms);
    rig.stop();
    rig.advance(50ms);
    EXPECT_TRUE(progress(0).paused);
    EXPECT_EQ(rig.count(EventKind::FlashPaused), 1U);
    const auto sent = requestsTo(0).size();
    EXPECT_EQ(wire::opOf(requestsTo(0).back()), FirmwareOp::ProgramPage) << "not half a page";
    rig.advance(60s);
    EXPECT_EQ(requestsTo(0).size(), sent);
    EXPECT_EQ(rig.refusal(ResumeFlash{maskOf(0)}), Errc::StopLatched);
    rig.rearm();
    rig.advance(10s);
    EXPECT_EQ(requestsTo(0).size(), sent) << "re-arming is not resuming";
    ASSERT_TRUE(rig.ask(ResumeFlash{maskOf(0)}));
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
    EXPECT_EQ(rig.refusal(ResumeFlash{maskOf(0)}), Errc::FlashNotRunning);
}

TEST_F(Flash, SendsNoRebootAfterStop) {
    ASSERT_TRUE(start(maskOf(0), {densePlan(200, kFpga)}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Verifying));
    rig.stop();
    rig.advance(60s);
    EXPECT_EQ(countOf(0, FirmwareOp::Reboot), 0U);
    EXPECT_EQ(contents(0), kNoDataByte) << "nor is anything committed";
    EXPECT_EQ(countOf(0, FirmwareOp::SetParameters), 1U) << "nor named in the copy that a reading shows";
    EXPECT_EQ(progress(0).left, FlashLeft::NoData);
}

TEST_F(Flash, AStopThatNobodyHasSeenYetPausesToo) {
    const auto plan = densePlan(2, kFpga);
    // Pressed on another thread, just when the robot is about to be told to reboot.
    judge = [this](const PassingMessage& message) {
        const bool committed = message.direction == Direction::In &&
                               message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::CommitParameters) &&
                               contents(0) != kNoDataByte;
        if (committed) rig.flows().stop.set(StopReason::Person);
        return MessageFate{};
    };
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(rig.waitUntil([this] { return rig.flows().stop.isSet(); }, 30s));
    rig.advance(30s);
    EXPECT_TRUE(progress(0).paused);
    EXPECT_EQ(rig.count(EventKind::FlashPaused), 1U);
    EXPECT_EQ(countOf(0, FirmwareOp::Reboot), 0U);
    judge = {};
    rig.rearm();
    ASSERT_TRUE(rig.ask(ResumeFlash{maskOf(0)}));
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
}

TEST_F(Flash, CancelEndsItAtOnceAndSaysWhatIsLeft) {
    ASSERT_TRUE(start(maskOf(0), {densePlan(60, kFpga)}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Erasing));
    ASSERT_TRUE(rig.ask(CancelFlash{maskOf(0)}));
    const FlashProgress end = progress(0);
    EXPECT_EQ(end.stage, FlashStage::Cancelled);
    EXPECT_EQ(end.left, FlashLeft::NoData);
    EXPECT_EQ(rig.refusal(CancelFlash{maskOf(0)}), Errc::FlashNotRunning);
    rig.advance(30s);
    EXPECT_EQ(contents(0), kNoDataByte);
}

TEST_F(Flash, TheNextRunGoesOnWhereTheErasureHolds) {
    const auto plan = densePlan(100, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    ASSERT_TRUE(rig.waitUntil([this] { return countOf(0, FirmwareOp::ProgramPage) >= 60; }, 5s));
    ASSERT_TRUE(rig.ask(CancelFlash{maskOf(0)}));
    rig.forgetPackets();
    ASSERT_TRUE(start(maskOf(0), {plan}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
    EXPECT_EQ(end.erases, 0);
    EXPECT_LE(countOf(0, FirmwareOp::ProgramPage), 41U);
}

TEST_F(Flash, TheNextRunErasesWhatIsNotItsOwn) {
    ASSERT_TRUE(start(maskOf(0), {densePlan(100, kFpga, 1)}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    rig.advance(100ms);
    ASSERT_TRUE(rig.ask(CancelFlash{maskOf(0)}));
    const auto other = densePlan(20, kFpga, 2);
    ASSERT_TRUE(start(maskOf(0), {other}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Done);
    EXPECT_EQ(end.erases, 1);
    EXPECT_EQ(countNotes(end, FlashNote::FoundOther), 1U);
    EXPECT_TRUE(holds(0, *other));
}

TEST_F(Flash, APageWhoseCrcIsWrongIsFilledAndProgrammedAgain) {
    int spoilt = 0;
    judge = [&spoilt](const PassingMessage& message) {
        MessageFate fate;
        const bool fill = message.direction == Direction::Out &&
                          message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::FillPage);
        if (fill && ++spoilt % 40 == 0) {
            fate.replacement.assign(message.packet.begin(), message.packet.end());
            fate.replacement.back() ^= 0x10;
        }
        return fate;
    };
    const auto plan = densePlan(40, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Done);
    EXPECT_TRUE(holds(0, *plan));
    EXPECT_GT(rig.robot(0).wrongCrcs, 3U);
    EXPECT_EQ(countNotes(end, FlashNote::PageAgain), rig.robot(0).wrongCrcs);
}

TEST_F(Flash, GivesUpAPageThatIsNeverTaken) {
    judge = [](const PassingMessage& message) {
        MessageFate fate;
        if (message.direction == Direction::Out &&
            message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::FillPage))
            fate.copies = 0;
        return fate;
    };
    ASSERT_TRUE(start(maskOf(0), {densePlan(4, kFpga)}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Failed);
    EXPECT_EQ(end.error->code, Errc::Unanswered);
    EXPECT_EQ(end.left, FlashLeft::NoData);
    EXPECT_EQ(contents(0), kNoDataByte);
}

TEST_F(Flash, ThatThereIsNoDataIsMadeToHoldAlsoWhereTheVolatileCopySaysSoAlready) {
    // An upload that ends between setting it and committing it.
    judge = [](const PassingMessage& message) {
        MessageFate fate;
        if (message.direction == Direction::Out &&
            message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::CommitParameters))
            fate.copies = 0;
        return fate;
    };
    ASSERT_TRUE(start(maskOf(0), {densePlan(8, kFpga, 1)}));
    ASSERT_EQ(waitForEnd(0).stage, FlashStage::Failed);
    judge = {};
    ASSERT_NE(contents(0), kNoDataByte) << "that was never committed";
    ASSERT_TRUE(start(maskOf(0), {densePlan(60, kFpga, 2)}));
    ASSERT_TRUE(progress(0).running());
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    EXPECT_EQ(contents(0), kNoDataByte);
    rig.simulate("dead", 1, 0);
    EXPECT_EQ(waitForEnd(0).stage, FlashStage::Failed);
    rig.simulate("dead", 0, 0);
    rig.advance(10s);
    EXPECT_FALSE(rig.robot(0).fpgaConfigured) << "half an image was taken for a whole one";
}

TEST_F(Flash, MakesNoNumberOrChannelPermanentThatSomebodyHasOnlyApplied) {
    // By another program: this session does not know of it.
    std::size_t place = 0;
    std::uint8_t applied = 0;
    judge = [&](const PassingMessage& message) {
        MessageFate fate;
        const bool parameters = message.direction == Direction::In &&
                                message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::ReadParameters);
        if (parameters) {
            fate.replacement.assign(message.packet.begin(), message.packet.end());
            fate.replacement[place] = applied;
        }
        return fate;
    };
    // After header, opcode and flash contents: two channels and the number (protocol 4.8).
    const std::pair<std::size_t, std::uint8_t> kApplied[] = {{3, 0x15}, {4, 0x00}, {5, 9}};
    for (const auto& [at, value] : kApplied) {
        place = at;
        applied = value;
        ASSERT_TRUE(start(maskOf(1), {densePlan(4, kFpga)})) << at;
        rig.advance(100ms);
        const FlashProgress end = waitForEnd(1);
        EXPECT_EQ(end.stage, FlashStage::Failed) << at;
        EXPECT_EQ(end.error->code, Errc::RebootNeeded) << at;
        EXPECT_EQ(end.left, FlashLeft::Untouched) << at;
    }
    EXPECT_EQ(countOf(1, FirmwareOp::CommitParameters), 0U);
}

TEST_F(Flash, ARobotThatDoesNotComeBackIsNotWaitedForForEver) {
    ASSERT_TRUE(start(maskOf(0), {densePlan(4, kFpga)}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Rebooting));
    rig.simulate("dead", 1, 0);
    const TimePoint gone = rig.scheduler().now();
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Failed);
    EXPECT_EQ(end.error->code, Errc::RobotNotAlive);
    EXPECT_EQ(end.left, FlashLeft::Rebooted);
    EXPECT_LE(end.endedAt - gone, 70s);
}

TEST_F(Flash, AnErasureWhoseAnswerIsLostIsFoundOut) {
    judge = [](const PassingMessage& message) {
        MessageFate fate;
        if (message.direction == Direction::In &&
            message.packet[1] == static_cast<std::uint8_t>(FirmwareOp::EraseChip))
            fate.copies = 0;
        return fate;
    };
    const auto plan = densePlan(10, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    const FlashProgress end = waitForEnd(0);
    EXPECT_EQ(end.stage, FlashStage::Done);
    EXPECT_EQ(end.erases, 1);
    EXPECT_TRUE(holds(0, *plan));
}

TEST_F(Flash, ShowsHowFarItIsAndHowLongItWillTake) {
    const auto plan = densePlan(200, kFpga);
    ASSERT_TRUE(start(maskOf(0), {plan}));
    ASSERT_TRUE(waitForStage(0, FlashStage::Erasing));
    const FlashProgress erasing = progress(0);
    EXPECT_NEAR(seconds(erasing.remaining), 8 + 200 * 0.008 + 3 + 2, 3);
    ASSERT_TRUE(waitForStage(0, FlashStage::Writing));
    rig.advance(800ms);
    const FlashProgress writing = progress(0);
    EXPECT_NEAR(writing.done_B, 100 * 256, 20 * 256);
    EXPECT_EQ(writing.total_B, 200U * 256U);
    EXPECT_NEAR(writing.rate_Bps, 256 / 0.008, 2000);
    EXPECT_LT(writing.remaining, erasing.remaining);
    EXPECT_EQ(waitForEnd(0).remaining, 0s);
}

TEST_F(Flash, WorksOnACableWhoseDeviceGoesWithTheRobot) {
    kickstand::testing::SessionRigOptions made = options();
    made.sim.cableRobot = std::uint8_t{5};
    kickstand::testing::SessionRig cable(std::move(made));
    ASSERT_TRUE(cable.connect());
    const auto firmware = densePlan(5, kMicrocontroller, 1);
    const auto bitstream = densePlan(5, kFpga, 2);
    ASSERT_TRUE(cable.ask(StartFlash{maskOf(5), {firmware, bitstream}, {}}));
    cable.advance(100ms);
    for (int i = 0; i < 2000 && cable.state().flash[5]->running(); ++i)
        cable.advance(50ms);
    const FlashProgress end = *cable.state().flash[5];
    EXPECT_EQ(end.stage, FlashStage::Done) << (end.error ? name(end.error->code) : "");
    EXPECT_EQ(cable.flows().stop.reason(), StopReason::None) << "it was told to go";
}

TEST_F(Flash, WorksOnARadioAtItsTruePace) {
    kickstand::testing::SessionRigOptions made = options();
    made.sim.pace = sim::RadioPace::True;
    made.sim.weather = {.loss = 0.05, .duplication = 0.05, .delay = 3ms};
    made.sim.robots = 0x0007;
    kickstand::testing::SessionRig other(std::move(made));
    ASSERT_TRUE(other.connect());
    // Heard first, measured a little later.
    const auto measured = [&other] {
        const auto now = other.state();
        return now.robots[0].capacitor && now.robots[1].capacitor && now.robots[2].capacitor;
    };
    ASSERT_TRUE(other.waitUntil(measured, 10s));
    const auto plan = densePlan(12, kFpga);
    ASSERT_TRUE(other.ask(StartFlash{0x0007, {plan}, {}}));
    other.advance(20ms);
    for (const std::size_t robot : {0U, 1U, 2U}) {
        ASSERT_TRUE(other.state().flash[robot]) << robot;
        for (int i = 0; i < 2000 && other.state().flash[robot]->running(); ++i)
            other.advance(50ms);
        const FlashProgress end = *other.state().flash[robot];
        EXPECT_EQ(end.stage, FlashStage::Done)
            << "robot " << robot << ": " << (end.error ? name(end.error->code) : "");
    }
}

}  // namespace
}  // namespace kickstand::thunderbots::testing
