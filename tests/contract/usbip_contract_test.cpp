#include "tests/contract/usb_link_contract.h"
#include "tests/contract/usbip_rig.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<UsbRig> inMemory() {
    return std::make_unique<UsbipMemoryRig>();
}
/// As over a slow network, whose pieces are a byte or some.
std::unique_ptr<UsbRig> inCrumbs() {
    return std::make_unique<UsbipMemoryRig>(MemoryStreamOptions{.seed = 7, .largestPiece = 60, .delay = 3ms});
}
std::unique_ptr<UsbRig> overTcp() {
    return std::make_unique<UsbipTcpRig>();
}

INSTANTIATE_TEST_SUITE_P(Usbip, UsbLinkContract,
                         ::testing::Values(UsbRigFactory{"usbip in memory", inMemory},
                                           UsbRigFactory{"usbip in memory, in crumbs", inCrumbs},
                                           UsbRigFactory{"usbip over TCP", overTcp}));

}  // namespace
}  // namespace kickstand::testing
