#include <QFile>
#include <QJsonDocument>
#include <array>
#include <cstdio>
#include <optional>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/save_file.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/typed_line.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_check.h"
#include "core/engine/describe_check_report.h"

namespace kickstand::ctl {
namespace {

using thunderbots::CheckAnswer;
using thunderbots::CheckPlan;
using thunderbots::CheckProgress;
using thunderbots::CheckRow;
using thunderbots::CheckStage;
using thunderbots::CheckVerdict;
using thunderbots::RobotMask;

/// A check ends by itself, but for a person who does not answer.
constexpr Duration kCheckLimit = std::chrono::hours(12);

/// How the questions are answered; none: by whoever types.
using Seen = std::optional<CheckAnswer>;

Expected<Seen> readSeen(const Invocation& invocation) {
    const std::string_view text = invocation.has("--seen") ? invocation.text("--seen") : "ask";
    if (text == "ask") return Seen{};
    if (text == "yes") return Seen{CheckAnswer::Yes};
    if (text == "no") return Seen{CheckAnswer::No};
    if (text == "skip") return Seen{CheckAnswer::Skip};
    return badUsage(Words::tr("--seen does not take “%1”.").arg(QString::fromUtf8(text.data(), text.size())),
                    Words::tr("It takes yes, no, ask or skip."));
}

Outcome readOnly(std::string_view list, CheckPlan& plan) {
    plan.wheels = plan.dribbler = plan.highVoltage = plan.lights = false;
    const QString text = QString::fromUtf8(list.data(), static_cast<qsizetype>(list.size()));
    for (const QString& part : text.split(u',')) {
        if (part == u"battery") continue;
        bool CheckPlan::*const member = part == u"wheels"     ? &CheckPlan::wheels
                                        : part == u"dribbler" ? &CheckPlan::dribbler
                                        : part == u"kicker"   ? &CheckPlan::highVoltage
                                        : part == u"leds"     ? &CheckPlan::lights
                                                              : nullptr;
        if (member == nullptr) {
            return badUsage(Words::tr("--only does not take “%1”.").arg(part),
                            Words::tr("It takes battery, wheels, dribbler, kicker and leds."));
        }
        plan.*member = true;
    }
    return {};
}

Outcome readLimits(std::string_view path, CheckPlan& plan) {
    QFile file(QString::fromUtf8(path.data(), static_cast<qsizetype>(path.size())));
    if (!file.open(QIODevice::ReadOnly)) {
        return badUsage(Words::tr("%1 cannot be read: %2.").arg(file.fileName(), file.errorString()),
                        Words::tr("Name a file with limits."));
    }
    constexpr qint64 kMost = 1 << 16;
    const auto limits = checkLimitsFromJson(file.read(kMost));
    if (!limits) return badUsage(limits.error(), Words::tr("Mend %1.").arg(file.fileName()));
    plan.limits = *limits;
    return {};
}

Expected<CheckPlan> readPlan(const Invocation& invocation) {
    CheckPlan plan;
    const auto robots = parseRobots(invocation.text("--robot"));
    if (!robots) return tl::unexpected(robots.error());
    plan.robots = *robots;
    if (invocation.has("--only")) {
        if (auto only = readOnly(invocation.text("--only"), plan); !only) return tl::unexpected(only.error());
    }
    if (invocation.has("--limits")) {
        if (auto limits = readLimits(invocation.text("--limits"), plan); !limits)
            return tl::unexpected(limits.error());
    }
    return plan;
}

/// Tells of steps as they end, and has questions answered.
class CheckTeller {
  public:
    CheckTeller(const Context& context, SessionRunner& runner, Seen seen)
        : output_(context.output), runner_(runner), seen_(seen) {}

    /// What is new; the answer to give now, where there is one.
    std::optional<thunderbots::AnswerCheck> look() {
        const CheckProgress& check = *runner_.state().check;
        for (; told_ < check.rows.size() && check.rows[told_].verdict != CheckVerdict::Waiting; ++told_)
            tell(check.rows[told_]);
        if (!check.running() || check.stage != CheckStage::Asking || answered_ == check.current)
            return std::nullopt;
        if (!seen_ && asked_ != check.current) ask(check);
        const auto answer = seen_ ? seen_ : typedAnswer(check);
        if (!answer) return std::nullopt;
        if (*answer != CheckAnswer::Again) answered_ = check.current;
        // That a robot may begin is said by whoever starts the command with an answer to everything.
        const bool ready = check.rows[check.current].step.kind == thunderbots::CheckKind::Ready;
        return thunderbots::AnswerCheck{check.current, ready && seen_ ? CheckAnswer::Yes : *answer};
    }

  private:
    void tell(const CheckRow& row) {
        if (row.step.kind == thunderbots::CheckKind::Ready) return;
        QStringList facts{valueText(row), limitText(row), reasonText(row)};
        facts.removeAll(QString());
        output_.line(Words::tr("robot %1  %2: %3  %4")
                         .arg(row.step.robot)
                         .arg(describe(row.step), describe(row.verdict), facts.join(QStringLiteral(", ")))
                         .trimmed());
    }

    /// On standard error: standard output is the report's.
    void ask(const CheckProgress& check) {
        asked_ = check.current;
        const QString text = Words::tr("Robot %1: %2 [y]es, [n]o, [s]kip%3: ")
                                 .arg(check.rows[check.current].step.robot)
                                 .arg(questionText(check.rows[check.current].step),
                                      check.canRepeat() ? Words::tr(", [a]gain") : QString());
        std::fputs(qPrintable(text), stderr);
        std::fflush(stderr);
    }

    Seen typedAnswer(const CheckProgress& check) {
        const auto line = typed_.take();
        // Whoever has gone away has seen nothing.
        if (!line) return typed_.ended() ? Seen{CheckAnswer::Skip} : Seen{};
        asked_.reset();
        if (line->empty()) return {};
        switch (line->front()) {
            case 'y':
                return CheckAnswer::Yes;
            case 'n':
                return CheckAnswer::No;
            case 's':
                return CheckAnswer::Skip;
            case 'a':
                return check.canRepeat() ? Seen{CheckAnswer::Again} : Seen{};
            default:
                return {};
        }
    }

    Output& output_;
    SessionRunner& runner_;
    const Seen seen_;
    TypedLine typed_;
    std::size_t told_ = 0;
    std::optional<std::size_t> asked_;
    std::optional<std::size_t> answered_;
};

RobotMask liveOf(const SessionRunner& runner, RobotMask robots) {
    RobotMask live = 0;
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        if (thunderbots::contains(robots, robot) && runner.robot(robot).live)
            live |= thunderbots::maskOf(robot);
    }
    return live;
}

Outcome prepare(SessionRunner& runner, Motion& motion, const CheckPlan& plan) {
    if (auto begun = motion.begin(plan.robots); !begun) {
        // One that is not heard fails by itself; the others are checked.
        const bool notHeard = begun.error().code == QLatin1String(name(Errc::RobotNotAlive));
        if (!notHeard || liveOf(runner, plan.robots) == 0) return begun;
    }
    const RobotMask live = liveOf(runner, plan.robots);
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        if (!thunderbots::contains(live, robot)) continue;
        if (auto known = runner.awaitReadings(robot); !known) return known;
    }
    if (!plan.highVoltage) return {};
    return runner.perform(thunderbots::ArmHighVoltage{live, true});
}

Outcome checkThrough(const Context& context, SessionRunner& runner, Motion& motion, const CheckPlan& plan,
                     Seen seen) {
    if (auto ready = prepare(runner, motion, plan); !ready) return ready;
    if (auto started = runner.perform(thunderbots::StartCheck{plan}); !started) return started;
    const auto begun =
        runner.waitUntil([&runner] { return !runner.state().check->rows.empty(); }, kCheckLimit);
    if (!begun) return tl::unexpected(begun.error());
    CheckTeller teller(context, runner, seen);
    while (runner.state().check->running()) {
        std::optional<thunderbots::AnswerCheck> answer;
        const auto met = runner.waitUntil(
            [&] {
                answer = teller.look();
                return answer || !runner.state().check->running();
            },
            kCheckLimit);
        if (!met) return tl::unexpected(met.error());
        if (!*met) return failed({.code = Errc::TimedOut});
        if (!answer) break;
        if (auto taken = runner.perform(*answer); !taken) return taken;
    }
    teller.look();
    return {};
}

Outcome save(const QString& path, const CheckProgress& check, WallTime began) {
    const QByteArray content = path.endsWith(u".html")   ? checkReportHtml(check, began).toUtf8()
                               : path.endsWith(u".json") ? QJsonDocument(checkReport(check, began)).toJson()
                                                         : checkReportText(check, began).toUtf8();
    return saveFile(path, content);
}

/// What came of it, whatever ended it: a report of half a check is worth having too.
Outcome report(const Context& context, SessionRunner& runner, Motion& motion, Outcome outcome) {
    const auto check = runner.state().check;
    if (check->rows.empty()) return outcome;
    const WallTime began = runner.engine().wallTime(check->began);
    motion.tell(QStringLiteral("report"), {{QStringLiteral("report"), checkReport(*check, began)}},
                sentenceOf(*check));
    if (context.invocation.has("--report")) {
        const std::string_view path = context.invocation.text("--report");
        auto saved = save(QString::fromUtf8(path.data(), static_cast<qsizetype>(path.size())), *check, began);
        if (outcome && !saved) outcome = std::move(saved);
    }
    if (!outcome || allPassed(*check)) return outcome;
    return tl::unexpected<Failure>({kFailed,
                                    {sentenceOf(*check), Words::tr("The report says which steps."), {}},
                                    QStringLiteral("check-failed")});
}

Outcome check(const Context& context) {
    const auto plan = readPlan(context.invocation);
    if (!plan) return tl::unexpected(plan.error());
    const auto seen = readSeen(context.invocation);
    if (!seen) return tl::unexpected(seen.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::OneValue);
    auto outcome = checkThrough(context, runner, motion, *plan, *seen);
    return motion.end(report(context, runner, motion, std::move(outcome)));
}

constexpr std::array kCheckOptions{
    OptionSpec{"--robot", "N,M", QT_TRANSLATE_NOOP("kickstandctl", "which: 3, 0,3 or 5-7"), true},
    OptionSpec{"--only", "LIST",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "battery, wheels, dribbler, kicker, leds, with commas; all without it")},
    OptionSpec{"--limits", "FILE",
               QT_TRANSLATE_NOOP("kickstandctl", "limits as JSON, as the Checks panel saves them")},
    OptionSpec{
        "--seen", "ANSWER",
        QT_TRANSLATE_NOOP("kickstandctl", "yes, no or skip to all that a person has to see; ask without it")},
    OptionSpec{"--report", "FILE",
               QT_TRANSLATE_NOOP("kickstandctl", "saves the report; as .html, .json or text")}};

constexpr CommandSpec kCommands[] = {
    {"thunderbots check", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Checks robots on their stands, step by step, and reports."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Runs each wheel both ways and the dribbler, charges, kicks once, and discharges. What no "
         "feedback tells is asked; with --seen the robots move unasked: they must stand free. Exit 0 "
         "only when every step of every robot passed."),
     kCheckOptions, "thunderbots check --robot 3 --report robot3.html", check},
};

}  // namespace

std::span<const CommandSpec> thunderbotsCheckCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
