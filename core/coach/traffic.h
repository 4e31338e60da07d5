#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "core/base/time.h"
#include "core/coach/wire/message.h"
#include "core/framing/xbee_parser.h"

namespace kickstand::coach {

/// One packet of the conversation.
struct TrafficEntry {
    std::uint64_t number = 0;  ///< Counts up from 1.
    TimePoint time{};
    bool sent = false;
    std::uint16_t address = 0;  ///< The other side's.
    int rssi_dBm = 0;           ///< Of what came.
    wire::Message message;
    std::uint8_t frameId = 0;               ///< Of what was sent.
    std::optional<std::uint8_t> outcome{};  ///< Of what was sent, once the module has told: xbee::TxOutcome.
};
/// The newest packets, oldest first.
using TrafficEntries = std::deque<TrafficEntry>;

/// What passed between this program and its radio module.
struct TrafficCounters {
    xbee::ParserCounters frames;
    std::uint64_t notMessages = 0;    ///< Packets that hold no message of this protocol.
    std::uint64_t acknowledged = 0;   ///< Packets whose TX status was success.
    std::uint64_t failed = 0;         ///< Packets whose TX status was anything else.
    std::uint64_t strayStatuses = 0;  ///< TX statuses of nothing that was sent.

    friend bool operator==(const TrafficCounters&, const TrafficCounters&) = default;
};

}  // namespace kickstand::coach
