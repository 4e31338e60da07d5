#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::wire {

const char* name(Pipe pipe) noexcept {
    switch (pipe) {
        case Pipe::Drive:
            return "drive";
        case Pipe::Feedback:
            return "feedback";
        case Pipe::Kick:
            return "kick";
        case Pipe::FirmwareRequest:
            return "firmware-request";
        case Pipe::FirmwareResponse:
            return "firmware-response";
        case Pipe::TestMode:
            return "test-mode";
        case Pipe::Indicator:
            return "indicator";
    }
    return "reserved";
}

}  // namespace kickstand::thunderbots::wire
