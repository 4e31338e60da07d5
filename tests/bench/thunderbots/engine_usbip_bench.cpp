// The figures of bench_engine over USB/IP, for information: client and server talk through sockets of this
// machine, the server on a thread of its own and with frames of a millisecond.
//
//     bench_engine_usbip [SAMPLES]

#include <cstdio>
#include <memory>

#include "core/link/usbip/usbip_link.h"
#include "core/usbip/usbip_server.h"
#include "tests/bench/thunderbots/dongle_thread.h"
#include "tests/bench/thunderbots/engine_figures.h"

namespace {

using namespace kickstand;

constexpr const char* kBusId = "1-1";

/// The dongle, served.
class ServedDongle {
  public:
    ServedDongle() {
        dongle_.scheduler().run([this] {
            server_ = UsbipServer::serve(dongle_.scheduler(), {{kBusId, &dongle_.device()}}, {.port = 0});
        });
    }
    ~ServedDongle() {
        dongle_.scheduler().run([this] { server_ = fail(Errc::Cancelled); });
    }
    ServedDongle(const ServedDongle&) = delete;
    ServedDongle& operator=(const ServedDongle&) = delete;

    /// 0 where it could not be served.
    std::uint16_t port() const { return server_ ? (*server_)->port() : 0; }

  private:
    bench::DongleThread dongle_;
    Result<std::unique_ptr<UsbipServer>> server_ = fail(Errc::Cancelled);
};

}  // namespace

int main(int count, char** arguments) {
    const ServedDongle dongle;
    if (dongle.port() == 0) {
        std::fprintf(stderr, "bench_engine_usbip: no port to listen at\n");
        return 1;
    }
    const UsbipAddress address{"127.0.0.1", dongle.port(), kBusId};
    const auto make = [&address](const LinkUri&, Scheduler& scheduler) -> Result<ProvidedUsbLink> {
        ProvidedUsbLink provided;
        provided.link = makeUsbipLink(scheduler, address, bench::DongleThread::match());
        return provided;
    };
    return bench::measureEngine({.uri = "usb:", .make = make, .samples = 1000, .starts = 10}, count,
                                arguments);
}
