#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "core/base/scheduler.h"
#include "core/link/socket/byte_stream.h"

namespace kickstand::testing {

/// How a connection in memory carries bytes.
struct MemoryStreamOptions {
    std::uint32_t seed = 1;
    /// Bytes arrive in pieces of random sizes up to this.
    std::size_t largestPiece = 1500;
    /// How long a piece is under way.
    Duration delay{};
};

/// The two ends of a connection in this process. An end that has not been started reads nothing: what it is
/// sent stays unsent at the other. One thread, the scheduler's; either end may go first.
std::pair<std::unique_ptr<ByteStream>, std::unique_ptr<ByteStream>> makeMemoryStreams(
    Scheduler& scheduler, const MemoryStreamOptions& options = {});

}  // namespace kickstand::testing
