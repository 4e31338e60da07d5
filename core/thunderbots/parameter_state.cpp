#include "core/thunderbots/parameter_state.h"

namespace kickstand::thunderbots {

const char* name(ParameterStanding standing) {
    switch (standing) {
        case ParameterStanding::Unread:
            return "unread";
        case ParameterStanding::AsRead:
            return "as-read";
        case ParameterStanding::Applied:
            return "applied";
        case ParameterStanding::Committed:
            return "committed";
        case ParameterStanding::Rebooted:
            return "rebooted";
        case ParameterStanding::Proven:
            return "proven";
        case ParameterStanding::Disproven:
            return "disproven";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots
