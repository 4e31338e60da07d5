#include <chrono>

#include "core/base/fake_scheduler.h"
#include "core/link/paced/paced_byte_link.h"
#include "core/link/tapped_byte_link.h"
#include "tests/contract/byte_link_contract.h"
#include "tests/support/usb/watched_scheduler.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using Bytes = std::vector<std::uint8_t>;

std::unique_ptr<PacedByteLink> makePaced(Scheduler& scheduler, FakeByteDevice& device) {
    return std::make_unique<PacedByteLink>(scheduler, device,
                                           PacedLineOptions{.port = "fake", .description = "Fake device"});
}

/// Everything on the test's own thread, in the time of a fake scheduler.
class PacedRig : public ByteRig {
  public:
    std::unique_ptr<ByteLink> makeLink() override { return makePaced(scheduler_, device_); }
    std::string port() const override { return "fake"; }
    void onLink(const std::function<void()>& action) override { action(); }
    void onDevice(const std::function<void(FakeByteDevice&)>& action) override { action(device_); }
    bool waitUntil(const std::function<bool()>& done) override { return scheduler_.runUntil(done, 60s); }
    bool waitForDevice(const std::function<bool(const FakeByteDevice&)>& done) override {
        return scheduler_.runUntil([&] { return done(device_); }, 60s);
    }

  protected:
    FakeScheduler scheduler_;

  private:
    FakeByteDevice device_;
};

class TappedRig final : public PacedRig {
  public:
    std::unique_ptr<ByteLink> makeLink() override {
        return std::make_unique<TappedByteLink>(PacedRig::makeLink(), scheduler_);
    }
};

/// Link and device on the thread of a real scheduler, as the engine runs them.
class ThreadedRig final : public ByteRig {
  public:
    std::unique_ptr<ByteLink> makeLink() override {
        return std::make_unique<TappedByteLink>(makePaced(scheduler_, device_), scheduler_);
    }
    std::string port() const override { return "fake"; }
    void onLink(const std::function<void()>& action) override { scheduler_.run(action); }
    void onDevice(const std::function<void(FakeByteDevice&)>& action) override {
        scheduler_.run([&] { action(device_); });
    }
    bool waitUntil(const std::function<bool()>& done) override { return scheduler_.waitUntil(done); }
    bool waitForDevice(const std::function<bool(const FakeByteDevice&)>& done) override {
        return scheduler_.waitUntil([&] { return done(device_); });
    }

  private:
    FakeByteDevice device_;
    WatchedScheduler scheduler_;
};

INSTANTIATE_TEST_SUITE_P(
    Paced, ByteLinkContract,
    ::testing::Values(ByteRigFactory{"paced", [] { return std::make_unique<PacedRig>(); }},
                      ByteRigFactory{"tapped paced", [] { return std::make_unique<TappedRig>(); }},
                      ByteRigFactory{"tapped paced on a thread",
                                     [] { return std::make_unique<ThreadedRig>(); }}));

class PacedLineTest : public ::testing::Test {
  protected:
    void open(Baud baud, ByteFaultOptions faults = {}) {
        PacedLineOptions options;
        options.baud = baud;
        options.faults = faults;
        link_ = std::make_unique<PacedByteLink>(scheduler_, device_, options);
        link_->setReceiver(
            [this](ByteView bytes) { received_.insert(received_.end(), bytes.begin(), bytes.end()); });
        link_->open([](const Result<ByteLinkInfo>& opened) { ASSERT_TRUE(opened); });
        scheduler_.runPending();
    }

    FakeScheduler scheduler_;
    FakeByteDevice device_;
    std::unique_ptr<PacedByteLink> link_;
    Bytes received_;
};

TEST_F(PacedLineTest, AByteTakesTenBitsOfTheSpeedEachWay) {
    open(9600);
    ASSERT_TRUE(link_->write(Bytes(96, 0x42)));
    scheduler_.advance(50ms);
    EXPECT_NEAR(static_cast<double>(device_.received().size()), 48, 1);
    scheduler_.advance(51ms);
    EXPECT_EQ(device_.received().size(), 96U);
    device_.send(Bytes(96, 0x42));
    scheduler_.advance(99ms);
    EXPECT_LT(received_.size(), 96U);
    scheduler_.advance(2ms);
    EXPECT_EQ(received_.size(), 96U);
}

TEST_F(PacedLineTest, CloseGivesUpAfterAFifthOfASecond) {
    open(1200);
    ASSERT_TRUE(link_->write(Bytes(1000)));
    bool closed = false;
    link_->close([&] { closed = true; });
    scheduler_.advance(199ms);
    EXPECT_FALSE(closed);
    scheduler_.advance(2ms);
    EXPECT_TRUE(closed);
    EXPECT_LT(device_.received().size(), 30U);
    EXPECT_EQ(link_->waiting(), 0U);
}

TEST_F(PacedLineTest, ADeviceThatSendsTooMuchLosesItAndTheLineGoesOn) {
    open(9600);
    for (int i = 0; i < 1000; ++i)
        device_.send(Bytes(1000, 0x11));
    scheduler_.advance(60s);
    EXPECT_GT(received_.size(), 4000U);
    EXPECT_LT(received_.size(), 6000U);
    received_.clear();
    device_.send(Bytes{9});
    scheduler_.advance(10ms);
    EXPECT_EQ(received_, Bytes{9});
}

TEST_F(PacedLineTest, FaultsLoseDamageAndInsertTheSameWayForTheSameSeed) {
    const auto passed = [](ByteFaultOptions options) {
        ByteFaults faults(options);
        return faults.pass(Bytes(10'000, 0x42));
    };
    EXPECT_EQ(passed({}), Bytes(10'000, 0x42));
    EXPECT_NEAR(static_cast<double>(passed({.lose = 0.1}).size()), 9000, 200);
    EXPECT_NEAR(static_cast<double>(passed({.insert = 0.1}).size()), 11000, 200);
    const Bytes damaged = passed({.damage = 0.1});
    EXPECT_EQ(damaged.size(), 10'000U);
    EXPECT_NEAR(static_cast<double>(std::count(damaged.begin(), damaged.end(), 0x42)), 9000, 200);
    EXPECT_EQ(passed({.lose = 0.1, .damage = 0.1, .insert = 0.1, .seed = 7}),
              passed({.lose = 0.1, .damage = 0.1, .insert = 0.1, .seed = 7}));
    EXPECT_NE(passed({.lose = 0.1, .seed = 7}), passed({.lose = 0.1, .seed = 8}));
    EXPECT_TRUE(passed({.lose = 1}).empty());
}

TEST_F(PacedLineTest, FaultsAreOnTheLineInBothDirections) {
    open(115200, {.lose = 0.5});
    ASSERT_TRUE(link_->write(Bytes(1000, 1)));
    device_.send(Bytes(1000, 1));
    scheduler_.advance(1s);
    EXPECT_NEAR(static_cast<double>(device_.received().size()), 500, 100);
    EXPECT_NEAR(static_cast<double>(received_.size()), 500, 100);
}

/// Notes what a tap shows.
class Notes final : public ByteTapObserver {
  public:
    void observe(const ByteTapRecord& record) override {
        kinds.push_back(record.kind);
        bytes.insert(bytes.end(), record.data.begin(), record.data.end());
        time = record.time;
    }
    std::vector<ByteTapRecord::Kind> kinds;
    Bytes bytes;
    TimePoint time{};
};

TEST(TappedByteLink, ShowsEverythingInOrderWithItsTime) {
    using Kind = ByteTapRecord::Kind;
    FakeScheduler scheduler;
    FakeByteDevice device;
    TappedByteLink link(makePaced(scheduler, device), scheduler);
    Notes notes;
    link.addObserver(&notes);
    EXPECT_FALSE(link.write(Bytes{9}));
    link.open([](const Result<ByteLinkInfo>&) {});
    scheduler.runPending();
    ASSERT_TRUE(link.write(Bytes{1}));
    scheduler.advance(1s);
    device.send(Bytes{2});
    scheduler.advance(1s);
    link.close({});
    scheduler.runPending();
    link.open([](const Result<ByteLinkInfo>&) {});
    scheduler.runPending();
    device.plug(false);
    scheduler.runPending();
    EXPECT_EQ(notes.kinds, (std::vector{Kind::Opened, Kind::Sent, Kind::Received, Kind::Closed, Kind::Opened,
                                        Kind::Lost}));
    EXPECT_EQ(notes.bytes, (Bytes{1, 2}));
    EXPECT_EQ(notes.time, scheduler.now());
    link.removeObserver(&notes);
}

}  // namespace
}  // namespace kickstand::testing
