#include <array>
#include <optional>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::KickMeasure;
using thunderbots::KickRecord;
using thunderbots::maskOf;
using thunderbots::SweepPlan;

constexpr int kLongest_s =
    static_cast<int>(std::chrono::duration_cast<std::chrono::seconds>(SweepPlan::kLongestPause).count());
/// A sweep ends by itself; this is for one that does not.
constexpr Duration kSweepLimit = std::chrono::hours(12);

/// Reads a whole number; what was there before where it was not given.
Outcome read(const Invocation& invocation, const char* option, int lowest, int highest, int& value) {
    if (!invocation.has(option)) return {};
    const auto parsed = parseWhole(invocation.text(option), option, lowest, highest);
    if (!parsed) return tl::unexpected(parsed.error());
    value = *parsed;
    return {};
}

/// The same for seconds.
Outcome read(const Invocation& invocation, const char* option, double lowest_s, Duration& value) {
    if (!invocation.has(option)) return {};
    const auto parsed = parseDecimal(invocation.text(option), option, lowest_s, kLongest_s);
    if (!parsed) return tl::unexpected(parsed.error());
    value = fromSeconds(*parsed);
    return {};
}

Expected<SweepPlan> readPlan(const Invocation& invocation) {
    SweepPlan plan;
    const auto robot = parseRobot(invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    plan.robot = *robot;
    const auto whole = [&invocation](const char* option, int lowest, int highest, int& value) {
        return read(invocation, option, lowest, highest, value);
    };
    const Outcome outcomes[] = {
        whole("--from", 0, wire::kKickMax_us, plan.from_us),
        whole("--to", 0, wire::kKickMax_us, plan.to_us),
        whole("--step", wire::kKickStep_us, wire::kKickMax_us, plan.step_us),
        whole("--solenoid", 1, 2, plan.solenoid),
        whole("--other-width", 0, wire::kKickMax_us, plan.otherWidth_us),
        whole("--offset", -wire::kKickMax_us, wire::kKickMax_us, plan.offset_us),
        whole("--count", 1, SweepPlan::kMostKicksPerStep, plan.kicksPerStep),
        read(invocation, "--pause", 0, plan.pause),
        read(invocation, "--charge-limit", 0.01, plan.chargeLimit),
    };
    for (const Outcome& outcome : outcomes) {
        if (!outcome) return tl::unexpected(outcome.error());
    }
    if (const auto kicks = thunderbots::planSweep(plan); !kicks) return refusedInput(kicks.error());
    return plan;
}

QJsonValue orNull(const std::optional<double>& value) {
    return value ? QJsonValue(rounded(*value)) : QJsonValue(QJsonValue::Null);
}

QString resultText(const KickRecord& record) {
    if (!record.drop_V()) return Words::tr("not measured");
    QString text = Words::tr("capacitor %1 to %2, a drop of %3 V")
                       .arg(capacitorText(*record.before_V), capacitorText(*record.after_V))
                       .arg(*record.drop_V(), 0, 'f', 1);
    if (record.recharge)
        text += Words::tr(", charged again in %1 s").arg(seconds(*record.recharge), 0, 'f', 2);
    return text;
}

/// Tells each kick once, as soon as what it did is known.
class KickTeller {
  public:
    KickTeller(SessionRunner& runner, Motion& motion) : runner_(runner), motion_(motion) {}

    void look() {
        for (const KickRecord& record : *runner_.state().kicks) {
            if (record.number <= told_ || record.cause != thunderbots::KickCause::Sweep) continue;
            if (record.measure == KickMeasure::Waiting || record.measure == KickMeasure::Recharging) return;
            told_ = record.number;
            tell(record);
        }
    }

  private:
    void tell(const KickRecord& record) {
        const wire::KickPulses pulses = wire::personTermsOf(record.times.value_or(wire::KickTimes{}));
        const QJsonValue recharge =
            record.recharge ? QJsonValue(rounded(seconds(*record.recharge))) : QJsonValue(QJsonValue::Null);
        motion_.tell(
            QStringLiteral("kick"),
            {{QStringLiteral("robot"), record.robot},
             {QStringLiteral("given_to_dongle"), true},
             {QStringLiteral("width1_us"), pulses.width1_us},
             {QStringLiteral("width2_us"), pulses.width2_us},
             {QStringLiteral("offset_us"), pulses.offset_us},
             {QStringLiteral("before_V"), orNull(record.before_V)},
             {QStringLiteral("after_V"), orNull(record.after_V)},
             {QStringLiteral("drop_V"), orNull(record.drop_V())},
             {QStringLiteral("recharge_s"), recharge}},
            Words::tr("%1 / %2 µs: %3").arg(pulses.width1_us).arg(pulses.width2_us).arg(resultText(record)));
    }

    SessionRunner& runner_;
    Motion& motion_;
    std::uint64_t told_ = 0;
};

Outcome sweepThrough(SessionRunner& runner, Motion& motion, const SweepPlan& plan) {
    std::optional<thunderbots::Event> ended;
    motion.setHook([&ended](const thunderbots::Event& event) {
        if (event.kind == thunderbots::EventKind::SweepEnded) ended = event;
    });
    if (auto begun = motion.begin(maskOf(plan.robot)); !begun) return begun;
    if (auto known = runner.awaitReadings(plan.robot); !known) return known;
    if (auto armed = runner.perform(thunderbots::ArmHighVoltage{maskOf(plan.robot), true}); !armed)
        return armed;
    if (auto started = runner.perform(thunderbots::StartSweep{plan}); !started) return started;
    KickTeller teller(runner, motion);
    const auto done = runner.waitUntil(
        [&] {
            teller.look();
            // The last kick is in the snapshot that says that the sweep is over.
            return ended && runner.state().sweep && !runner.state().sweep->running();
        },
        kSweepLimit);
    motion.setHook({});
    if (!done) return tl::unexpected(done.error());
    if (!*done) return failed({.code = Errc::TimedOut, .robot = plan.robot});
    teller.look();
    if (ended->code != 0) return failed({.code = static_cast<Errc>(ended->code), .robot = plan.robot});
    return {};
}

Outcome sweep(const Context& context) {
    const auto plan = readPlan(context.invocation);
    if (!plan) return tl::unexpected(plan.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::Stream);
    return motion.end(sweepThrough(runner, motion, *plan));
}

constexpr std::array kSweepOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true},
    OptionSpec{"--from", "US", QT_TRANSLATE_NOOP("kickstandctl", "the first width, in µs"), true},
    OptionSpec{"--to", "US", QT_TRANSLATE_NOOP("kickstandctl", "the last width, or the last before it"),
               true},
    OptionSpec{"--step", "US", QT_TRANSLATE_NOOP("kickstandctl", "from width to width; at least 32"), true},
    OptionSpec{"--solenoid", "N", QT_TRANSLATE_NOOP("kickstandctl", "whose width: 1 (the kicker) or 2")},
    OptionSpec{"--other-width", "US",
               QT_TRANSLATE_NOOP("kickstandctl", "the other solenoid's pulse; 0 without it")},
    OptionSpec{
        "--offset", "US",
        QT_TRANSLATE_NOOP("kickstandctl", "how much later solenoid 2 begins, in µs; negative: solenoid 1")},
    OptionSpec{"--count", "N", QT_TRANSLATE_NOOP("kickstandctl", "kicks with each width; 1 without it")},
    OptionSpec{"--pause", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "at least so long from kick to kick")},
    OptionSpec{"--charge-limit", "SECONDS",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "how long charging may take before it ends with exit 1; 30 without it")}};

constexpr CommandSpec kCommands[] = {
    {"thunderbots sweep", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Kicks with one width after another and measures what each does."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Arms the high voltage of that robot itself, keeps its capacitor charging, and waits for "
         "it before each kick. Ctrl+C stops it. The charge stays when the command has ended: "
         "treat the robot as live until it was discharged."),
     kSweepOptions, "thunderbots sweep --robot 3 --from 640 --to 2560 --step 320", sweep},
};

}  // namespace

std::span<const CommandSpec> thunderbotsSweepCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
