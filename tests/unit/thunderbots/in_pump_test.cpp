#include "core/thunderbots/in_pump.h"

#include <vector>

#include <gtest/gtest.h>

#include "core/thunderbots/retry.h"
#include "tests/support/session/fake_usb_link.h"

namespace kickstand::thunderbots {
namespace {

constexpr std::uint8_t kIn = 0x85;
constexpr int kDepth = 3;

class InPumpTest : public ::testing::Test {
  protected:
    InPumpTest() { link.finishOpen(UsbDeviceInfo{}); }

    kickstand::testing::FakeUsbLink link;
    std::vector<std::vector<std::uint8_t>> received;
    std::vector<Error> failures;
    InPump pump{link,
                kIn,
                64,
                kDepth,
                [this](ByteView packet) { received.emplace_back(packet.begin(), packet.end()); },
                [this](Error error) { failures.push_back(std::move(error)); }};
};

TEST_F(InPumpTest, KeepsTransfersPendingAndHandsPacketsOn) {
    pump.open();
    ASSERT_EQ(link.pending(kIn).size(), static_cast<std::size_t>(kDepth));
    EXPECT_EQ(link.pending(kIn).front().size, 64U);
    const std::vector<std::uint8_t> packet{1, 2, 3};
    link.complete(kIn, UsbStatus::Completed, packet);
    link.complete(kIn, UsbStatus::Completed, {});
    EXPECT_EQ(received, (std::vector<std::vector<std::uint8_t>>{packet, {}}));
    EXPECT_EQ(link.pending(kIn).size(), static_cast<std::size_t>(kDepth));
}

TEST_F(InPumpTest, ClearsAStallOnceForAllTransfersThatItEnded) {
    pump.open();
    for (int i = 0; i < kDepth; ++i)
        link.complete(kIn, UsbStatus::Stalled);
    EXPECT_EQ(link.clearing(), std::vector<std::uint8_t>{kIn});
    EXPECT_TRUE(link.pending(kIn).empty());
    link.completeClear();
    EXPECT_EQ(link.pending(kIn).size(), static_cast<std::size_t>(kDepth));
}

TEST_F(InPumpTest, GivesUpAfterABoundedNumberOfFailuresInARow) {
    pump.open();
    for (int i = 0; i < kStallRetries; ++i) {
        link.complete(kIn, UsbStatus::Stalled);
        link.completeClear();
    }
    EXPECT_TRUE(failures.empty());
    link.complete(kIn, UsbStatus::Stalled);
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.front().code, Errc::Stalled);
    EXPECT_EQ(failures.front().endpoint, kIn);
    link.complete(kIn, UsbStatus::Stalled);
    EXPECT_EQ(failures.size(), 1U) << "told once";
}

TEST_F(InPumpTest, BeginsToCountAgainAfterAPacket) {
    pump.open();
    for (int i = 0; i < 3 * kStallRetries; ++i) {
        link.complete(kIn, UsbStatus::Overflow);
        link.completeClear();
        link.complete(kIn, UsbStatus::Completed, {});
    }
    EXPECT_TRUE(failures.empty());
}

TEST_F(InPumpTest, AsksForNothingMoreOnceClosed) {
    pump.open();
    pump.close();
    link.complete(kIn, UsbStatus::Completed, {});
    link.complete(kIn, UsbStatus::Stalled);
    link.complete(kIn, UsbStatus::Cancelled);
    EXPECT_TRUE(link.pending(kIn).empty());
    EXPECT_TRUE(link.clearing().empty());
    EXPECT_TRUE(received.empty()) << "what comes late belongs to no connection";
}

TEST_F(InPumpTest, LeavesLateCompletionsOfAnEarlierConnectionAlone) {
    pump.open();
    pump.close();
    pump.open();
    ASSERT_EQ(link.pending(kIn).size(), static_cast<std::size_t>(2 * kDepth));
    for (int i = 0; i < kDepth; ++i)
        link.complete(kIn, UsbStatus::Stalled);
    EXPECT_TRUE(link.clearing().empty());
    EXPECT_EQ(link.pending(kIn).size(), static_cast<std::size_t>(kDepth));
}

}  // namespace
}  // namespace kickstand::thunderbots
