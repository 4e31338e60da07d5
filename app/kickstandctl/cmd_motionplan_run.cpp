#include <array>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/plan_options.h"
#include "app/kickstandctl/plan_report.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_motionplan.h"

namespace kickstand::ctl {
namespace {

namespace wire = motionplan::wire;

constexpr Duration kRequestLimit = std::chrono::seconds(30);
constexpr Duration kHearLimit = std::chrono::milliseconds(1600);

const motionplan::Snapshot& robotOf(const SessionRunner& runner) {
    return runner.stateOf<motionplan::Snapshot>();
}

/// What the commands that let a robot move have in common: they tell what happens, and end with it stopped.
class Run {
  public:
    explicit Run(const Context& context) : context_(context), runner_(context) {}

    SessionRunner& runner() { return runner_; }
    Outcome begin() {
        if (auto begun = beginMotionplan(runner_); !begun) return begun;
        askForTrigger(runner_);
        runner_.setObserver([this](const EngineEvent& event) {
            context_.output.value(toJson(runner_.engine(), event));
            context_.output.line(eventLine(runner_.engine(), event));
        });
        return {};
    }
    /// Until the plan has ended by itself, or for so long.
    Outcome watch(Duration span) {
        const auto ended = runner_.waitUntil([this] { return !robotOf(runner_).active(); }, span);
        if (!ended) return tl::unexpected(ended.error());
        completed_ = *ended;
        return {};
    }
    Outcome end(Outcome outcome) {
        const motionplan::Snapshot before = robotOf(runner_);
        const bool began = before.connections > 0;
        const bool stopped = runner_.finish();
        if (!began) return outcome;
        if (outcome && !stopped) outcome = failed({.code = Errc::Unconfirmed, .subject = "stop"});
        QJsonObject facts{{QStringLiteral("type"), QStringLiteral("end")},
                          {QStringLiteral("plan_ended"), completed_},
                          {QStringLiteral("stopped"), stopped}};
        addClosing(facts, before);
        if (!outcome) facts[QStringLiteral("error")] = toJson(outcome.error());
        context_.output.value(facts);
        context_.output.line(stopped ? Words::tr("The robot stands, as it says itself.")
                                     : Words::tr("Whether the robot stands is not known."));
        if (const QString closing = closingText(before); !closing.isEmpty()) context_.output.line(closing);
        return outcome;
    }

  private:
    const Context& context_;
    SessionRunner runner_;
    bool completed_ = false;
};

struct ExecuteRequest {
    int slot = 0;
    std::optional<int> plan;
    std::optional<std::vector<motionplan::Movement>> movements;
    Duration span{};
};

Expected<ExecuteRequest> readExecute(const Invocation& invocation) {
    ExecuteRequest request;
    const auto slot = readSlot(invocation);
    if (!slot) return tl::unexpected(slot.error());
    const auto plan = readPlanId(invocation);
    if (!plan) return tl::unexpected(plan.error());
    auto movements = readPlan(invocation, motionplan::PlanUse::Slot);
    if (!movements) return tl::unexpected(movements.error());
    const auto span = parseSeconds(invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    request.slot = *slot;
    request.plan = *plan;
    request.movements = *std::move(movements);
    request.span = *span;
    return request;
}

/// Puts the plan there first, where one was given, and starts the slot's plan.
Outcome start(const ExecuteRequest& request, SessionRunner& runner) {
    if (auto asked = runner.perform(motionplan::QuerySlot{request.slot}, kRequestLimit); !asked) return asked;
    int resident = robotOf(runner).slotStates[static_cast<std::size_t>(request.slot)].plan;
    const bool empty = resident == wire::kNoPlan;
    if (request.movements) {
        const int id = request.plan.value_or(empty ? wire::kFirstPlan : resident);
        const Outcome put =
            empty
                ? runner.perform(motionplan::CreatePlan{id, request.slot, *request.movements}, kRequestLimit)
                : runner.perform(motionplan::UpdatePlan{id, request.slot, *request.movements}, kRequestLimit);
        if (!put) return put;
        resident = id;
    }
    const int id = request.plan.value_or(resident == wire::kNoPlan ? wire::kFirstPlan : resident);
    return runner.perform(motionplan::ExecutePlan{id, request.slot}, kRequestLimit);
}

Outcome execute(const Context& context) {
    const auto request = readExecute(context.invocation);
    if (!request) return tl::unexpected(request.error());
    Run run(context);
    Outcome outcome = run.begin();
    if (outcome) outcome = start(*request, run.runner());
    if (outcome) outcome = run.watch(request->span);
    return run.end(std::move(outcome));
}

Outcome adjust(const Context& context) {
    const auto change = readSpeedChange(context.invocation);
    if (!change) return tl::unexpected(change.error());
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    Run run(context);
    Outcome outcome = run.begin();
    if (outcome) {
        // A robot that executes says so once a second.
        const auto heard = run.runner().waitUntil([&] { return robotOf(run.runner()).active(); }, kHearLimit);
        if (!heard) outcome = tl::unexpected(heard.error());
    }
    if (outcome)
        outcome = run.runner().perform(motionplan::AdjustSpeed{change->wheels, change->change_percent},
                                       kRequestLimit);
    if (outcome) outcome = run.watch(*span);
    return run.end(std::move(outcome));
}

constexpr std::array kExecuteOptions{
    OptionSpec{"--slot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-4"), true},
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long at most"), true},
    OptionSpec{
        "--plan", "ID",
        QT_TRANSLATE_NOOP("kickstandctl", "of the plan in the slot; without it the one that is there")},
    OptionSpec{"--file", "FILE",
               QT_TRANSLATE_NOOP("kickstandctl", "a plan that is put into the slot first, as PLAN is")},
};
constexpr std::array kAdjustOptions{
    OptionSpec{"--wheels", "both|left|right", QT_TRANSLATE_NOOP("kickstandctl", "which"), true},
    OptionSpec{"--change", "PERCENT", QT_TRANSLATE_NOOP("kickstandctl", "-100 to 100"), true},
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long it may go on"), true},
};
constexpr std::size_t kWords = 400;

constexpr CommandSpec kCommands[] = {
    {"motionplan execute", "[PLAN]", 0, kWords,
     QT_TRANSLATE_NOOP("kickstandctl", "Executes the plan of a slot, and stops it when the time is over."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "It ends when the plan does. With a plan, as text or in a file, that is put into the "
                       "slot first."),
     kExecuteOptions, "motionplan execute --slot 4 --for 20 \"forward 25, turn left 84\"", execute},
    {"motionplan adjust", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Changes the speed of wheels while a plan executes."),
     QT_TRANSLATE_NOOP("kickstandctl", "The robot is stopped when the time is over."), kAdjustOptions,
     "motionplan adjust --wheels left --change -30 --for 10", adjust},
};

}  // namespace

std::span<const CommandSpec> motionplanRunCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
