#include "core/coach/towrp_side.h"

#include <utility>

#include "core/framing/xbee.h"

namespace kickstand::coach {
namespace {

using wire::Opcode;

constexpr Duration kAvailablePeriod = std::chrono::milliseconds(500);
constexpr Duration kMoraleStep = std::chrono::seconds(1);
/// A mutiny that has waited so long goes before replies, or it would not be told once a second.
constexpr Duration kMutinyPatience = std::chrono::milliseconds(800);
constexpr int kTopMorale = 127;

}  // namespace

TowrpSide::TowrpSide(Scheduler& scheduler, SideOutput output)
    : scheduler_(scheduler),
      output_(std::move(output)),
      deadlines_(scheduler, [this](TimerKind kind) { expired(kind); }),
      slots_(scheduler, [this] { return sendNext(); }) {}

void TowrpSide::tell(EventKind kind, int team, std::int64_t code) {
    output_.event(kind, team, code, 0);
}

void TowrpSide::begin(Team team) {
    if (state_ != TowrpState::Off) end(Unpairing::RoleEnded);
    team_ = team;
    freeDigital_ = 0;
    freeAnalog_.reset();
    sleep();
    tell(EventKind::TowrpStarted, team);
}

void TowrpSide::end(Unpairing why) {
    if (state_ == TowrpState::Off) return;
    if (isPaired()) unpair(why);
    deadlines_.stopAll();
    availableWaits_ = false;
    state_ = TowrpState::Off;
    ++version_;
    tell(EventKind::RoleEnded, team_);
}

/// Not paired, as it wakes and whenever it becomes so.
void TowrpSide::sleep() {
    deadlines_.stopAll();
    coach_.reset();
    resultWaits_ = false;
    moraleWaits_ = false;
    mutinySince_.reset();
    velocity_ = {};
    stoppedItself_ = false;
    morale_ = 0;
    moraleWanted_.reset();
    state_ = TowrpState::NotPaired;
    availableWaits_ = true;
    ++version_;
    slots_.want();
}

void TowrpSide::unpair(Unpairing why) {
    const Team coach = *coach_;
    sleep();
    tell(EventKind::Unpaired, coach, static_cast<std::int64_t>(why));
}

void TowrpSide::expired(TimerKind kind) {
    ++version_;
    switch (kind) {
        case TimerKind::Available:
            availableWaits_ = true;
            slots_.want();
            return;
        case TimerKind::Velocity:
            velocity_ = {};
            stoppedItself_ = true;
            tell(EventKind::BoatStopped, *coach_);
            return;
        case TimerKind::Silence:
            unpair(Unpairing::Silence);
            return;
        case TimerKind::Mutiny:
            unpair(Unpairing::Mutiny);
            return;
        case TimerKind::MoraleStep:
            if (moraleWanted_) applyMorale(*std::exchange(moraleWanted_, std::nullopt));
            return;
        default:
            return;
    }
}

bool TowrpSide::sendNext() {
    if (state_ == TowrpState::Off) return false;
    const TimePoint now = scheduler_.now();
    const bool mutinyIsOverdue = mutinySince_ && now - *mutinySince_ >= kMutinyPatience;
    if (std::exchange(resultWaits_, false)) {
        send(xbee::kBroadcast, Opcode::AssertionResult, *coach_);
    } else if (moraleWaits_ && !mutinyIsOverdue) {
        moraleWaits_ = false;
        send(coachAddress(), Opcode::UpdateMorale, static_cast<std::uint8_t>(morale_));
    } else if (mutinySince_) {
        mutinySince_ = now;
        send(coachAddress(), Opcode::MutinyInProgress, 0);
    } else if (std::exchange(availableWaits_, false)) {
        send(xbee::kBroadcast, Opcode::Available, 0);
        deadlines_.start(TimerKind::Available, kAvailablePeriod);
    } else {
        return false;
    }
    return true;
}

void TowrpSide::send(std::uint16_t destination, Opcode opcode, std::uint8_t parameter) {
    ++counters_.sent;
    ++version_;
    output_.send(destination, wire::Message{opcode, parameter});
}

void TowrpSide::received(const Received& message) {
    if (state_ == TowrpState::Off) return;
    ++version_;
    const bool fromCoach = wire::roleOf(message.source) == wire::Role::Coach;
    const Team sender = wire::teamOf(message.source);
    if (!fromCoach || (isPaired() && sender != *coach_)) {
        ++counters_.foreign;
        return;
    }
    const Opcode opcode = message.message.opcode;
    if (opcode == Opcode::AssertCommand) {
        ++counters_.received;
        color_ = static_cast<wire::TeamColor>(message.message.parameter);
        // Its own COACH asks again when the Result was lost: it is told again, and nothing else changes.
        resultWaits_ = true;
        slots_.want();
        if (isPaired()) return;
        availableWaits_ = false;
        deadlines_.stopAll();
        coach_ = sender;
        state_ = TowrpState::Paired;
        deadlines_.start(TimerKind::Velocity, kVelocitySpan);
        deadlines_.start(TimerKind::Silence, kPairedSilence);
        tell(EventKind::Paired, sender);
    } else if (isPaired() && wire::specOf(opcode).sender == wire::Role::Coach) {
        ++counters_.received;
        obey(message);
    } else {
        ++counters_.outOfPlace;
    }
}

void TowrpSide::obey(const Received& message) {
    switch (message.message.opcode) {
        case Opcode::Velocity:
            velocityCame(message.message.parameter);
            return;
        case Opcode::SuppressMutiny:
            suppressCame();
            return;
        case Opcode::Jettison:
            unpair(Unpairing::Jettison);
            return;
        case Opcode::FreeDigital:
            ++freeDigital_;
            tell(EventKind::FreeDigital, *coach_);
            return;
        case Opcode::FreeAnalog:
            freeAnalog_ = static_cast<std::int8_t>(message.message.parameter);
            tell(EventKind::FreeAnalog, *coach_, *freeAnalog_);
            return;
        default:
            return;
    }
}

void TowrpSide::velocityCame(std::uint8_t parameter) {
    velocity_ = halted_ ? wire::Velocity() : wire::velocityOf(parameter);
    velocityAt_ = scheduler_.now();
    stoppedItself_ = false;
    deadlines_.start(TimerKind::Velocity, kVelocitySpan);
    deadlines_.start(TimerKind::Silence, kPairedSilence);
    moraleWaits_ = true;
    slots_.want();
}

void TowrpSide::suppressCame() {
    if (state_ == TowrpState::Mutiny) {
        state_ = TowrpState::Paired;
        mutinySince_.reset();
        deadlines_.stop(TimerKind::Mutiny);
        morale_ = wire::kQuelledMorale;
        deadlines_.start(TimerKind::MoraleStep, kMoraleStep);
        tell(EventKind::MutinyQuelled, *coach_, morale_);
    }
    // Asked again, because the answer was lost, it answers again.
    moraleWaits_ = true;
    slots_.want();
}

Result<void> TowrpSide::setMorale(int morale) {
    if (!isPaired()) return fail(Errc::NotPaired);
    if (morale < wire::kMutinyMorale || morale > kTopMorale) {
        Error error;
        error.code = Errc::OutOfRange;
        error.subject = "morale";
        error.lowest = wire::kMutinyMorale;
        error.highest = kTopMorale;
        error.got = morale;
        return fail(std::move(error));
    }
    if (state_ == TowrpState::Mutiny) return fail(Errc::BadArgument, "morale", "mutiny");
    ++version_;
    if (deadlines_.runs(TimerKind::MoraleStep)) {
        moraleWanted_ = morale;
    } else {
        applyMorale(morale);
    }
    return {};
}

void TowrpSide::applyMorale(int morale) {
    ++version_;
    if (morale == morale_) return;
    morale_ = morale;
    deadlines_.start(TimerKind::MoraleStep, kMoraleStep);
    tell(EventKind::MoraleSet, *coach_, morale);
    if (morale == wire::kMutinyMorale) beginMutiny();
}

void TowrpSide::beginMutiny() {
    state_ = TowrpState::Mutiny;
    moraleWanted_.reset();
    deadlines_.start(TimerKind::Mutiny, kMutinySpan);
    mutinySince_ = scheduler_.now();
    slots_.want();
    tell(EventKind::MutinyStarted, *coach_);
}

void TowrpSide::halt() {
    halted_ = true;
    velocity_ = {};
    ++version_;
}

TowrpView TowrpSide::view() const {
    TowrpView view;
    view.state = state_;
    view.team = team_;
    view.coach = coach_;
    view.color = color_;
    view.velocity = velocity_;
    view.velocityAt = velocityAt_;
    view.stoppedItself = stoppedItself_;
    view.morale = morale_;
    view.moraleWanted = moraleWanted_;
    view.freeDigital = freeDigital_;
    view.freeAnalog = freeAnalog_;
    view.timers = deadlines_.running();
    view.counters = counters_;
    return view;
}

}  // namespace kickstand::coach
