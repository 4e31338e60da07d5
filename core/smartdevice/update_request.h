#pragma once

#include <chrono>

#include "core/base/time.h"

namespace kickstand::smartdevice {

/// A request for updates that may get lost, until it is granted: asked again every 500 ms, ten times in all.
class UpdateRequest {
  public:
    static constexpr Duration kAskEvery = std::chrono::milliseconds(500);
    static constexpr int kAsks = 10;

    /// It was sent for the first time.
    void begin(TimePoint now) {
        asked_ = 1;
        nextAt_ = now + kAskEvery;
    }
    /// It was granted, or nobody is there any more.
    void end() { asked_ = 0; }
    bool isOpen() const { return asked_ > 0; }

    enum class Due { Nothing, AskAgain, GiveUp };
    /// What there is to do now; after GiveUp it is not open any more.
    Due due(TimePoint now) {
        if (asked_ == 0 || now < nextAt_) return Due::Nothing;
        if (asked_ == kAsks) {
            asked_ = 0;
            return Due::GiveUp;
        }
        ++asked_;
        nextAt_ = now + kAskEvery;
        return Due::AskAgain;
    }

  private:
    int asked_ = 0;  ///< How often; 0 while nothing is open.
    TimePoint nextAt_{};
};

}  // namespace kickstand::smartdevice
