#include "core/smartdevice/sample_pieces.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace kickstand::smartdevice {
namespace {

using wire::ParameterMask;

ParameterMask join(const std::vector<ParameterMask>& masks) {
    return std::accumulate(masks.begin(), masks.end(), ParameterMask{0}, std::bit_or<>());
}

}  // namespace

void SamplePieces::restart(ParameterMask subscribed, bool sends) {
    if (subscribed == subscribed_ && sends == sends_) return;
    subscribed_ = subscribed;
    sends_ = sends;
    pieces_.clear();
    run_.clear();
    seen_ = 0;
}

void SamplePieces::learn(ParameterMask mask) {
    // An answer in between overlaps with what is next of the sample, so that no cut with one in it gets
    // whole.
    if ((join(run_) & mask) != 0) run_.clear();
    run_.push_back(mask);
    if (join(run_) != subscribed_) return;
    // This is the last piece of the first sample that is cut so.
    if (!std::ranges::is_permutation(run_, pieces_)) seen_ = static_cast<ParameterMask>(subscribed_ & ~mask);
    pieces_ = std::exchange(run_, {});
}

SamplePieces::Part SamplePieces::take(ParameterMask mask) {
    if (!sends_) return Part::None;
    if (mask == subscribed_) {
        pieces_ = {mask};
        run_.clear();
        seen_ = 0;
        return Part::End;
    }
    if (mask == 0 || (mask & ~subscribed_) != 0) return Part::None;
    learn(mask);
    if (std::ranges::find(pieces_, mask) == pieces_.end()) return Part::None;
    if ((seen_ & mask) != 0) seen_ = 0;
    seen_ = static_cast<ParameterMask>(seen_ | mask);
    if (seen_ != subscribed_) return Part::Piece;
    seen_ = 0;
    return Part::End;
}

}  // namespace kickstand::smartdevice
