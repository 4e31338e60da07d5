#include "tests/contract/libusb_rig.h"
#include "tests/contract/usb_link_contract.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;

INSTANTIATE_TEST_SUITE_P(
    Libusb, UsbLinkContract,
    ::testing::Values(UsbRigFactory{"libusb", [] { return std::make_unique<LibusbRig>(); }},
                      UsbRigFactory{"libusb without hotplug", [] {
                                        return std::make_unique<LibusbRig>(UsbWatchOptions{true, 20ms});
                                    }}));

}  // namespace
}  // namespace kickstand::testing
