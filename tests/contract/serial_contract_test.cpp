#include <QCoreApplication>
#include <filesystem>

#include <unistd.h>

#include "core/link/pty/pty_port.h"
#include "core/link/serial/serial_byte_link.h"
#include "core/link/serial/serial_ports.h"
#include "core/link/tapped_byte_link.h"
#include "tests/contract/byte_link_contract.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

/// Qt's event loops want one, on whatever thread they run.
class Application final : public ::testing::Environment {
  public:
    void SetUp() override { application_.emplace(count_, &name_); }
    void TearDown() override { application_.reset(); }

  private:
    int count_ = 1;
    char text_[5] = "test";
    char* name_ = text_;
    std::optional<QCoreApplication> application_;
};
[[maybe_unused]] const auto* const kApplication = ::testing::AddGlobalTestEnvironment(new Application);

/// A folder of the test's own.
class Folder {
  public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "kickstand-serial-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    ~Folder() { fs::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    std::string file(const char* name) const { return (path_ / name).string(); }

  private:
    fs::path path_;
};

/// QSerialPort on one thread, and the device behind a pseudo-terminal on another.
class PtyRig : public ByteRig {
  public:
    PtyRig() {
        deviceScheduler_.run([this] {
            auto served = makePtyPort(deviceScheduler_, device_, port());
            ASSERT_TRUE(served) << served.error().detail;
            pty_ = std::move(*served);
        });
    }
    ~PtyRig() override {
        deviceScheduler_.run([this] { pty_.reset(); });
    }
    PtyRig(const PtyRig&) = delete;
    PtyRig& operator=(const PtyRig&) = delete;

    std::unique_ptr<ByteLink> makeLink() override {
        return makeSerialByteLink(linkScheduler_, port(), 115200);
    }
    std::string port() const override { return folder_.file("port"); }
    void onLink(const std::function<void()>& action) override { linkScheduler_.run(action); }
    void onDevice(const std::function<void(FakeByteDevice&)>& action) override {
        deviceScheduler_.run([&] { action(device_); });
    }
    bool waitUntil(const std::function<bool()>& done) override { return linkScheduler_.waitUntil(done); }
    bool waitForDevice(const std::function<bool(const FakeByteDevice&)>& done) override {
        return deviceScheduler_.waitUntil([&] { return done(device_); });
    }
    std::string terminal() {
        std::string name;
        deviceScheduler_.run([&] { name = pty_->terminal(); });
        return name;
    }

    Scheduler& linkScheduler() { return linkScheduler_; }

  private:
    Folder folder_;
    WatchedScheduler linkScheduler_;
    FakeByteDevice device_;
    WatchedScheduler deviceScheduler_;
    std::unique_ptr<PtyPort> pty_;
};

class TappedPtyRig final : public PtyRig {
  public:
    std::unique_ptr<ByteLink> makeLink() override {
        return std::make_unique<TappedByteLink>(PtyRig::makeLink(), linkScheduler());
    }
};

INSTANTIATE_TEST_SUITE_P(
    Serial, ByteLinkContract,
    ::testing::Values(ByteRigFactory{"serial port", [] { return std::make_unique<PtyRig>(); }},
                      ByteRigFactory{"tapped serial port", [] { return std::make_unique<TappedPtyRig>(); }}));

std::optional<Result<ByteLinkInfo>> openAndWait(PtyRig& rig, ByteLink& link) {
    std::optional<Result<ByteLinkInfo>> opened;
    rig.onLink([&] { link.open([&](Result<ByteLinkInfo> result) { opened = std::move(result); }); });
    rig.waitUntil([&] { return opened.has_value(); });
    return opened;
}

TEST(SerialByteLink, APortThatIsHeldSaysSoUnderEachOfItsNames) {
    PtyRig rig;
    std::unique_ptr<ByteLink> first;
    std::unique_ptr<ByteLink> second;
    rig.onLink([&] { first = rig.makeLink(); });
    ASSERT_TRUE(*openAndWait(rig, *first));
    for (const std::string& name : {rig.port(), rig.terminal()}) {
        rig.onLink([&] { second = makeSerialByteLink(rig.linkScheduler(), name, 115200); });
        const auto opened = openAndWait(rig, *second);
        ASSERT_TRUE(opened);
        ASSERT_FALSE(*opened) << name;
        EXPECT_EQ(opened->error().code, Errc::ClaimedElsewhere) << opened->error().detail;
        EXPECT_EQ(opened->error().port, name);
        rig.onLink([&] { second.reset(); });
    }
    rig.onLink([&] { first.reset(); });
}

TEST(SerialByteLink, AFileThatIsNoPortIsRefused) {
    Folder folder;
    WatchedScheduler scheduler;
    std::unique_ptr<ByteLink> link;
    std::optional<Result<ByteLinkInfo>> opened;
    ASSERT_TRUE(fs::create_directory(folder.file("folder")));
    scheduler.run([&] {
        link = makeSerialByteLink(scheduler, folder.file("folder"), 9600);
        link->open([&](Result<ByteLinkInfo> result) { opened = std::move(result); });
    });
    ASSERT_TRUE(scheduler.waitUntil([&] { return opened.has_value(); }));
    EXPECT_FALSE(*opened);
    scheduler.run([&] { link.reset(); });
}

TEST(SerialPorts, OneNamedPortComesAndGoes) {
    PtyRig rig;
    std::vector<std::vector<BytePort>> told;
    std::unique_ptr<BytePorts> ports;
    rig.onLink([&] {
        ports = makeSerialPorts(rig.linkScheduler(), rig.port());
        ports->watch([&](const std::vector<BytePort>& now) { told.push_back(now); });
    });
    ASSERT_TRUE(rig.waitUntil([&] { return told.size() == 1; }));
    rig.onDevice([](FakeByteDevice& device) { device.plug(false); });
    ASSERT_TRUE(rig.waitUntil([&] { return told.size() == 2; }));
    rig.onDevice([](FakeByteDevice& device) { device.plug(true); });
    ASSERT_TRUE(rig.waitUntil([&] { return told.size() == 3; }));
    rig.onLink([&] {
        ASSERT_EQ(told[0].size(), 1U);
        EXPECT_EQ(told[0][0].name, rig.port());
        EXPECT_TRUE(told[1].empty());
        EXPECT_EQ(told[2].size(), 1U);
        ports.reset();
    });
}

TEST(SerialPorts, AllPortsAreToldOnceEvenWhereThereAreNone) {
    WatchedScheduler scheduler;
    std::unique_ptr<BytePorts> ports;
    int told = 0;
    scheduler.run([&] {
        ports = makeSerialPorts(scheduler);
        ports->watch([&](const std::vector<BytePort>&) { ++told; });
    });
    EXPECT_TRUE(scheduler.waitUntil([&] { return told == 1; }));
    scheduler.run([&] { ports.reset(); });
}

TEST(PtyPort, LeavesAloneWhatIsNoLinkOfItsKind) {
    Folder folder;
    FakeByteDevice device;
    WatchedScheduler scheduler;
    ASSERT_TRUE(fs::create_directory(folder.file("taken")));
    const auto port = makePtyPort(scheduler, device, folder.file("taken"));
    ASSERT_FALSE(port);
    EXPECT_EQ(port.error().code, Errc::BadArgument);
    EXPECT_TRUE(fs::is_directory(folder.file("taken")));
    EXPECT_FALSE(makePtyPort(scheduler, device, folder.file("no/such/folder")));
}

TEST(PtyPort, TakesTheNameOfAnOldOneAndGivesItBack) {
    Folder folder;
    FakeByteDevice device;
    WatchedScheduler scheduler;
    fs::create_symlink("/dev/pts/99999", folder.file("port"));
    scheduler.run([&] {
        auto port = makePtyPort(scheduler, device, folder.file("port"));
        ASSERT_TRUE(port);
        EXPECT_EQ(fs::read_symlink(folder.file("port")), (*port)->terminal());
    });
    EXPECT_FALSE(fs::exists(fs::symlink_status(folder.file("port"))));
}

}  // namespace
}  // namespace kickstand::testing
