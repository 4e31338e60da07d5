#include <array>

#include "app/kickstandctl/coach_link.h"
#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_coach.h"

namespace kickstand::ctl {
namespace {

namespace wire = coach::wire;
using coach::RadioSettings;

/// Twenty places, and a module that has to be asked for its command mode at half of them.
constexpr Duration kFindLimit = std::chrono::seconds(45);
constexpr Duration kApplyLimit = std::chrono::seconds(30);

QJsonObject toJson(const coach::FoundRadio& radio) {
    return {{QStringLiteral("address"), radio.settings.address},
            {QStringLiteral("channel"), radio.settings.channel},
            {QStringLiteral("pan"), radio.settings.pan},
            {QStringLiteral("api_mode"), static_cast<int>(radio.settings.mode)},
            {QStringLiteral("baud"), static_cast<int>(radio.settings.baud)},
            {QStringLiteral("name"), QString::fromStdString(radio.settings.name)},
            {QStringLiteral("serial"),
             QStringLiteral("%1").arg(radio.identity.serial, 16, 16, QLatin1Char('0')).toUpper()},
            {QStringLiteral("firmware"), radio.identity.firmware},
            {QStringLiteral("hardware"), radio.identity.hardware}};
}

QString hex(unsigned value, int digits) {
    return QStringLiteral("0x") + QStringLiteral("%1").arg(value, digits, 16, QLatin1Char('0')).toUpper();
}

void print(const Context& context, const coach::FoundRadio& radio) {
    const RadioSettings& settings = radio.settings;
    context.output.value(toJson(radio));
    context.output.table(
        {{Words::tr("address"), hex(settings.address, 4), describeAddress(settings.address)},
         {Words::tr("channel"), hex(settings.channel, 2), QString()},
         {Words::tr("network (PAN)"), hex(settings.pan, 4), QString()},
         {Words::tr("mode"), QString::number(static_cast<int>(settings.mode)), describe(settings.mode)},
         {Words::tr("baud"), QString::number(settings.baud), QString()},
         {Words::tr("node name"), QString::fromStdString(settings.name), QString()},
         {Words::tr("serial number"), hex(static_cast<unsigned>(radio.identity.serial >> 32), 8),
          hex(static_cast<unsigned>(radio.identity.serial & 0xFFFFFFFF), 8)},
         {Words::tr("firmware"), hex(radio.identity.firmware, 4), QString()}});
}

/// Connects, and looks for the module where it does not answer as it should.
Outcome reach(const Context& context, SessionRunner& runner) {
    if (auto connected = connectRadio(context, runner, SessionRunner::Need::Open); !connected)
        return connected;
    if (radioOf(runner).link == coach::LinkState::Running && !context.invocation.has("--find")) return {};
    return runner.perform(coach::FindRadio{}, kFindLimit);
}

/// The answer to a command may come before the state that it led to.
Expected<coach::FoundRadio> shown(SessionRunner& runner, const std::optional<RadioSettings>& wanted) {
    const auto there = [&] {
        const auto& radio = radioOf(runner).radio;
        return radioOf(runner).link != coach::LinkState::Setting && radio &&
               (!wanted || radio->settings == *wanted);
    };
    const auto seen = runner.waitUntil(there, std::chrono::seconds(2));
    if (!seen) return tl::unexpected(seen.error());
    if (!*seen) return failed({.code = Errc::TimedOut, .subject = "radio"});
    return *radioOf(runner).radio;
}

Outcome get(const Context& context) {
    SessionRunner runner(context);
    if (auto reached = reach(context, runner); !reached) return reached;
    const auto radio = shown(runner, std::nullopt);
    if (!radio) return tl::unexpected(radio.error());
    print(context, *radio);
    return {};
}

Expected<RadioSettings> preset(const Invocation& invocation, RadioSettings settings) {
    if (!invocation.has("--preset")) return settings;
    const std::string_view name = invocation.text("--preset");
    if (name == "coach" || name == "towrp") {
        const auto team = parseWhole(invocation.text("--team"), "--team", 0, 255);
        if (!team) return tl::unexpected(team.error());
        return presetFor(name == "coach" ? wire::Role::Coach : wire::Role::Towrp,
                         static_cast<wire::Team>(*team), settings);
    }
    if (name != "dongle" && name != "robot")
        return badUsage(Words::tr("There is no such preset."),
                        Words::tr("Give coach, towrp, dongle or robot."));
    const auto radio = parseWhole(invocation.text("--radio"), "--radio", 0, 1);
    if (!radio) return tl::unexpected(radio.error());
    if (name == "dongle") return coach::thunderbotsPreset(std::nullopt, *radio, settings);
    const auto robot = parseRobot(invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    return coach::thunderbotsPreset(*robot, *radio, settings);
}

/// One number of the settings, where its option was given.
template <class Number>
Outcome read(const Invocation& invocation, const char* option, int lowest, int highest, Number& into) {
    if (!invocation.has(option)) return {};
    const auto value = parseWhole(invocation.text(option), option, lowest, highest);
    if (!value) return tl::unexpected(value.error());
    into = static_cast<Number>(*value);
    return {};
}

Expected<RadioSettings> wantedOf(const Invocation& invocation, const RadioSettings& present) {
    auto wanted = preset(invocation, present);
    if (!wanted) return wanted;
    for (auto outcome :
         {read(invocation, "--address", 0, 0xFFFF, wanted->address),
          read(invocation, "--channel", 0x0B, 0x1A, wanted->channel),
          read(invocation, "--pan", 0, 0xFFFF, wanted->pan), read(invocation, "--mode", 0, 2, wanted->mode),
          read(invocation, "--baud", 1200, 250000, wanted->baud)}) {
        if (!outcome) return tl::unexpected(outcome.error());
    }
    if (invocation.has("--name")) wanted->name = std::string(invocation.text("--name"));
    if (auto right = checkSettings(*wanted); !right) return refusedInput(right.error());
    return wanted;
}

Outcome set(const Context& context) {
    // What is typed wrong is said before anything is touched.
    if (const auto right = wantedOf(context.invocation, {}); !right) return tl::unexpected(right.error());
    SessionRunner runner(context);
    if (auto reached = reach(context, runner); !reached) return reached;
    const auto present = shown(runner, std::nullopt);
    if (!present) return tl::unexpected(present.error());
    const auto wanted = wantedOf(context.invocation, present->settings);
    if (!wanted) return tl::unexpected(wanted.error());
    if (auto done = runner.perform(coach::ApplyRadio{*wanted}, kApplyLimit); !done) return done;
    const auto applied = shown(runner, *wanted);
    if (!applied) return tl::unexpected(applied.error());
    print(context, *applied);
    return {};
}

constexpr OptionSpec kFind{
    "--find", "",
    QT_TRANSLATE_NOOP("kickstandctl", "look at every speed, also where the module answers at once")};
constexpr std::array kGetOptions{kFind};
constexpr std::array kSetOptions{
    OptionSpec{"--preset", "NAME",
               QT_TRANSLATE_NOOP(
                   "kickstandctl",
                   "coach or towrp (with --team), dongle (with --radio), robot (with --robot and --radio)")},
    OptionSpec{"--team", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-255")},
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15")},
    OptionSpec{"--radio", "N",
               QT_TRANSLATE_NOOP("kickstandctl", "0 or 1: which of a Thunderbots dongle's or robot's two")},
    OptionSpec{"--address", "N", QT_TRANSLATE_NOOP("kickstandctl", "16 bits, as in 0xBC05")},
    OptionSpec{"--channel", "N", QT_TRANSLATE_NOOP("kickstandctl", "0x0B to 0x1A")},
    OptionSpec{"--pan", "N", QT_TRANSLATE_NOOP("kickstandctl", "the network's number, 16 bits")},
    OptionSpec{"--mode", "N", QT_TRANSLATE_NOOP("kickstandctl", "0 transparent, 1 API, 2 API escaped")},
    OptionSpec{"--baud", "N", QT_TRANSLATE_NOOP("kickstandctl", "1200 to 115200, or 250000")},
    OptionSpec{"--name", "TEXT", QT_TRANSLATE_NOOP("kickstandctl", "the node's name, at most 20 characters")},
    kFind};

constexpr CommandSpec kCommands[] = {
    {"coach radio get", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Reads the settings of the radio module."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "A module that does not answer at this link's speed in API mode is looked for at every speed "
         "and in every mode, which takes up to half a minute."),
     kGetOptions, "coach radio get --link sim:coach", get},
    {"coach radio set", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Sets the radio module, makes that last, and reads it back."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "What is not given stays as it is. A fresh module needs no other program."),
     kSetOptions, "coach radio set --preset coach --team 5 --link sim:coach?fresh=1", set},
};

}  // namespace

std::span<const CommandSpec> coachRadioCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
