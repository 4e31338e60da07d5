#pragma once

#include "app/kickstandctl/session_runner.h"

namespace kickstand::ctl {

/// What a link to a COACH's or TOWRP's radio module showed last; a default one where it is of another system.
inline const coach::Snapshot& radioOf(const SessionRunner& runner) {
    return runner.stateOf<coach::Snapshot>();
}

/// Opens the link that was named and waits until its radio module answers; with Need::Open also until none
/// did.
Outcome connectRadio(const Context& context, SessionRunner& runner,
                     SessionRunner::Need need = SessionRunner::Need::Running);

/// Plays the COACH that the module is set up for, and pairs it with a boat: its own team's where `boat` is
/// negative.
Outcome pairWith(SessionRunner& runner, int boat, coach::wire::TeamColor color);

}  // namespace kickstand::ctl
