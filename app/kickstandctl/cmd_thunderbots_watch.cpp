#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_facts.h"
#include "core/thunderbots/wire/readings.h"

namespace kickstand::ctl {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::Freshness;
using thunderbots::kRobots;
using thunderbots::RobotState;

constexpr Duration kEndless = std::chrono::hours(24 * 365);
constexpr Duration kLinesApart = std::chrono::milliseconds(250);

/// "ball, charged", "stale for 12 s": what is not a number.
QString conditionText(const RobotState& robot, TimePoint now) {
    QStringList words;
    if (robot.freshness == Freshness::Waiting) words << Words::tr("no readings yet");
    if (robot.freshness == Freshness::Stale)
        words << Words::tr("not heard for %1 s").arg(seconds(now - robot.currentUntil), 0, 'f', 0);
    if (!robot.feedback) return words.join(QStringLiteral(", "));
    if (robot.readings.battery_V < wire::kBatteryEmpty_V)
        words << Words::tr("battery at its end");
    else if (robot.readings.battery_V < wire::kBatteryLow_V)
        words << Words::tr("battery low");
    if (robot.readings.capacitor_V >= wire::kCapacitorLive_V) words << Words::tr("LIVE capacitor");
    if (robot.readings.charged) words << Words::tr("charged");
    if (robot.readings.ball) words << Words::tr("ball");
    return words.join(QStringLiteral(", "));
}

QStringList robotRow(int number, const RobotState& robot, TimePoint now) {
    const QString none = QStringLiteral("-");
    const bool known = robot.feedback.has_value();
    const auto& readings = robot.readings;
    return {QString::number(number),
            known ? batteryText(readings.battery_V) : none,
            known ? capacitorText(readings.capacitor_V) : none,
            known ? Words::tr("%1 °C").arg(readings.dribbler_C, 0, 'f', 0) : none,
            known ? QString::number(readings.light_adc) : none,
            conditionText(robot, now)};
}

void printLink(const Context& context, const SessionRunner& runner) {
    const thunderbots::Snapshot& state = runner.state();
    QString radios = describe(state.radios);
    if (state.channels)
        radios +=
            Words::tr(", channels %1 and %2").arg(state.channels->channel0).arg(state.channels->channel1);
    const QString away = state.roundTrip
                             ? Words::tr("server %1 ms away").arg(seconds(*state.roundTrip) * 1000, 0, 'f', 1)
                             : QString();
    context.output.table({
        {Words::tr("link"), QString::fromStdString(toString(runner.uri())), deviceText(runner.uri(), state),
         away},
        {Words::tr("e-stop"), describe(state.eStop), QString(), QString()},
        {Words::tr("radios"), radios, QString(), QString()},
    });
}

void printRobots(const Context& context, const thunderbots::Snapshot& state) {
    QList<QStringList> rows{{Words::tr("<robot"), Words::tr("<battery"), Words::tr("<capacitor"),
                             Words::tr("<dribbler"), Words::tr("<light"), Words::tr("state")}};
    thunderbots::RobotMask silent = 0;
    for (int number = 0; number < kRobots; ++number) {
        const RobotState& robot = state.robots[static_cast<std::size_t>(number)];
        if (robot.freshness == Freshness::NotHeard)
            silent |= thunderbots::maskOf(number);
        else
            rows.append(robotRow(number, robot, state.time));
    }
    if (rows.size() > 1) context.output.table(rows);
    if (silent != 0) context.output.line(Words::tr("not heard: %1").arg(robotsText(silent)));
}

Outcome status(const Context& context) {
    SessionRunner runner(context);
    if (auto connected = runner.connect(); !connected) return connected;
    if (auto settled = runner.settle(); !settled) return settled;
    const thunderbots::Snapshot& state = runner.state();
    QJsonObject json = linkToJson(runner.uri(), state);
    QJsonArray robots;
    for (int number = 0; number < kRobots; ++number)
        robots.append(robotToJson(number, runner.robot(number), state.time));
    json[QStringLiteral("robots")] = robots;
    context.output.value(json);
    printLink(context, runner);
    printRobots(context, state);
    return {};
}

/// Tells what changed from one look to the next.
class Watch {
  public:
    Watch(const Context& context, SessionRunner& runner) : context_(context), runner_(runner) {}

    void look() {
        for (int number = 0; number < kRobots; ++number) {
            const RobotState& robot = runner_.robot(number);
            Shown& shown = shown_[static_cast<std::size_t>(number)];
            if (shown.freshness == robot.freshness && shown.feedback == robot.feedback) continue;
            const TimePoint now = runner_.engine().now();
            // A script gets every change; a person is spared the noise of the converters.
            if (!context_.output.isJson() && !matters(shown, robot, now)) continue;
            shown = {robot.freshness, robot.feedback, robot.readings, now};
            tell(number, robot);
        }
    }

  private:
    struct Shown {
        Freshness freshness = Freshness::NotHeard;
        std::optional<wire::FeedbackBlock> feedback;
        thunderbots::Readings readings;
        TimePoint at{};
    };

    /// Whether a person would see a difference: a state at once, a number when it has moved a little and the
    /// last line is not too fresh.
    static bool matters(const Shown& shown, const RobotState& robot, TimePoint now) {
        const thunderbots::Readings& before = shown.readings;
        const thunderbots::Readings& after = robot.readings;
        if (shown.freshness != robot.freshness || before.ball != after.ball ||
            before.charged != after.charged)
            return true;
        if (now - shown.at < kLinesApart) return false;
        return std::abs(after.battery_V - before.battery_V) >= 0.1 ||
               std::abs(after.capacitor_V - before.capacitor_V) >= 2 ||
               std::abs(after.dribbler_C - before.dribbler_C) >= 2 ||
               std::abs(after.light_adc - before.light_adc) >= 10;
    }

    void tell(int number, const RobotState& robot) {
        const TimePoint now = runner_.state().time;
        QJsonObject json = robotToJson(number, robot, now);
        json[QStringLiteral("type")] = QStringLiteral("readings");
        json[QStringLiteral("time")] = isoTime(runner_.engine(), now);
        context_.output.value(json);
        const QStringList row = robotRow(number, robot, now);
        context_.output.line(QStringLiteral("%1  %2  %3  %4  %5  %6  %7")
                                 .arg(clockText(runner_.engine(), now),
                                      Words::tr("robot %1").arg(number).leftJustified(8),
                                      row[1].rightJustified(7), row[2].rightJustified(6),
                                      row[3].rightJustified(6), row[4].rightJustified(4), row[5])
                                 .trimmed());
    }

    const Context& context_;
    SessionRunner& runner_;
    std::array<Shown, kRobots> shown_;
};

Outcome watchFor(SessionRunner& runner, const Context& context, Duration span) {
    runner.setObserver([&](const EngineEvent& event) {
        context.output.value(toJson(runner.engine(), event));
        context.output.line(eventLine(runner.engine(), event));
    });
    if (auto connected = runner.connect(); !connected) return connected;
    runner.watchOnly();
    Watch watch(context, runner);
    const auto watched = runner.waitUntil(
        [&watch] {
            watch.look();
            return false;
        },
        span);
    if (!watched) return tl::unexpected(watched.error());
    return {};
}

Outcome monitor(const Context& context) {
    const bool endless = !context.invocation.has("--for");
    Duration span = kEndless;
    if (!endless) {
        const auto parsed = parseSeconds(context.invocation.text("--for"), "--for");
        if (!parsed) return tl::unexpected(parsed.error());
        span = *parsed;
    }
    SessionRunner runner(context);
    Outcome outcome = watchFor(runner, context, span);
    // Ctrl+C is how one that has no end is ended.
    if (endless && context.interruption.isRequest()) return {};
    return outcome;
}

constexpr std::array kMonitorOptions{
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long; without it until Ctrl+C")}};

constexpr CommandSpec kCommands[] = {
    {"thunderbots status",
     "",
     0,
     0,
     QT_TRANSLATE_NOOP("kickstandctl", "Shows the link, the e-stop, the radios and every robot, once."),
     "",
     {},
     "--link sim:thunderbots?robots=0-3 thunderbots status",
     status},
    {"thunderbots monitor", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Prints events, and readings as they change."), "", kMonitorOptions,
     "--json thunderbots monitor --for 10", monitor},
};

}  // namespace

std::span<const CommandSpec> thunderbotsWatchCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
