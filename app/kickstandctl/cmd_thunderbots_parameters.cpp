#include <array>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/history.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/parameter_options.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_parameters.h"

namespace kickstand::ctl {
namespace {

using thunderbots::ParameterState;
using thunderbots::ParameterValues;

/// A request is tried again and again, and robots may be slow.
constexpr Duration kRequestLimit = std::chrono::minutes(2);
/// A robot that copies an image is gone twice.
constexpr Duration kRebootLimit = std::chrono::seconds(40);
/// A robot that has answered the request to reboot has gone by then, and is not back yet.
constexpr Duration kGoes = std::chrono::seconds(1);
constexpr Duration kSoon = std::chrono::milliseconds(300);
constexpr Duration kAnswers = std::chrono::seconds(5);
constexpr Duration kProofLimit = std::chrono::seconds(20);

/// One robot's parameters, and what a person has said about them.
class Work {
  public:
    Work(const Context& context, int robot)
        : context_(context),
          runner_(context),
          motion_(context, runner_, Motion::Style::OneValue),
          robot_(robot) {}

    Outcome begin() {
        if (auto begun = motion_.begin(thunderbots::maskOf(robot_)); !begun) return begun;
        history_.emplace(runner_);
        runner_.setObserver([this](const EngineEvent& event) { history_->take(event); });
        return {};
    }
    /// Ends the command, and gives its history a moment to be written.
    Outcome end(Outcome outcome) {
        outcome = motion_.end(std::move(outcome));
        if (history_) history_->finish();
        return outcome;
    }

    const ParameterState& state() const { return stateOf(robot_); }
    const ParameterState& stateOf(int robot) const {
        return runner_.state().parameters[static_cast<std::size_t>(robot)];
    }
    Outcome ask(const thunderbots::Command& command) { return runner_.perform(command, kRequestLimit); }
    Outcome read() {
        if (auto done = ask(thunderbots::ReadParameters{robot_}); !done) return done;
        return awaitSnapshot([this] { return state().robot.has_value(); });
    }

    Outcome readSignatures() {
        if (auto done = ask(thunderbots::ReadSignatures{robot_}); !done) return done;
        return awaitSnapshot([this] { return state().signatures.has_value(); });
    }

    Outcome apply(const ParameterValues& values) {
        thunderbots::ParameterDraft draft;
        draft.setRobot(state().robot);
        draft.take(values);
        const auto block = *draft.blockWith(thunderbots::kAllParameters);
        if (auto allowed = checkWarnings(block, ParameterStep::Apply); !allowed) return allowed;
        if (auto done = ask(thunderbots::ApplyParameters{robot_, block}); !done) return done;
        return awaitSnapshot([this, &block] { return state().robot == block; });
    }
    Outcome commit() {
        if (auto allowed = checkWarnings(*state().robot, ParameterStep::Commit); !allowed) return allowed;
        if (auto done = ask(thunderbots::CommitParameters{robot_}); !done) return done;
        return awaitSnapshot(
            [this] { return state().standing == thunderbots::ParameterStanding::Committed; });
    }
    /// Reboots it and waits until it is heard again, under its next number.
    Outcome reboot(bool discard) {
        // It comes back under the number that it keeps, which nobody may know here.
        const auto& kept = state().committed ? state().committed : state().robot;
        int next = kept && kept->robotNumber < thunderbots::kRobots ? kept->robotNumber : robot_;
        if (runner_.robot(next).live) next = robot_;
        // A cable's device goes away with its robot.
        if (runner_.state().cable) runner_.watchOnly();
        const bool unknown = context_.invocation.has("--discharged");
        if (auto done = ask(thunderbots::RebootRobot{robot_, discard, unknown}); !done) return done;
        // By now it has gone, and a dongle need never notice: only an answer shows that it is back.
        const TimePoint gone = runner_.engine().now() + kGoes;
        if (auto waited = runner_.waitUntil([] { return false; }, kGoes); !waited)
            return tl::unexpected(waited.error());
        while (runner_.engine().now() < gone + kRebootLimit) {
            for (const int robot : {next, robot_}) {
                if (!runner_.robot(robot).live) continue;
                const auto answered = [&] { return stateOf(robot).robot && stateOf(robot).readAt > gone; };
                if (!answered()) runner_.perform(thunderbots::ReadParameters{robot}, kAnswers);
                const auto known = runner_.waitUntil(answered, kSoon);
                if (!known) return tl::unexpected(known.error());
                if (!*known) continue;
                robot_ = robot;
                return {};
            }
            if (auto waited = runner_.waitUntil([] { return false; }, kSoon); !waited)
                return tl::unexpected(waited.error());
        }
        return failed({.code = Errc::TimedOut, .robot = next});
    }
    /// Waits until what was committed has been found again, or something else.
    Outcome prove() {
        using thunderbots::ParameterStanding;
        if (auto read =
                await([this] { return state().standing >= ParameterStanding::Proven; }, kProofLimit, robot_);
            !read)
            return read;
        if (state().standing == ParameterStanding::Proven) return {};
        return failed({.code = Errc::NotVerified, .robot = robot_});
    }

    void tellParameters() {
        QJsonObject facts = parametersToJson(state());
        facts[QStringLiteral("robot")] = robot_;
        motion_.tell(QStringLiteral("parameters"), facts, describe(state()));
        context_.output.table(parameterRows(state()));
    }
    void tell(const QJsonObject& facts, const QString& text) {
        motion_.tell(QStringLiteral("robot"), facts, text);
    }
    int robot() const { return robot_; }

  private:
    /// An answer may be here before the state that belongs to it.
    Outcome awaitSnapshot(const std::function<bool()>& met) {
        return await(met, std::chrono::seconds(2), robot_);
    }
    Outcome await(const std::function<bool()>& met, Duration limit, int robot) {
        const auto came = runner_.waitUntil(met, limit);
        if (!came) return tl::unexpected(came.error());
        if (!*came) return failed({.code = Errc::TimedOut, .robot = robot});
        return {};
    }

    Outcome checkWarnings(const thunderbots::wire::OperationalParameters& block, ParameterStep step) {
        thunderbots::RobotMask alive = 0;
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            if (runner_.robot(robot).live)
                alive = static_cast<thunderbots::RobotMask>(alive | thunderbots::maskOf(robot));
        }
        const auto now = step == ParameterStep::Apply ? state().robot : std::nullopt;
        for (const auto& warning :
             thunderbots::parameterWarnings(robot_, block, now, runner_.state().channels, alive)) {
            const QString text = describe(warning, step);
            if (warning.serious() && !context_.invocation.has("--yes")) {
                return tl::unexpected<Failure>({kFailed,
                                                {text, Words::tr("If that is meant, give --yes."), {}},
                                                QStringLiteral("needs-yes")});
            }
            if (step == ParameterStep::Apply || warning.serious()) context_.output.line(text);
        }
        return {};
    }

    const Context& context_;
    SessionRunner runner_;
    Motion motion_;
    int robot_;
    std::optional<History> history_;
};

Outcome getParameters(Work& work, const Invocation& invocation) {
    if (auto begun = work.begin(); !begun) return begun;
    if (auto read = work.read(); !read) return read;
    work.tellParameters();
    if (!invocation.has("--file")) return {};
    return saveParameterFile(invocation.text("--file"), thunderbots::valuesOf(*work.state().robot));
}

Outcome setParameters(Work& work, const ParameterValues& values) {
    if (auto begun = work.begin(); !begun) return begun;
    if (auto read = work.read(); !read) return read;
    if (auto applied = work.apply(values); !applied) return applied;
    work.tellParameters();
    return {};
}

Outcome commitParameters(Work& work, const ParameterValues& values, bool reboot) {
    if (auto begun = work.begin(); !begun) return begun;
    if (auto read = work.read(); !read) return read;
    if (values != ParameterValues{}) {
        if (auto applied = work.apply(values); !applied) return applied;
    }
    if (auto committed = work.commit(); !committed) return committed;
    if (reboot) {
        if (auto rebooted = work.reboot(false); !rebooted) return rebooted;
        if (auto proven = work.prove(); !proven) return proven;
    }
    work.tellParameters();
    return {};
}

Outcome readSignatures(Work& work) {
    if (auto begun = work.begin(); !begun) return begun;
    if (auto read = work.read(); !read) return read;
    if (auto done = work.readSignatures(); !done) return done;
    const auto& signatures = work.state().signatures;
    work.tell({{QStringLiteral("robot"), work.robot()},
               {QStringLiteral("microcontroller"), signatures->microcontrollerCrc},
               {QStringLiteral("flash"), signatures->flashCrc}},
              Words::tr("microcontroller %1, flash %2")
                  .arg(signatureText(signatures->microcontrollerCrc), signatureText(signatures->flashCrc)));
    return {};
}

Outcome rebootOne(Work& work, bool discard) {
    if (auto begun = work.begin(); !begun) return begun;
    const int before = work.robot();
    if (auto read = work.read(); !read) return read;
    if (auto rebooted = work.reboot(discard); !rebooted) return rebooted;
    work.tell({{QStringLiteral("robot"), work.robot()}, {QStringLiteral("rebooted"), true}},
              Words::tr("Robot %1 has rebooted and is heard as robot %2.").arg(before).arg(work.robot()));
    return {};
}

/// Reads --robot and, where the command takes them, values; then does the work and ends it.
template <class Do>
Outcome work(const Context& context, Do todo) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    Work work(context, *robot);
    return work.end(todo(work));
}

Expected<ParameterValues> someValues(const Invocation& invocation) {
    auto values = readParameterValues(invocation);
    if (values && *values == ParameterValues{})
        return badUsage(Words::tr("No value was given."), Words::tr("Give FIELD=VALUE, or --file."));
    return values;
}

Outcome paramsGet(const Context& context) {
    return work(context, [&](Work& work) { return getParameters(work, context.invocation); });
}

Outcome paramsSet(const Context& context) {
    const auto values = someValues(context.invocation);
    if (!values) return tl::unexpected(values.error());
    return work(context, [&](Work& work) { return setParameters(work, *values); });
}

Outcome paramsCommit(const Context& context) {
    const auto values = readParameterValues(context.invocation);
    if (!values) return tl::unexpected(values.error());
    const bool reboot = context.invocation.has("--reboot");
    return work(context, [&](Work& work) { return commitParameters(work, *values, reboot); });
}

Outcome signatures(const Context& context) {
    return work(context, [](Work& work) { return readSignatures(work); });
}

Outcome reboot(const Context& context) {
    const bool discard = context.invocation.has("--yes");
    return work(context, [discard](Work& work) { return rebootOne(work, discard); });
}

constexpr OptionSpec kRobot{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true};
constexpr OptionSpec kYes{
    "--yes", "",
    QT_TRANSLATE_NOOP("kickstandctl", "do it although it may lose the robot, or what was not committed")};
constexpr OptionSpec kDischarged{
    "--discharged", "",
    QT_TRANSLATE_NOOP("kickstandctl",
                      "a robot that reports nothing has an empty capacitor: you have seen to it")};
constexpr std::array kGetOptions{
    kRobot, OptionSpec{"--file", "FILE", QT_TRANSLATE_NOOP("kickstandctl", "a JSON file of parameters")}};
constexpr std::array kSetOptions{kRobot, kGetOptions[1], kYes};
constexpr std::array kCommitOptions{
    kRobot, kGetOptions[1], kYes, kDischarged,
    OptionSpec{
        "--reboot", "",
        QT_TRANSLATE_NOOP("kickstandctl", "reboot the robot and read them again, which proves the commit")}};
constexpr std::array kSignatureOptions{kRobot};
constexpr std::array kRebootOptions{kRobot, kYes, kDischarged};

constexpr CommandSpec kCommands[] = {
    {"thunderbots params get", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Reads the operational parameters of a robot."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "They are those that it works with now; only after a reboot they are those that it keeps. "
         "--file writes them down too."),
     kGetOptions, "thunderbots params get --robot 3 --file robot3.json", paramsGet},
    {"thunderbots params set", "[FIELD=VALUE…]", 0, 5,
     QT_TRANSLATE_NOOP("kickstandctl", "Changes parameters of a robot, until it reboots."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Fields: flash_contents, channel0, channel1, robot_number, dribbler_duty. What is given "
         "stands over what --file has. Numbers and channels count from the boot after a commit on."),
     kSetOptions, "thunderbots params set --robot 3 dribbler_duty=60%", paramsSet},
    {"thunderbots params commit", "[FIELD=VALUE…]", 0, 5,
     QT_TRANSLATE_NOOP("kickstandctl", "Has a robot keep its parameters."),
     QT_TRANSLATE_NOOP("kickstandctl", "Values that are given are set before."), kCommitOptions,
     "thunderbots params commit --robot 3 robot_number=5 --reboot", paramsCommit},
    {"thunderbots signatures", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Reads which firmware a robot has, as two CRCs."),
     QT_TRANSLATE_NOOP("kickstandctl", "It takes the robot some seconds to compute them."), kSignatureOptions,
     "thunderbots signatures --robot 3", signatures},
    {"thunderbots reboot", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Reboots a robot and waits until it is heard again."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "It has to be at rest and discharged. What was applied and not committed is lost."),
     kRebootOptions, "thunderbots reboot --robot 3", reboot},
};

}  // namespace

std::span<const CommandSpec> thunderbotsParametersCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
