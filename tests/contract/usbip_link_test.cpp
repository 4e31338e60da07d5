#include <deque>
#include <optional>

#include <gtest/gtest.h>

#include "core/link/usbip/usbip_wire.h"
#include "tests/contract/usbip_rig.h"

// What only a USB/IP link does: connections and servers that fail it.

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;
using namespace usbip;
using Bytes = std::vector<std::uint8_t>;
using Device = FakeUsbDevice;

/// A link on a fake clock whose server is this test, unless it hands the connection to a real one.
class UsbipLinkTest : public ::testing::Test {
  protected:
    UsbipLinkTest() { make(UsbipMemoryRig::match()); }
    void make(const UsbMatch& match) {
        link_ = makeUsbipLink(scheduler_, UsbipMemoryRig::address(), match, [this](auto done) {
            ++connections_;
            scheduler_.post([this, done = std::move(done)] {
                if (refuse_) return done(fail(*refuse_));
                auto [near, far] = makeMemoryStreams(scheduler_);
                serve(std::move(far));
                done(std::move(near));
            });
        });
    }

    std::optional<Result<UsbDeviceInfo>> open(Duration limit = 30s) {
        auto opened = std::make_shared<std::optional<Result<UsbDeviceInfo>>>();
        link_->open([opened](Result<UsbDeviceInfo> info) { *opened = std::move(info); });
        scheduler_.runUntil([&] { return opened->has_value(); }, limit);
        return *opened;
    }
    Error openInVain(Duration limit = 30s) {
        const auto opened = open(limit);
        EXPECT_TRUE(opened && !*opened);
        return opened && !*opened ? opened->error() : Error{};
    }
    void listen() {
        link_->setPresenceListener([this](bool present) { presence_.push_back(present); });
    }
    UsbCallback record() {
        return [this](const UsbCompletion& completion) { ended_.push_back(completion.status); };
    }

    FakeScheduler scheduler_;
    std::optional<Error> refuse_;
    /// What the scripted server does with a request or a command; silent where it is empty.
    std::function<Bytes(const Request&)> onRequest_ = [](const Request&) {
        usbip::Device device;
        device.busId = "1-1";
        device.bus = 1;
        device.number = 2;
        device.vendor = FakeUsbDevice::kVendor;
        device.product = FakeUsbDevice::kProduct;
        return encodeImportReply(OpStatus::Ok, device);
    };
    std::function<Bytes(const Command&)> onCommand_ = [this](const Command& command) {
        return answer(command);
    };
    int connections_ = 0;
    std::unique_ptr<ByteStream> server_;
    std::unique_ptr<UsbLink> link_;
    std::vector<bool> presence_;
    std::vector<UsbStatus> ended_;
    FakeUsbDevice device_;

    /// As a server that knows control transfers alone.
    Bytes answer(const Command& command) {
        Reply reply;
        reply.kind = command.kind;
        reply.sequence = command.sequence;
        if (command.kind == Command::Kind::Unlink) {
            reply.status = TransferStatus::Reset;
            return encodeReply(reply);
        }
        if ((command.endpoint & 0x0F) != 0) return {};
        std::vector<std::uint8_t> in;
        if (device_.control(command.setup, command.data, in) != UsbHandshake::Ack) {
            reply.status = TransferStatus::Stall;
            return encodeReply(reply);
        }
        in.resize(std::min<std::size_t>(in.size(), command.setup.length));
        reply.actual = static_cast<std::uint32_t>(in.size());
        return encodeReply(reply, in);
    }

  private:
    void serve(std::unique_ptr<ByteStream> stream) {
        heard_.clear();
        importing_ = true;
        server_ = std::move(stream);
        server_->start(
            {.received = [this](ByteView bytes) { received(bytes); }, .closed = [](const Error&) {}});
    }
    void received(ByteView bytes) {
        heard_.insert(heard_.end(), bytes.begin(), bytes.end());
        while (takeOne()) {
        }
    }
    bool takeOne() {
        Request request;
        Command command;
        const Parse parse = importing_ ? parseRequest(heard_, request) : parseCommand(heard_, command);
        if (parse.status != Parse::Status::Complete) return false;
        Bytes reply;
        if (importing_) {
            importing_ = false;
            if (onRequest_) reply = onRequest_(request);
        } else if (onCommand_) {
            reply = onCommand_(command);
        }
        heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(parse.bytes));
        server_->send(reply);
        return true;
    }

    Bytes heard_;
    bool importing_ = true;
};

TEST_F(UsbipLinkTest, TheScriptedServerServes) {
    const auto opened = open();
    ASSERT_TRUE(opened && *opened) << opened->error().detail;
    EXPECT_EQ((*opened)->productName, "Fake device");
    EXPECT_EQ((*opened)->port, "server:3240/1-1");
}

TEST_F(UsbipLinkTest, NobodyThereIsNoDevice) {
    for (const Errc code : {Errc::NoDevice, Errc::TimedOut}) {
        refuse_ = Error{.code = code, .detail = "the system's word"};
        const Error error = openInVain();
        EXPECT_EQ(error.code, Errc::NoDevice);
        EXPECT_EQ(error.subject, "server:3240/1-1");
        EXPECT_EQ(error.detail, "the system's word");
    }
}

TEST_F(UsbipLinkTest, ADeviceInUseIsSaidToBe) {
    onRequest_ = [](const Request&) { return encodeImportReply(OpStatus::Busy, {}); };
    EXPECT_EQ(openInVain().code, Errc::ClaimedElsewhere);
    EXPECT_EQ(connections_, 1) << "who has not just had it does not insist";
}

TEST_F(UsbipLinkTest, ADeviceJustGivenBackMayBeBusyForAMoment) {
    ASSERT_TRUE(*open());
    bool closed = false;
    link_->close([&] { closed = true; });
    scheduler_.advance(10ms);
    ASSERT_TRUE(closed);
    const auto give = onRequest_;
    int busy = 5;
    onRequest_ = [&](const Request& request) {
        return busy-- > 0 ? encodeImportReply(OpStatus::Busy, {}) : give(request);
    };
    const auto opened = open();
    ASSERT_TRUE(opened && *opened) << opened->error().detail;
    EXPECT_EQ(busy, -1);
}

TEST_F(UsbipLinkTest, AnotherKindOfDeviceIsRefused) {
    UsbMatch match = UsbipMemoryRig::match();
    match.product = 0x4711;
    make(match);
    EXPECT_EQ(openInVain().code, Errc::BadArgument);
}

TEST_F(UsbipLinkTest, ADeviceWithoutTheInterfaceIsRefused) {
    UsbMatch match = UsbipMemoryRig::match();
    match.interfaces = {0, 5};
    make(match);
    const Error error = openInVain();
    EXPECT_EQ(error.code, Errc::Io);
    EXPECT_EQ(error.detail, "the device has no interface 5");
}

TEST_F(UsbipLinkTest, NonsenseWhileOpeningIsSaidToBe) {
    onRequest_ = [](const Request&) {
        const std::string text = "HTTP/1.1 400 Bad Request\r\n\r\n";
        return Bytes(text.begin(), text.end());
    };
    EXPECT_EQ(openInVain().code, Errc::Malformed);
    scheduler_.advance(1s);
    EXPECT_EQ(scheduler_.pending(), 0U) << "nothing is left of the attempt";
}

TEST_F(UsbipLinkTest, DescriptorsWithoutSenseAreSaidToBe) {
    onCommand_ = [this](const Command& command) {
        Bytes reply = answer(command);
        // The second byte of every descriptor is its type.
        if (reply.size() > kReplySize + 1) reply[kReplySize + 1] = 0x77;
        return reply;
    };
    EXPECT_EQ(openInVain().code, Errc::Malformed);
}

TEST_F(UsbipLinkTest, ADeviceThatRefusesToBeConfiguredDoesNotOpen) {
    onCommand_ = [this](const Command& command) {
        if (command.setup.request != 9) return answer(command);
        return encodeReply({Command::Kind::Submit, command.sequence, TransferStatus::Stall, 0});
    };
    const Error error = openInVain();
    EXPECT_EQ(error.code, Errc::Io);
    EXPECT_EQ(error.detail, "a configuration: stalled");
}

TEST_F(UsbipLinkTest, AServerThatFallsSilentWhileOpeningIsGivenUp) {
    onRequest_ = nullptr;
    EXPECT_EQ(openInVain(5s).code, Errc::NoDevice);
    onCommand_ = nullptr;
    EXPECT_NE(openInVain(5s).code, Errc::BadArgument) << "closed, and not still opening";
}

TEST_F(UsbipLinkTest, ADeviceThatNeverAnswersDoesNotHoldUpTheOpening) {
    // The server lives, and says so; the device does not answer to its configuration.
    onCommand_ = [this](const Command& command) {
        const bool configuration = command.kind == Command::Kind::Submit && command.setup.request == 9;
        return configuration ? Bytes() : answer(command);
    };
    EXPECT_EQ(openInVain(20s).code, Errc::Io);
}

TEST_F(UsbipLinkTest, AServerThatFallsSilentLaterIsLost) {
    listen();
    ASSERT_TRUE(*open());
    presence_.clear();
    onCommand_ = nullptr;
    onRequest_ = nullptr;
    ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, record()));
    link_->control({0xC0, 1, 0, 0, 4}, {}, 1s, record());
    ASSERT_TRUE(scheduler_.runUntil([&] { return !presence_.empty(); }, 4s));
    EXPECT_EQ(presence_, std::vector<bool>{false});
    EXPECT_EQ(ended_, (std::vector<UsbStatus>{UsbStatus::NoDevice, UsbStatus::NoDevice}));
    EXPECT_EQ(link_->submitIn(Device::kFastIn, 64, record()).error().code, Errc::NotConnected);
}

TEST_F(UsbipLinkTest, ALostConnectionCanBeMadeAgain) {
    for (int round = 0; round < 3; ++round) {
        ASSERT_TRUE(*open());
        listen();
        presence_.clear();
        ended_.clear();
        ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, record()));
        ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1}, record()));
        server_->close();
        ASSERT_TRUE(scheduler_.runUntil([&] { return !presence_.empty(); }, 1s));
        EXPECT_EQ(ended_, (std::vector<UsbStatus>{UsbStatus::NoDevice, UsbStatus::NoDevice}));
        link_->setPresenceListener(nullptr);
    }
}

TEST_F(UsbipLinkTest, ANonsensicalAnswerLosesTheLink) {
    listen();
    ASSERT_TRUE(*open());
    ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, record()));
    server_->send(encodeReply({Command::Kind::Submit, 4711, TransferStatus::Ok, 0}));
    ASSERT_TRUE(scheduler_.runUntil([&] { return !presence_.empty(); }, 1s));
    EXPECT_EQ(ended_, std::vector<UsbStatus>{UsbStatus::NoDevice});
}

TEST_F(UsbipLinkTest, ClosingDoesNotWaitForeverForTheUnlinks) {
    ASSERT_TRUE(*open());
    onCommand_ = nullptr;
    ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, record()));
    ASSERT_TRUE(link_->submitOut(Device::kFastOut, Bytes{1}, record()));
    bool closed = false;
    link_->close([&] { closed = true; });
    scheduler_.advance(900ms);
    EXPECT_FALSE(closed);
    scheduler_.advance(200ms);
    EXPECT_TRUE(closed);
    EXPECT_EQ(ended_, (std::vector<UsbStatus>{UsbStatus::Cancelled, UsbStatus::Cancelled}));
}

TEST_F(UsbipLinkTest, AConnectionLostWhileClosingStillCloses) {
    ASSERT_TRUE(*open());
    onCommand_ = nullptr;
    ASSERT_TRUE(link_->submitIn(Device::kFastIn, 64, record()));
    bool closed = false;
    link_->close([&] { closed = true; });
    server_->close();
    scheduler_.advance(100ms);
    EXPECT_TRUE(closed);
    EXPECT_EQ(ended_, std::vector<UsbStatus>{UsbStatus::Cancelled});
}

TEST_F(UsbipLinkTest, ClosingWritesNothingToTheDevice) {
    ASSERT_TRUE(*open());
    const std::size_t before = device_.configurations().size();
    bool closed = false;
    link_->close([&] { closed = true; });
    scheduler_.advance(100ms);
    EXPECT_TRUE(closed);
    EXPECT_EQ(device_.configurations().size(), before);
}

TEST_F(UsbipLinkTest, NobodyIsAskedWithoutAListener) {
    scheduler_.advance(10s);
    EXPECT_EQ(connections_, 0);
    listen();
    scheduler_.advance(5s);
    EXPECT_GE(connections_, 5);
    EXPECT_LE(connections_, 11);
    link_->setPresenceListener(nullptr);
    const int asked = connections_;
    scheduler_.advance(5s);
    EXPECT_EQ(connections_, asked);
}

TEST_F(UsbipLinkTest, AServerThatComesBackIsTold) {
    refuse_ = Error{.code = Errc::NoDevice};
    listen();
    EXPECT_EQ(openInVain().code, Errc::NoDevice);
    scheduler_.advance(5s);
    EXPECT_TRUE(presence_.empty());
    refuse_.reset();
    onRequest_ = [](const Request&) {
        usbip::Device device;
        device.busId = "1-1";
        device.vendor = FakeUsbDevice::kVendor;
        device.product = FakeUsbDevice::kProduct;
        return encodeDeviceList(std::vector{device});
    };
    scheduler_.advance(600ms);
    EXPECT_EQ(presence_, std::vector<bool>{true});
    scheduler_.advance(5s);
    EXPECT_EQ(presence_.size(), 1U) << "told once";
}

// ---- Over sockets.

TEST(UsbipTcpLink, SurvivesAServerThatEndsInMidTransferAndComesBack) {
    UsbipTcpRig rig;
    auto link = rig.makeLink();
    std::vector<bool> presence;
    std::vector<UsbStatus> ended;
    for (std::size_t round = 0; round < 3; ++round) {
        std::optional<bool> opened;
        rig.onLink([&] {
            link->setPresenceListener([&](bool present) { presence.push_back(present); });
            link->open([&](const auto& result) { opened = result.has_value(); });
        });
        ASSERT_TRUE(rig.waitUntil([&] { return opened.has_value(); }));
        ASSERT_TRUE(*opened);
        rig.onLink([&] {
            ended.clear();
            for (int i = 0; i < 50; ++i) {
                const auto done = [&](const UsbCompletion& completion) {
                    ended.push_back(completion.status);
                };
                ASSERT_TRUE(link->submitIn(Device::kFastIn, 64, done));
                ASSERT_TRUE(link->submitOut(Device::kFastOut, Bytes(64), done));
            }
        });
        rig.stopServer();
        ASSERT_TRUE(rig.waitUntil([&] { return presence.size() == 2 * round + 1; }));
        rig.onLink([&] {
            EXPECT_EQ(ended.size(), 100U);
            EXPECT_EQ(ended.back(), UsbStatus::NoDevice);
            EXPECT_FALSE(presence.back());
        });
        rig.startServer();
        ASSERT_TRUE(rig.waitUntil([&] { return presence.size() == 2 * round + 2; }));
        EXPECT_TRUE(presence.back());
    }
    rig.onLink([&] { link.reset(); });
}

TEST(UsbipTcpLink, ASecondClientFindsTheDeviceInUse) {
    UsbipTcpRig rig;
    auto first = rig.makeLink();
    auto second = rig.makeLink();
    std::optional<Errc> refused;
    bool secondOpened = false;
    rig.onLink([&] {
        first->open([&](const auto& opened) {
            ASSERT_TRUE(opened);
            second->open(
                [&](const auto& again) { refused = again ? Errc::BadArgument : again.error().code; });
        });
    });
    ASSERT_TRUE(rig.waitUntil([&] { return refused.has_value(); }));
    EXPECT_EQ(*refused, Errc::ClaimedElsewhere);
    rig.onLink([&] {
        first->close([&] { second->open([&](const auto& opened) { secondOpened = opened.has_value(); }); });
    });
    EXPECT_TRUE(rig.waitUntil([&] { return secondOpened; }));
    rig.onLink([&] {
        first.reset();
        second.reset();
    });
}

}  // namespace
}  // namespace kickstand::testing
