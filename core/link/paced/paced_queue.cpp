#include "core/link/paced/paced_queue.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace kickstand {
namespace {

constexpr int kBitsPerByte = 10;
constexpr Duration kLongestPiece = std::chrono::milliseconds(1);

}  // namespace

PacedQueue::PacedQueue(Scheduler& scheduler, std::function<void(ByteView)> deliver)
    : scheduler_(scheduler), deliver_(std::move(deliver)) {
    setBitRate(0);
}

PacedQueue::~PacedQueue() {
    clear();
}

void PacedQueue::setBitRate(std::uint32_t bitsPerSecond) {
    byteTime_ = Duration(std::chrono::seconds(kBitsPerByte)) / std::max(bitsPerSecond, 1U);
}

void PacedQueue::push(ByteView bytes) {
    bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    if (timer_ == 0 && !bytes_.empty()) arm();
}

void PacedQueue::clear() {
    bytes_.clear();
    if (timer_ != 0) scheduler_.cancel(std::exchange(timer_, 0));
}

void PacedQueue::arm() {
    const auto most = byteTime_ > Duration::zero() ? kLongestPiece / byteTime_ : Duration::rep{1};
    piece_ = std::min(bytes_.size(), static_cast<std::size_t>(std::max(most, Duration::rep{1})));
    timer_ = scheduler_.callAfter(byteTime_ * static_cast<Duration::rep>(piece_), [this] { due(); });
}

void PacedQueue::due() {
    timer_ = 0;
    const auto end = bytes_.begin() + static_cast<std::ptrdiff_t>(piece_);
    const std::vector<std::uint8_t> piece(bytes_.begin(), end);
    bytes_.erase(bytes_.begin(), end);
    if (!bytes_.empty()) arm();
    // A copy, because what it calls may destroy this queue.
    const auto deliver = deliver_;
    deliver(piece);
}

}  // namespace kickstand
