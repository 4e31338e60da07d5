#include "core/link/usb_standard_requests.h"

#include <gtest/gtest.h>

#include "core/link/usb_descriptors.h"

namespace kickstand {
namespace {

using Bytes = std::vector<std::uint8_t>;

UsbDescriptors twoInterfaces() {
    using Type = UsbEndpointInfo::Type;
    UsbDeviceDescription description;
    description.vendor = 0x1234;
    description.product = 0x5678;
    description.release = 0x0102;
    description.manufacturer = "Maker";
    description.productName = "Thing";
    description.power_mA = 500;
    UsbInterfaceDescription first;
    first.name = "First";
    first.endpoints = {{0x81, Type::Interrupt, 4, 25, 9}};
    UsbInterfaceDescription second;
    second.endpoints = {{0x05, Type::Interrupt, 64, 1, 9}, {0x83, Type::Bulk, 8, 0, 9}};
    description.interfaces = {first, second};
    return buildUsbDescriptors(description);
}

TEST(UsbDescriptors, TravelAsTheStandardHasThem) {
    const UsbDescriptors descriptors = twoInterfaces();
    EXPECT_EQ(descriptors.device,
              (Bytes{18, 1, 0x00, 0x02, 0, 0, 0, 8, 0x34, 0x12, 0x78, 0x56, 0x02, 0x01, 1, 2, 0, 1}));
    const Bytes expected{9, 2, 48,   0, 2,  1,    0,  0x80, 250,  // configuration: 48 bytes, 500 mA
                         9, 4, 0,    0, 1,  0xFF, 0,  0,    3,    // interface 0, string 3
                         7, 5, 0x81, 3, 4,  0,    25,             // interrupt IN
                         9, 4, 1,    0, 2,  0xFF, 0,  0,    0,    // interface 1, no string
                         7, 5, 0x05, 3, 64, 0,    1,              // interrupt OUT
                         7, 5, 0x83, 2, 8,  0,    0};             // bulk IN
    EXPECT_EQ(descriptors.configuration, expected);
    EXPECT_EQ(descriptors.strings,
              (std::map<std::uint8_t, std::string>{{1, "Maker"}, {2, "Thing"}, {3, "First"}}));
    ASSERT_EQ(descriptors.endpoints.size(), 3U);
    EXPECT_EQ(descriptors.endpoints[0].interface, 0);
    EXPECT_EQ(descriptors.endpoints[2].interface, 1);
    EXPECT_EQ(descriptors.endpoints[2].address, 0x83);
}

class StandardRequests : public ::testing::Test {
  protected:
    /// The answer, or nothing where the request stalled.
    std::optional<Bytes> ask(UsbSetup setup) {
        Bytes in{0xEE};
        const auto handshake = requests_.handle(setup, in);
        EXPECT_TRUE(handshake.has_value());
        if (handshake != UsbHandshake::Ack) return std::nullopt;
        return in;
    }
    std::optional<Bytes> descriptor(std::uint16_t value) { return ask({0x80, 6, value, 0, 255}); }
    bool configure(std::uint16_t value) { return ask({0x00, 9, value, 0, 0}).has_value(); }
    bool clearHalt(std::uint8_t endpoint) { return ask({0x02, 1, 0, endpoint, 0}).has_value(); }

    UsbDescriptors descriptors_ = twoInterfaces();
    Bytes configured_;
    Bytes cleared_;
    UsbStandardRequests requests_{
        descriptors_,
        {.configured = [this](std::uint8_t value) { configured_.push_back(value); },
         .haltCleared = [this](std::uint8_t endpoint) { cleared_.push_back(endpoint); }}};
};

TEST_F(StandardRequests, GiveTheDescriptors) {
    EXPECT_EQ(descriptor(0x0100), descriptors_.device);
    EXPECT_EQ(descriptor(0x0200), descriptors_.configuration);
    EXPECT_EQ(descriptor(0x0201), std::nullopt) << "there is one configuration";
    EXPECT_EQ(descriptor(0x0600), std::nullopt) << "a full-speed device has no qualifier";
}

TEST_F(StandardRequests, GiveStringsAsUtf16) {
    EXPECT_EQ(descriptor(0x0300), (Bytes{4, 3, 0x09, 0x04}));
    EXPECT_EQ(descriptor(0x0301), (Bytes{12, 3, 'M', 0, 'a', 0, 'k', 0, 'e', 0, 'r', 0}));
    EXPECT_EQ(descriptor(0x0309), std::nullopt);
    descriptors_.strings[7] = "\xC2\xB5\xE2\x82\xAC\xF0\x9F\xA4\x96";  // µ, € and a robot.
    EXPECT_EQ(descriptor(0x0307), (Bytes{10, 3, 0xB5, 0x00, 0xAC, 0x20, 0x3E, 0xD8, 0x16, 0xDD}));
}

TEST_F(StandardRequests, BadUtf8BecomesTheReplacementCharacter) {
    for (const char* bad : {"\x80", "\xC3", "\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE2\x28"}) {
        descriptors_.strings[7] = bad;
        const auto answer = descriptor(0x0307);
        ASSERT_TRUE(answer) << bad;
        ASSERT_GE(answer->size(), 4U);
        EXPECT_EQ(answer->at(2), 0xFD);
        EXPECT_EQ(answer->at(3), 0xFF);
    }
}

TEST_F(StandardRequests, LongStringsAreCutAtWholeCharacters) {
    descriptors_.strings[7] = std::string(300, 'x');
    EXPECT_EQ(descriptor(0x0307)->size(), 254U);
    std::string robots;
    for (int i = 0; i < 100; ++i)
        robots += "\xF0\x9F\xA4\x96";
    descriptors_.strings[7] = "x" + robots;
    const auto answer = descriptor(0x0307);
    EXPECT_EQ(answer->size(), 252U) << "half a surrogate pair was sent";
    EXPECT_EQ(answer->front(), 252);
}

TEST_F(StandardRequests, ConfigurationIsKeptAndTold) {
    EXPECT_EQ(ask({0x80, 8, 0, 0, 1}), Bytes{0});
    EXPECT_TRUE(configure(1));
    EXPECT_EQ(ask({0x80, 8, 0, 0, 1}), Bytes{1});
    EXPECT_TRUE(configure(1));
    EXPECT_TRUE(configure(0));
    EXPECT_FALSE(configure(2));
    EXPECT_EQ(configured_, (Bytes{1, 1, 0}));
    EXPECT_EQ(requests_.configuration(), 0);
}

TEST_F(StandardRequests, HaltIsSetShownAndCleared) {
    ASSERT_TRUE(configure(1));
    requests_.halt(0x81);
    EXPECT_EQ(ask({0x82, 0, 0, 0x81, 2}), (Bytes{1, 0}));
    EXPECT_TRUE(clearHalt(0x81));
    EXPECT_FALSE(requests_.isHalted(0x81));
    EXPECT_EQ(ask({0x82, 0, 0, 0x81, 2}), (Bytes{0, 0}));
    EXPECT_TRUE(clearHalt(0x81)) << "clearing what is not halted is allowed";
    EXPECT_EQ(cleared_, Bytes{0x81});
    EXPECT_TRUE(ask({0x02, 3, 0, 0x05, 0}).has_value());
    EXPECT_TRUE(requests_.isHalted(0x05)) << "a host may halt an endpoint itself";
}

TEST_F(StandardRequests, EndpointsThatAreNotThereStall) {
    EXPECT_FALSE(clearHalt(0x81)) << "before it is configured a device has no endpoint but 0";
    ASSERT_TRUE(configure(1));
    EXPECT_FALSE(clearHalt(0x82));
    EXPECT_EQ(ask({0x82, 0, 0, 0x82, 2}), std::nullopt);
    EXPECT_EQ(ask({0x82, 0, 0, 0x00, 2}), (Bytes{0, 0}));
}

TEST_F(StandardRequests, ConfiguringAndResettingClearHalts) {
    ASSERT_TRUE(configure(1));
    requests_.halt(0x81);
    ASSERT_TRUE(configure(1));
    EXPECT_FALSE(requests_.isHalted(0x81));
    requests_.halt(0x81);
    requests_.reset();
    EXPECT_FALSE(requests_.isHalted(0x81));
    EXPECT_EQ(requests_.configuration(), 0);
}

TEST_F(StandardRequests, InterfacesHaveOneSetting) {
    EXPECT_EQ(ask({0x81, 10, 0, 0, 1}), std::nullopt) << "not configured";
    ASSERT_TRUE(configure(1));
    requests_.halt(0x81);
    requests_.halt(0x05);
    EXPECT_EQ(ask({0x81, 10, 0, 1, 1}), Bytes{0});
    EXPECT_TRUE(ask({0x01, 11, 0, 1, 0}).has_value());
    EXPECT_FALSE(requests_.isHalted(0x05));
    EXPECT_TRUE(requests_.isHalted(0x81)) << "another interface's endpoint";
    EXPECT_EQ(ask({0x01, 11, 1, 1, 0}), std::nullopt);
    EXPECT_EQ(ask({0x81, 10, 0, 2, 1}), std::nullopt);
    EXPECT_EQ(ask({0x81, 0, 0, 0, 2}), (Bytes{0, 0}));
}

TEST_F(StandardRequests, OthersAreTheModelsOwnOrStall) {
    Bytes in;
    EXPECT_EQ(requests_.handle({0xC0, 1, 0, 0, 4}, in), std::nullopt);
    EXPECT_EQ(requests_.handle({0x21, 1, 0, 0, 4}, in), std::nullopt);
    EXPECT_EQ(ask({0x80, 0, 0, 0, 2}), (Bytes{0, 0}));
    EXPECT_TRUE(ask({0x00, 5, 3, 0, 0}).has_value()) << "an address is the host controller's affair";
    EXPECT_EQ(ask({0x00, 7, 0, 0, 0}), std::nullopt);
    EXPECT_EQ(ask({0x1F, 0, 0, 0, 0}), std::nullopt);
}

}  // namespace
}  // namespace kickstand
