#include "core/link/usb_types.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/link/usb_packet_check.h"

namespace kickstand {
namespace {

TEST(UsbStatusNames, AreDistinct) {
    std::set<std::string> names;
    for (int i = 0; i <= static_cast<int>(UsbStatus::Failed); ++i)
        names.insert(name(static_cast<UsbStatus>(i)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(UsbStatus::Failed) + 1);
    EXPECT_FALSE(names.contains("unknown"));
    EXPECT_STREQ(name(UsbStatus::TimedOut), "timed-out");
}

TEST(UsbPacketCheck, TakesInterruptAndBulkEndpointsInTheirDirection) {
    using Type = UsbEndpointInfo::Type;
    const std::vector<UsbEndpointInfo> endpoints{
        {0x81, Type::Interrupt, 4, 25, 0}, {0x02, Type::Bulk, 64, 0, 0}, {0x03, Type::Isochronous, 64, 1, 0}};
    EXPECT_TRUE(checkUsbPacket(endpoints, 0x81, UsbDirection::In, 4));
    EXPECT_TRUE(checkUsbPacket(endpoints, 0x02, UsbDirection::Out, 0));
    EXPECT_TRUE(checkUsbPacket(endpoints, 0x02, UsbDirection::Out, 64));
    EXPECT_EQ(checkUsbPacket(endpoints, 0x81, UsbDirection::Out, 4).error().code, Errc::BadArgument);
    EXPECT_EQ(checkUsbPacket(endpoints, 0x03, UsbDirection::Out, 4).error().code, Errc::BadArgument);
    EXPECT_EQ(checkUsbPacket(endpoints, 0x00, UsbDirection::Out, 4).error().code, Errc::BadArgument);
    const auto tooLong = checkUsbPacket(endpoints, 0x81, UsbDirection::In, 5);
    ASSERT_FALSE(tooLong);
    EXPECT_EQ(tooLong.error().code, Errc::OutOfRange);
    EXPECT_EQ(tooLong.error().endpoint, 0x81);
    EXPECT_EQ(tooLong.error().lowest, 1);
    EXPECT_EQ(tooLong.error().highest, 4);
    EXPECT_EQ(tooLong.error().got, 5);
}

}  // namespace
}  // namespace kickstand
