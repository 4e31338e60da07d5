#pragma once

#include <cstdint>
#include <optional>

#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots {

/// What one robot has been asked on its firmware pipes, and how well it answers (protocol 4.7).
struct RequestState {
    std::optional<wire::FirmwareOp> op;  ///< Of the request that has no answer yet.
    int attempt = 0;                     ///< Of that request, from 1.
    int attempts = 0;                    ///< After so many it is given up.
    bool awaitingSign = false;           ///< The state of the link is being established before anything else.
    std::uint32_t unanswered = 0;        ///< Requests that had no answer in time, since the session began.
    std::uint32_t strays = 0;            ///< Responses that answered nothing; likewise.

    friend bool operator==(const RequestState&, const RequestState&) = default;
};

}  // namespace kickstand::thunderbots
