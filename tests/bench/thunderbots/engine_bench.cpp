// How long a command and a STOP take from the caller's thread to the link, as JSON on standard output: the
// engine on its own thread, a simulated dongle on a bus of one packet a millisecond, sixteen robots that feed
// back at 200 Hz over an ideal radio. Also how long a session takes to start.
//
//     bench_engine [SAMPLES]

#include <memory>

#include "core/link/loopback/loopback_usb_link.h"
#include "core/thunderbots/sim/thunderbots_sim.h"
#include "tests/bench/thunderbots/engine_figures.h"

namespace {

using namespace kickstand;

Result<ProvidedUsbLink> makeLoopback(const LinkUri& uri, Scheduler& scheduler) {
    const auto options = thunderbots::sim::parseSimOptions(uri);
    if (!options) return fail(options.error());
    auto device = std::make_shared<thunderbots::sim::ThunderbotsSim>(scheduler, *options);
    ProvidedUsbLink provided;
    provided.link = std::make_unique<LoopbackUsbLink>(scheduler, device->device());
    provided.sim = &device->control();
    provided.keepAlive = std::move(device);
    return provided;
}

}  // namespace

int main(int count, char** arguments) {
    return bench::measureEngine({.uri = "sim:thunderbots?radio=ideal", .make = makeLoopback}, count,
                                arguments);
}
