#include "core/link/usbip/usb_descriptor_reader.h"

#include <gtest/gtest.h>

#include "core/link/usb_descriptors.h"
#include "tests/support/usb/fake_usb_device.h"

namespace kickstand {
namespace {

using Bytes = std::vector<std::uint8_t>;

const UsbDescriptors& descriptors() {
    static const testing::FakeUsbDevice device;
    return device.descriptors();
}

/// A configuration around these descriptors.
Bytes configuration(const std::vector<Bytes>& parts) {
    Bytes bytes{9, 2, 0, 0, 1, 1, 0, 0x80, 50};
    for (const Bytes& part : parts)
        bytes.insert(bytes.end(), part.begin(), part.end());
    storeLe16(bytes, 2, static_cast<std::uint16_t>(bytes.size()));
    return bytes;
}

const Bytes kInterface0{9, 4, 0, 0, 1, 0xFF, 0, 0, 0};
const Bytes kInterface1{9, 4, 1, 0, 1, 0xFF, 0, 0, 0};
const Bytes kAlternate1{9, 4, 1, 1, 1, 0xFF, 0, 0, 0};
const Bytes kIn1{7, 5, 0x81, 3, 0x40, 0x18, 25};
const Bytes kOut2{7, 5, 0x02, 2, 0x40, 0, 0};

TEST(UsbDescriptorReader, ReadsWhatTheBuilderBuilt) {
    const auto device = readDeviceDescriptor(descriptors().device);
    ASSERT_TRUE(device);
    EXPECT_EQ(device->vendor, testing::FakeUsbDevice::kVendor);
    EXPECT_EQ(device->product, testing::FakeUsbDevice::kProduct);
    EXPECT_EQ(device->release, 0x0123);
    EXPECT_EQ(device->manufacturer, 1);
    EXPECT_EQ(device->productName, 2);
    const auto read = readConfigurationDescriptor(descriptors().configuration);
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read->interfaces, (Bytes{0, 1}));
    ASSERT_EQ(read->endpoints.size(), descriptors().endpoints.size());
    for (std::size_t i = 0; i < read->endpoints.size(); ++i) {
        const UsbEndpointInfo& expected = descriptors().endpoints[i];
        EXPECT_EQ(read->endpoints[i].address, expected.address);
        EXPECT_EQ(read->endpoints[i].type, expected.type);
        EXPECT_EQ(read->endpoints[i].packetSize, expected.packetSize);
        EXPECT_EQ(read->endpoints[i].interval_ms, expected.interval_ms);
        EXPECT_EQ(read->endpoints[i].interface, expected.interface);
    }
}

TEST(UsbDescriptorReader, TakesFirstSettingsAndSkipsWhatItDoesNotKnow) {
    const auto read = readConfigurationDescriptor(
        configuration({kInterface0, {4, 0x21, 1, 2}, kIn1, kInterface1, kOut2, kAlternate1, kIn1}));
    ASSERT_TRUE(read) << read.error().detail;
    EXPECT_EQ(read->interfaces, (Bytes{0, 1}));
    ASSERT_EQ(read->endpoints.size(), 2U);
    EXPECT_EQ(read->endpoints[0].packetSize, 64) << "the bits above the size are none of it";
    EXPECT_EQ(read->endpoints[1].interface, 1);
}

TEST(UsbDescriptorReader, DamagedConfigurationsAreRefused) {
    const struct {
        Bytes bytes;
        const char* why;
    } cases[] = {
        {{}, "not a configuration descriptor"},
        {{9, 1, 9, 0, 1, 1, 0, 0x80, 50}, "not a configuration descriptor"},
        {{8, 2, 9, 0, 1, 1, 0, 0x80, 50}, "not a configuration descriptor"},
        {{9, 2, 8, 0, 1, 1, 0, 0x80, 50}, "a configuration of an impossible length"},
        {{9, 2, 0xFF, 0xFF, 1, 1, 0, 0x80, 50}, "a configuration of an impossible length"},
        {{9, 2, 10, 0, 1, 1, 0, 0x80, 50}, "a configuration cut short"},
        {configuration({{0, 4}}), "a descriptor longer than what holds it"},
        {configuration({{1}}), "a descriptor longer than what holds it"},
        {configuration({{10, 4, 0, 0, 1, 0xFF, 0, 0, 0}}), "a descriptor longer than what holds it"},
        {configuration({{8, 4, 0, 0, 1, 0xFF, 0, 0}}), "an interface descriptor too short"},
        {configuration({kInterface0, kInterface0}), "an interface twice"},
        {configuration({kInterface0, {6, 5, 0x81, 3, 64, 0}}), "an endpoint descriptor too short"},
        {configuration({kInterface0, kIn1, kInterface1, kIn1}), "an endpoint twice"},
        {configuration({kInterface0, {7, 5, 0x80, 3, 64, 0, 1}}), "an endpoint that no device can have"},
        {configuration({kInterface0, {7, 5, 0x91, 3, 64, 0, 1}}), "an endpoint that no device can have"},
    };
    for (const auto& one : cases) {
        const auto read = readConfigurationDescriptor(one.bytes);
        ASSERT_FALSE(read) << one.why;
        EXPECT_EQ(read.error().code, Errc::Malformed);
        EXPECT_EQ(read.error().detail, one.why);
    }
}

TEST(UsbDescriptorReader, DamagedDeviceDescriptorsAreRefused) {
    const Bytes good = descriptors().device;
    for (std::size_t size = 0; size < good.size(); ++size)
        EXPECT_FALSE(readDeviceDescriptor(ByteView(good).first(size))) << size;
    Bytes wrong = good;
    wrong[1] = 2;
    EXPECT_FALSE(readDeviceDescriptor(wrong));
}

TEST(UsbDescriptorReader, StringsBecomeUtf8) {
    EXPECT_EQ(readStringDescriptor(Bytes{6, 3, 'O', 0, 'K', 0}), "OK");
    EXPECT_EQ(readStringDescriptor(Bytes{10, 3, 0xE9, 0, 0xAC, 0x20, 0x3D, 0xD8, 0x00, 0xDE}),
              "\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
    EXPECT_EQ(readStringDescriptor(Bytes{6, 3, 0x3D, 0xD8, 'x', 0}), "\xEF\xBF\xBDx") << "half a pair";
    EXPECT_EQ(readStringDescriptor(Bytes{8, 3, 0x1B, 0, 'x', 0, 0x9B, 0}), "x") << "no control characters";
    EXPECT_EQ(readStringDescriptor(Bytes{200, 3, 'a', 0}), "a") << "never past the end";
    EXPECT_EQ(readStringDescriptor(Bytes{5, 3, 'a', 0, 'b'}), "a");
    EXPECT_EQ(readStringDescriptor(Bytes{4, 2, 'a', 0}), "");
    EXPECT_EQ(readStringDescriptor({}), "");
}

TEST(UsbDescriptorReader, LanguagesHaveADefault) {
    EXPECT_EQ(readFirstLanguage(Bytes{6, 3, 0x07, 0x04, 0x09, 0x04}), 0x0407);
    EXPECT_EQ(readFirstLanguage({}), 0x0409);
    EXPECT_EQ(readFirstLanguage(Bytes{2, 3}), 0x0409);
}

}  // namespace
}  // namespace kickstand
