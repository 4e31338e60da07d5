#include "app/composition/composition.h"

#include <future>

#include <gtest/gtest.h>

#include "app/composition/device_finder.h"
#include "core/base/fake_scheduler.h"
#include "core/base/thread_scheduler.h"

namespace kickstand {
namespace {

Errc refusalOf(const char* text) {
    const auto uri = parseLinkUri(text);
    EXPECT_TRUE(uri) << text;
    const auto exists = checkLink(*uri);
    EXPECT_FALSE(exists) << text;
    if (exists) return Errc::Io;
    EXPECT_FALSE(exists.error().subject.empty()) << text;
    return exists.error().code;
}

TEST(Composition, TakesItsLinks) {
    for (const char* text :
         {"usb:", "usb:?port=1-2.3", "usb-cable:", "usb-cable:?port=1-2.3", "sim:thunderbots",
          "sim:thunderbots?robots=0-15&loss=0.02&seed=1&radio=ideal", "sim:thunderbots?cable=3",
          "sim:smartdevice", "sim:smartdevice?devices=PolarBear,Encoder.hibike&noise=0.01&seed=2&boot_ms=100",
          "usbip:127.0.0.1:3240/1-1", "usbip:bench.local/1-1", "usbip:[::1]:3241/2-1.4",
          "serial:", "serial:/dev/ttyACM0", "serial:/dev/ttyACM0?protocol=smartdevice&baud=115200",
          "serial:/dev/ttyUSB0?protocol=coach", "serial:COM3?protocol=motionplan&baud=9600"})
        EXPECT_TRUE(checkLink(*parseLinkUri(text))) << text;
}

TEST(Composition, RefusesEverythingElse) {
    EXPECT_EQ(refusalOf("serial:?protocol=coach"), Errc::BadUri);
    EXPECT_EQ(refusalOf("serial:/dev/ttyACM0?protocol=modem"), Errc::BadUri);
    EXPECT_EQ(refusalOf("serial:/dev/ttyACM0?protocol=coach&baud=0"), Errc::BadUri);
    EXPECT_EQ(refusalOf("serial:/dev/ttyACM0?baud=fast"), Errc::BadUri);
    EXPECT_EQ(refusalOf("serial:/dev/ttyACM0?baud=4294967295"), Errc::BadUri);
    EXPECT_EQ(refusalOf("serial:/dev/ttyACM0?speed=9600"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usbip:127.0.0.1:3240"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usbip:127.0.0.1:0/1-1"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usbip:/1-1"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usbip:127.0.0.1/1-1?port=1-1"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usb:1-2"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usb:?serial=4"), Errc::BadUri);
    EXPECT_EQ(refusalOf("usb:?port="), Errc::BadUri);
    EXPECT_EQ(refusalOf("sim:nothing"), Errc::Unsupported);
    EXPECT_EQ(refusalOf("sim:"), Errc::Unsupported);
    EXPECT_EQ(refusalOf("sim:thunderbots?robts=3"), Errc::UnknownName);
    EXPECT_EQ(refusalOf("sim:smartdevice?devices=Toaster"), Errc::UnknownName);
    EXPECT_EQ(refusalOf("sim:smartdevice?devices="), Errc::BadArgument);
    EXPECT_EQ(refusalOf("sim:smartdevice?colour=red"), Errc::UnknownName);
    EXPECT_EQ(refusalOf("sim:smartdevice?noise=2"), Errc::OutOfRange);
    EXPECT_EQ(refusalOf("sim:smartdevice?seed=x"), Errc::BadArgument);
    EXPECT_EQ(refusalOf("sim:thunderbots?loss=2"), Errc::OutOfRange);
}

TEST(Composition, NamesWhatItWouldTake) {
    EXPECT_EQ(checkLink(*parseLinkUri("tcp:host")).error().detail,
              "usb:, usb-cable:, usbip:HOST:PORT/BUSID, serial:PATH?protocol=NAME, sim:thunderbots, "
              "sim:smartdevice, sim:motionplan, sim:coach");
}

TEST(Composition, MakesASimulatedDongleThatOpens) {
    FakeScheduler scheduler;
    const auto links = makeLinkProvider();
    auto provided = links->makeUsbLink(*parseLinkUri("sim:thunderbots?robots=3"), scheduler);
    ASSERT_TRUE(provided);
    ASSERT_NE(provided->sim, nullptr);
    std::optional<UsbDeviceInfo> info;
    provided->link->open(
        [&info](const Result<UsbDeviceInfo>& opened) { info = opened.value_or(UsbDeviceInfo{}); });
    scheduler.advance(std::chrono::seconds(1));
    ASSERT_TRUE(info);
    EXPECT_EQ(info->vendor, 0x04D8);
    EXPECT_EQ(info->product, 0x7839);
    provided->link.reset();
}

TEST(Composition, MakesSimulatedBoardsWithPortsOfTheirOwn) {
    FakeScheduler scheduler;
    const auto links = makeLinkProvider();
    auto provided = links->makeBytePorts(*parseLinkUri("sim:smartdevice?devices=PolarBear,RFID"), scheduler);
    ASSERT_TRUE(provided);
    ASSERT_NE(provided->sim, nullptr);
    std::vector<BytePort> ports;
    provided->ports->watch([&ports](const std::vector<BytePort>& now) { ports = now; });
    scheduler.runPending();
    EXPECT_EQ(ports.size(), 2U);
    provided->ports.reset();
    EXPECT_FALSE(links->makeBytePorts(*parseLinkUri("sim:thunderbots"), scheduler));
    EXPECT_FALSE(links->makeByteLink(*parseLinkUri("sim:smartdevice"), scheduler));
    EXPECT_FALSE(links->makeUsbLink(*parseLinkUri("sim:smartdevice"), scheduler));
}

TEST(Composition, MakesNoLinkThatItRefuses) {
    FakeScheduler scheduler;
    EXPECT_FALSE(makeLinkProvider()->makeUsbLink(*parseLinkUri("sim:nothing"), scheduler));
    EXPECT_FALSE(makeLinkProvider()->makeUsbLink(*parseLinkUri("usb:?serial=4"), scheduler));
}

TEST(DeviceFinder, LooksOnAThreadOfItsOwnAndAnswersOnTheSchedulers) {
    ThreadScheduler scheduler;
    std::thread::id lookedOn;
    DeviceFinder finder([&lookedOn] {
        lookedOn = std::this_thread::get_id();
        FoundDevice device;
        device.info.port = "1-2";
        return FoundHardware{.devices = {device}, .ports = {}};
    });
    for (int round = 0; round < 3; ++round) {
        std::promise<FoundHardware> answer;
        bool onScheduler = false;
        finder.find(scheduler, [&](FoundHardware found) {
            onScheduler = scheduler.isCurrent();
            answer.set_value(std::move(found));
        });
        const auto devices = answer.get_future().get().devices;
        EXPECT_TRUE(onScheduler);
        EXPECT_NE(lookedOn, std::this_thread::get_id());
        ASSERT_EQ(devices.size(), 1U);
        EXPECT_EQ(devices[0].info.port, "1-2");
    }
}

TEST(DeviceFinder, EndsWithoutEverHavingLooked) {
    bool looked = false;
    {
        DeviceFinder finder([&looked] {
            looked = true;
            return FoundHardware{};
        });
    }
    EXPECT_FALSE(looked);
}

TEST(DeviceFinder, EndsWhileItLooks) {
    FakeScheduler scheduler;
    std::promise<void> looking;
    std::promise<void> mayEnd;
    int answers = 0;
    {
        DeviceFinder finder([&] {
            looking.set_value();
            mayEnd.get_future().wait();
            return FoundHardware{};
        });
        finder.find(scheduler, [&answers](const FoundHardware&) { ++answers; });
        finder.find(scheduler, [&answers](const FoundHardware&) { ++answers; });
        looking.get_future().wait();
        mayEnd.set_value();
    }
    scheduler.advance(std::chrono::seconds(1));
    EXPECT_LE(answers, 1);
}

}  // namespace
}  // namespace kickstand
