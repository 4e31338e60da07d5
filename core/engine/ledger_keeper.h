#pragma once

#include <chrono>
#include <string>

#include "core/engine/messages.h"
#include "core/ledger/ledger.h"

namespace kickstand {

/// Puts into a ledger what sessions tell that is worth keeping for good. Any thread, one at a time; never
/// waits.
class LedgerKeeper {
  public:
    /// The ledger must outlive it.
    explicit LedgerKeeper(Ledger& ledger) : ledger_(ledger) {}

    /// Takes an event of a session on the link `source`, and when it happened.
    void take(const EngineEvent& event, const std::string& source,
              std::chrono::system_clock::time_point time);

  private:
    Ledger& ledger_;
};

}  // namespace kickstand
