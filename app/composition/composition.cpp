#include "app/composition/composition.h"

#include <utility>

#include "app/composition/device_finder.h"
#include "app/composition/usb_links.h"
#include "app/composition/usbip_links.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand {
namespace {

using thunderbots::sim::parseSimOptions;
using thunderbots::sim::ThunderbotsSim;

constexpr char kSchemes[] = "usb:, usb-cable:, usbip:HOST:PORT/BUSID, sim:thunderbots";

class ComposedLinks final : public LinkProvider {
  public:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        if (auto exists = checkLink(uri); !exists) return fail(std::move(exists.error()));
        if (uri.isSimulated()) return makeSimulated(uri, scheduler);
        auto link = isUsbip(uri) ? makeUsbipLink(uri, scheduler) : makeHardwareLink(uri, scheduler);
        if (!link) return fail(std::move(link.error()));
        ProvidedUsbLink provided;
        provided.link = std::move(*link);
        return provided;
    }

    void discover(Scheduler& scheduler, std::function<void(std::vector<FoundDevice>)> found) override {
        finder_.find(scheduler, std::move(found));
    }

  private:
    static Result<ProvidedUsbLink> makeSimulated(const LinkUri& uri, Scheduler& scheduler) {
        const auto options = parseSimOptions(uri);
        if (!options) return fail(options.error());
        const auto sim = std::make_shared<ThunderbotsSim>(scheduler, *options);
        ProvidedUsbLink provided;
        provided.link = std::make_unique<LoopbackUsbLink>(scheduler, sim->device());
        provided.sim = &sim->control();
        provided.keepAlive = sim;
        return provided;
    }

    DeviceFinder finder_{findHardware};
};

}  // namespace

std::unique_ptr<LinkProvider> makeLinkProvider() {
    return std::make_unique<ComposedLinks>();
}

Result<void> checkLink(const LinkUri& uri) {
    if (isHardware(uri)) return checkHardwareLink(uri);
    if (isUsbip(uri)) return checkUsbipLink(uri);
    if (!uri.isSimulated()) return fail(Errc::BadUri, toString(uri), kSchemes);
    if (uri.target != "thunderbots")
        return fail(Errc::Unsupported, toString(uri), "only sim:thunderbots is simulated");
    if (const auto options = parseSimOptions(uri); !options) return fail(options.error());
    return {};
}

}  // namespace kickstand
