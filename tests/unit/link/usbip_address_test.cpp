#include "core/link/usbip/usbip_address.h"

#include <gtest/gtest.h>

namespace kickstand {
namespace {

TEST(UsbipAddress, IsTakenApartAndPutTogether) {
    const struct {
        const char* text;
        UsbipAddress address;
    } cases[] = {
        {"127.0.0.1:3240/1-1", {"127.0.0.1", 3240, "1-1"}},
        {"bench.local/2-1.4", {"bench.local", 3240, "2-1.4"}},
        {"[::1]:99/1-1", {"::1", 99, "1-1"}},
        {"[fe80::1%eth0]/1-1", {"fe80::1%eth0", 3240, "1-1"}},
        {"h:65535/x", {"h", 65535, "x"}},
    };
    for (const auto& one : cases) {
        const auto address = parseUsbipAddress(one.text);
        ASSERT_TRUE(address) << one.text;
        EXPECT_EQ(*address, one.address) << one.text;
        EXPECT_EQ(*parseUsbipAddress(toString(*address)), one.address) << toString(*address);
    }
}

TEST(UsbipAddress, AnythingElseIsRefused) {
    for (const char* text : {"",
                             "/",
                             "h",
                             "h/",
                             "/1-1",
                             ":3240/1-1",
                             "h:/1-1",
                             "h:0/1-1",
                             "h:65536/1-1",
                             "h:12a/1-1",
                             "h:-1/1-1",
                             "h: 1/1-1",
                             "h:1:2/1-1",
                             "::1/1-1",
                             "[::1/1-1",
                             "[]/1-1",
                             "[h]/1-1",
                             "[::1]x/1-1",
                             "[::1]:/1-1",
                             "[[::1]]/1-1",
                             "a]b/1-1",
                             "h/1-1/2",
                             "h /1-1",
                             "h/1 1",
                             "h/\x1B",
                             "h/12345678901234567890123456789012"}) {
        const auto address = parseUsbipAddress(text);
        ASSERT_FALSE(address) << text;
        EXPECT_EQ(address.error().code, Errc::BadUri);
        EXPECT_EQ(address.error().detail, "usbip:HOST[:PORT]/BUSID");
    }
}

}  // namespace
}  // namespace kickstand
