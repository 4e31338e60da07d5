#include "app/kickstandctl/session_runner.h"

#include <algorithm>

#include "app/composition/composition.h"
#include "app/kickstandctl/device_access.h"
#include "app/kickstandctl/interruption.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_stop.h"

namespace kickstand::ctl {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Well below the age at which the engine takes the heartbeat for stale.
constexpr Duration kTick = milliseconds(10);
constexpr Duration kDiscoveryLimit = seconds(10);
/// Opening takes a while on a busy bus, and a dongle sets up its radios one after the other.
constexpr Duration kConnectLimit = seconds(15);
constexpr Duration kRobotLimit = seconds(2);
constexpr Duration kSettleLimit = seconds(2);
/// Robots are found one after another: so long without a new one, and that was all.
constexpr Duration kQuiet = milliseconds(300);
constexpr Duration kSnapshotFollows = milliseconds(30);
constexpr Duration kBrakeLimit = milliseconds(500);
/// Over Bluetooth a Stop is sent up to five times, once a second.
constexpr Duration kStopPlanLimit = milliseconds(6500);
/// A port is asked for five seconds who is there, after it was opened.
constexpr Duration kStopBoardsLimit = seconds(9);
/// A zero velocity is repeated every 0.2 s until the boat answers, which has stopped by itself by then.
constexpr Duration kStopBoatLimit = milliseconds(2000);

QString list(const std::vector<FoundDevice>& devices) {
    QStringList links;
    for (const FoundDevice& device : devices)
        links << QString::fromStdString(toString(device.uri));
    return links.join(QStringLiteral(", "));
}

Error errorOf(Errc code, std::string subject = {}) {
    Error error;
    error.code = code;
    error.subject = std::move(subject);
    return error;
}

/// Whether every robot has been told to brake since then.
bool isAtRest(const thunderbots::Snapshot& state, TimePoint since) {
    return std::all_of(state.robots.begin(), state.robots.end(),
                       [since](const thunderbots::RobotState& robot) {
                           return robot.told == thunderbots::wire::brakedBlock() && robot.toldAt >= since;
                       });
}
/// Whether the robot has confirmed Stop since then.
bool isAtRest(const motionplan::Snapshot& state, TimePoint since) {
    return state.stopConfirmedAt >= since && !state.active();
}
/// Whether the boat that was driven, where there was one, has answered a zero velocity. Nobody knows it of
/// one that fell silent, or when the line was lost: such a boat may have been told nothing.
bool isAtRest(const coach::Snapshot& state, TimePoint since) {
    const coach::CoachView& view = state.coach;
    const bool stands = view.answered && view.answered->isZero();
    if (view.state == coach::CoachState::Paired) return stands && view.answeredAt >= since;
    return state.link == coach::LinkState::Running && (stands || !view.sent);
}

bool isLost(const smartdevice::DeviceState& board) {
    return board.presence == smartdevice::Presence::Lost;
}
/// Whether every board that was met has been told to stop since then, which disables it, and no port may lead
/// to another.
bool isAtRest(const smartdevice::Snapshot& state, TimePoint since) {
    return state.stoppedAt >= since && !arePortsUnderWay(state) && !state.devices.empty() &&
           std::ranges::none_of(state.devices, [](const smartdevice::DeviceState& board) {
               return isLost(board) || !board.disabled;
           });
}
/// Whether some board, or all there may be, will not be reached by waiting.
bool isOutOfReach(const SessionSnapshot* session, TimePoint since) {
    const auto* const state =
        session == nullptr ? nullptr : std::get_if<smartdevice::Snapshot>(&session->system);
    return state != nullptr && state->stoppedAt >= since && !arePortsUnderWay(*state) &&
           (state->devices.empty() || std::ranges::any_of(state->devices, isLost));
}

}  // namespace

SessionRunner::SessionRunner(const Context& context) : context_(context), engine_(makeLinkProvider()) {
    refresh();
}

SessionRunner::~SessionRunner() {
    finish();
}

Expected<std::vector<FoundDevice>> SessionRunner::discover() {
    if (const auto id = engine_.submit(0, Discover{}); !id) return failed(id.error());
    const auto found = waitUntil([this] { return snapshot_->discovered; }, kDiscoveryLimit);
    if (!found) return tl::unexpected(found.error());
    if (!*found) return failed(errorOf(Errc::TimedOut, "USB"));
    return snapshot_->found;
}

Expected<LinkUri> SessionRunner::chooseLink() {
    if (context_.invocation.link) return *context_.invocation.link;
    const auto devices = discover();
    if (!devices) return tl::unexpected(devices.error());
    if (devices->empty()) {
        Failure failure = failed(errorOf(Errc::NoDevice)).value();
        failure.text.remedy = Words::tr("Plug one in, or name a link, as in --link sim:thunderbots.");
        return tl::unexpected(std::move(failure));
    }
    if (devices->size() > 1) {
        Failure failure = failed(errorOf(Errc::SeveralDevices)).value();
        failure.text.remedy = Words::tr("Name one of them with --link: %1.").arg(list(*devices));
        return tl::unexpected(std::move(failure));
    }
    return devices->front().uri;
}

Outcome SessionRunner::connect() {
    auto uri = chooseLink();
    if (!uri) return tl::unexpected(std::move(uri.error()));
    return connect(*uri);
}

Outcome SessionRunner::connect(const LinkUri& uri, Need need) {
    uri_ = uri;
    const auto opened = engine_.connect(uri);
    if (!opened) return failed(opened.error());
    session_ = *opened;
    std::optional<Error> refusal;
    const auto decided = waitUntil(
        [this, &refusal] {
            for (const Answer& answer : engine_.takeAnswers()) {
                if (answer.session == session_ && !answer.result) refusal = answer.result.error();
            }
            if (refusal) return true;
            const SessionSnapshot* current = session();
            if (current == nullptr) return false;
            const Standing link = standing();
            return link.failed || link.searching || link.unready ||
                   (link.running && snapshot_->heartbeatFresh);
        },
        kConnectLimit);
    if (!decided) return tl::unexpected(decided.error());
    // A link that this program does not have was typed wrong; everything else is the link's own failure.
    if (refusal) return refusedInput(*refusal);
    if (!*decided) return failed(errorOf(Errc::TimedOut, toString(uri)));
    const Standing link = standing();
    if (link.error) return failed(*link.error);
    if (link.unready && need == Need::Running) return failed(errorOf(Errc::RadioNotReady));
    if (!link.running && !link.unready) return failed(errorOf(Errc::NoDevice, toString(uri)));
    running_ = true;
    return {};
}

Outcome SessionRunner::awaitRobots(thunderbots::RobotMask robots) {
    const auto missing = [this, robots] {
        for (int number = 0; number < thunderbots::kRobots; ++number) {
            if (thunderbots::contains(robots, number) && !robot(number).live) return number;
        }
        return -1;
    };
    const auto heard = waitUntil([&missing] { return missing() < 0; }, kRobotLimit);
    if (!heard) return tl::unexpected(heard.error());
    if (*heard) return {};
    Error error = errorOf(Errc::RobotNotAlive);
    error.robot = missing();
    return failed(error);
}

Outcome SessionRunner::awaitReadings(int number) {
    const auto known = waitUntil(
        [this, number] { return robot(number).freshness == thunderbots::Freshness::Current; }, kRobotLimit);
    if (!known) return tl::unexpected(known.error());
    if (*known) return {};
    Error error = errorOf(Errc::ReadingsUnknown);
    error.robot = number;
    return failed(error);
}

Outcome SessionRunner::settle() {
    std::uint32_t known = 0;
    TimePoint lastNews = engine_.now();
    const auto quiet = [&] {
        std::uint32_t live = 0;
        bool complete = true;
        for (int number = 0; number < thunderbots::kRobots; ++number) {
            if (!robot(number).live) continue;
            live |= thunderbots::maskOf(number);
            complete = complete && robot(number).freshness == thunderbots::Freshness::Current;
        }
        if (live != known) lastNews = engine_.now();
        known = live;
        return live != 0 && complete && engine_.now() - lastNews >= kQuiet;
    };
    const auto settled = waitUntil(quiet, kSettleLimit);
    if (!settled) return tl::unexpected(settled.error());
    return {};
}

Outcome SessionRunner::perform(const SystemCommand& command, Duration limit) {
    const auto id = engine_.submit(session_, command);
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
    // The answer comes when it is known, the snapshot that belongs to it with the engine's next step.
    if (auto shown = waitUntil([] { return false; }, kSnapshotFollows); !shown)
        return tl::unexpected(std::move(shown.error()));
    return {};
}

Expected<bool> SessionRunner::waitUntil(const std::function<bool()>& met, Duration limit) {
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

Outcome SessionRunner::trouble() const {
    if (context_.interruption.cause())
        return failed(errorOf(Errc::Cancelled, *context_.interruption.cause()));
    if (context_.output.failed()) return failed(errorOf(Errc::Cancelled, "the output cannot be written"));
    if (!running_) return {};
    if (!watchesOnly_ && snapshot_->stop != StopReason::None) return tl::unexpected(stopped());
    if (session() == nullptr) return failed(errorOf(Errc::NotConnected));
    const Standing link = standing();
    if (link.failed && link.error) return failed(*link.error);
    if (!watchesOnly_ && link.searching) return failed(errorOf(Errc::Disconnected));
    return {};
}

Failure SessionRunner::stopped() const {
    const StopReason reason = snapshot_->stop;
    const SessionSnapshot* const current = session();
    if (reason == StopReason::LinkLost && current != nullptr) {
        // What is out of reach was not stopped.
        Failure failure = failed(standing().error.value_or(errorOf(Errc::Disconnected))).value();
        failure.text.what += u' ' + stoppedText(current->system, reason);
        return failure;
    }
    Failure failure = failed(errorOf(Errc::StopLatched)).value();
    failure.text.what = Words::tr("Everything was stopped: %1.").arg(describe(reason));
    failure.text.remedy = Words::tr("Put that right, then start the command again.");
    return failure;
}

const SessionSnapshot* SessionRunner::session() const {
    const auto& sessions = snapshot_->sessions;
    const auto found = std::find_if(sessions.begin(), sessions.end(),
                                    [this](const SessionSnapshot& one) { return one.id == session_; });
    return found == sessions.end() ? nullptr : &*found;
}

SessionRunner::Standing SessionRunner::standing() const {
    const SessionSnapshot* const current = session();
    if (current == nullptr) return {};
    return std::visit(
        [](const auto& state) {
            using State = decltype(state.link);
            bool unready = false;
            if constexpr (requires { State::NoModule; }) unready = state.link == State::NoModule;
            return Standing{state.link == State::Running, unready, state.link == State::Searching,
                            state.link == State::Failed, state.error};
        },
        current->system);
}

void SessionRunner::refresh() {
    snapshot_ = engine_.snapshot();
    const auto read = engine_.readEvents(cursor_);
    if (!observer_) return;
    for (const auto& event : read.events)
        observer_(event.value);
}

bool SessionRunner::atRest(TimePoint since) const {
    const SessionSnapshot* const current = session();
    return current != nullptr &&
           std::visit([since](const auto& state) { return isAtRest(state, since); }, current->system);
}

bool SessionRunner::finish() {
    if (finished_) return braked_;
    finished_ = true;
    observer_ = nullptr;
    const TimePoint stopped = engine_.now();
    engine_.stop(StopReason::Person);
    const TimePoint end = stopped + brakeLimit();
    // A second signal must not cut this short: it is what every ending is for.
    while (running_ && !braked_ && engine_.now() < end) {
        engine_.heartbeat();
        refresh();
        braked_ = atRest(stopped);
        if (!standing().running || isOutOfReach(session(), stopped)) break;
        if (!braked_) context_.interruption.wait(kTick);
    }
    engine_.shutdown();
    return braked_;
}

Duration SessionRunner::brakeLimit() const {
    const SessionSnapshot* const current = session();
    if (current == nullptr) return kBrakeLimit;
    if (std::holds_alternative<motionplan::Snapshot>(current->system)) return kStopPlanLimit;
    if (std::holds_alternative<smartdevice::Snapshot>(current->system)) return kStopBoardsLimit;
    return std::holds_alternative<coach::Snapshot>(current->system) ? kStopBoatLimit : kBrakeLimit;
}

void SessionRunner::leave() {
    if (std::exchange(finished_, true)) return;
    observer_ = nullptr;
    engine_.shutdown();
}

}  // namespace kickstand::ctl
