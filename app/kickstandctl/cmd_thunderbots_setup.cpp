#include <array>
#include <optional>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

namespace wire = thunderbots::wire;

constexpr Duration kGivenLimit = std::chrono::seconds(2);
/// As long as a dongle may take to set up its radios.
constexpr Duration kRestartLimit = std::chrono::seconds(15);
constexpr int kLowestChannel = 0x0B;
constexpr int kHighestChannel = 0x1A;

Expected<wire::TestClass> readClass(const Invocation& invocation) {
    const auto testClass = wire::testClassFromName(invocation.text("--class"));
    if (testClass) return *testClass;
    QStringList names;
    for (std::uint8_t number = 0; number < wire::kTestClassCount; ++number)
        names << QLatin1String(wire::name(static_cast<wire::TestClass>(number)));
    return badUsage(Words::tr("--class cannot be that."),
                    Words::tr("It is one of: %1.").arg(names.join(QStringLiteral(", "))));
}

Expected<wire::TestMode> readTestMode(const Invocation& invocation) {
    const auto testClass = readClass(invocation);
    if (!testClass) return tl::unexpected(testClass.error());
    wire::TestMode mode{*testClass, 0};
    const wire::TestTargets targets = wire::targetsOf(*testClass);
    const QString name = QLatin1String(wire::name(*testClass));
    if (!targets.any()) {
        if (invocation.has("--target"))
            return badUsage(Words::tr("Class %1 has no targets.").arg(name),
                            Words::tr("Leave --target out."));
        return mode;
    }
    if (!invocation.has("--target"))
        return badUsage(Words::tr("Class %1 needs --target.").arg(name),
                        Words::tr("It is a number from %1 to %2.").arg(targets.first).arg(targets.last));
    const auto target = parseWhole(invocation.text("--target"), "--target", targets.first, targets.last);
    if (!target) return tl::unexpected(target.error());
    mode.target = static_cast<std::uint8_t>(*target);
    return mode;
}

Outcome showTest(SessionRunner& runner, Motion& motion, int robot, const wire::TestMode& mode) {
    if (auto begun = motion.begin(thunderbots::maskOf(robot)); !begun) return begun;
    const auto set =
        thunderbots::SetTestMode{thunderbots::maskOf(robot), mode, thunderbots::TestModeWay::Message};
    if (auto asked = runner.perform(set); !asked) return asked;
    const auto given =
        runner.waitUntil([&] { return runner.robot(robot).toldTestMode == mode; }, kGivenLimit);
    if (!given) return tl::unexpected(given.error());
    if (!*given) return failed({.code = Errc::TimedOut, .robot = robot});
    const QString name = QLatin1String(wire::name(mode.testClass));
    motion.tell(QStringLiteral("test-mode"),
                {{QStringLiteral("robot"), robot},
                 {QStringLiteral("class"), name},
                 {QStringLiteral("target"), mode.target}},
                mode.target != 0
                    ? Words::tr("Test mode for robot %1 given to the dongle: %2 %3.")
                          .arg(robot)
                          .arg(name)
                          .arg(mode.target)
                    : Words::tr("Test mode for robot %1 given to the dongle: %2.").arg(robot).arg(name));
    return {};
}

Outcome testMode(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    const auto mode = readTestMode(context.invocation);
    if (!mode) return tl::unexpected(mode.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::OneValue);
    return motion.end(showTest(runner, motion, *robot, *mode));
}

Expected<std::optional<wire::Channels>> readChannels(const Invocation& invocation) {
    const auto& operands = invocation.operands;
    if (operands.empty()) return std::nullopt;
    if (operands.size() == 1)
        return badUsage(Words::tr("The channel of radio 1 is missing."),
                        Words::tr("Give both, as in 0x0E 0x0F, or none to read them."));
    const auto channel0 = parseWhole(operands[0], "channel 0", kLowestChannel, kHighestChannel);
    if (!channel0) return tl::unexpected(channel0.error());
    const auto channel1 = parseWhole(operands[1], "channel 1", kLowestChannel, kHighestChannel);
    if (!channel1) return tl::unexpected(channel1.error());
    return wire::Channels{static_cast<std::uint8_t>(*channel0), static_cast<std::uint8_t>(*channel1)};
}

/// Waits until the dongle has said which channels it uses.
Outcome awaitChannels(SessionRunner& runner, const std::optional<wire::Channels>& wanted) {
    const auto known = runner.waitUntil(
        [&] {
            const auto& channels = runner.state().channels;
            return channels && (!wanted || channels == wanted);
        },
        kGivenLimit);
    if (!known) return tl::unexpected(known.error());
    if (!*known) return failed({.code = Errc::TimedOut, .subject = "channels"});
    return {};
}

Outcome setChannels(SessionRunner& runner, const wire::Channels& wanted) {
    const std::uint64_t before = runner.state().connections;
    if (auto set = runner.perform(thunderbots::SetChannels{wanted.channel0, wanted.channel1}); !set)
        return set;
    const auto restarted = runner.waitUntil(
        [&] {
            return runner.state().connections > before &&
                   runner.state().link == thunderbots::LinkState::Running;
        },
        kRestartLimit);
    if (!restarted) return tl::unexpected(restarted.error());
    if (!*restarted) return failed({.code = Errc::TimedOut, .subject = "radios"});
    return {};
}

Outcome channels(const Context& context) {
    const auto wanted = readChannels(context.invocation);
    if (!wanted) return tl::unexpected(wanted.error());
    SessionRunner runner(context);
    if (auto connected = runner.connect(); !connected) return connected;
    if (runner.state().cable)
        return failed({.code = Errc::Unsupported, .subject = "channels", .detail = "a cable has no radios"});
    if (*wanted) {
        if (auto set = setChannels(runner, **wanted); !set) return set;
    }
    if (auto known = awaitChannels(runner, *wanted); !known) return known;
    const wire::Channels now = *runner.state().channels;
    context.output.value(QJsonObject{{QStringLiteral("channels"), QJsonArray{now.channel0, now.channel1}}});
    context.output.line(
        Words::tr("radio 0: channel %1 (0x%2)").arg(now.channel0).arg(now.channel0, 2, 16, QLatin1Char('0')));
    context.output.line(
        Words::tr("radio 1: channel %1 (0x%2)").arg(now.channel1).arg(now.channel1, 2, 16, QLatin1Char('0')));
    return {};
}

constexpr std::array kTestModeOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true},
    OptionSpec{"--class", "NAME",
               QT_TRANSLATE_NOOP("kickstandctl", "none, lamp, hall, encoder, encoder-count or charger"),
               true},
    OptionSpec{"--target", "N",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "hall: motor 1-5, 5 the dribbler; encoder, encoder-count: wheel 1-4")},
};

constexpr CommandSpec kCommands[] = {
    {"thunderbots test-mode", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Chooses what the four LEDs of a robot show."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "They show it until they are told otherwise, or the robot reboots. “none” is normal."),
     kTestModeOptions, "thunderbots test-mode --robot 3 --class encoder --target 2", testMode},
    {"thunderbots channels",
     "[A B]",
     0,
     2,
     QT_TRANSLATE_NOOP("kickstandctl", "Reads the dongle's two radio channels, or sets them."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Each 0x0B-0x1A, or 11-26. Setting them brakes all robots and starts the radios anew."),
     {},
     "thunderbots channels 0x0E 0x0F",
     channels},
};

}  // namespace

std::span<const CommandSpec> thunderbotsSetupCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
