#pragma once

#include <chrono>
#include <optional>

#include "core/base/time.h"
#include "core/smartdevice/wire/message.h"

namespace kickstand::smartdevice {

/// A request for updates that may get lost, until it is granted: asked again every 500 ms, ten times in all.
class UpdateRequest {
  public:
    static constexpr Duration kAskEvery = std::chrono::milliseconds(500);
    static constexpr int kAsks = 10;

    /// It was sent for the first time.
    void begin(const wire::SubscriptionRequest& request, TimePoint now);
    /// Nobody is there any more.
    void end() { asked_ = 0; }
    bool isOpen() const { return asked_ > 0; }
    /// A response came. Whether this is what the device will do: it grants what was asked for, or insists on
    /// something else. What differs is asked for once more, since it may answer an earlier request.
    bool settledBy(const wire::SubscriptionResponse& response);

    enum class Due { Nothing, AskAgain, GiveUp };
    /// What there is to do now; after GiveUp it is not open any more.
    Due due(TimePoint now);

  private:
    wire::SubscriptionRequest request_;
    std::optional<wire::SubscriptionResponse> other_;  ///< What was granted instead.
    int asked_ = 0;                                    ///< How often; 0 while nothing is open.
    TimePoint nextAt_{};
};

}  // namespace kickstand::smartdevice
