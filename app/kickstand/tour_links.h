#pragma once

#include <atomic>
#include <memory>

#include "core/engine/link_provider.h"

namespace kickstand::app {

/// What the tour's own USB bus has. Any thread.
struct TourBus {
    /// A dongle that this user may not open.
    std::atomic<bool> forbiddenDongle = false;
};

/// The links of a tour: simulators as they are, and no hardware but what is on the tour's own bus, so that
/// its pictures are the same on every machine.
std::unique_ptr<LinkProvider> makeTourLinks(std::unique_ptr<LinkProvider> links,
                                            std::shared_ptr<const TourBus> bus);

}  // namespace kickstand::app
