#include "core/coach/coach_side.h"

#include <algorithm>
#include <utility>

namespace kickstand::coach {
namespace {

using wire::Opcode;

constexpr Duration kStartupSpan = std::chrono::seconds(5);
/// Half of the second that the protocol allows, so that no timer of a second at the other end sees it late.
constexpr Duration kPeriod = std::chrono::milliseconds(500);
constexpr Duration kReplySpan = std::chrono::milliseconds(200);
constexpr Duration kResultSpan = std::chrono::nanoseconds(1'000'000'000 / 3);
/// A velocity that has waited so long goes before free commands.
constexpr Duration kVelocityPatience = std::chrono::milliseconds(600);
/// So long after the last one it goes before everything but STOP: one slot later the second that the boat
/// waits would be nearly over.
constexpr Duration kVelocityDeadline = std::chrono::milliseconds(700);
constexpr std::size_t kAssertionRepeats = 5;

}  // namespace

CoachSide::CoachSide(Scheduler& scheduler, SideOutput output)
    : scheduler_(scheduler),
      output_(std::move(output)),
      deadlines_(scheduler, [this](TimerKind kind) { expired(kind); }),
      slots_(scheduler, [this] { return sendNext(); }) {}

void CoachSide::tell(EventKind kind, int team, std::int64_t code, std::int64_t previous) {
    output_.event(kind, team, code, previous);
}

void CoachSide::enter(CoachState state) {
    state_ = state;
    ++version_;
}

void CoachSide::begin(Team team, wire::TeamColor color) {
    if (state_ != CoachState::Off) end(Unpairing::RoleEnded);
    team_ = team;
    color_ = color;
    boats_.clear();
    boat_ = team;
    assertions_ = 0;
    enter(CoachState::Startup);
    deadlines_.start(TimerKind::Startup, kStartupSpan);
    assertWaits_ = true;
    slots_.want();
    tell(EventKind::CoachStarted, team);
}

void CoachSide::end(Unpairing why) {
    const bool reachable = why != Unpairing::LinkLost;
    if (!reachable) {
        stopFor_.reset();
        jettisonFor_.reset();
    }
    if (state_ == CoachState::Off) return;
    if (state_ == CoachState::Paired) {
        if (reachable) stopFor_ = boat_;
        unpair(why);
    }
    assertWaits_ = false;
    boat_.reset();
    deadlines_.stopAll();
    enter(CoachState::Off);
    tell(EventKind::RoleEnded, team_);
    if (stopFor_ || jettisonFor_) slots_.want();
}

void CoachSide::expired(TimerKind kind) {
    ++version_;
    switch (kind) {
        case TimerKind::Startup:
            deadlines_.stopAll();
            assertWaits_ = false;
            boat_.reset();
            enter(CoachState::NotPaired);
            return;
        case TimerKind::Assert:
            assertWaits_ = true;
            break;
        case TimerKind::Result:
            if (assertions_ > kAssertionRepeats) {
                pairingFailed(Errc::TimedOut, 0);
                return;
            }
            assertWaits_ = true;
            ++counters_.resent;
            break;
        case TimerKind::MoraleReply:
            ++counters_.resent;
            answered_.reset();
            // What was sent before the last velocity is answered by now, or never.
            openReplies_ = 1;
            strayReplies_ = 0;
            wantVelocity();
            return;
        case TimerKind::Velocity:
            wantVelocity();
            return;
        case TimerKind::SuppressReply:
            ++counters_.resent;
            suppressWaits_ = true;
            break;
        case TimerKind::Silence:
            unpair(Unpairing::Silence);
            return;
        case TimerKind::Mutiny:
            if (mutiny_) tell(EventKind::MutinyLost, *boat_);
            endMutiny();
            return;
        case TimerKind::Available:
        case TimerKind::MoraleStep:
            return;
    }
    slots_.want();
}

void CoachSide::wantVelocity() {
    if (!velocityWaitsSince_) velocityWaitsSince_ = scheduler_.now();
    ++version_;
    slots_.want();
}

bool CoachSide::velocityIsOverdue() const {
    return velocityWaitsSince_ && scheduler_.now() - *velocityWaitsSince_ >= kVelocityPatience;
}

bool CoachSide::velocityIsLate() const {
    return state_ == CoachState::Paired && scheduler_.now() - sentAt_ >= kVelocityDeadline;
}

/// What goes before free commands and velocity.
bool CoachSide::sendUrgent() {
    if (stopFor_) {
        const Team boat = *std::exchange(stopFor_, std::nullopt);
        sendVelocity(boat, {});
        tell(EventKind::Stopped, boat);
    } else if (velocityIsLate()) {
        sendVelocity(*boat_, steered());
    } else if (std::exchange(suppressWaits_, false)) {
        send(*boat_, Opcode::SuppressMutiny, 0);
        ++openReplies_;
        ++strayReplies_;
        deadlines_.start(TimerKind::SuppressReply, kReplySpan);
        tell(EventKind::SuppressSent, *boat_);
    } else if (jettisonFor_) {
        send(*std::exchange(jettisonFor_, std::nullopt), Opcode::Jettison, 0);
    } else if (std::exchange(assertWaits_, false)) {
        sendAssertion();
    } else {
        return false;
    }
    return true;
}

bool CoachSide::sendNext() {
    if (sendUrgent()) return true;
    if (state_ != CoachState::Paired) return false;
    if (!free_.empty() && !velocityIsOverdue()) {
        const wire::Message message = free_.front();
        free_.pop_front();
        send(*boat_, message.opcode, message.parameter);
        const bool digital = message.opcode == Opcode::FreeDigital;
        tell(digital ? EventKind::FreeDigital : EventKind::FreeAnalog, *boat_,
             static_cast<std::int8_t>(message.parameter));
        return true;
    }
    if (!velocityWaitsSince_) return false;
    sendVelocity(*boat_, steered());
    return true;
}

void CoachSide::send(Team boat, Opcode opcode, std::uint8_t parameter) {
    ++counters_.sent;
    ++version_;
    output_.send(wire::addressOf(wire::Role::Towrp, boat), wire::Message{opcode, parameter});
}

void CoachSide::sendVelocity(Team boat, const wire::Velocity& velocity) {
    velocityWaitsSince_.reset();
    send(boat, Opcode::Velocity, wire::parameterOf(velocity));
    if (state_ != CoachState::Paired) return;
    // What is only repeated stays answered until its answer is late.
    if (sent_ != velocity) {
        answered_.reset();
        strayReplies_ = openReplies_;
    }
    sent_ = velocity;
    ++openReplies_;
    sentAt_ = scheduler_.now();
    deadlines_.start(TimerKind::Velocity, kPeriod);
    deadlines_.start(TimerKind::MoraleReply, kReplySpan);
}

void CoachSide::sendAssertion() {
    ++assertions_;
    send(*boat_, Opcode::AssertCommand, static_cast<std::uint8_t>(color_));
    if (state_ == CoachState::Startup) deadlines_.start(TimerKind::Assert, kPeriod);
    if (state_ == CoachState::Asserting) deadlines_.start(TimerKind::Result, kResultSpan);
}

HeardBoat& CoachSide::heard(const Received& message) {
    const Team team = wire::teamOf(message.source);
    const auto at = std::lower_bound(boats_.begin(), boats_.end(), team,
                                     [](const HeardBoat& boat, Team wanted) { return boat.team < wanted; });
    const bool isNew = at == boats_.end() || at->team != team;
    HeardBoat& boat = isNew ? *boats_.insert(at, HeardBoat{team}) : *at;
    boat.rssi_dBm = message.rssi_dBm;
    boat.heard = scheduler_.now();
    ++boat.packets;
    if (isNew) tell(EventKind::BoatFound, team, message.rssi_dBm);
    return boat;
}

void CoachSide::received(const Received& message) {
    if (state_ == CoachState::Off) return;
    ++version_;
    const bool fromBoat = wire::roleOf(message.source) == wire::Role::Towrp;
    if (!fromBoat || (state_ == CoachState::Paired && wire::teamOf(message.source) != *boat_)) {
        ++counters_.foreign;
        return;
    }
    ++counters_.received;
    switch (message.message.opcode) {
        case Opcode::Available:
            heard(message).coach.reset();
            return;
        case Opcode::AssertionResult:
            result(message);
            return;
        case Opcode::UpdateMorale:
            if (state_ == CoachState::Paired) return moraleCame(message);
            break;
        case Opcode::MutinyInProgress:
            if (state_ == CoachState::Paired) return mutinyNoticed();
            break;
        default:
            break;
    }
    ++counters_.outOfPlace;
}

void CoachSide::result(const Received& message) {
    HeardBoat& boat = heard(message);
    boat.coach = message.message.parameter;
    const bool asked = state_ == CoachState::Startup || state_ == CoachState::Asserting;
    if (!asked || boat.team != *boat_) return;
    if (message.message.parameter == team_) {
        paired(boat.team);
    } else if (state_ == CoachState::Asserting) {
        pairingFailed(Errc::PairedElsewhere, message.message.parameter);
    }
}

void CoachSide::paired(Team boat) {
    deadlines_.stopAll();
    assertWaits_ = false;
    boat_ = boat;
    wanted_ = {};
    sent_.reset();
    sentAt_ = scheduler_.now();
    answered_.reset();
    openReplies_ = 0;
    strayReplies_ = 0;
    morale_ = 0;
    enter(CoachState::Paired);
    deadlines_.start(TimerKind::Silence, kPairedSilence);
    wantVelocity();
    tell(EventKind::Paired, boat);
}

void CoachSide::pairingFailed(Errc why, std::int64_t coach) {
    const Team boat = *boat_;
    deadlines_.stopAll();
    assertWaits_ = false;
    boat_.reset();
    enter(CoachState::NotPaired);
    tell(EventKind::PairingFailed, boat, static_cast<std::int64_t>(why), coach);
}

void CoachSide::unpair(Unpairing why) {
    const Team boat = *boat_;
    deadlines_.stopAll();
    suppressWaits_ = false;
    free_.clear();
    velocityWaitsSince_.reset();
    mutiny_.reset();
    boat_.reset();
    wanted_ = {};
    morale_.reset();
    enter(CoachState::NotPaired);
    tell(EventKind::Unpaired, boat, static_cast<std::int64_t>(why));
}

void CoachSide::moraleCame(const Received& message) {
    heard(message);
    morale_ = static_cast<std::int8_t>(message.message.parameter);
    replyCame();
    deadlines_.start(TimerKind::Silence, kPairedSilence);
    if (*morale_ == wire::kMutinyMorale) {
        mutinyNoticed();
    } else if (mutiny_) {
        tell(EventKind::MutinyQuelled, *boat_, *morale_);
        endMutiny();
    } else if (deadlines_.runs(TimerKind::SuppressReply)) {
        // Asked for without a mutiny that we knew of: this is its answer.
        endMutiny();
    }
}

/// An Update Morale does not say what it answers. While one may come late that answers an earlier velocity,
/// or a Suppress Mutiny, the last velocity is repeated: a zero that was lost would pass for heard.
void CoachSide::replyCame() {
    if (openReplies_ > 0) --openReplies_;
    if (strayReplies_ > 0) {
        --strayReplies_;
        return;
    }
    if (!sent_) return;
    answered_ = sent_;
    answeredAt_ = scheduler_.now();
    deadlines_.stop(TimerKind::MoraleReply);
}

void CoachSide::mutinyNoticed() {
    if (mutiny_) return;
    const TimePoint now = scheduler_.now();
    mutiny_ = MutinyView{now, now + kMutinySpan};
    deadlines_.start(TimerKind::Mutiny, kMutinySpan);
    tell(EventKind::MutinyStarted, *boat_);
}

void CoachSide::endMutiny() {
    mutiny_.reset();
    suppressWaits_ = false;
    deadlines_.stop(TimerKind::Mutiny);
    deadlines_.stop(TimerKind::SuppressReply);
}

Result<void> CoachSide::checkPaired() const {
    if (state_ != CoachState::Paired) return fail(Errc::NotPaired);
    return {};
}

Result<void> CoachSide::checkFree() const {
    if (auto paired = checkPaired(); !paired) return paired;
    if (halted_) return fail(Errc::StopLatched);
    if (free_.size() >= kFreeLimit) return fail(Errc::QueueFull);
    return {};
}

Result<void> CoachSide::pair(Team boat) {
    if (state_ != CoachState::NotPaired) return fail(Errc::BadArgument, "pair", "not-paired");
    const auto found = std::find_if(boats_.begin(), boats_.end(), [boat](const HeardBoat& heard) {
        return heard.team == boat && !heard.coach;
    });
    if (found == boats_.end() || scheduler_.now() - found->heard > kPairedSilence) {
        Error error;
        error.code = Errc::RobotNotAlive;
        error.got = boat;
        return fail(std::move(error));
    }
    boat_ = boat;
    assertions_ = 0;
    assertWaits_ = true;
    enter(CoachState::Asserting);
    slots_.want();
    return {};
}

Result<void> CoachSide::steer(const wire::Velocity& velocity) {
    if (auto paired = checkPaired(); !paired) return paired;
    if (!wire::isVelocity(velocity)) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "velocity";
        error.lowest = -wire::kTopLevel;
        error.highest = wire::kTopLevel;
        return fail(std::move(error));
    }
    if (halted_ && !velocity.isZero()) return fail(Errc::StopLatched);
    wanted_ = velocity;
    if (!sent_ || *sent_ != wanted_) wantVelocity();
    return {};
}

Result<void> CoachSide::freeDigital() {
    if (auto may = checkFree(); !may) return may;
    free_.push_back({Opcode::FreeDigital, 0});
    slots_.want();
    return {};
}

Result<void> CoachSide::freeAnalog(int percent) {
    if (auto may = checkFree(); !may) return may;
    if (percent < -100 || percent > 100) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "magnitude";
        error.lowest = -100;
        error.highest = 100;
        error.got = percent;
        return fail(std::move(error));
    }
    free_.push_back({Opcode::FreeAnalog, static_cast<std::uint8_t>(percent)});
    slots_.want();
    return {};
}

Result<void> CoachSide::suppress() {
    if (auto paired = checkPaired(); !paired) return paired;
    if (mutiny_) mutiny_->suppressed = true;
    suppressWaits_ = true;
    // Without a mutiny that is known of it is not repeated for ever either.
    if (!deadlines_.runs(TimerKind::Mutiny)) deadlines_.start(TimerKind::Mutiny, kMutinySpan);
    ++version_;
    slots_.want();
    return {};
}

Result<void> CoachSide::act(std::size_t action, std::size_t length) {
    if (auto paired = checkPaired(); !paired) return paired;
    if (!mutiny_ || action >= length) return fail(Errc::BadArgument, "action", "mutiny");
    ++version_;
    if (mutiny_->suppressed) return {};
    if (action != mutiny_->done) {
        mutiny_->done = 0;
        return {};
    }
    ++mutiny_->done;
    return mutiny_->done == length ? suppress() : Result<void>();
}

Result<void> CoachSide::jettison() {
    if (auto paired = checkPaired(); !paired) return paired;
    const Team boat = *boat_;
    jettisonFor_ = boat;
    slots_.want();
    tell(EventKind::Jettisoned, boat);
    unpair(Unpairing::Jettison);
    // A boat that is free stands, and answers nothing that it was told before.
    sent_.reset();
    answered_.reset();
    return {};
}

void CoachSide::halt() {
    halted_ = true;
    free_.clear();
    wanted_ = {};
    ++version_;
    if (state_ != CoachState::Paired) return;
    stopFor_ = boat_;
    slots_.want();
}

CoachView CoachSide::view() const {
    CoachView view;
    view.state = state_;
    view.team = team_;
    view.color = color_;
    view.boat = boat_;
    view.boats = boats_;
    view.wanted = wanted_;
    view.sent = sent_;
    view.answered = answered_;
    view.sentAt = sentAt_;
    view.answeredAt = answeredAt_;
    view.morale = morale_;
    view.mutiny = mutiny_;
    const std::size_t others = static_cast<std::size_t>(stopFor_.has_value()) + (suppressWaits_ ? 1 : 0) +
                               static_cast<std::size_t>(jettisonFor_.has_value()) + (assertWaits_ ? 1 : 0);
    view.waiting = others + free_.size() + static_cast<std::size_t>(velocityWaitsSince_.has_value());
    view.assertions = assertions_;
    view.timers = deadlines_.running();
    view.counters = counters_;
    return view;
}

}  // namespace kickstand::coach
