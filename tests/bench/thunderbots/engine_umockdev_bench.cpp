// The figures of bench_engine through unmodified libusb, for information: the bus is umockdev's emulation of
// the kernel's, which has no frames and a price of its own for every call. To be run under umockdev-wrapper.
//
//     bench_engine_umockdev [SAMPLES]

#include <memory>

#include "core/link/usb/libusb_link.h"
#include "tests/bench/thunderbots/dongle_thread.h"
#include "tests/bench/thunderbots/engine_figures.h"
#include "tests/support/usb/umockdev_bus.h"

namespace {

using namespace kickstand;

Result<ProvidedUsbLink> makeLink(const LinkUri&, Scheduler& scheduler) {
    ProvidedUsbLink provided;
    provided.link = makeLibusbLink(scheduler, bench::DongleThread::match());
    return provided;
}

}  // namespace

int main(int count, char** arguments) {
    bench::DongleThread dongle;
    testing::UmockdevBus bus(dongle.scheduler());
    bus.connect(dongle.device(), "1-1");
    return bench::measureEngine({.uri = "usb:", .make = makeLink, .samples = 1000, .starts = 10}, count,
                                arguments);
}
