#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/scheduler.h"

namespace kickstand {

/// One direction of a line with a speed: what is put in comes out in order, each byte when its last bit would
/// have passed, in pieces of a millisecond at most. The scheduler's thread.
class PacedQueue {
  public:
    /// `deliver` is never called from inside push(), and may destroy this queue.
    PacedQueue(Scheduler& scheduler, std::function<void(ByteView)> deliver);
    /// Drops what is under way.
    ~PacedQueue();
    PacedQueue(const PacedQueue&) = delete;
    PacedQueue& operator=(const PacedQueue&) = delete;

    /// From the next piece on. A start bit, eight data bits and a stop bit make a byte; 0 counts as 1.
    void setBitRate(std::uint32_t bitsPerSecond);
    void push(ByteView bytes);
    void clear();
    /// Bytes that have not come out yet.
    std::size_t size() const { return bytes_.size(); }

  private:
    void arm();
    void due();

    Scheduler& scheduler_;
    const std::function<void(ByteView)> deliver_;
    Duration byteTime_{};
    std::deque<std::uint8_t> bytes_;
    std::size_t piece_ = 0;  ///< How many come out when the timer falls due.
    TimerId timer_ = 0;
};

}  // namespace kickstand
