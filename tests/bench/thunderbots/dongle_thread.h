#pragma once

#include <memory>

#include "core/link/usb_types.h"
#include "core/thunderbots/sim/thunderbots_sim.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::bench {

/// The simulated dongle of the benchmarks on a thread of its own, as hardware is.
class DongleThread {
  public:
    DongleThread() {
        scheduler_.run([this] {
            thunderbots::sim::ThunderbotsSimOptions options;
            options.pace = thunderbots::sim::RadioPace::Ideal;
            sim_ = std::make_unique<thunderbots::sim::ThunderbotsSim>(scheduler_, options);
        });
    }
    ~DongleThread() {
        scheduler_.run([this] { sim_.reset(); });
    }
    DongleThread(const DongleThread&) = delete;
    DongleThread& operator=(const DongleThread&) = delete;

    testing::WatchedScheduler& scheduler() { return scheduler_; }
    /// On the scheduler's thread only, once it is used.
    UsbDeviceModel& device() { return sim_->device(); }

    /// What finds it.
    static UsbMatch match() {
        UsbMatch match;
        match.vendor = thunderbots::wire::kVendorId;
        match.product = thunderbots::wire::kDongleProductId;
        match.interfaces = {thunderbots::wire::kLocalDataInterface,
                            thunderbots::wire::kMainTransportInterface};
        return match;
    }

  private:
    testing::WatchedScheduler scheduler_;
    std::unique_ptr<thunderbots::sim::ThunderbotsSim> sim_;
};

}  // namespace kickstand::bench
