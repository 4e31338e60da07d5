#include "app/kickstandctl/coach_link.h"

#include <algorithm>

#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

using coach::CoachState;

/// The startup takes five seconds, and a second more on a busy machine.
constexpr Duration kStartupLimit = std::chrono::milliseconds(6000);
constexpr Duration kHeardLimit = std::chrono::seconds(3);
/// Six assertions a third of a second apart.
constexpr Duration kAssertLimit = std::chrono::seconds(4);

tl::unexpected<Failure> notHeard(int boat) {
    return failed({.code = Errc::RobotNotAlive, .got = boat});
}
tl::unexpected<Failure> silent(int boat) {
    return failed({.code = Errc::TimedOut, .subject = "TOWRP " + std::to_string(boat)});
}
tl::unexpected<Failure> obeysAnother(int boat) {
    return failed({.code = Errc::PairedElsewhere, .robot = boat});
}

Outcome pairAfterStartup(SessionRunner& runner, coach::wire::Team boat) {
    const auto available = [&runner, boat] {
        return std::ranges::any_of(radioOf(runner).coach.boats, [boat](const coach::HeardBoat& heard) {
            return heard.team == boat && !heard.coach;
        });
    };
    const auto heard = runner.waitUntil(available, kHeardLimit);
    if (!heard) return tl::unexpected(heard.error());
    if (!*heard) return notHeard(boat);
    if (auto asked = runner.perform(coach::Pair{boat}); !asked) return asked;
    const auto ended = runner.waitUntil(
        [&runner] {
            const CoachState state = radioOf(runner).coach.state;
            return state == CoachState::Paired || state == CoachState::NotPaired;
        },
        kAssertLimit);
    if (!ended) return tl::unexpected(ended.error());
    if (radioOf(runner).coach.state == CoachState::Paired) return {};
    return available() ? silent(boat) : obeysAnother(boat);
}

}  // namespace

Outcome connectRadio(const Context& context, SessionRunner& runner, SessionRunner::Need need) {
    if (!context.invocation.link)
        return badUsage(
            Words::tr("Which serial port the radio module is at is not said."),
            Words::tr("Name it: --link 'serial:/dev/ttyUSB0?protocol=coach', or --link sim:coach."));
    if (auto connected = runner.connect(*context.invocation.link, need); !connected) return connected;
    if (radioOf(runner).link == coach::LinkState::Idle)
        return badUsage(Words::tr("This link is not one to a COACH's or TOWRP's radio module."),
                        Words::tr("Name one, as in --link 'serial:/dev/ttyUSB0?protocol=coach'."));
    return {};
}

Outcome pairWith(SessionRunner& runner, int boat, coach::wire::TeamColor color) {
    const auto& radio = radioOf(runner).radio;
    const coach::wire::Team team = coach::wire::teamOf(radio ? radio->settings.address : std::uint16_t{0});
    if (auto started = runner.perform(coach::StartCoach{team, color}); !started) return started;
    const auto over = runner.waitUntil(
        [&runner] {
            const CoachState state = radioOf(runner).coach.state;
            return state != CoachState::Startup && state != CoachState::Off;
        },
        kStartupLimit);
    if (!over) return tl::unexpected(over.error());
    const bool own = boat < 0 || boat == team;
    if (radioOf(runner).coach.state == CoachState::Paired) {
        if (own) return {};
        // The startup belongs to the own boat; who wants another one gives it up.
        if (auto given = runner.perform(coach::Jettison{}); !given) return given;
    }
    return pairAfterStartup(runner, own ? team : static_cast<coach::wire::Team>(boat));
}

}  // namespace kickstand::ctl
