#pragma once

#include <QObject>
#include <map>
#include <string>

#include "core/engine/ledger_keeper.h"
#include "ui/shell/engine_client.h"

namespace kickstand::ui {

/// Hands every event that arrives to the ledger, with the link that it came through. GUI thread.
class LedgerFeed final : public QObject {
    Q_OBJECT
  public:
    /// Both must outlive it.
    LedgerFeed(EngineClient& client, Ledger& ledger);

  private:
    void take(const std::vector<EngineEvent>& events);

    EngineClient& client_;
    LedgerKeeper keeper_;
    std::map<SessionId, std::string> sources_;  ///< A session may be gone before its last event is read.
};

}  // namespace kickstand::ui
