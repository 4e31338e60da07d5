#include "core/thunderbots/parameter_keeper.h"

#include <utility>

namespace kickstand::thunderbots {
namespace {

/// What a reading says about a robot of which this was known.
ParameterStanding standingAfter(const ParameterState& before, const wire::OperationalParameters& read) {
    switch (before.standing) {
        case ParameterStanding::Rebooted:
            return before.committed == read ? ParameterStanding::Proven : ParameterStanding::Disproven;
        case ParameterStanding::Applied:
        case ParameterStanding::Committed:
        case ParameterStanding::Proven:
            // Still what it was, or somebody else has changed it meanwhile.
            return before.robot == read ? before.standing : ParameterStanding::AsRead;
        case ParameterStanding::Unread:
        case ParameterStanding::AsRead:
        case ParameterStanding::Disproven:
            break;
    }
    return ParameterStanding::AsRead;
}

}  // namespace

void ParameterKeeper::read(int robot, const wire::OperationalParameters& parameters, TimePoint time) {
    ParameterState& state = at(robot).state;
    state.standing = standingAfter(state, parameters);
    state.robot = parameters;
    state.readAt = time;
    state.movedTo = -1;
    ++version_;
}

void ParameterKeeper::signaturesRead(int robot, const wire::ReadSignaturesResponse& signatures,
                                     TimePoint time) {
    at(robot).state.signatures = signatures;
    at(robot).state.signaturesAt = time;
    ++version_;
}

void ParameterKeeper::applied(int robot) {
    at(robot).state.standing = ParameterStanding::Applied;
    ++version_;
}

void ParameterKeeper::committed(int robot) {
    ParameterState& state = at(robot).state;
    if (!state.robot) return;
    state.standing = ParameterStanding::Committed;
    state.committed = state.robot;
    ++version_;
}

void ParameterKeeper::erased(int robot) {
    ParameterState& state = at(robot).state;
    state.standing = ParameterStanding::Unread;
    state.robot.reset();
    state.committed.reset();
    state.signatures.reset();
    ++version_;
}

void ParameterKeeper::willReboot(int robot) {
    at(robot).rebooting = true;
}

void ParameterKeeper::lost(int robot, RobotMask others) {
    Entry& entry = at(robot);
    if (!std::exchange(entry.rebooting, false)) return;
    ParameterState& state = entry.state;
    const bool proofDue = state.standing == ParameterStanding::Committed;
    state.standing = proofDue ? ParameterStanding::Rebooted : ParameterStanding::Unread;
    state.signatures.reset();
    const int next = proofDue ? state.committed->robotNumber : robot;
    if (next != robot && next < kRobots && !contains(others, next)) {
        at(next).state = std::exchange(state, ParameterState{});
        state.movedTo = next;
    }
    ++version_;
}

void ParameterKeeper::rebootedUnseen(int robot) {
    const ParameterState& state = at(robot).state;
    const bool moves =
        state.standing == ParameterStanding::Committed && state.committed->robotNumber != robot;
    if (!moves) lost(robot, 0);
}

}  // namespace kickstand::thunderbots
