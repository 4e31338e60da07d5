#include "tests/contract/byte_link_contract.h"

#include <numeric>

namespace kickstand::testing {

void ByteLinkContract::SetUp() {
    rig_ = GetParam().make();
    makeLink();
}

void ByteLinkContract::TearDown() {
    destroy();
    rig_->onDevice([](FakeByteDevice& device) { EXPECT_EQ(device.misuses(), 0); });
    rig_.reset();
}

void ByteLinkContract::makeLink() {
    rig_->onLink([this] {
        link_.reset();
        link_ = rig_->makeLink();
        link_->setPresenceListener([this](bool present) { presence_.push_back(present); });
        link_->setReceiver(
            [this](ByteView bytes) { received_.insert(received_.end(), bytes.begin(), bytes.end()); });
    });
}

void ByteLinkContract::destroy() {
    rig_->onLink([this] { link_.reset(); });
}

Result<ByteLinkInfo> ByteLinkContract::tryOpen() {
    auto opened = std::make_shared<std::optional<Result<ByteLinkInfo>>>();
    rig_->onLink([&] {
        link_->open([opened](Result<ByteLinkInfo> result) { *opened = std::move(result); });
        EXPECT_FALSE(opened->has_value()) << "called back from inside the call";
    });
    if (!rig_->waitUntil([&] { return opened->has_value(); })) return fail(Errc::TimedOut, "watchdog");
    return **opened;
}

ByteLinkInfo ByteLinkContract::open() {
    const auto opened = tryOpen();
    EXPECT_TRUE(opened.has_value()) << name(opened.error().code) << " " << opened.error().detail;
    EXPECT_TRUE(rig_->waitForDevice([](const FakeByteDevice& device) { return device.isOpen(); }));
    return opened.value_or(ByteLinkInfo{});
}

void ByteLinkContract::close() {
    auto closed = std::make_shared<bool>(false);
    rig_->onLink([&] {
        link_->close([closed] { *closed = true; });
        EXPECT_FALSE(*closed) << "called back from inside the call";
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return *closed; }));
}

Result<void> ByteLinkContract::write(const Bytes& bytes) {
    Result<void> written;
    rig_->onLink([&] { written = link_->write(bytes); });
    return written;
}

Result<void> ByteLinkContract::setBaud(Baud baud) {
    auto set = std::make_shared<std::optional<Result<void>>>();
    rig_->onLink([&] {
        link_->setBaud(baud, [set](Result<void> result) { *set = std::move(result); });
        EXPECT_FALSE(set->has_value()) << "called back from inside the call";
    });
    if (!rig_->waitUntil([&] { return set->has_value(); })) return fail(Errc::TimedOut, "watchdog");
    return **set;
}

void ByteLinkContract::plug(bool in) {
    rig_->onDevice([in](FakeByteDevice& device) { device.plug(in); });
}

bool ByteLinkContract::deviceGets(const Bytes& bytes) {
    return rig_->waitForDevice([&](const FakeByteDevice& device) { return device.received() == bytes; });
}

bool ByteLinkContract::hostGets(const Bytes& bytes) {
    return rig_->waitUntil([&] { return received_ == bytes; });
}

bool ByteLinkContract::waitForPresence(std::size_t changes) {
    return rig_->waitUntil([&] { return presence_.size() >= changes; });
}

TEST_P(ByteLinkContract, OpenTellsThePortAndItsSpeed) {
    const ByteLinkInfo info = open();
    EXPECT_EQ(info.port, rig_->port());
    EXPECT_EQ(info.baud, 115200U);
    EXPECT_TRUE(rig_->waitForDevice([](const FakeByteDevice& device) { return device.baud() == 115200; }));
}

TEST_P(ByteLinkContract, OpeningWhatIsNotThereSaysSo) {
    plug(false);
    const auto opened = tryOpen();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, Errc::NoDevice);
    EXPECT_EQ(opened.error().port, rig_->port());
}

TEST_P(ByteLinkContract, OpeningTwiceIsRefusedAndHarmless) {
    open();
    const auto again = tryOpen();
    ASSERT_FALSE(again);
    EXPECT_EQ(again.error().code, Errc::BadArgument);
    EXPECT_TRUE(write({7}));
    EXPECT_TRUE(deviceGets({7}));
}

TEST_P(ByteLinkContract, EveryByteArrivesUnchangedAndInOrderBothWays) {
    rig_->onDevice([](FakeByteDevice& device) { device.setEcho(true); });
    open();
    // Every value, those that terminals treat as something else included.
    Bytes all(256);
    std::iota(all.begin(), all.end(), std::uint8_t{0});
    Bytes sent;
    for (int round = 0; round < 8; ++round) {
        ASSERT_TRUE(write(all));
        sent.insert(sent.end(), all.begin(), all.end());
    }
    EXPECT_TRUE(hostGets(sent));
    EXPECT_TRUE(deviceGets(sent));
    EXPECT_TRUE(rig_->waitUntil([&] { return link_->waiting() == 0; }));
}

TEST_P(ByteLinkContract, WritingNothingIsFine) {
    open();
    EXPECT_TRUE(write({}));
    EXPECT_TRUE(write({1}));
    EXPECT_TRUE(deviceGets({1}));
}

TEST_P(ByteLinkContract, WritingToAClosedLinkIsRefused) {
    const auto written = write({1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Errc::NotConnected);
    open();
    close();
    EXPECT_FALSE(write({1}));
}

TEST_P(ByteLinkContract, WhatWaitsIsBoundedAndAllOrNothing) {
    open();
    rig_->onLink([&] {
        const auto written = link_->write(Bytes(ByteLink::kSendLimit + 1));
        ASSERT_FALSE(written);
        EXPECT_EQ(written.error().code, Errc::QueueFull);
        EXPECT_EQ(link_->waiting(), 0U);
        ASSERT_TRUE(link_->write(Bytes(ByteLink::kSendLimit)));
        EXPECT_EQ(link_->waiting(), ByteLink::kSendLimit);
        EXPECT_FALSE(link_->write(Bytes(1)));
        EXPECT_EQ(link_->waiting(), ByteLink::kSendLimit);
    });
}

TEST_P(ByteLinkContract, CloseSendsWhatWaitsFirst) {
    open();
    Bytes bytes(300, 0x55);
    ASSERT_TRUE(write(bytes));
    close();
    EXPECT_TRUE(deviceGets(bytes));
    EXPECT_TRUE(rig_->waitForDevice([](const FakeByteDevice& device) { return !device.isOpen(); }));
    rig_->onLink([&] { EXPECT_TRUE(presence_.empty()) << "closing is not losing"; });
}

TEST_P(ByteLinkContract, CloseDuringOpenEndsBoth) {
    std::vector<std::string> heard;
    rig_->onLink([&] {
        link_->open([&](const Result<ByteLinkInfo>& opened) {
            heard.emplace_back(opened ? "opened" : name(opened.error().code));
        });
        link_->close([&] { heard.emplace_back("closed"); });
    });
    ASSERT_TRUE(rig_->waitUntil([&] { return heard.size() == 2; }));
    EXPECT_EQ(heard, (std::vector<std::string>{"cancelled", "closed"}));
    open();
}

TEST_P(ByteLinkContract, CloseOfAClosedLinkComesBack) {
    close();
    open();
    close();
    close();
}

TEST_P(ByteLinkContract, AClosedLinkOpensAgain) {
    Bytes sent;
    for (std::uint8_t round = 0; round < 5; ++round) {
        open();
        ASSERT_TRUE(write({round}));
        sent.push_back(round);
        EXPECT_TRUE(deviceGets(sent));
        close();
        EXPECT_TRUE(rig_->waitForDevice([](const FakeByteDevice& device) { return !device.isOpen(); }));
    }
}

TEST_P(ByteLinkContract, ALineThatIsPulledOutIsToldOnceAndClosed) {
    open();
    plug(false);
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink([&] {
        EXPECT_EQ(presence_, std::vector<bool>{false});
        EXPECT_EQ(link_->waiting(), 0U);
    });
    const auto written = write({1});
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().code, Errc::NotConnected);
    const auto opened = tryOpen();
    ASSERT_FALSE(opened);
    EXPECT_EQ(opened.error().code, Errc::NoDevice);
}

TEST_P(ByteLinkContract, ALineThatIsPutBackIsToldAndWorks) {
    for (std::size_t round = 0; round < 3; ++round) {
        open();
        plug(false);
        ASSERT_TRUE(waitForPresence(2 * round + 1));
        plug(true);
        ASSERT_TRUE(waitForPresence(2 * round + 2));
        rig_->onLink([&] { EXPECT_EQ(presence_.size(), 2 * round + 2); });
    }
    rig_->onLink([&] { EXPECT_EQ(presence_, (std::vector<bool>{false, true, false, true, false, true})); });
    open();
    ASSERT_TRUE(write({9}));
    EXPECT_TRUE(deviceGets({9}));
}

TEST_P(ByteLinkContract, APortThatAppearsAfterAFailedOpeningIsTold) {
    plug(false);
    ASSERT_FALSE(tryOpen());
    plug(true);
    ASSERT_TRUE(waitForPresence(1));
    rig_->onLink([&] { EXPECT_EQ(presence_, std::vector<bool>{true}); });
    open();
}

TEST_P(ByteLinkContract, TheSpeedChangesAndStays) {
    open();
    // 250000 is none of those that have names.
    for (const Baud baud : {Baud{250000}, Baud{9600}}) {
        EXPECT_TRUE(setBaud(baud));
        EXPECT_TRUE(
            rig_->waitForDevice([baud](const FakeByteDevice& device) { return device.baud() == baud; }));
    }
    close();
    EXPECT_EQ(open().baud, 9600U);
    EXPECT_TRUE(rig_->waitForDevice([](const FakeByteDevice& device) { return device.baud() == 9600; }));
}

TEST_P(ByteLinkContract, ASpeedThatIsNoneOrOfAClosedLineIsRefused) {
    const auto closed = setBaud(9600);
    ASSERT_FALSE(closed);
    EXPECT_EQ(closed.error().code, Errc::NotConnected);
    open();
    const auto none = setBaud(0);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.error().code, Errc::OutOfRange);
}

TEST_P(ByteLinkContract, WithoutAReceiverBytesAreDropped) {
    open();
    rig_->onLink([&] { link_->setReceiver(nullptr); });
    rig_->onDevice([](FakeByteDevice& device) { device.setEcho(true); });
    ASSERT_TRUE(write({1, 2, 3}));
    EXPECT_TRUE(deviceGets({1, 2, 3}));
}

TEST_P(ByteLinkContract, ADestroyedLinkIsSilentAndLetsGo) {
    rig_->onDevice([](FakeByteDevice& device) { device.setEcho(true); });
    int called = 0;
    rig_->onLink([&] {
        link_->open([&](const Result<ByteLinkInfo>&) { ++called; });
        link_.reset();
    });
    makeLink();
    open();
    EXPECT_EQ(called, 0);
    ASSERT_TRUE(write({5}));
    EXPECT_TRUE(hostGets({5}));
}

TEST_P(ByteLinkContract, TheReceiverMayDestroyTheLink) {
    open();
    rig_->onLink([&] { link_->setReceiver([this](ByteView) { link_.reset(); }); });
    rig_->onDevice([](FakeByteDevice& device) { device.send(Bytes{1, 2}); });
    EXPECT_TRUE(rig_->waitUntil([&] { return link_ == nullptr; }));
}

TEST_P(ByteLinkContract, ThePresenceListenerMayDestroyTheLink) {
    open();
    rig_->onLink([&] { link_->setPresenceListener([this](bool) { link_.reset(); }); });
    plug(false);
    EXPECT_TRUE(rig_->waitUntil([&] { return link_ == nullptr; }));
    plug(true);
}

}  // namespace kickstand::testing
