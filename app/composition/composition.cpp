#include "app/composition/composition.h"

#include <utility>

#include "app/composition/device_finder.h"
#include "app/composition/serial_links.h"
#include "app/composition/simulated_lines.h"
#include "app/composition/usb_links.h"
#include "app/composition/usbip_links.h"
#include "app/composition/user_catalogue.h"
#include "core/link/loopback/loopback_usb_link.h"
#include "core/link/serial/serial_ports.h"
#include "core/smartdevice/sim/simulated_ports.h"
#include "core/thunderbots/sim/thunderbots_sim.h"

namespace kickstand {
namespace {

using thunderbots::sim::parseSimOptions;
using thunderbots::sim::ThunderbotsSim;

std::string simulatedNames() {
    const std::string lines = simulatedLineNames();
    return "sim:thunderbots, sim:smartdevice" + (lines.empty() ? lines : ", " + lines);
}

std::string schemes() {
    return "usb:, usb-cable:, usbip:HOST:PORT/BUSID, serial:PATH?protocol=NAME, " + simulatedNames();
}

bool isSimulatedSmartDevices(const LinkUri& uri) {
    return uri.isSimulated() && uri.target == "smartdevice";
}

class ComposedLinks final : public LinkProvider {
  public:
    Result<ProvidedUsbLink> makeUsbLink(const LinkUri& uri, Scheduler& scheduler) override {
        if (auto exists = checkLink(uri); !exists) return fail(std::move(exists.error()));
        if (isSerial(uri) || isSimulatedLine(uri) || isSimulatedSmartDevices(uri))
            return fail(Errc::BadUri, toString(uri), "USB: usb:, usb-cable:, usbip:HOST:PORT/BUSID");
        if (uri.isSimulated()) return makeSimulated(uri, scheduler);
        auto link = isUsbip(uri) ? makeUsbipLink(uri, scheduler) : makeHardwareLink(uri, scheduler);
        if (!link) return fail(std::move(link.error()));
        ProvidedUsbLink provided;
        provided.link = std::move(*link);
        return provided;
    }

    Result<ProvidedByteLink> makeByteLink(const LinkUri& uri, Scheduler& scheduler) override {
        if (isSerial(uri)) return makeSerialLink(uri, scheduler);
        if (isSimulatedLine(uri)) return makeSimulatedLine(uri, scheduler);
        return fail(Errc::BadUri, toString(uri), "a serial line: serial:PATH?protocol=NAME");
    }

    Result<ProvidedBytePorts> makeBytePorts(const LinkUri& uri, Scheduler& scheduler) override {
        const bool simulated = isSimulatedSmartDevices(uri);
        if (!isSerial(uri) && !simulated)
            return fail(Errc::BadUri, toString(uri), "serial ports: serial:, sim:smartdevice");
        auto provided = simulated ? makeBoards(uri, scheduler) : makeSerialPortList(uri, scheduler);
        if (!provided) return provided;
        provided->catalogue = catalogue_.text;
        provided->catalogueSource = catalogue_.source;
        return provided;
    }

    void discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) override {
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

    static Result<ProvidedBytePorts> makeBoards(const LinkUri& uri, Scheduler& scheduler) {
        const auto options = smartdevice::sim::parseSimOptions(uri);
        if (!options) return fail(options.error());
        const auto sim = std::make_shared<smartdevice::sim::SmartDeviceSim>(scheduler, *options);
        ProvidedBytePorts provided;
        provided.ports = smartdevice::sim::makeSimulatedPorts(scheduler, *sim, {.damage = options->noise});
        provided.sim = sim.get();
        provided.keepAlive = sim;
        return provided;
    }

    const UserCatalogue catalogue_ = readUserCatalogue();
    DeviceFinder finder_{[] { return FoundHardware{findHardware(), listSerialPorts()}; }};
};

}  // namespace

std::unique_ptr<LinkProvider> makeLinkProvider() {
    return std::make_unique<ComposedLinks>();
}

Result<void> checkLink(const LinkUri& uri) {
    if (isHardware(uri)) return checkHardwareLink(uri);
    if (isUsbip(uri)) return checkUsbipLink(uri);
    if (isSerial(uri)) return checkSerialLink(uri);
    if (isSimulatedLine(uri)) return checkSimulatedLine(uri);
    if (isSimulatedSmartDevices(uri)) {
        const auto options = smartdevice::sim::parseSimOptions(uri);
        return options ? Result<void>() : fail(options.error());
    }
    if (!uri.isSimulated()) return fail(Errc::BadUri, toString(uri), schemes());
    if (uri.target != "thunderbots")
        return fail(Errc::Unsupported, toString(uri), "simulated are " + simulatedNames());
    if (const auto options = parseSimOptions(uri); !options) return fail(options.error());
    return {};
}

}  // namespace kickstand
