#include <array>
#include <cmath>
#include <optional>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/kick_options.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

using thunderbots::maskOf;

/// A discharge ends by itself, or when it does not get anywhere; this is for a robot that does neither.
constexpr Duration kDischargeLimit = std::chrono::minutes(5);
constexpr Duration kProgressEvery = std::chrono::milliseconds(250);
constexpr double kProgressStep_V = 2;
/// The most that is sensible to wait for: the robot regulates its capacitor somewhat above 215 V.
constexpr double kHighest_V = 215;

Outcome arm(SessionRunner& runner, int robot) {
    return runner.perform(thunderbots::ArmHighVoltage{maskOf(robot), true});
}

/// Tells a capacitor's voltage as it changes.
class Progress {
  public:
    Progress(SessionRunner& runner, Motion& motion, int robot)
        : runner_(runner), motion_(motion), robot_(robot) {}

    /// The voltage now, if it is known.
    std::optional<double> look() {
        const thunderbots::RobotState& robot = runner_.robot(robot_);
        if (robot.freshness != thunderbots::Freshness::Current) return std::nullopt;
        const double capacitor_V = robot.readings.capacitor_V;
        const TimePoint now = runner_.engine().now();
        if (now - toldAt_ >= kProgressEvery && std::abs(capacitor_V - told_V_) >= kProgressStep_V) {
            toldAt_ = now;
            told_V_ = capacitor_V;
            motion_.tell(
                QStringLiteral("capacitor"),
                {{QStringLiteral("robot"), robot_}, {QStringLiteral("capacitor_V"), rounded(capacitor_V)}},
                Words::tr("Robot %1: %2").arg(robot_).arg(capacitorText(capacitor_V)));
        }
        return capacitor_V;
    }

  private:
    SessionRunner& runner_;
    Motion& motion_;
    const int robot_;
    TimePoint toldAt_{};
    double told_V_ = -kProgressStep_V;
};

Outcome kickOnce(SessionRunner& runner, Motion& motion, int robot,
                 const thunderbots::wire::KickEncoding& kick) {
    if (auto begun = motion.begin(maskOf(robot)); !begun) return begun;
    if (auto known = runner.awaitReadings(robot); !known) return known;
    const double capacitor_V = runner.robot(robot).readings.capacitor_V;
    if (auto armed = arm(runner, robot); !armed) return armed;
    if (auto given = runner.perform(thunderbots::Kick{robot, kick.times}); !given) return given;
    QJsonObject facts = kickToJson(kick);
    facts[QStringLiteral("robot")] = robot;
    facts[QStringLiteral("given_to_dongle")] = true;
    facts[QStringLiteral("capacitor_before_V")] = rounded(capacitor_V);
    motion.tell(QStringLiteral("kick"), facts,
                Words::tr("Kick for robot %1 given to the dongle: %2; its capacitor had %3.")
                    .arg(robot)
                    .arg(kickText(kick), capacitorText(capacitor_V)));
    return {};
}

Outcome kick(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    const auto encoding = readKick(context.invocation);
    if (!encoding) return tl::unexpected(encoding.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::OneValue);
    return motion.end(kickOnce(runner, motion, *robot, *encoding));
}

Outcome startAutokick(SessionRunner& runner, Motion& motion, int robot,
                      const thunderbots::wire::KickEncoding& kick, bool charge) {
    if (auto begun = motion.begin(maskOf(robot)); !begun) return begun;
    if (auto armed = arm(runner, robot); !armed) return armed;
    if (charge) {
        if (auto charging = runner.perform(thunderbots::SetCharger{maskOf(robot), true}); !charging)
            return charging;
    }
    return runner.perform(thunderbots::SetAutokick{maskOf(robot), true, kick.times});
}

Outcome autokick(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    const auto encoding = readKick(context.invocation);
    if (!encoding) return tl::unexpected(encoding.error());
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::Stream);
    Outcome outcome = startAutokick(runner, motion, *robot, *encoding, context.invocation.has("--charge"));
    if (outcome) {
        QJsonObject facts = kickToJson(*encoding);
        facts[QStringLiteral("robot")] = *robot;
        facts[QStringLiteral("for_s")] = seconds(*span);
        motion.tell(
            QStringLiteral("autokick"), facts,
            Words::tr("Robot %1 kicks by itself with %2 when it has the ball, for %3 s; Ctrl+C disarms.")
                .arg(*robot)
                .arg(kickText(*encoding))
                .arg(seconds(*span)));
        outcome = motion.keepFor(*span);
    }
    return motion.end(std::move(outcome));
}

Outcome chargeFor(SessionRunner& runner, Motion& motion, int robot, Duration span,
                  std::optional<double> until_V) {
    if (auto begun = motion.begin(maskOf(robot)); !begun) return begun;
    if (auto armed = arm(runner, robot); !armed) return armed;
    if (auto charging = runner.perform(thunderbots::SetCharger{maskOf(robot), true}); !charging)
        return charging;
    Progress progress(runner, motion, robot);
    const auto reached = runner.waitUntil(
        [&progress, until_V] {
            const auto capacitor_V = progress.look();
            return until_V && capacitor_V && *capacitor_V >= *until_V;
        },
        span);
    if (!reached) return tl::unexpected(reached.error());
    if (*reached || !until_V) return {};
    auto failure = failed({.code = Errc::TimedOut, .robot = robot});
    failure.value().text = {
        Words::tr("Robot %1 did not come to %2 in time.").arg(robot).arg(capacitorText(*until_V)),
        Words::tr("Give it longer with --for, and check its battery."),
        {}};
    return failure;
}

Outcome charge(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    std::optional<double> until_V;
    if (context.invocation.has("--until")) {
        const auto volts = parseDecimal(context.invocation.text("--until"), "--until", 1, kHighest_V);
        if (!volts) return tl::unexpected(volts.error());
        until_V = *volts;
    }
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::Stream);
    return motion.end(chargeFor(runner, motion, *robot, *span, until_V));
}

Outcome dischargeFully(SessionRunner& runner, Motion& motion, int robot) {
    std::optional<thunderbots::Event> ended;
    motion.setHook([&ended, robot](const thunderbots::Event& event) {
        if (event.kind == thunderbots::EventKind::DischargeEnded && event.robot == robot) ended = event;
    });
    if (auto begun = motion.begin(maskOf(robot)); !begun) return begun;
    if (auto known = runner.awaitReadings(robot); !known) return known;
    if (auto armed = arm(runner, robot); !armed) return armed;
    if (auto started = runner.perform(thunderbots::Discharge{robot, true}); !started) return started;
    Progress progress(runner, motion, robot);
    const auto done = runner.waitUntil(
        [&] {
            progress.look();
            return ended.has_value();
        },
        kDischargeLimit);
    motion.setHook({});
    if (!done) return tl::unexpected(done.error());
    if (!*done) return failed({.code = Errc::TimedOut, .robot = robot});
    if (ended->code != 0) return failed({.code = static_cast<Errc>(ended->code), .robot = robot});
    return {};
}

Outcome discharge(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::Stream);
    return motion.end(dischargeFully(runner, motion, *robot));
}

constexpr OptionSpec kRobotOption{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true};
constexpr OptionSpec kForOption{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long"), true};

constexpr std::array kChargeOptions{
    kRobotOption, kForOption,
    OptionSpec{"--until", "V",
               QT_TRANSLATE_NOOP(
                   "kickstandctl",
                   "end as soon as the capacitor has so many volts; exit 1 when it does not get there")}};
constexpr std::array kDischargeOptions{kRobotOption};

constexpr std::array kAutokickOptions{
    kKickOptions[0],
    kKickOptions[1],
    kKickOptions[2],
    kKickOptions[3],
    kForOption,
    OptionSpec{"--charge", "", QT_TRANSLATE_NOOP("kickstandctl", "keep the capacitor charged meanwhile")}};

constexpr CommandSpec kCommands[] = {
    {"thunderbots kick", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Kicks once. Arms the high voltage of that robot itself."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "Times go to the nearest 32 µs; what is really sent is said. A kick is given to the "
                       "dongle: no robot says that it kicked."),
     kKickOptions, "thunderbots kick --robot 3 --width1 2400", kick},
    {"thunderbots autokick", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Lets a robot kick by itself whenever it has the ball, for a time."),
     "", kAutokickOptions, "thunderbots autokick --robot 3 --width1 2400 --for 30 --charge", autokick},
    {"thunderbots charge", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Charges a robot's capacitor for a time, or up to a voltage."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "The charge stays when the command has ended: treat the robot as live until it was discharged."),
     kChargeOptions, "thunderbots charge --robot 3 --for 10 --until 200", charge},
    {"thunderbots discharge", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Empties a robot's capacitor with short pulses, down to 25 V."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "The pulses are too short to move the ball far, but keep clear of the kicker."),
     kDischargeOptions, "thunderbots discharge --robot 3", discharge},
};

}  // namespace

std::span<const CommandSpec> thunderbotsKickCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
