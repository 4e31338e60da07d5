#include "app/kickstandctl/coach_runner.h"

#include <algorithm>
#include <optional>

#include "app/composition/composition.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/words.h"

namespace kickstand::ctl {
namespace {

using coach::CoachState;
using coach::LinkState;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Duration kTick = milliseconds(10);
constexpr Duration kConnectLimit = seconds(15);
/// The startup takes five seconds, and a second more on a busy machine.
constexpr Duration kStartupLimit = milliseconds(6000);
constexpr Duration kHeardLimit = seconds(3);
/// Six assertions a third of a second apart.
constexpr Duration kAssertLimit = seconds(4);
constexpr Duration kStopLimit = milliseconds(500);

Error errorOf(Errc code, std::string subject = {}) {
    Error error;
    error.code = code;
    error.subject = std::move(subject);
    return error;
}

Outcome notHeard(int team) {
    Error error = errorOf(Errc::RobotNotAlive);
    error.robot = team;
    return failed(error);
}

}  // namespace

CoachRunner::CoachRunner(const Context& context) : context_(context), engine_(makeLinkProvider()) {
    refresh();
}

CoachRunner::~CoachRunner() {
    finish();
}

Outcome CoachRunner::connect(bool anyModule) {
    if (!context_.invocation.link)
        return badUsage(
            Words::tr("Which serial port the radio module is at is not said."),
            Words::tr("Name it: --link 'serial:/dev/ttyUSB0?protocol=coach', or --link sim:coach."));
    uri_ = *context_.invocation.link;
    const auto opened = engine_.connect(uri_);
    if (!opened) return failed(opened.error());
    session_ = *opened;
    std::optional<Error> refusal;
    const auto decided = waitUntil(
        [this, &refusal] {
            for (const Answer& answer : engine_.takeAnswers()) {
                if (answer.session == session_ && !answer.result) refusal = answer.result.error();
            }
            if (refusal) return true;
            // A link of another system never comes to be what is waited for.
            if (session() != nullptr && !std::holds_alternative<coach::Snapshot>(session()->system))
                return true;
            const LinkState link = state().link;
            return link == LinkState::Failed || link == LinkState::Searching || link == LinkState::NoModule ||
                   (link == LinkState::Running && snapshot_->heartbeatFresh);
        },
        kConnectLimit);
    if (!decided) return tl::unexpected(decided.error());
    if (refusal) return refusedInput(*refusal);
    if (!*decided) return failed(errorOf(Errc::TimedOut, toString(uri_)));
    if (session() != nullptr && !std::holds_alternative<coach::Snapshot>(session()->system))
        return badUsage(Words::tr("This link is not one to a COACH's or TOWRP's radio module."),
                        Words::tr("Name one, as in --link 'serial:/dev/ttyUSB0?protocol=coach'."));
    if (state().error) return failed(*state().error);
    if (state().link == LinkState::NoModule && !anyModule) return failed(errorOf(Errc::RadioNotReady));
    connected_ = true;
    return {};
}

Outcome CoachRunner::perform(const coach::Command& command, Duration limit) {
    const auto id = engine_.submit(session_, SystemCommand(command));
    if (!id) return failed(id.error());
    std::optional<Result<void>> result;
    const auto answered = waitUntil(
        [this, &result, &id] {
            for (Answer& answer : engine_.takeAnswers()) {
                if (answer.id == *id) result = std::move(answer.result);
            }
            return result.has_value();
        },
        limit);
    if (!answered) return tl::unexpected(answered.error());
    if (!result) return failed(errorOf(Errc::TimedOut));
    if (!*result) return failed(result->error());
    return {};
}

Outcome CoachRunner::pairWith(int boat, coach::wire::TeamColor color) {
    const std::uint16_t address = state().radio ? state().radio->settings.address : std::uint16_t{0};
    const coach::wire::Team team = coach::wire::teamOf(address);
    if (auto started = perform(coach::StartCoach{team, color}); !started) return started;
    const auto over = waitUntil(
        [this] {
            return state().coach.state != CoachState::Startup && state().coach.state != CoachState::Off;
        },
        kStartupLimit);
    if (!over) return tl::unexpected(over.error());
    const bool own = boat < 0 || boat == team;
    if (state().coach.state == CoachState::Paired) {
        if (own) return {};
        // The startup belongs to the own boat; who wants another one gives it up.
        if (auto given = perform(coach::Jettison{}); !given) return given;
    }
    return pairAfterStartup(own ? team : static_cast<coach::wire::Team>(boat));
}

Outcome CoachRunner::pairAfterStartup(coach::wire::Team boat) {
    const auto available = [this, boat] {
        const auto& boats = state().coach.boats;
        return std::any_of(boats.begin(), boats.end(), [boat](const coach::HeardBoat& heard) {
            return heard.team == boat && !heard.coach;
        });
    };
    const auto heard = waitUntil(available, kHeardLimit);
    if (!heard) return tl::unexpected(heard.error());
    if (!*heard) return notHeard(boat);
    if (auto asked = perform(coach::Pair{boat}); !asked) return asked;
    const auto ended = waitUntil(
        [this] {
            return state().coach.state == CoachState::Paired || state().coach.state == CoachState::NotPaired;
        },
        kAssertLimit);
    if (!ended) return tl::unexpected(ended.error());
    if (state().coach.state == CoachState::Paired) return {};
    Error error = errorOf(available() ? Errc::TimedOut : Errc::PairedElsewhere, "TOWRP");
    error.robot = boat;
    return failed(error);
}

Expected<bool> CoachRunner::waitUntil(const std::function<bool()>& met, Duration limit) {
    const TimePoint end = engine_.now() + limit;
    for (;;) {
        engine_.heartbeat();
        refresh();
        if (auto ended = trouble(); !ended) return tl::unexpected(std::move(ended.error()));
        if (met()) return true;
        const TimePoint now = engine_.now();
        if (now >= end) return false;
        context_.interruption.wait(std::min<Duration>(kTick, end - now));
    }
}

Outcome CoachRunner::trouble() const {
    if (context_.interruption.cause())
        return failed(errorOf(Errc::Cancelled, *context_.interruption.cause()));
    if (context_.output.failed()) return failed(errorOf(Errc::Cancelled, "the output cannot be written"));
    if (!connected_) return {};
    if (snapshot_->stop != StopReason::None) {
        Failure failure = failed(errorOf(Errc::StopLatched)).value();
        failure.text.what = Words::tr("Everything was stopped: %1.").arg(describe(snapshot_->stop));
        failure.text.remedy = Words::tr("Put that right, then start the command again.");
        return tl::unexpected(std::move(failure));
    }
    if (session() == nullptr) return failed(errorOf(Errc::NotConnected));
    const LinkState link = state().link;
    if (link == LinkState::Failed && state().error) return failed(*state().error);
    if (link == LinkState::Searching) return failed(errorOf(Errc::Disconnected));
    return {};
}

const SessionSnapshot* CoachRunner::session() const {
    const auto& sessions = snapshot_->sessions;
    const auto found = std::find_if(sessions.begin(), sessions.end(),
                                    [this](const SessionSnapshot& one) { return one.id == session_; });
    return found == sessions.end() ? nullptr : &*found;
}

const coach::Snapshot& CoachRunner::state() const {
    static const coach::Snapshot kNothing;
    const SessionSnapshot* current = session();
    const auto* system = current == nullptr ? nullptr : std::get_if<coach::Snapshot>(&current->system);
    return system == nullptr ? kNothing : *system;
}

void CoachRunner::refresh() {
    snapshot_ = engine_.snapshot();
    const auto read = engine_.readEvents(cursor_);
    if (!observer_) return;
    for (const auto& event : read.events)
        observer_(event.value);
}

bool CoachRunner::finish() {
    if (finished_) return stopped_;
    finished_ = true;
    observer_ = nullptr;
    const auto paired = [this] { return state().coach.state == CoachState::Paired; };
    refresh();
    stopped_ = !paired();
    const TimePoint since = engine_.now();
    engine_.stop(StopReason::Person);
    // A second signal must not cut this short: it is what every ending is for.
    while (!stopped_ && paired() && engine_.now() - since < kStopLimit) {
        engine_.heartbeat();
        refresh();
        const coach::CoachView& view = state().coach;
        stopped_ = view.sent && view.sent->isZero() && view.sentAt >= since;
        if (!stopped_) context_.interruption.wait(kTick);
    }
    engine_.shutdown();
    return stopped_;
}

}  // namespace kickstand::ctl
