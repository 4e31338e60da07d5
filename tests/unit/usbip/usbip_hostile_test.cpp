#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "core/usbip/usbip_connection.h"
#include "tests/support/usb/fake_usb_device.h"
#include "tests/unit/usbip/usbip_rig.h"

// What a client that does not keep to the protocol comes to: its own connection's end, and nobody else's.

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;
using Device = FakeUsbDevice;
using Status = usbip::TransferStatus;

class HostileUsbip : public ::testing::Test {
  protected:
    RawClient& host(UsbipRig& rig) {
        RawClient& client = rig.connectAndImport("1-1");
        EXPECT_EQ(rig.await(client, client.controlOut({0x00, 9, 1, 0, 0})).reply.status, Status::Ok);
        return client;
    }
    /// Whether the server has ended this connection, and a good client is served after it.
    void expectCutOff(UsbipRig& rig, const RawClient& client, const std::string& why) {
        rig.advance(0ms);
        EXPECT_TRUE(client.closed()) << why;
        EXPECT_EQ(rig.connections(), 0U);
        EXPECT_NE(rig.log().back().find("was cut off: " + why), std::string::npos) << rig.log().back();
        RawClient& good = host(rig);
        EXPECT_EQ(rig.await(good, good.out(Device::kFastOut, {1})).reply.status, Status::Ok);
    }

    Device device_;
    std::vector<UsbipExport> exports_{{"1-1", &device_}};
};

struct Malformed {
    const char* name;
    bool imported;  ///< Sent after an import, by a host that has configured the device.
    const char* why;
    std::function<void(Bytes&)> damage;  ///< Of a good message.
};

void PrintTo(const Malformed& malformed, std::ostream* out) {
    *out << malformed.name;
}

std::string nameOf(const ::testing::TestParamInfo<Malformed>& parameter) {
    std::string name = parameter.param.name;
    std::ranges::replace(name, ' ', '_');
    return name;
}

class MalformedUsbip : public HostileUsbip, public ::testing::WithParamInterface<Malformed> {};

TEST_P(MalformedUsbip, EndsTheConnectionWithItsReason) {
    UsbipRig rig(exports_);
    RawClient& client = GetParam().imported ? host(rig) : rig.connect();
    usbip::Command command;
    command.sequence = 100;
    command.device = client.device().id();
    command.endpoint = Device::kFastOut;
    command.length = 2;
    const Bytes data{1, 2};
    command.data = data;
    Bytes message = GetParam().imported ? usbip::encodeCommand(command)
                                        : usbip::encodeRequest({usbip::Request::Kind::Import, "1-1"});
    GetParam().damage(message);
    client.send(message);
    expectCutOff(rig, client, GetParam().why);
    EXPECT_EQ(rig.report().malformed, 1U);
    EXPECT_EQ(rig.report().overrun, 0U);
    EXPECT_EQ(device_.received().size(), 1U) << "only the good client's packet";
}

INSTANTIATE_TEST_SUITE_P(
    Messages, MalformedUsbip,
    ::testing::Values(
        Malformed{"version", false, "not USB/IP 1.1.1", [](Bytes& bytes) { bytes[1] = 0x06; }},
        Malformed{"request", false, "neither a request", [](Bytes& bytes) { bytes[3] = 0x77; }},
        Malformed{"a reply as a request", false, "neither a request", [](Bytes& bytes) { bytes[2] = 0; }},
        Malformed{"a web browser", false, "not USB/IP 1.1.1",
                  [](Bytes& bytes) {
                      bytes.assign({'G', 'E', 'T', ' ', '/', ' ', 'H', 'T', 'T', 'P'});
                  }},
        Malformed{"command", true, "neither a submit nor an unlink", [](Bytes& bytes) { bytes[3] = 3; }},
        Malformed{"a request after the import", true, "neither a submit nor an unlink",
                  [](Bytes& bytes) {
                      bytes = usbip::encodeRequest({});
                      bytes.resize(48);
                  }},
        Malformed{"direction", true, "a direction", [](Bytes& bytes) { bytes[15] = 2; }},
        Malformed{"endpoint", true, "an endpoint above 15", [](Bytes& bytes) { bytes[19] = 16; }},
        Malformed{"length", true, "a transfer longer", [](Bytes& bytes) { bytes[24] = 0x7F; }},
        Malformed{"negative length", true, "a transfer longer", [](Bytes& bytes) { bytes[24] = 0xFF; }},
        Malformed{"isochronous", true, "an isochronous transfer",
                  [](Bytes& bytes) { storeBe32(bytes, 32, 4); }},
        Malformed{"another device", true, "a command for another device",
                  [](Bytes& bytes) { bytes[11] ^= 1; }},
        Malformed{"a sequence number twice", true, "a sequence number that is in use",
                  [](Bytes& bytes) {
                      const Bytes once = bytes;
                      bytes.insert(bytes.end(), once.begin(), once.end());
                      bytes[19] = 7;  // The first waits at another endpoint.
                  }}),
    nameOf);

TEST_F(HostileUsbip, ATruncatedMessageWaitsForItsRest) {
    UsbipRig rig(exports_);
    RawClient& client = host(rig);
    usbip::Command command;
    command.sequence = 77;
    command.device = client.device().id();
    command.endpoint = Device::kFastOut;
    command.length = 2;
    const Bytes data{1, 2};
    command.data = data;
    for (const std::uint8_t byte : usbip::encodeCommand(command)) {
        EXPECT_TRUE(device_.received().empty());
        client.send(Bytes{byte});
        rig.advance(2ms);
    }
    EXPECT_EQ(device_.received(), (std::vector<Device::Packet>{{Device::kFastOut, data}}));
}

TEST_F(HostileUsbip, AClientThatSaysNothingIsCutOff) {
    UsbipRig rig(exports_, {.silence = 10s});
    RawClient& client = rig.connect();
    client.send(Bytes{0x01});
    rig.advance(9999ms);
    EXPECT_FALSE(client.closed());
    rig.advance(1ms);
    expectCutOff(rig, client, "it said nothing");
    EXPECT_EQ(rig.report().overrun, 1U);
}

TEST_F(HostileUsbip, AHostMayBeSilentForever) {
    UsbipRig rig(exports_);
    RawClient& client = host(rig);
    rig.advance(24h);
    EXPECT_FALSE(client.closed());
}

TEST_F(HostileUsbip, TooManyTransfersAtOnceAreCutOff) {
    UsbipRig rig(exports_, {.transfers = 20});
    RawClient& client = host(rig);
    for (int i = 0; i < 20; ++i)
        client.in(Device::kFastIn, 64);
    rig.advance(1s);
    EXPECT_FALSE(client.closed());
    client.in(Device::kFastIn, 64);
    expectCutOff(rig, client, "it asked for too much at once");
    EXPECT_EQ(rig.report().overrun, 1U);
    EXPECT_EQ(rig.report().malformed, 0U);
}

TEST_F(HostileUsbip, AClientThatDoesNotReadIsCutOff) {
    UsbipRig rig(exports_, {.unsentBytes = 4096});
    RawClient& client = rig.connect(false);
    client.import("1-1");
    rig.advance(0ms);
    // What it imported it cannot know without reading; the first device of a bus is number 2.
    usbip::Command command;
    command.kind = usbip::Command::Kind::Unlink;
    command.device = 1U << 16 | 2U;
    const Bytes unlink = usbip::encodeCommand(command);
    for (int i = 0; i < 1000; ++i)
        client.send(unlink);
    rig.advance(1s);
    EXPECT_EQ(rig.report().overrun, 1U);
    EXPECT_EQ(rig.log().back(), "client 1 was cut off: it does not read its answers");
    EXPECT_EQ(rig.connections(), 0U);
    EXPECT_FALSE(rig.inUse());
}

TEST_F(HostileUsbip, AFloodOfUnlinksIsAnsweredAndHarmless) {
    UsbipRig rig(exports_);
    RawClient& client = host(rig);
    for (int i = 0; i < 5000; ++i)
        client.unlink(static_cast<std::uint32_t>(i * 7919));
    rig.advance(1s);
    EXPECT_EQ(client.answers().size(), 5001U);
    EXPECT_FALSE(client.closed());
}

TEST_F(HostileUsbip, AClientMayGoAtAnyByte) {
    UsbipRig rig(exports_);
    const Bytes request = usbip::encodeRequest({usbip::Request::Kind::Import, "1-1"});
    for (std::size_t length = 0; length <= request.size(); ++length) {
        RawClient& client = rig.connect();
        client.send(ByteView(request).first(length));
        rig.advance(0ms);
        client.close();
        rig.advance(0ms);
        EXPECT_EQ(rig.connections(), 0U) << length;
        EXPECT_EQ(rig.scheduler().pending(), 0U) << length;
    }
    EXPECT_EQ(rig.report().malformed, 0U);
    EXPECT_FALSE(rig.inUse());
}

/// Damages good commands at random, or makes bytes up.
Bytes anything(std::mt19937& random, const RawClient& client) {
    Bytes bytes(random() % 200);
    if (random() % 8 == 0) {
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        return bytes;
    }
    usbip::Command command;
    command.kind = random() % 4 == 0 ? usbip::Command::Kind::Unlink : usbip::Command::Kind::Submit;
    command.sequence = random() % 64;
    command.device = client.device().id();
    const Bytes endpoints{0x00, 0x80, 0x05, 0x85, 0x81, 0x83, 0x07, 0x0A, 0x8F};
    command.endpoint = endpoints[random() % endpoints.size()];
    command.length = static_cast<std::uint32_t>(bytes.size());
    command.unlink = random() % 64;
    command.flags = static_cast<std::uint32_t>(random());
    command.setup = {static_cast<std::uint8_t>(random() % 4 == 0 ? 0xC0 : random()),
                     static_cast<std::uint8_t>(random() % 16), static_cast<std::uint16_t>(random() % 4),
                     static_cast<std::uint16_t>(random() % 256), static_cast<std::uint16_t>(random() % 200)};
    if (!isInEndpoint(command.endpoint)) command.data = bytes;
    if (command.kind == usbip::Command::Kind::Unlink) command.data = {};
    Bytes message = usbip::encodeCommand(command);
    if (random() % 16 == 0)
        message[random() % message.size()] ^= static_cast<std::uint8_t>(1U << random() % 8);
    return message;
}

TEST_F(HostileUsbip, NoBytesDoHarm) {
    UsbipRig rig(exports_);
    std::mt19937 random(20110217);
    std::uint64_t cutOff = 0;
    for (int round = 0; round < 400; ++round) {
        RawClient& client = rig.connectAndImport("1-1");
        for (int i = 0; i < 60 && !client.closed(); ++i) {
            client.send(anything(random, client));
            if (random() % 4 == 0) device_.offer(Device::kFastIn, {1, 2, 3});
            rig.advance(random() % 3 * 1ms);
        }
        rig.advance(0ms);
        if (client.closed()) ++cutOff;
        client.close();
        rig.advance(0ms);
        ASSERT_EQ(rig.connections(), 0U) << "round " << round;
        ASSERT_EQ(rig.scheduler().pending(), 0U) << "round " << round;
    }
    EXPECT_EQ(rig.report().malformed + rig.report().overrun, cutOff);
    EXPECT_GT(rig.report().transfers, 1000U) << "damaged so much that nothing was done";
    EXPECT_GT(cutOff, 100U) << "hardly damaged";
    RawClient& good = host(rig);
    EXPECT_EQ(rig.await(good, good.controlOut({0x40, Device::kStore, 0, 0, 1}, {1})).reply.status,
              Status::Ok);
}

}  // namespace
}  // namespace kickstand::testing
