#include <optional>
#include <random>

#include <gtest/gtest.h>

#include "core/link/usb/usb_probe.h"
#include "tests/contract/libusb_rig.h"

namespace kickstand::testing {
namespace {

using Device = FakeUsbDevice;
using Opened = std::optional<Result<UsbDeviceInfo>>;

/// What only a link to a real bus can meet: other devices, other programs, other users.
class LibusbLinkTest : public ::testing::Test {
  protected:
    ~LibusbLinkTest() override {
        rig_.onLink([this] {
            link_.reset();
            other_.reset();
        });
    }

    Result<UsbDeviceInfo> open(std::unique_ptr<UsbLink>& link, const UsbMatch& match) {
        const auto opened = std::make_shared<Opened>();
        rig_.onLink([&] {
            link.reset();
            link = rig_.makeLink(match);
            link->open([opened](Result<UsbDeviceInfo> result) { *opened = std::move(result); });
        });
        if (!rig_.waitUntil([&] { return opened->has_value(); })) return fail(Errc::TimedOut, "watchdog");
        return **opened;
    }
    Result<UsbDeviceInfo> open(const UsbMatch& match) { return open(link_, match); }

    static UsbMatch at(const std::string& port) {
        UsbMatch match = LibusbRig::match();
        match.port = port;
        return match;
    }

    void submitIns(int& ended) {
        for (int i = 0; i < 3; ++i)
            static_cast<void>(link_->submitIn(Device::kFastIn, 64, [&](const UsbCompletion&) { ++ended; }));
    }
    /// Destroys the link while `calls` counts what it still says.
    void destroyAndExpectSilence(const int& calls) {
        int before = 0;
        rig_.onLink([&] {
            link_.reset();
            before = calls;
        });
        rig_.settle();
        rig_.onLink([&] { EXPECT_EQ(calls, before) << "called back after its end"; });
    }

    FakeUsbDevice second_;
    LibusbRig rig_;
    std::unique_ptr<UsbLink> link_;
    std::unique_ptr<UsbLink> other_;
};

TEST_F(LibusbLinkTest, SeveralDevicesAreNamedByTheirPorts) {
    rig_.bus().connect(second_, "1-2.3");
    const auto opened = open(LibusbRig::match());
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::SeveralDevices);
    EXPECT_NE(opened.error().detail.find("1-1"), std::string::npos) << opened.error().detail;
    EXPECT_NE(opened.error().detail.find("1-2.3"), std::string::npos) << opened.error().detail;
}

TEST_F(LibusbLinkTest, APortChoosesAmongSeveralDevices) {
    rig_.bus().connect(second_, "1-3");
    const auto opened = open(at("1-3"));
    ASSERT_TRUE(opened.has_value()) << opened.error().detail;
    EXPECT_EQ(opened->port, "1-3");
    const auto nowhere = open(at("1-4"));
    ASSERT_FALSE(nowhere.has_value());
    EXPECT_EQ(nowhere.error().code, Errc::NoDevice);
}

TEST_F(LibusbLinkTest, AnotherProductIsNotTheDevice) {
    UsbMatch match = LibusbRig::match();
    match.product = 0x7777;
    const auto opened = open(match);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::NoDevice);
}

TEST_F(LibusbLinkTest, MissingPermissionIsSaid) {
    rig_.bus().connect(second_, "1-5", UmockdevBus::Permission::Denied);
    const auto opened = open(at("1-5"));
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::PermissionDenied);
    EXPECT_EQ(opened.error().subject, "1-5");
}

TEST_F(LibusbLinkTest, ADeviceThatAnotherHoldsIsLeftAlone) {
    ASSERT_TRUE(open(other_, LibusbRig::match()));
    std::size_t configurations = 0;
    rig_.onDevice([&](Device& device) { configurations = device.configurations().size(); });
    const auto opened = open(LibusbRig::match());
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::ClaimedElsewhere);
    rig_.onDevice([&](Device& device) { EXPECT_EQ(device.configurations().size(), configurations); });
    rig_.onLink([&] { other_.reset(); });
    EXPECT_TRUE(open(LibusbRig::match())) << "its release was not noticed";
}

TEST_F(LibusbLinkTest, AnInterfaceThatIsNotThereIsAnError) {
    UsbMatch match = LibusbRig::match();
    match.interfaces = {0, 7};
    const auto opened = open(match);
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::Io);
    EXPECT_TRUE(open(LibusbRig::match())) << "the interfaces that could be claimed were kept";
}

TEST_F(LibusbLinkTest, EndpointsOfInterfacesThatAreNotClaimedAreNotThere) {
    UsbMatch match = LibusbRig::match();
    match.interfaces = {1};
    ASSERT_TRUE(open(match));
    rig_.onLink([&] {
        const auto submitted = link_->submitIn(Device::kSlowIn, 4, {});
        ASSERT_FALSE(submitted);
        EXPECT_EQ(submitted.error().code, Errc::BadArgument);
    });
}

TEST_F(LibusbLinkTest, OnlyTheDeviceAtThePortIsTold) {
    ASSERT_TRUE(open(at("1-1")));
    std::vector<bool> presence;
    rig_.onLink([&] { link_->setPresenceListener([&](bool present) { presence.push_back(present); }); });
    rig_.bus().connect(second_, "1-6");
    rig_.bus().disconnect("1-6");
    rig_.onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(rig_.waitUntil([&] { return !presence.empty(); }));
    rig_.onLink([&] { EXPECT_EQ(presence, std::vector<bool>{false}); });
}

TEST_F(LibusbLinkTest, TheProbeTellsWhatStandsInTheWay) {
    rig_.bus().connect(second_, "1-5", UmockdevBus::Permission::Denied);
    auto probed = probeUsbDevices(LibusbRig::match());
    ASSERT_TRUE(probed);
    ASSERT_EQ(probed->size(), 2U);
    EXPECT_EQ(probed->at(0).info.port, "1-1");
    EXPECT_EQ(probed->at(0).info.productName, "Fake device");
    EXPECT_TRUE(probed->at(0).permitted);
    EXPECT_FALSE(probed->at(0).claimedElsewhere);
    EXPECT_EQ(probed->at(1).info.port, "1-5");
    EXPECT_EQ(probed->at(1).info.product, Device::kProduct);
    EXPECT_EQ(probed->at(1).info.productName, "");
    EXPECT_FALSE(probed->at(1).permitted);
    EXPECT_FALSE(probed->at(1).claimedElsewhere);
}

TEST_F(LibusbLinkTest, TheProbeDoesNotDisturbADeviceInUse) {
    ASSERT_TRUE(open(LibusbRig::match()));
    int ended = 0;
    rig_.onLink(
        [&] { ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, [&](const UsbCompletion&) { ++ended; })); });
    const auto probed = probeUsbDevices(LibusbRig::match());
    ASSERT_TRUE(probed);
    ASSERT_EQ(probed->size(), 1U);
    EXPECT_TRUE(probed->front().permitted);
    EXPECT_TRUE(probed->front().claimedElsewhere);
    rig_.onLink([&] { EXPECT_EQ(ended, 0); });
    rig_.onDevice([](Device& device) { device.offer(Device::kFastIn, {1}); });
    EXPECT_TRUE(rig_.waitUntil([&] { return ended == 1; }));
}

TEST_F(LibusbLinkTest, AProbeLeavesTheDeviceFree) {
    ASSERT_TRUE(probeUsbDevices(LibusbRig::match()));
    EXPECT_TRUE(open(LibusbRig::match()));
}

TEST_F(LibusbLinkTest, TheListNamesEveryDevice) {
    rig_.bus().connect(second_, "1-2");
    const auto listed = listUsbDevices(LibusbRig::match());
    ASSERT_TRUE(listed);
    ASSERT_EQ(listed->size(), 2U);
    EXPECT_EQ(listed->at(0).port, "1-1");
    EXPECT_EQ(listed->at(1).port, "1-2");
    EXPECT_EQ(listed->at(0).manufacturer, "Bench works");
    UsbMatch nothing = LibusbRig::match();
    nothing.vendor = 0x7777;
    EXPECT_TRUE(listUsbDevices(nothing)->empty());
}

TEST_F(LibusbLinkTest, PullingThePlugAtAnyMomentEndsEachTransferOnce) {
    constexpr int kRounds = 30;
    std::mt19937 random(1);
    std::vector<bool> presence;
    for (int round = 0; round < kRounds; ++round) {
        ASSERT_TRUE(open(LibusbRig::match()));
        presence.clear();
        int submitted = 0;
        int ended = 0;
        std::function<void()> send = [&] {
            const auto id =
                link_->submitOut(Device::kFastOut, std::vector<std::uint8_t>{1}, [&](const UsbCompletion&) {
                    ++ended;
                    send();
                });
            submitted += id ? 1 : 0;
        };
        rig_.onLink([&] {
            link_->setPresenceListener([&](bool present) { presence.push_back(present); });
            ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, [&](const UsbCompletion&) { ++ended; }));
            ++submitted;
            send();
        });
        const int packets = static_cast<int>(random() % 8);
        ASSERT_TRUE(rig_.waitUntil([&] { return ended >= packets; }));
        rig_.onDevice([](Device& device) { device.unplug(); });
        ASSERT_TRUE(rig_.waitUntil([&] { return !presence.empty(); }));
        rig_.onLink([&] {
            EXPECT_FALSE(presence.front());
            EXPECT_EQ(ended, submitted);
        });
        rig_.onDevice([](Device& device) { device.plug(); });
        ASSERT_TRUE(rig_.waitUntil([&] { return presence.size() == 2; }));
    }
}

TEST_F(LibusbLinkTest, ALinkMayGoAtAnyMoment) {
    constexpr int kRounds = 30;
    std::mt19937 random(2);
    for (int round = 0; round < kRounds; ++round) {
        int posts = 0;
        rig_.onLink([&] {
            link_ = rig_.makeLink(LibusbRig::match());
            link_->open([&](const Result<UsbDeviceInfo>& opened) {
                ++posts;
                if (!opened) return;
                submitIns(posts);
                if (random() % 2 == 0) link_->close([&] { ++posts; });
            });
        });
        const auto moment = static_cast<int>(random() % 3);
        ASSERT_TRUE(rig_.waitUntil([&] { return posts >= moment - 1; }));
        destroyAndExpectSilence(posts);
    }
    EXPECT_TRUE(open(LibusbRig::match()));
}

// libusb 1.0.26 forgets a device that goes just while a context starts, so every round begins with a link
// that is open.
TEST_F(LibusbLinkTest, ALinkMayGoWhileItsDeviceGoes) {
    constexpr int kRounds = 30;
    for (int round = 0; round < kRounds; ++round) {
        ASSERT_TRUE(open(LibusbRig::match()));
        int posts = 0;
        rig_.onLink([&] {
            submitIns(posts);
            if (round % 3 == 0) return;
            link_->close([&] {
                ++posts;
                if (round % 3 == 1) link_->open([&](const Result<UsbDeviceInfo>&) { ++posts; });
            });
        });
        rig_.onDevice([](Device& device) { device.unplug(); });
        destroyAndExpectSilence(posts);
        rig_.onDevice([](Device& device) { device.plug(); });
    }
}

}  // namespace
}  // namespace kickstand::testing
