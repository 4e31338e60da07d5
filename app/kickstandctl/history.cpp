#include "app/kickstandctl/history.h"

#include <QtGlobal>

#include "app/composition/ledger_file.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "core/engine/ledger_keeper.h"

namespace kickstand::ctl {
namespace {

constexpr Duration kWriteLimit = std::chrono::seconds(3);

}  // namespace

History::History(SessionRunner& runner) : runner_(runner) {
    if (!runner_.uri().isSimulated() || qEnvironmentVariableIsSet("KICKSTAND_LEDGER"))
        ledger_ = std::make_unique<Ledger>(ledgerFile());
}

void History::take(const EngineEvent& event) {
    if (!ledger_) return;
    LedgerKeeper(*ledger_).take(event, toString(runner_.uri()), runner_.engine().wallTime(timeOf(event)));
}

void History::finish() {
    if (ledger_) ledger_->flush(kWriteLimit);
}

}  // namespace kickstand::ctl
