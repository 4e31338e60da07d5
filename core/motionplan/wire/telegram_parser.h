#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "core/base/bytes.h"
#include "core/motionplan/wire/telegram.h"

namespace kickstand::motionplan::wire {

/// Finds telegrams in a stream of bytes that comes in any pieces. Where none can begin, bytes are skipped one
/// by one until one can (protocol 2.1). Holds at most one telegram's bytes. Not thread-safe.
class TelegramParser {
  public:
    struct Counters {
        std::uint64_t telegrams = 0;
        std::uint64_t skipped = 0;    ///< Bytes that belong to no telegram.
        std::uint64_t malformed = 0;  ///< Whole telegrams that say what cannot be.
    };

    /// Takes bytes and hands over every telegram that they complete, in order.
    void feed(ByteView bytes, const std::function<void(const Telegram&)>& take);
    /// The rest of what has begun will not come: forgets it, as skipped.
    void abandon();
    /// Whether a telegram has begun and is not complete.
    bool hasBegun() const { return !held_.empty(); }
    const Counters& counters() const { return counters_; }

  private:
    std::vector<std::uint8_t> held_;
    Counters counters_;
};

}  // namespace kickstand::motionplan::wire
