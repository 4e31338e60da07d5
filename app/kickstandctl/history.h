#pragma once

#include <memory>

#include "core/engine/messages.h"
#include "core/ledger/ledger.h"

namespace kickstand::ctl {

class SessionRunner;

/// Keeps for good what a command learns of the fleet: every block of parameters and every signature that is
/// read. What is simulated ends with the command, and so does its history, unless KICKSTAND_LEDGER names a
/// file. Main thread.
class History {
  public:
    /// The runner has chosen its link, and outlives it.
    explicit History(SessionRunner& runner);
    void take(const EngineEvent& event);
    /// Gives what was told a moment to be written.
    void finish();

  private:
    SessionRunner& runner_;
    std::unique_ptr<Ledger> ledger_;
};

}  // namespace kickstand::ctl
