#include "tests/contract/usb_link_contract.h"

// Opening, closing, losing and destroying a link, whatever is under way.

namespace kickstand::testing {

using Device = FakeUsbDevice;
using Bytes = std::vector<std::uint8_t>;

namespace {

UsbSetup vendorIn(std::uint8_t request, std::uint16_t length) {
    return {0xC0, request, 0, 0, length};
}

}  // namespace

TEST_P(UsbLinkContract, OpenTellsWhatTheDeviceIs) {
    const UsbDeviceInfo info = open();
    EXPECT_EQ(info.vendor, Device::kVendor);
    EXPECT_EQ(info.product, Device::kProduct);
    EXPECT_EQ(info.release, 0x0123);
    EXPECT_EQ(info.manufacturer, "Bench works");
    EXPECT_EQ(info.productName, "Fake device");
    EXPECT_EQ(info.port, rig_->port());
}

TEST_P(UsbLinkContract, OpenStartsTheDeviceAfresh) {
    rig_->onDevice([](Device& device) { device.offer(Device::kFastIn, {0xEE}); });
    open();
    rig_->onDevice([](Device& device) {
        ASSERT_GE(device.configurations().size(), 2U);
        EXPECT_EQ(device.configurations()[device.configurations().size() - 2], 0);
        EXPECT_EQ(device.configurations().back(), 1);
        device.offer(Device::kFastIn, {0x01});
    });
    EXPECT_EQ(finished(in(Device::kFastIn, 64)).data, Bytes{0x01}) << "an earlier program's packet survived";
}

TEST_P(UsbLinkContract, OpenWithoutDeviceSaysSo) {
    rig_->onDevice([](Device& device) { device.unplug(); });
    makeLink();
    const auto opened = tryOpen();
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, Errc::NoDevice);
}

TEST_P(UsbLinkContract, OpeningAnOpenLinkIsRefusedAndHarmless) {
    open();
    const auto again = tryOpen();
    ASSERT_FALSE(again.has_value());
    EXPECT_EQ(again.error().code, Errc::BadArgument);
    EXPECT_EQ(finished(out(Device::kFastOut, {1})).status, UsbStatus::Completed);
}

TEST_P(UsbLinkContract, CloseDuringOpenEndsBoth) {
    std::vector<std::string> heard;
    rig_->onLink([&] {
        link_->open([&](Result<UsbDeviceInfo> opened) {
            heard.emplace_back(opened ? "opened" : name(opened.error().code));
        });
        link_->close([&] { heard.emplace_back("closed"); });
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return heard.size() == 2; }));
    EXPECT_EQ(heard, (std::vector<std::string>{"cancelled", "closed"}));
    open();
}

TEST_P(UsbLinkContract, CloseEndsEverythingOnceAndThenSaysSo) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    std::vector<int> pending{in(Device::kFastIn, 64),    in(Device::kFastIn, 64),
                             in(Device::kSlowIn, 4),     out(Device::kFastOut, {1}),
                             out(Device::kFastOut, {2}), control(vendorIn(Device::kIgnore, 4), {})};
    std::optional<std::size_t> endedBefore;
    rig_->onLink([&] { link_->close([&] { endedBefore = order_.size(); }); });
    ASSERT_TRUE(rig_->waitUntil([&] { return endedBefore.has_value(); }));
    EXPECT_EQ(endedBefore, pending.size()) << "done came before the last callback";
    rig_->settle();
    for (const int number : pending) {
        EXPECT_EQ(ending(number).calls, 1);
        EXPECT_EQ(ending(number).status, UsbStatus::Cancelled);
    }
    rig_->onLink([&] { EXPECT_TRUE(presence_.empty()) << "closing is not losing"; });
}

TEST_P(UsbLinkContract, CloseOfAClosedLinkComesBack) {
    close();
    open();
    close();
    close();
}

TEST_P(UsbLinkContract, AClosedLinkOpensAgain) {
    for (int round = 0; round < 5; ++round) {
        open();
        EXPECT_EQ(finished(out(Device::kFastOut, {static_cast<std::uint8_t>(round)})).status,
                  UsbStatus::Completed);
        close();
    }
    EXPECT_EQ(received().size(), 5U);
}

TEST_P(UsbLinkContract, UnplugEndsEverythingWithNoDeviceAndThenSaysSo) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    std::vector<int> pending{in(Device::kFastIn, 64), in(Device::kSlowIn, 4), out(Device::kFastOut, {1}),
                             out(Device::kFastOut, {2}), control(vendorIn(Device::kIgnore, 4), {})};
    std::optional<std::size_t> endedBefore;
    rig_->onLink([&] {
        link_->setPresenceListener([&](bool present) {
            presence_.push_back(present);
            endedBefore = order_.size();
        });
    });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->settle();
    EXPECT_EQ(endedBefore, pending.size()) << "told before the last callback";
    for (const int number : pending) {
        EXPECT_EQ(ending(number).calls, 1);
        EXPECT_EQ(ending(number).status, UsbStatus::NoDevice);
    }
    rig_->onLink([&] {
        EXPECT_EQ(presence_, std::vector<bool>{false});
        EXPECT_EQ(link_->submitOut(Device::kFastOut, {}, {}).error().code, Errc::NotConnected);
    });
    EXPECT_FALSE(tryOpen().has_value());
}

TEST_P(UsbLinkContract, UnplugWithNothingPendingIsNoticed) {
    open();
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink([&] { EXPECT_EQ(presence_, std::vector<bool>{false}); });
}

TEST_P(UsbLinkContract, AReplugIsToldAndTheLinkOpensAgain) {
    open();
    for (std::size_t round = 0; round < 3; ++round) {
        const int waiting = in(Device::kFastIn, 64);
        rig_->onDevice([](Device& device) { device.unplug(); });
        ASSERT_TRUE(waitForPresence(2 * round + 1));
        EXPECT_EQ(ending(waiting).status, UsbStatus::NoDevice);
        rig_->onDevice([](Device& device) { device.plug(); });
        ASSERT_TRUE(waitForPresence(2 * round + 2));
        open();
        EXPECT_EQ(finished(out(Device::kFastOut, {1})).status, UsbStatus::Completed);
    }
    rig_->onLink([&] { EXPECT_EQ(presence_, (std::vector<bool>{false, true, false, true, false, true})); });
}

TEST_P(UsbLinkContract, ADeviceThatAppearsIsToldBeforeTheFirstOpen) {
    rig_->onDevice([](Device& device) { device.unplug(); });
    makeLink();
    EXPECT_FALSE(tryOpen().has_value());
    rig_->onDevice([](Device& device) { device.plug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink(
        [&] { EXPECT_EQ(presence_, std::vector<bool>{true}) << "a link that is not open loses nothing"; });
    open();
}

TEST_P(UsbLinkContract, UnplugDuringOpenEndsIt) {
    // Opened once before, so that now nothing but the opening is under way.
    open();
    close();
    std::optional<bool> opened;
    rig_->onLink(
        [&] { link_->open([&](const Result<UsbDeviceInfo>& result) { opened = result.has_value(); }); });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(rig_->waitUntil([&] { return opened.has_value(); }));
    if (*opened) {
        ASSERT_TRUE(waitForPresence(1));
    }
    rig_->onDevice([](Device& device) { device.plug(); });
    ASSERT_TRUE(rig_->waitUntil([&] { return !presence_.empty() && presence_.back(); }));
    open();
}

TEST_P(UsbLinkContract, DestroyWithTransfersPendingSilencesThem) {
    open();
    rig_->onDevice([](Device& device) { device.setBusy(true); });
    const std::vector<int> pending{in(Device::kFastIn, 64), out(Device::kFastOut, {1}),
                                   control(vendorIn(Device::kIgnore, 4), {})};
    destroy();
    rig_->onDevice([](Device& device) { device.setBusy(false); });
    rig_->settle();
    for (const int number : pending)
        EXPECT_EQ(ending(number).calls, 0);
}

TEST_P(UsbLinkContract, DestroyDuringOpenIsSilent) {
    bool called = false;
    rig_->onLink([&] {
        link_->open([&](const Result<UsbDeviceInfo>&) { called = true; });
        link_.reset();
    });
    rig_->settle();
    rig_->onLink([&] { EXPECT_FALSE(called); });
}

TEST_P(UsbLinkContract, DestroyDuringCloseIsSilent) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    bool closed = false;
    rig_->onLink([&] {
        link_->close([&] { closed = true; });
        link_.reset();
    });
    rig_->settle();
    rig_->onLink([&] { EXPECT_FALSE(closed); });
    EXPECT_EQ(ending(waiting).calls, 0);
}

TEST_P(UsbLinkContract, DestroyWhileTheDeviceVanishesIsSilent) {
    open();
    const int waiting = in(Device::kFastIn, 64);
    rig_->onDevice([](Device& device) { device.unplug(); });
    destroy();
    rig_->settle();
    EXPECT_LE(ending(waiting).calls, 1);
}

TEST_P(UsbLinkContract, ACallbackMayDestroyTheLink) {
    open();
    const int other = in(Device::kSlowIn, 4);
    bool called = false;
    rig_->onLink([&] {
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1}, [&](const UsbCompletion&) {
            link_.reset();
            called = true;
        }));
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return called; }));
    rig_->settle();
    EXPECT_EQ(ending(other).calls, 0);
}

TEST_P(UsbLinkContract, ThePresenceListenerMayDestroyTheLink) {
    open();
    rig_->onLink([&] {
        link_->setPresenceListener([&](bool present) {
            link_.reset();
            presence_.push_back(present);
        });
    });
    rig_->onDevice([](Device& device) { device.unplug(); });
    ASSERT_TRUE(waitForPresence(1));
    rig_->settle();
}

TEST_P(UsbLinkContract, ACallbackMayClose) {
    open();
    bool closed = false;
    const int waiting = in(Device::kFastIn, 64);
    rig_->onLink([&] {
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1},
                                     [&](const UsbCompletion&) { link_->close([&] { closed = true; }); }));
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return closed; }));
    EXPECT_EQ(ending(waiting).status, UsbStatus::Cancelled);
}

}  // namespace kickstand::testing
