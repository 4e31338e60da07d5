#include "tests/soak/soak_links.h"

#include <utility>

#include "core/link/loopback/loopback_usb_link.h"
#include "core/link/usbip/usbip_link.h"
#include "core/thunderbots/wire/dongle.h"
#include "tests/support/usb/memory_stream.h"

namespace kickstand::soak {
namespace {

using namespace std::chrono_literals;
using namespace thunderbots;

constexpr const char* kBusId = "1-1";
/// As a network on one desk.
constexpr Duration kDelay = 200us;

}  // namespace

std::unique_ptr<UsbLink> SoakLinks::make(UsbDeviceModel& device, Scheduler& scheduler) {
    if (!overUsbip_) return std::make_unique<LoopbackUsbLink>(scheduler, device);
    // The one device and its name are sound.
    if (!hall_)
        hall_ = UsbipHall{.exports = *UsbipExports::make(std::vector<UsbipExport>{{kBusId, &device}})};
    UsbMatch match;
    match.vendor = wire::kVendorId;
    match.product = wire::kDongleProductId;
    match.interfaces = {wire::kLocalDataInterface, wire::kMainTransportInterface};
    const UsbipAddress address{"soak", 0, kBusId};
    return makeUsbipLink(scheduler, address, match, [this, &scheduler](auto done) {
        scheduler.post([this, &scheduler, done = std::move(done)] {
            if (reachable_) {
                done(connect(scheduler));
            } else {
                done(fail(Errc::NoDevice, "server"));
            }
        });
    });
}

std::unique_ptr<ByteStream> SoakLinks::connect(Scheduler& scheduler) {
    auto [server, client] = testing::makeMemoryStreams(scheduler, {.seed = ++seed_, .delay = kDelay});
    const auto place = connections_.emplace(connections_.end());
    *place = std::make_unique<UsbipConnection>(scheduler, std::move(server), *hall_, UsbipLimits{},
                                               [this, place] { connections_.erase(place); });
    return std::move(client);
}

void SoakLinks::cut() {
    reachable_ = false;
    connections_.clear();
}

}  // namespace kickstand::soak
