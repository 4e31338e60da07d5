#include <array>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

using thunderbots::RobotMask;
using thunderbots::WheelSpeeds;

struct DriveRequest {
    RobotMask robots = 0;
    WheelSpeeds wheels{};
    Duration span{};
    int limit = thunderbots::kStartingWheelLimit;
    bool dribble = false;
};

Expected<DriveRequest> readDrive(const Invocation& invocation) {
    DriveRequest request;
    const auto robots = parseRobots(invocation.text("--robot"));
    if (!robots) return tl::unexpected(robots.error());
    const auto span = parseSeconds(invocation.text("--for"), "--for");
    if (!span) return tl::unexpected(span.error());
    if (invocation.has("--limit")) {
        const auto limit = parseWhole(invocation.text("--limit"), "--limit", 0, thunderbots::kFastestWheel);
        if (!limit) return tl::unexpected(limit.error());
        request.limit = *limit;
    }
    const auto wheels = parseWheels(invocation.text("--wheels"), request.limit);
    if (!wheels) return tl::unexpected(wheels.error());
    request.robots = *robots;
    request.span = *span;
    request.wheels = *wheels;
    request.dribble = invocation.has("--dribble");
    return request;
}

Outcome start(const DriveRequest& request, SessionRunner& runner) {
    if (request.limit != thunderbots::kStartingWheelLimit) {
        if (auto limit = runner.perform(thunderbots::SetWheelLimit{request.limit}); !limit) return limit;
    }
    if (auto wheels = runner.perform(thunderbots::SetWheels{request.robots, request.wheels, false}); !wheels)
        return wheels;
    if (!request.dribble) return {};
    return runner.perform(thunderbots::SetDribbler{request.robots, true});
}

void tellDrive(const DriveRequest& request, Motion& motion) {
    QJsonArray speeds;
    QStringList numbers;
    for (const int speed : request.wheels) {
        speeds.append(speed);
        numbers << QString::number(speed);
    }
    const double span_s = seconds(request.span);
    motion.tell(QStringLiteral("driving"),
                {{QStringLiteral("robots"), toJson(request.robots)},
                 {QStringLiteral("wheels"), speeds},
                 {QStringLiteral("dribble"), request.dribble},
                 {QStringLiteral("for_s"), span_s}},
                Words::tr("Driving %1 with %2 for %3 s; Ctrl+C brakes.")
                    .arg(robotsPhrase(request.robots), numbers.join(QLatin1Char(',')))
                    .arg(span_s));
}

Outcome drive(const Context& context) {
    const auto request = readDrive(context.invocation);
    if (!request) return tl::unexpected(request.error());
    SessionRunner runner(context);
    Motion motion(context, runner, Motion::Style::Stream);
    Outcome outcome = motion.begin(request->robots);
    if (outcome) outcome = start(*request, runner);
    if (outcome) {
        tellDrive(*request, motion);
        outcome = motion.keepFor(request->span);
    }
    return motion.end(std::move(outcome));
}

constexpr std::array kDriveOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15; several as in 0,3,5-7"), true},
    OptionSpec{
        "--wheels", "A,B,C,D",
        QT_TRANSLATE_NOOP(
            "kickstandctl",
            "front left, back left, back right, front right, in quarter-degrees per 5 ms (42 is 350 rpm)"),
        true},
    OptionSpec{"--for", "SECONDS", QT_TRANSLATE_NOOP("kickstandctl", "how long"), true},
    OptionSpec{"--limit", "N",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "allow up to ±N (at most 1023) and no ramp above ±100; without it ±100")},
    OptionSpec{"--dribble", "", QT_TRANSLATE_NOOP("kickstandctl", "run the dribbler too")},
};

constexpr CommandSpec kCommands[] = {
    {"thunderbots drive", "", 0, 0,
     QT_TRANSLATE_NOOP("kickstandctl", "Runs the wheels of one or several robots for a time."),
     QT_TRANSLATE_NOOP("kickstandctl",
                       "The robots brake when the time is over, and when the command ends in any other way."),
     kDriveOptions, "thunderbots drive --robot 3 --wheels 40,-36,36,-40 --for 2", drive},
};

}  // namespace

std::span<const CommandSpec> thunderbotsDriveCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
