// Every error code of the robot, and whole jobs, while messages are lost, doubled and late.
#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "tests/session/plan_rig.h"

namespace kickstand::testing {
namespace {

using namespace motionplan;
using wire::MessageKind;
using wire::Wheels;
using namespace std::chrono_literals;

/// What becomes of the command that the robot refuses, of its copy, and of the error, which is the message
/// after that.
enum class Fate { Clear, Doubled, Late, CommandLost, CopyLost, ErrorLost, BothLost };
constexpr Fate kFates[] = {Fate::Clear,    Fate::Doubled,   Fate::Late,    Fate::CommandLost,
                           Fate::CopyLost, Fate::ErrorLost, Fate::BothLost};

/// What the session says in the end.
enum class Said {
    Refused,      ///< With the code, once.
    Done,         ///< Nothing that the protocol has tells it from what was done.
    Unconfirmed,  ///< The person is asked.
};

const char* nameOf(Fate fate) {
    constexpr const char* kNames[] = {"clear",     "doubled",    "late",     "command lost",
                                      "copy lost", "error lost", "both lost"};
    return kNames[static_cast<std::size_t>(fate)];
}

/// A rig that is wrong about slot 4.
struct Deceived : PlanRig {
    using PlanRig::PlanRig;

    /// Runs, and believes that the slot holds plan `believed` (0: none).
    void prepare(int believed) {
        ASSERT_TRUE(connect());
        if (believed == wire::kNoPlan)
            ASSERT_TRUE(ask(QuerySlot{4}));
        else
            ASSERT_TRUE(create(believed, 4, kLong));
    }
    /// Another hand: the program was ended and started again, and holds plan `really` there.
    void deceive(int really) {
        simulate("program", 0);
        simulate("program", 1);
        if (really != wire::kNoPlan) {
            const wire::Message create{
                .kind = MessageKind::Create, .plan = really, .slot = 4, .movements = {0x01}};
            sim().program().command(wire::encodeMessage(create)->view(), scheduler().now());
        }
        advance(500ms);
    }
    /// Believes that plan 9 executes, which the robot has lost.
    void deceiveRunning() {
        ASSERT_TRUE(ask(ExecutePlan{9, 4}));
        sim().program().restart();
    }
};

class PlanCodes : public ::testing::TestWithParam<Fate> {
  protected:
    void meet() {
        if (GetParam() == Fate::Doubled) rig.simulate("duplicate", 1);
        if (GetParam() == Fate::Late) rig.simulate("delay", 600);
        if (GetParam() == Fate::CommandLost) rig.simulate("lose-next", 1);
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
    /// Whether it is one of these.
    static bool among(std::initializer_list<Fate> fates) {
        return std::ranges::find(fates, GetParam()) != fates.end();
    }

    Deceived rig;
};

TEST_P(PlanCodes, CreateIntoASlotThatIsFull) {
    rig.prepare(0);
    rig.deceive(5);
    expect(CreatePlan{9, 4, PlanRig::kShort}, wire::kErrorSlotFull, Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Create), 1U);
    // It is asked for again, or known by now.
    EXPECT_EQ(rig.refusal(CreatePlan{9, 4, PlanRig::kShort}), Errc::WouldBeRefused);
    EXPECT_EQ(rig.state().slotStates[4].plan, 5);
}

TEST_P(PlanCodes, UpdateOfAnotherPlan) {
    rig.prepare(9);
    rig.deceive(5);
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateOtherPlan, Said::Refused);
}

TEST_P(PlanCodes, UpdateOfAnEmptySlot) {
    rig.prepare(9);
    rig.deceive(0);
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateEmptySlot, Said::Refused);
}

TEST_P(PlanCodes, UpdateWhileNothingExecutes) {
    rig.prepare(9);
    rig.simulate("strict-update", 1);
    // The plan keeps its ID whether it was updated or not, and no message asks what is in it.
    expect(UpdatePlan{9, 4, PlanRig::kShort}, wire::kErrorUpdateIdle,
           among({Fate::ErrorLost}) ? Said::Done : Said::Refused);
}

TEST_P(PlanCodes, ExecuteOfAnotherPlan) {
    rig.prepare(9);
    rig.deceive(5);
    const bool unheard = among({Fate::CommandLost, Fate::BothLost});
    expect(ExecutePlan{9, 4}, wire::kErrorExecuteOtherPlan, unheard ? Said::Unconfirmed : Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.session().active(), unheard);
}

TEST_P(PlanCodes, ExecuteOfAnEmptySlot) {
    rig.prepare(9);
    rig.deceive(0);
    const bool unheard = among({Fate::CommandLost, Fate::BothLost});
    expect(ExecutePlan{9, 4}, wire::kErrorExecuteEmptySlot, unheard ? Said::Unconfirmed : Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Execute), 1U);
    EXPECT_EQ(rig.session().active(), unheard);
}

TEST_P(PlanCodes, StopWhileNothingExecutes) {
    ASSERT_TRUE(rig.connect());
    // The robot stands, and that is what is said of it, with its error or without.
    const bool lost = among({Fate::CommandLost, Fate::ErrorLost, Fate::BothLost});
    expect(StopPlan{}, wire::kErrorStopIdle, lost ? Said::Done : Said::Refused);
    EXPECT_EQ(rig.count(EventKind::Stopped), 1U);
    EXPECT_FALSE(rig.session().active());
}

TEST_P(PlanCodes, AdjustWhileNothingExecutes) {
    rig.prepare(9);
    rig.deceiveRunning();
    const bool lost = among({Fate::CommandLost, Fate::ErrorLost, Fate::BothLost});
    expect(AdjustSpeed{Wheels::BothForward, 10}, wire::kErrorAdjustIdle,
           lost ? Said::Unconfirmed : Said::Refused);
    EXPECT_EQ(rig.writtenOf(MessageKind::Adjust), 1U);
    EXPECT_EQ(rig.session().active(), lost);
}

/// Errors that belong to no command: none of what is lost.
class UnaskedCodes : public PlanCodes {};

/// They are told, each once.
TEST_P(UnaskedCodes, Told) {
    ASSERT_TRUE(rig.connect());
    meet();
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
INSTANTIATE_TEST_SUITE_P(Fates, UnaskedCodes, ::testing::Values(Fate::Clear, Fate::Doubled, Fate::Late),
                         testName);

/// A command that the robot refuses.
struct Refusal {
    int code;
    Command command;
    int believed;               ///< In its slot.
    std::optional<int> really;  ///< Something else is there.
    bool mayPass;               ///< No message tells it from what was done, once its error is lost.
};

TEST(PlanWeather, EveryRefusalInBadWeather) {
    const Refusal refusals[] = {
        {wire::kErrorSlotFull, CreatePlan{9, 4, PlanRig::kShort}, 0, 5, false},
        {wire::kErrorUpdateOtherPlan, UpdatePlan{9, 4, PlanRig::kShort}, 9, 5, false},
        {wire::kErrorUpdateEmptySlot, UpdatePlan{9, 4, PlanRig::kShort}, 9, 0, false},
        {wire::kErrorUpdateIdle, UpdatePlan{9, 4, PlanRig::kShort}, 9, std::nullopt, true},
        {wire::kErrorExecuteOtherPlan, ExecutePlan{9, 4}, 9, 5, false},
        {wire::kErrorExecuteEmptySlot, ExecutePlan{9, 4}, 9, 0, false},
        {wire::kErrorStopIdle, StopPlan{}, 0, std::nullopt, true},
        {wire::kErrorAdjustIdle, AdjustSpeed{Wheels::BothForward, 10}, 9, std::nullopt, false},
    };
    for (const Refusal& refusal : refusals) {
        int refused = 0;
        for (std::uint64_t seed = 1; seed <= 30; ++seed) {
            const std::string in = std::to_string(refusal.code) + ", seed " + std::to_string(seed);
            sim::NxtOptions options;
            options.seed = seed;
            Deceived rig(options);
            rig.prepare(refusal.believed);
            if (refusal.really) rig.deceive(*refusal.really);
            if (refusal.code == wire::kErrorAdjustIdle) rig.deceiveRunning();
            rig.simulate("strict-update", 1);
            rig.simulate("loss", 0.2);
            rig.simulate("duplicate", 0.3);
            rig.simulate("delay", static_cast<double>(seed % 4 * 100));
            const auto result = rig.ask(refusal.command);
            rig.advance(5s);
            if (result) {
                EXPECT_TRUE(refusal.mayPass) << in;
            } else if (result.error().code == Errc::PlanRefused) {
                EXPECT_EQ(result.error().got, refusal.code) << in;
                ++refused;
            } else {
                EXPECT_EQ(result.error().code, Errc::Unconfirmed) << in;
            }
            EXPECT_LE(rig.count(EventKind::Refused), 1U) << in;
            EXPECT_EQ(rig.count(EventKind::Differs), 0U) << in;
            EXPECT_LE(rig.writtenOf(MessageKind::Execute), 1U) << in;
            EXPECT_LE(rig.writtenOf(MessageKind::Adjust), 1U) << in;
            EXPECT_FALSE(rig.robot().motion()) << in;
        }
        EXPECT_GT(refused, 10) << refusal.code;
    }
}

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
