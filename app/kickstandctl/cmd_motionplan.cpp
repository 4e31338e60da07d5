#include <array>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/plan_options.h"
#include "app/kickstandctl/plan_report.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

namespace wire = motionplan::wire;
using motionplan::Movement;
using motionplan::PlanUse;

/// Requests may be sent several times, each with its wait (protocol 6.2).
constexpr Duration kRequestLimit = std::chrono::seconds(30);
constexpr Duration kAnswerLimit = std::chrono::seconds(5);
/// A robot that executes says so once a second.
constexpr Duration kStatusLimit = std::chrono::milliseconds(1600);

tl::unexpected<Failure> planMissing() {
    return badUsage(Words::tr("No plan is given."),
                    Words::tr("Write it, as in \"forward 25, turn left 84\", or name a file with --file."));
}

Outcome connectRobot(SessionRunner& runner) {
    if (auto connected = runner.connect(); !connected) return connected;
    if (runner.stateOf<motionplan::Snapshot>().connections == 0)
        return badUsage(Words::tr("This link does not lead to a robot with motion plans."),
                        Words::tr("Name one, as in --link serial:/dev/rfcomm0?protocol=motionplan."));
    return {};
}

/// Connects, and waits until the robot has answered.
Outcome begin(SessionRunner& runner) {
    if (auto connected = connectRobot(runner); !connected) return connected;
    const auto answers =
        runner.waitUntil([&runner] { return runner.stateOf<motionplan::Snapshot>().answers; }, kAnswerLimit);
    if (!answers) return tl::unexpected(answers.error());
    if (!*answers) return failed({.code = Errc::TimedOut, .subject = "robot"});
    return {};
}

/// Says what the robot does when it is let go of, which it does after a command that failed as well.
void tellClosing(const Context& context, const motionplan::Snapshot& robot, const Failure& failure) {
    if (robot.connections == 0) return;
    QJsonObject facts{{QStringLiteral("error"), toJson(failure)}};
    addClosing(facts, robot);
    context.output.value(facts);
    if (const QString closing = closingText(robot); !closing.isEmpty()) context.output.line(closing);
}

/// What a command with one answer does: connects, does it, shows how it left the robot, and leaves it so.
template <class Do>
Outcome once(const Context& context, Do act) {
    SessionRunner runner(context);
    Outcome outcome = begin(runner);
    if (outcome) outcome = act(runner);
    askForTrigger(runner);
    const motionplan::Snapshot& robot = runner.stateOf<motionplan::Snapshot>();
    if (outcome)
        showRobot(context.output, runner.uri(), robot);
    else
        tellClosing(context, robot, outcome.error());
    runner.leave();
    return outcome;
}

Outcome createOrUpdate(const Context& context, bool create) {
    const auto slot = readSlot(context.invocation);
    if (!slot) return tl::unexpected(slot.error());
    const auto id = readPlanId(context.invocation);
    if (!id) return tl::unexpected(id.error());
    const auto plan = readPlan(context.invocation, PlanUse::Slot);
    if (!plan) return tl::unexpected(plan.error());
    if (!*plan) return planMissing();
    return once(context, [&](SessionRunner& runner) -> Outcome {
        if (create) return runner.perform(motionplan::CreatePlan{**id, *slot, **plan}, kRequestLimit);
        if (auto asked = runner.perform(motionplan::QuerySlot{*slot}, kRequestLimit); !asked) return asked;
        const auto& places = runner.stateOf<motionplan::Snapshot>().slotStates;
        const int resident = places[static_cast<std::size_t>(*slot)].plan;
        const int target = id->value_or(resident == wire::kNoPlan ? wire::kFirstPlan : resident);
        return runner.perform(motionplan::UpdatePlan{target, *slot, **plan}, kRequestLimit);
    });
}

Outcome create(const Context& context) {
    return createOrUpdate(context, true);
}
Outcome update(const Context& context) {
    return createOrUpdate(context, false);
}

Outcome query(const Context& context) {
    std::optional<int> only;
    if (context.invocation.has("--slot")) {
        const auto slot = readSlot(context.invocation);
        if (!slot) return tl::unexpected(slot.error());
        only = *slot;
    }
    return once(context, [&](SessionRunner& runner) -> Outcome {
        for (int slot = 0; slot < wire::kSlots; ++slot) {
            if (only && *only != slot) continue;
            if (auto asked = runner.perform(motionplan::QuerySlot{slot}, kRequestLimit); !asked) return asked;
        }
        return {};
    });
}

Outcome trigger(const Context& context) {
    const auto id = readPlanId(context.invocation);
    if (!id) return tl::unexpected(id.error());
    const auto plan = readPlan(context.invocation, PlanUse::Trigger);
    if (!plan) return tl::unexpected(plan.error());
    if (id->has_value() && !*plan) return planMissing();
    return once(context, [&](SessionRunner& runner) -> Outcome {
        if (!*plan) return runner.perform(motionplan::ReadTrigger{}, kRequestLimit);
        return runner.perform(motionplan::SetTrigger{id->value_or(wire::kFirstPlan), **plan}, kRequestLimit);
    });
}

Outcome status(const Context& context) {
    return once(context, [](SessionRunner& runner) -> Outcome {
        const auto heard = runner.waitUntil(
            [&] { return runner.stateOf<motionplan::Snapshot>().execution.step > 0; }, kStatusLimit);
        if (!heard) return tl::unexpected(heard.error());
        return {};
    });
}

Outcome stop(const Context& context) {
    SessionRunner runner(context);
    // Not after an answer: a robot that is silent may hear.
    if (auto connected = connectRobot(runner); !connected) return connected;
    const motionplan::Snapshot robot = stopAndAsk(runner);
    const bool stopped = runner.finish();
    Outcome outcome;
    if (!stopped) outcome = failed({.code = Errc::Unconfirmed, .subject = "stop"});
    QJsonObject facts{{QStringLiteral("stopped"), stopped}};
    addClosing(facts, robot);
    if (!outcome) facts[QStringLiteral("error")] = toJson(outcome.error());
    context.output.value(facts);
    if (stopped) context.output.line(Words::tr("The robot stands, as it says itself."));
    if (const QString closing = closingText(robot); !closing.isEmpty()) context.output.line(closing);
    return outcome;
}

constexpr OptionSpec kSlot{"--slot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-4"), true};
constexpr OptionSpec kFile{"--file", "FILE",
                           QT_TRANSLATE_NOOP("kickstandctl", "a file with the plan, instead of its text")};
constexpr std::array kCreateOptions{
    kSlot, OptionSpec{"--plan", "ID", QT_TRANSLATE_NOOP("kickstandctl", "1-254"), true}, kFile};
constexpr std::array kUpdateOptions{
    kSlot,
    OptionSpec{
        "--plan", "ID",
        QT_TRANSLATE_NOOP("kickstandctl", "of the plan in the slot; without it the one that is there")},
    kFile};
constexpr std::array kQueryOptions{
    OptionSpec{"--slot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-4; all of them without it")}};
constexpr std::array kTriggerOptions{
    OptionSpec{"--plan", "ID", QT_TRANSLATE_NOOP("kickstandctl", "1-254; 1 without it")}, kFile};
constexpr std::size_t kWords = 400;

constexpr CommandSpec kCommands[] = {
    {"motionplan create", "[PLAN]", 0, kWords,
     QT_TRANSLATE_NOOP("kickstandctl", "Puts a plan into an empty slot of the robot."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "A plan is text: forward 25, back 50, turn left 84, turn right back 30; centimetres "
                       "and degrees, parted by commas."),
     kCreateOptions, "motionplan create --slot 4 --plan 9 \"forward 25, turn left 84, forward 50\"", create},
    {"motionplan update", "[PLAN]", 0, kWords,
     QT_TRANSLATE_NOOP("kickstandctl", "Replaces the plan in a slot of the robot."), "", kUpdateOptions,
     "motionplan update --slot 4 --file square.plan", update},
    {"motionplan query", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Asks which plans are in the robot's slots."), "", kQueryOptions,
     "motionplan query", query},
    {"motionplan trigger", "[PLAN]", 0, kWords,
     QT_TRANSLATE_NOOP("kickstandctl", "Sets the plan that starts when the connection is lost, or reads it."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Without a plan it only reads. A robot cannot tell a connection that was closed from "
                       "one that was lost."),
     kTriggerOptions, "motionplan trigger --plan 7 \"back 50\"", trigger},
    {"motionplan status",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl", "Shows what the robot says of itself; leaves it as it is."),
     "",
     {},
     "motionplan status",
     status},
    {"motionplan stop",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl", "Stops the plan that executes."),
     QT_TRANSLATE_NOOP("kickstandctl", "It cannot reach a robot whose Bluetooth is gone."),
     {},
     "motionplan stop",
     stop},
};

}  // namespace

Outcome beginMotionplan(SessionRunner& runner) {
    return begin(runner);
}

void askForTrigger(SessionRunner& runner) {
    const motionplan::Snapshot& robot = runner.stateOf<motionplan::Snapshot>();
    if (robot.trigger.known || !robot.answers) return;
    static_cast<void>(runner.perform(motionplan::ReadTrigger{}, kRequestLimit));
}

motionplan::Snapshot stopAndAsk(SessionRunner& runner) {
    static_cast<void>(runner.perform(motionplan::StopPlan{}, kRequestLimit));
    askForTrigger(runner);
    return runner.stateOf<motionplan::Snapshot>();
}

std::span<const CommandSpec> motionplanCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
