// Every error code of the robot, and whole jobs, while messages are lost, doubled and late.
#include <string>

#include <gtest/gtest.h>

#include "tests/session/plan_rig.h"

namespace kickstand::testing {
namespace {

using namespace motionplan;
using wire::MessageKind;
using wire::Wheels;
using namespace std::chrono_literals;

/// What becomes of the robot's copy of the command that it refuses, and of its error, which is the message
/// after that.
enum class Fate { Clear, Doubled, Late, CopyLost, ErrorLost, BothLost };
constexpr Fate kFates[] = {Fate::Clear,    Fate::Doubled,   Fate::Late,
                           Fate::CopyLost, Fate::ErrorLost, Fate::BothLost};

/// What the session says in the end.
enum class Said {
    Refused,      ///< With the code, once.
    Done,         ///< Nothing that the protocol has tells it from what was done.
    Unconfirmed,  ///< The person is asked.
};

const char* nameOf(Fate fate) {
    constexpr const char* kNames[] = {"clear", "doubled", "late", "copy lost", "error lost", "both lost"};
    return kNames[static_cast<std::size_t>(fate)];
}

class PlanCodes : public ::testing::TestWithParam<Fate> {
  protected:
    /// A rig that runs, and believes that slot 4 holds plan `believed` (0: none).
    void prepare(int believed) {
        ASSERT_TRUE(rig.connect());
        if (believed == 0)
            ASSERT_TRUE(rig.ask(QuerySlot{4}));
        else
            ASSERT_TRUE(rig.create(believed, 4, PlanRig::kLong));
    }
    /// Another hand: the program was ended and started again, and holds plan `really` in slot 4.
    void deceive(int really) {
        rig.simulate("program", 0);
        rig.simulate("program", 1);
        if (really != 0) {
            const wire::Message create{
                .kind = MessageKind::Create, .plan = really, .slot = 4, .movements = {0x01}};
            rig.sim().program().command(wire::encodeMessage(create)->view(), rig.scheduler().now());
        }
        rig.advance(500ms);
    }
    void meet() {
        if (GetParam() == Fate::Doubled) rig.simulate("duplicate", 1);
        if (GetParam() == Fate::Late) rig.simulate("delay", 600);
        if (GetParam() == Fate::CopyLost) rig.simulate("lose-next-out", 1);
        if (GetParam() == Fate::ErrorLost) rig.simulate("lose-one-out", 2);
        if (GetParam() == Fate::BothLost) rig.simulate("lose-next-out", 2);
    }
    /// Does it, and looks at what was said of it, now and for a while after.
    void expect(const Command& command, int code, Said said) {
        meet();
        rig.forgetWritten();
        const auto result = rig.ask(command);
        rig.advance(5s);
        const std::string in = nameOf(GetParam());
        if (said == Said::Done) {
            EXPECT_TRUE(result) << in;
        } else if (result) {
            ADD_FAILURE() << in << ": said to be done";
        } else if (said == Said::Refused) {
            EXPECT_EQ(result.error().code, Errc::PlanRefused) << in;
            EXPECT_EQ(result.error().got, code) << in;
        } else {
            EXPECT_EQ(result.error().code, Errc::Unconfirmed) << in;
        }
        // An idle robot's answer to Stop is told as Stopped.
        const bool event = said == Said::Refused && code != wire::kErrorStopIdle;
        EXPECT_EQ(rig.count(EventKind::Refused), event ? 1U : 0U) << in;
        EXPECT_EQ(rig.count(EventKind::Differs), 0U) << in;
    }
    static Said unless(Fate fate, Said then) { return GetParam() == fate ? then : Said::Refused; }

    PlanRig rig;
};

TEST_P(PlanCodes, CreateIntoASlotThatIsFull) {
    prepare(0);
    deceive(5);
    expect(CreatePlan{9, 4, PlanRig::kShort}, wire::kErrorSlotFull, Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 1U);
    // It is asked for again, or known by now.
    EXPECT_EQ(rig.refusal(CreatePlan{9, 4, PlanRig::kShort}), Errc::WouldBeRefused);
    EXPECT_EQ(rig.state().slotStates[4].plan, 5);
}

TEST_P(PlanCodes, UpdateOfAnotherPlan) {
    prepare(9);
    deceive(5);
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateOtherPlan, Said::Refused);
}

TEST_P(PlanCodes, UpdateOfAnEmptySlot) {
    prepare(9);
    deceive(0);
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateEmptySlot, Said::Refused);
}

TEST_P(PlanCodes, UpdateWhileNothingExecutes) {
    prepare(9);
    rig.simulate("strict-update", 1);
    // The plan keeps its ID whether it was updated or not, and no message asks what is in it.
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateIdle, unless(Fate::ErrorLost, Said::Done));
}

TEST_P(PlanCodes, ExecuteOfAnotherPlan) {
    prepare(9);
    deceive(5);
    expect(ExecutePlan{9, 4}, wire::kErrorExecuteOtherPlan, unless(Fate::BothLost, Said::Unconfirmed));
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.session().active(), GetParam() == Fate::BothLost);
}

TEST_P(PlanCodes, ExecuteOfAnEmptySlot) {
    prepare(9);
    deceive(0);
    expect(ExecutePlan{9, 4}, wire::kErrorExecuteEmptySlot, unless(Fate::BothLost, Said::Unconfirmed));
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.session().active(), GetParam() == Fate::BothLost);
}

TEST_P(PlanCodes, StopWhileNothingExecutes) {
    ASSERT_TRUE(rig.connect());
    // The robot stands, and that is what is said of it, with its error or without.
    const bool lost = GetParam() == Fate::ErrorLost || GetParam() == Fate::BothLost;
    expect(StopPlan{}, wire::kErrorStopIdle, lost ? Said::Done : Said::Refused);
    EXPECT_EQ(rig.count(EventKind::Stopped), 1U);
    EXPECT_FALSE(rig.session().active());
}

TEST_P(PlanCodes, AdjustWhileNothingExecutes) {
    prepare(9);
    ASSERT_TRUE(rig.ask(ExecutePlan{9, 4}));
    // The robot has lost its plan, and nobody has heard of it yet.
    rig.sim().program().restart();
    const bool lost = GetParam() == Fate::ErrorLost || GetParam() == Fate::BothLost;
    expect(AdjustSpeed{Wheels::BothForward, 10}, wire::kErrorAdjustIdle,
           lost ? Said::Unconfirmed : Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Adjust), 1U);
    EXPECT_EQ(rig.session().active(), lost);
}

/// Those that nobody has asked for are told, each once.
TEST_P(PlanCodes, Unasked) {
    ASSERT_TRUE(rig.connect());
    if (GetParam() == Fate::Doubled || GetParam() == Fate::Late) meet();
    for (int code = 0; code < wire::kErrorCodes; ++code) {
        rig.simulate("error", code);
        rig.advance(1s);
    }
    EXPECT_EQ(rig.count(EventKind::Refused), static_cast<std::size_t>(wire::kErrorCodes));
    EXPECT_EQ(rig.events().back().previous, 1);
}

std::string testName(const ::testing::TestParamInfo<Fate>& of) {
    std::string name = nameOf(of.param);
    std::erase(name, ' ');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Fates, PlanCodes, ::testing::ValuesIn(kFates), testName);

/// A whole job, in any weather, ends in one way or the other: every command is answered once, nothing is
/// executed twice, and what was said to be there is there.
TEST(PlanWeather, WholeJobsInBadWeather) {
    int done = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        sim::NxtOptions options;
        options.seed = seed;
        options.weather.loss = 0.15;
        options.weather.replyLoss = 0.1;
        options.weather.duplicate = 0.2;
        options.weather.delay = std::chrono::milliseconds(seed % 4 * 100);
        PlanRig rig(options);
        ASSERT_TRUE(rig.connect()) << seed;
        const auto created = rig.ask(CreatePlan{9, 4, PlanRig::kShort});
        if (created) {
            EXPECT_EQ(rig.robot().kept()[4].id, 9) << seed;
        }
        const auto updated = rig.ask(UpdatePlan{9, 4, {{Wheels::BothBack, 100}}});
        if (updated) {
            EXPECT_EQ(rig.robot().kept()[4].movements, (std::vector<std::uint8_t>{0x37})) << seed;
        }
        const auto armed = rig.ask(SetTrigger{7, PlanRig::kShort});
        if (armed) {
            EXPECT_EQ(rig.robot().trigger().id, 7) << seed;
        }
        const auto read = rig.ask(ReadTrigger{});
        if (read) {
            EXPECT_EQ(rig.state().trigger.plan, rig.robot().trigger().id) << seed;
        }
        const auto queried = rig.ask(QuerySlot{4});
        if (queried) {
            EXPECT_EQ(rig.state().slotStates[4].plan, rig.robot().kept()[4].id) << seed;
        }
        const auto executed = rig.ask(ExecutePlan{9, 4});
        EXPECT_LE(rig.writtenOf(MessageKind::Execute), 1U) << seed;
        const auto adjusted = rig.ask(AdjustSpeed{Wheels::BothForward, -10});
        EXPECT_LE(rig.writtenOf(MessageKind::Adjust), 1U) << seed;
        for (const auto& result : {created, updated, armed, read, queried, executed, adjusted}) {
            if (result) continue;
            const Errc code = result.error().code;
            EXPECT_TRUE(code == Errc::Unconfirmed || code == Errc::TimedOut || code == Errc::WouldBeRefused)
                << seed << ' ' << name(code) << ' ' << result.error().detail;
        }
        rig.stop();
        rig.advance(20s);
        EXPECT_FALSE(rig.robot().motion()) << seed;
        done += executed ? 1 : 0;
    }
    // Most of them get through all the same.
    EXPECT_GT(done, 30);
}

}  // namespace
}  // namespace kickstand::testing
