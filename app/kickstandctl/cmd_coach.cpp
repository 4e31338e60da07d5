#include <algorithm>
#include <array>
#include <map>

#include "app/kickstandctl/coach_play.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_coach.h"

namespace kickstand::ctl {
namespace {

namespace wire = coach::wire;

constexpr Duration kEndless = std::chrono::hours(24 * 365);
constexpr Duration kScanSpan = std::chrono::seconds(3);

/// `--for`, or what is meant without it.
Expected<Duration> readSpan(const Invocation& invocation, Duration otherwise) {
    if (!invocation.has("--for")) return otherwise;
    return parseSeconds(invocation.text("--for"), "--for");
}

struct Heard {
    int rssi_dBm = 0;
    int packets = 0;
    std::optional<int> coach;
};

/// Listens, and sends nothing.
Outcome scan(const Context& context) {
    const auto span = readSpan(context.invocation, kScanSpan);
    if (!span) return tl::unexpected(span.error());
    SessionRunner runner(context);
    if (auto connected = connectRadio(context, runner); !connected) return connected;
    const std::optional<coach::FoundRadio> radio = radioOf(runner).radio;
    const std::optional<int> ownTeam =
        radio ? std::optional<int>(wire::teamOf(radio->settings.address)) : std::nullopt;
    std::map<int, Heard> boats;
    std::uint64_t last = 0;
    const auto listened = runner.waitUntil(
        [&] {
            for (const coach::TrafficEntry& entry : *radioOf(runner).entries) {
                if (entry.number <= last || entry.sent) continue;
                last = entry.number;
                if (wire::roleOf(entry.address) != wire::Role::Towrp) continue;
                Heard& heard = boats[wire::teamOf(entry.address)];
                heard.rssi_dBm = entry.rssi_dBm;
                ++heard.packets;
                if (entry.message.opcode == wire::Opcode::Available) heard.coach.reset();
                if (entry.message.opcode == wire::Opcode::AssertionResult)
                    heard.coach = entry.message.parameter;
                // These go to the COACH that the boat obeys, and to nobody else.
                if (entry.message.opcode == wire::Opcode::UpdateMorale ||
                    entry.message.opcode == wire::Opcode::MutinyInProgress)
                    heard.coach = ownTeam;
            }
            return false;
        },
        *span);
    if (!listened) return tl::unexpected(listened.error());
    QJsonArray json;
    QList<QStringList> rows{
        {Words::tr("<TOWRP"), Words::tr("<strength"), Words::tr("<packets"), Words::tr("state")}};
    for (const auto& [team, heard] : boats) {
        QJsonObject boat{{QStringLiteral("team"), team},
                         {QStringLiteral("rssi_dBm"), heard.rssi_dBm},
                         {QStringLiteral("packets"), heard.packets},
                         {QStringLiteral("coach"), QJsonValue::Null}};
        if (heard.coach) boat[QStringLiteral("coach")] = *heard.coach;
        json.append(boat);
        rows.append({QString::number(team), Words::tr("%1 dBm").arg(heard.rssi_dBm),
                     QString::number(heard.packets),
                     heard.coach ? Words::tr("obeys COACH %1").arg(*heard.coach) : Words::tr("available")});
    }
    context.output.value(QJsonObject{{QStringLiteral("towrps"), json}});
    if (boats.empty()) {
        context.output.line(Words::tr("No TOWRP is heard."));
    } else {
        context.output.table(rows);
    }
    return {};
}

/// Tells every packet; sends nothing.
Outcome monitor(const Context& context) {
    const auto span = readSpan(context.invocation, kEndless);
    if (!span) return tl::unexpected(span.error());
    SessionRunner runner(context);
    if (auto connected = connectRadio(context, runner); !connected) return connected;
    std::uint64_t last = 0;
    const auto listened = runner.waitUntil(
        [&] {
            for (const coach::TrafficEntry& entry : *radioOf(runner).entries) {
                if (entry.number <= last) continue;
                last = entry.number;
                const QString from = describeAddress(entry.address);
                context.output.value(
                    QJsonObject{{QStringLiteral("time"), isoTime(runner.engine(), entry.time)},
                                {QStringLiteral("source"), entry.address},
                                {QStringLiteral("rssi_dBm"), entry.rssi_dBm},
                                {QStringLiteral("message"), wire::specOf(entry.message.opcode).name},
                                {QStringLiteral("parameter"), entry.message.parameter}});
                context.output.line(Words::tr("%1  %2  %3 dBm  %4")
                                        .arg(clockText(runner.engine(), entry.time), from)
                                        .arg(entry.rssi_dBm)
                                        .arg(describe(entry.message)));
            }
            return false;
        },
        *span);
    if (!listened) return tl::unexpected(listened.error());
    return {};
}

Outcome pair(const Context& context) {
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    CoachPlay play(context);
    Outcome outcome = play.pair();
    if (outcome) outcome = play.keepFor(*span);
    return play.end(std::move(outcome));
}

/// A percentage, snapped to the nearest of the levels that there are.
Expected<int> readLevel(const Invocation& invocation, const char* option) {
    if (!invocation.has(option)) return 0;
    const auto percent = parseDecimal(invocation.text(option), option, -100, 100);
    if (!percent) return tl::unexpected(percent.error());
    return wire::nearestLevel(*percent);
}

Outcome drive(const Context& context) {
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    const auto forward = readLevel(context.invocation, "--forward");
    if (!forward) return tl::unexpected(forward.error());
    const auto turn = readLevel(context.invocation, "--turn");
    if (!turn) return tl::unexpected(turn.error());
    CoachPlay play(context);
    Outcome outcome = play.pair();
    if (outcome) outcome = play.runner().perform(coach::Steer{{*forward, *turn}});
    if (outcome) {
        const wire::Velocity velocity{*forward, *turn};
        play.tell(
            QStringLiteral("driving"),
            {{QStringLiteral("forward_percent"), wire::percentOf(*forward)},
             {QStringLiteral("turn_percent"), wire::percentOf(*turn)},
             {QStringLiteral("for_s"), seconds(*span)}},
            Words::tr("Driving: %1, for %2 s; Ctrl+C stops.").arg(describe(velocity)).arg(seconds(*span)));
        outcome = play.keepFor(*span);
    }
    return play.end(std::move(outcome));
}

/// Pairs, sends one thing, and waits until the radio says what became of it.
Outcome once(const Context& context, const coach::Command& command, wire::Opcode opcode) {
    CoachPlay play(context);
    Outcome outcome = play.pair();
    if (outcome) outcome = play.runner().perform(command);
    if (outcome) outcome = play.awaitSent(opcode);
    return play.end(std::move(outcome));
}

Outcome freeDigital(const Context& context) {
    return once(context, coach::FreeDigital{}, wire::Opcode::FreeDigital);
}

Outcome freeAnalog(const Context& context) {
    const auto percent = parseWhole(context.invocation.text("--percent"), "--percent", -100, 100);
    if (!percent) return tl::unexpected(percent.error());
    return once(context, coach::FreeAnalog{*percent}, wire::Opcode::FreeAnalog);
}

Outcome suppress(const Context& context) {
    return once(context, coach::Suppress{}, wire::Opcode::SuppressMutiny);
}

Outcome jettison(const Context& context) {
    return once(context, coach::Jettison{}, wire::Opcode::Jettison);
}

/// Tells a velocity that is another one than the last.
void tellVelocity(CoachPlay& play, wire::Velocity& told) {
    const wire::Velocity velocity = radioOf(play.runner()).towrp.velocity;
    if (velocity == told) return;
    told = velocity;
    play.tell(QStringLiteral("velocity"),
              {{QStringLiteral("forward_percent"), wire::percentOf(velocity.forward)},
               {QStringLiteral("turn_percent"), wire::percentOf(velocity.turn)}},
              Words::tr("Velocity: %1").arg(describe(velocity)));
}

/// The morale is that of a crew which obeys: it is set once a COACH has come.
Outcome beTheBoat(CoachPlay& play, Duration span, std::optional<int> morale) {
    SessionRunner& runner = play.runner();
    const TimePoint end = runner.engine().now() + span;
    const wire::Team team = wire::teamOf(radioOf(runner).radio->settings.address);
    if (auto started = runner.perform(coach::StartTowrp{team}); !started) return started;
    wire::Velocity told;
    if (morale) {
        const auto paired = runner.waitUntil(
            [&] {
                tellVelocity(play, told);
                return radioOf(runner).towrp.state == coach::TowrpState::Paired;
            },
            end - runner.engine().now());
        if (!paired) return tl::unexpected(paired.error());
        if (*paired) {
            if (auto set = runner.perform(coach::SetMorale{*morale}); !set) return set;
        }
    }
    const auto kept = runner.waitUntil(
        [&] {
            tellVelocity(play, told);
            return false;
        },
        end - runner.engine().now());
    if (!kept) return tl::unexpected(kept.error());
    return {};
}

/// Plays the boat.
Outcome towrp(const Context& context) {
    const auto span = parseSeconds(context.invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    std::optional<int> morale;
    if (context.invocation.has("--morale")) {
        const auto given =
            parseWhole(context.invocation.text("--morale"), "--morale", wire::kMutinyMorale, 127);
        if (!given) return tl::unexpected(given.error());
        morale = *given;
    }
    CoachPlay play(context);
    Outcome outcome = play.connect();
    if (outcome) outcome = beTheBoat(play, *span, morale);
    return play.end(std::move(outcome));
}

constexpr OptionSpec kBoat{
    "--boat", "N", QT_TRANSLATE_NOOP("kickstandctl", "the team of the boat; without it this COACH's own")};
constexpr OptionSpec kColor{"--color", "COLOR",
                            QT_TRANSLATE_NOOP("kickstandctl", "red (as without it) or blue")};
constexpr OptionSpec kFor{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long"), true};
constexpr std::array kListenOptions{
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long")}};
constexpr std::array kPairOptions{kBoat, kColor, kFor};
constexpr std::array kOnceOptions{kBoat, kColor};
constexpr std::array kDriveOptions{
    OptionSpec{"--forward", "PERCENT",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "-100 to 100, snapped to the nearest of 0, 15, 29, 45, 59, 75, 89, 100")},
    OptionSpec{"--turn", "PERCENT",
               QT_TRANSLATE_NOOP("kickstandctl", "the same; positive is counterclockwise")},
    kBoat, kColor, kFor};
constexpr std::array kAnalogOptions{
    OptionSpec{"--percent", "N", QT_TRANSLATE_NOOP("kickstandctl", "-100 to 100"), true}, kBoat, kColor};
constexpr std::array kTowrpOptions{
    OptionSpec{"--morale", "N",
               QT_TRANSLATE_NOOP("kickstandctl", "the crew's morale once it is paired; -10 is a mutiny")},
    kFor};

constexpr const char kPairs[] = QT_TRANSLATE_NOOP(
    "kickstandctl",
    "Plays the COACH that the radio module is set up for: its startup first, then the boat that is "
    "asked for. When it ends in any way, zero velocity is sent.");
constexpr const char kSilent[] = QT_TRANSLATE_NOOP("kickstandctl", "Only listens: nothing is sent by radio.");

constexpr CommandSpec kCommands[] = {
    {"coach scan", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Lists the TOWRPs that are heard."), kSilent,
     kListenOptions, "coach scan --link sim:coach", scan},
    {"coach monitor", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Shows every packet that is heard."),
     kSilent, kListenOptions, "coach monitor --for 10 --link sim:coach", monitor},
    {"coach pair", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Pairs with a boat and holds it still for a time."), kPairs,
     kPairOptions, "coach pair --boat 7 --for 10 --link sim:coach", pair},
    {"coach drive", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Drives a boat for a time."), kPairs,
     kDriveOptions, "coach drive --forward 59 --turn -15 --for 3 --link sim:coach", drive},
    {"coach free-digital", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Sends Free Digital to a boat."),
     kPairs, kOnceOptions, "coach free-digital --link sim:coach", freeDigital},
    {"coach free-analog", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Sends Free Analog to a boat."), kPairs,
     kAnalogOptions, "coach free-analog --percent -40 --link sim:coach", freeAnalog},
    {"coach suppress", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Sends Suppress Mutiny to a boat."),
     kPairs, kOnceOptions, "coach suppress --link sim:coach", suppress},
    {"coach jettison", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Gives a boat up."), kPairs, kOnceOptions,
     "coach jettison --link sim:coach", jettison},
    {"coach towrp", "", 0, 0, QT_TRANSLATE_NOOP("kickstandctl", "Plays the TOWRP, the boat, for a time."),
     QT_TRANSLATE_NOOP("kickstandctl", "So that a team can test its own COACH."), kTowrpOptions,
     "coach towrp --for 10 --link sim:coach?address=0xAF05", towrp},
};

}  // namespace

std::span<const CommandSpec> coachCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
