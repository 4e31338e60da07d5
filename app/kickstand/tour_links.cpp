#include "app/kickstand/tour_links.h"

#include <utility>

namespace kickstand::app {

namespace {

class TourLinks final : public LinkProvider {
  public:
    TourLinks(std::unique_ptr<LinkProvider> links, std::shared_ptr<const TourBus> bus)
        : links_(std::move(links)), bus_(std::move(bus)) {}

    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        return links_->makeUsbLink(uri, scheduler);
    }
    Result<ProvidedByteLink> makeByteLink(const LinkUri& uri, Scheduler& scheduler) override {
        return links_->makeByteLink(uri, scheduler);
    }
    Result<ProvidedBytePorts> makeBytePorts(const LinkUri& uri, Scheduler& scheduler) override {
        return links_->makeBytePorts(uri, scheduler);
    }
    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
        scheduler.post([bus = bus_, found = std::move(found)] {
            FoundHardware hardware;
            if (bus->forbiddenDongle) {
                FoundDevice dongle;
                dongle.uri.scheme = "usb";
                dongle.info.port = "1-2.3";
                dongle.obstacle = Error{.code = Errc::PermissionDenied};
                hardware.devices.push_back(std::move(dongle));
            }
            found(std::move(hardware));
        });
    }

  private:
    std::unique_ptr<LinkProvider> links_;
    std::shared_ptr<const TourBus> bus_;
};

}  // namespace

std::unique_ptr<LinkProvider> makeTourLinks(std::unique_ptr<LinkProvider> links,
                                            std::shared_ptr<const TourBus> bus) {
    return std::make_unique<TourLinks>(std::move(links), std::move(bus));
}

}  // namespace kickstand::app
