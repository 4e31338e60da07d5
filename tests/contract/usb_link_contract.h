#pragma once

#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "tests/contract/usb_rig.h"

namespace kickstand::testing {

/// What one transfer's callback said, as often as it was called.
struct Ending {
    int calls = 0;
    UsbStatus status = UsbStatus::Failed;
    std::vector<std::uint8_t> data;
    std::size_t actual = 0;
};

/// The suite that every UsbLink passes: instantiate it with the factory of a rig.
class UsbLinkContract : public ::testing::TestWithParam<UsbRigFactory> {
  protected:
    void SetUp() override;
    void TearDown() override;

    /// Makes the link, anew where there is one.
    void makeLink();
    /// Opens and waits; a failure fails the test.
    UsbDeviceInfo open();
    /// Opens and waits for however it ends.
    Result<UsbDeviceInfo> tryOpen();
    void close();
    void destroy();

    /// Each gives the transfer a number by which ending() finds what became of it.
    int out(std::uint8_t endpoint, std::vector<std::uint8_t> bytes);
    int in(std::uint8_t endpoint, std::size_t size);
    int control(const UsbSetup& setup, std::vector<std::uint8_t> bytes,
                Duration deadline = std::chrono::seconds(5));
    int clearHalt(std::uint8_t endpoint);
    void cancel(int number);
    /// A number that nothing has been submitted under yet, for code that runs on the links' thread itself.
    UsbCallback record(int number);
    Ending ending(int number);
    /// Waits for the ending of a transfer.
    Ending finished(int number);
    bool waitForPresence(std::size_t changes);
    bool waitForReceived(std::size_t packets);
    std::vector<FakeUsbDevice::Packet> received();

    std::unique_ptr<UsbRig> rig_;
    std::unique_ptr<UsbLink> link_;
    // On the links' thread only.
    std::map<int, Ending> endings_;
    std::map<int, UsbTransferId> ids_;
    std::vector<int> order_;
    std::vector<bool> presence_;
    int lastNumber_ = 0;
};

}  // namespace kickstand::testing
