#include "ui/shell/ledger_feed.h"

#include "core/engine/describe.h"

namespace kickstand::ui {

LedgerFeed::LedgerFeed(EngineClient& client, Ledger& ledger) : client_(client), keeper_(ledger) {
    connect(&client_, &EngineClient::eventsArrived, this, &LedgerFeed::take);
}

void LedgerFeed::take(const std::vector<EngineEvent>& events) {
    for (const SessionSnapshot& session : client_.snapshot().sessions)
        sources_.try_emplace(session.id, toString(session.uri));
    for (const EngineEvent& event : events)
        keeper_.take(event, sources_[event.session], client_.wallTime(timeOf(event)));
}

}  // namespace kickstand::ui
