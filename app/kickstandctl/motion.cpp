#include "app/kickstandctl/motion.h"

#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {

Motion::Motion(const Context& context, SessionRunner& runner, Style style)
    : context_(context), runner_(runner), style_(style) {}

Outcome Motion::begin(thunderbots::RobotMask robots) {
    robots_ = robots;
    if (auto connected = runner_.connect(); !connected) return connected;
    runner_.setObserver([this](const EngineEvent& event) { told(event); });
    return runner_.awaitRobots(robots);
}

void Motion::told(const EngineEvent& event) {
    if (listener_) listener_(event);
    // Of robots that were not asked for, only what somebody should worry about.
    const int robot = robotOf(event);
    const bool concerns = robot < 0 || thunderbots::contains(robots_, robot) ||
                          describe(event).severity != Severity::Information;
    if (style_ == Style::Stream && concerns) {
        context_.output.value(toJson(runner_.engine(), event));
        context_.output.line(eventLine(runner_.engine(), event));
    }
    const auto* system = std::get_if<SystemEvent>(&event.body);
    const auto* own = system == nullptr ? nullptr : std::get_if<thunderbots::Event>(system);
    if (own != nullptr && hook_) hook_(*own);
}

Outcome Motion::keepFor(Duration span) {
    const auto kept = runner_.waitUntil([] { return false; }, span);
    if (!kept) return tl::unexpected(kept.error());
    return {};
}

void Motion::tell(const QString& type, QJsonObject facts, const QString& text) {
    context_.output.line(text);
    if (style_ == Style::Stream) {
        facts[QStringLiteral("type")] = type;
        context_.output.value(facts);
        return;
    }
    for (auto fact = facts.constBegin(); fact != facts.constEnd(); ++fact)
        facts_[fact.key()] = fact.value();
}

Outcome Motion::end(Outcome outcome) {
    const bool began = runner_.state().connections > 0;
    const bool braked = runner_.finish();
    if (outcome && !braked) {
        outcome = failed({.code = Errc::TimedOut, .subject = "braking"});
        outcome.error().text.remedy =
            Words::tr("Keep clear: the robots brake by themselves within two seconds.");
    }
    if (!began) return outcome;
    QJsonArray capacitors;
    for (int number = 0; number < thunderbots::kRobots; ++number) {
        const thunderbots::RobotState& robot = runner_.robot(number);
        const QString live = liveCapacitorText(number, robot);
        if (live.isEmpty()) continue;
        capacitors.append(QJsonObject{{QStringLiteral("robot"), number},
                                      {QStringLiteral("last_V"), rounded(robot.capacitor->last_V)}});
        context_.output.line(live);
    }
    QJsonObject facts{{QStringLiteral("braked"), braked},
                      {QStringLiteral("completed"), outcome.has_value()},
                      {QStringLiteral("live_capacitors"), capacitors},
                      {QStringLiteral("robots"), toJson(robots_)}};
    if (!outcome) facts[QStringLiteral("error")] = toJson(outcome.error());
    tell(QStringLiteral("end"), facts,
         braked ? Words::tr("All robots are braked.")
                : Words::tr("Whether the robots are braked is not known."));
    if (style_ == Style::OneValue) context_.output.value(facts_);
    return outcome;
}

}  // namespace kickstand::ctl
