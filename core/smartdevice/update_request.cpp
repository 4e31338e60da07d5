#include "core/smartdevice/update_request.h"

#include <utility>

namespace kickstand::smartdevice {

void UpdateRequest::begin(const wire::SubscriptionRequest& request, TimePoint now) {
    request_ = request;
    other_.reset();
    asked_ = 1;
    nextAt_ = now + kAskEvery;
}

bool UpdateRequest::settledBy(const wire::SubscriptionResponse& response) {
    // A ping is answered in the same way, by a device that has not been asked for updates yet.
    if ((response.delay_ms == 0) != (request_.delay_ms == 0)) return false;
    // Without updates it does not matter of what.
    const bool same = response.delay_ms == request_.delay_ms &&
                      (response.delay_ms == 0 || response.parameters == request_.parameters);
    if (!same && std::exchange(other_, response) != response) return false;
    asked_ = 0;
    return true;
}

UpdateRequest::Due UpdateRequest::due(TimePoint now) {
    if (asked_ == 0 || now < nextAt_) return Due::Nothing;
    if (asked_ == kAsks) {
        asked_ = 0;
        return Due::GiveUp;
    }
    ++asked_;
    nextAt_ = now + kAskEvery;
    return Due::AskAgain;
}

}  // namespace kickstand::smartdevice
