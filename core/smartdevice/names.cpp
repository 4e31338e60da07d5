#include "core/smartdevice/snapshot.h"

namespace kickstand::smartdevice {

const char* name(WriteVerdict verdict) noexcept {
    switch (verdict) {
        case WriteVerdict::None:
            return "none";
        case WriteVerdict::Pending:
            return "pending";
        case WriteVerdict::Done:
            return "done";
        case WriteVerdict::Refused:
            return "refused";
        case WriteVerdict::Changed:
            return "changed";
        case WriteVerdict::Unconfirmed:
            return "unconfirmed";
    }
    return "";
}

const char* name(Presence presence) noexcept {
    switch (presence) {
        case Presence::Live:
            return "live";
        case Presence::Quiet:
            return "quiet";
        case Presence::Lost:
            return "lost";
    }
    return "";
}

const char* name(PortPhase phase) noexcept {
    switch (phase) {
        case PortPhase::Opening:
            return "opening";
        case PortPhase::Asking:
            return "asking";
        case PortPhase::Talking:
            return "talking";
        case PortPhase::Silent:
            return "silent";
        case PortPhase::Failed:
            return "failed";
    }
    return "";
}

}  // namespace kickstand::smartdevice
