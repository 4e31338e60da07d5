#include "core/link/usbip/usbip_client.h"

#include <deque>
#include <optional>

#include <gtest/gtest.h>

#include "core/base/fake_scheduler.h"
#include "tests/support/usb/memory_stream.h"

namespace kickstand {
namespace {

using namespace std::chrono_literals;
using namespace usbip;
using Bytes = std::vector<std::uint8_t>;

Device dongle() {
    Device device;
    device.busId = "1-1";
    device.bus = 1;
    device.number = 2;
    device.vendor = 0x1209;
    device.product = 1;
    return device;
}

/// A client, and the other end of its connection in the test's hands.
class UsbipClientTest : public ::testing::Test {
  protected:
    struct Asked {
        Command command;
        Bytes data;
    };
    struct Ended {
        UsbStatus status = UsbStatus::Failed;
        Bytes data;
        std::size_t actual = 0;
    };

    UsbipClientTest() {
        auto [near, far] = testing::makeMemoryStreams(scheduler_);
        client_ = std::make_unique<UsbipClient>(scheduler_, std::move(near));
        server_ = std::move(far);
        server_->start({.received =
                            [this](ByteView bytes) {
                                heard_.insert(heard_.end(), bytes.begin(), bytes.end());
                                if (imported_) takeCommands();
                            },
                        .closed = [this](const Error&) { left_ = true; }});
    }

    void import() {
        client_->import(
            "1-1", [this](Result<Device> device) { imported_ = device.has_value(); },
            [this](const Error& error) { lost_.push_back(error); });
        settle();
        EXPECT_EQ(heard_, encodeRequest({Request::Kind::Import, "1-1"}));
        heard_.clear();
        say(encodeImportReply(OpStatus::Ok, dongle()));
        ASSERT_TRUE(imported_);
    }
    void settle() { scheduler_.advance(10ms); }
    void say(const Bytes& bytes) {
        server_->send(bytes);
        settle();
    }
    void reply(std::uint32_t sequence, TransferStatus status, std::uint32_t actual = 0,
               const Bytes& data = {}) {
        say(encodeReply({Command::Kind::Submit, sequence, status, actual}, data));
    }
    void replyUnlink(std::uint32_t sequence, TransferStatus status) {
        say(encodeReply({Command::Kind::Unlink, sequence, status, 0}));
    }
    UsbCallback record(int number) {
        return [this, number](const UsbCompletion& completion) {
            ended_[number].push_back(
                {completion.status, {completion.data.begin(), completion.data.end()}, completion.actual});
        };
    }
    std::uint32_t in(int number, std::size_t size = 64) {
        const auto sequence = client_->in(0x85, size, 1, record(number));
        settle();
        return sequence;
    }
    /// The one ending of a transfer.
    Ended ending(int number) {
        EXPECT_EQ(ended_[number].size(), 1U) << number;
        return ended_[number].empty() ? Ended{} : ended_[number].front();
    }
    /// The connection has ended for this reason, once.
    void expectLost(Errc code, const std::string& detail) {
        ASSERT_EQ(lost_.size(), 1U);
        EXPECT_EQ(lost_[0].code, code);
        EXPECT_EQ(lost_[0].detail, detail);
        scheduler_.advance(1s);
        EXPECT_TRUE(left_) << "the server hears it";
    }

    FakeScheduler scheduler_;
    std::unique_ptr<ByteStream> server_;
    std::unique_ptr<UsbipClient> client_;
    Bytes heard_;
    std::deque<Asked> asked_;
    std::map<int, std::vector<Ended>> ended_;
    std::vector<Error> lost_;
    bool imported_ = false;
    bool left_ = false;

  private:
    void takeCommands() {
        Command command;
        Parse parse;
        while ((parse = parseCommand(heard_, command)).status == Parse::Status::Complete) {
            asked_.push_back({command, {command.data.begin(), command.data.end()}});
            heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(parse.bytes));
        }
        EXPECT_NE(parse.status, Parse::Status::Malformed) << parse.why;
    }
};

TEST_F(UsbipClientTest, AsksForTheList) {
    std::optional<Result<std::vector<Device>>> listed;
    client_->list([&](auto result) { listed = std::move(result); });
    settle();
    EXPECT_EQ(heard_, encodeRequest({}));
    Device device = dongle();
    device.interfaces = {{0xFF, 0, 0}};
    say(encodeDeviceList(std::vector{device}));
    ASSERT_TRUE(listed && *listed);
    EXPECT_EQ(**listed, std::vector{device});
}

TEST_F(UsbipClientTest, ARefusalSaysWhich) {
    const std::pair<OpStatus, Errc> cases[] = {{OpStatus::NotAvailable, Errc::NoDevice},
                                               {OpStatus::Busy, Errc::ClaimedElsewhere},
                                               {OpStatus::DeviceError, Errc::Io},
                                               {OpStatus::NoDevice, Errc::NoDevice},
                                               {OpStatus::Error, Errc::Io},
                                               {static_cast<OpStatus>(99), Errc::Io}};
    for (const auto& [status, code] : cases) {
        auto [near, far] = testing::makeMemoryStreams(scheduler_);
        UsbipClient client(scheduler_, std::move(near));
        far->start({.received = [](ByteView) {}, .closed = [](const Error&) {}});
        std::optional<Error> error;
        bool lost = false;
        client.import(
            "1-1", [&](const Result<Device>& device) { error = device ? Error{} : device.error(); },
            [&](const Error&) { lost = true; });
        far->send(encodeImportReply(status, {}));
        settle();
        ASSERT_TRUE(error);
        EXPECT_EQ(error->code, code);
        far.reset();
        settle();
        EXPECT_FALSE(lost) << "what was never given cannot be lost";
    }
}

TEST_F(UsbipClientTest, TransfersTravelWholeAndAnswersFindTheirs) {
    import();
    client_->out(0x05, Bytes{1, 2, 3}, 1, record(1));
    client_->control({0x40, 0x12, 7, 8, 2}, Bytes{9, 8}, record(2));
    client_->control({0xC0, 0x13, 0, 0, 4}, {}, record(3));
    client_->control({0x80, 0x14, 0, 0, 0}, {}, record(4));
    in(5);
    ASSERT_EQ(asked_.size(), 5U);
    EXPECT_EQ(asked_[0].command.device, dongle().id());
    EXPECT_EQ(asked_[0].command.endpoint, 0x05);
    EXPECT_EQ(asked_[0].command.interval, 1U);
    EXPECT_EQ(asked_[0].data, (Bytes{1, 2, 3}));
    EXPECT_EQ(asked_[1].command.setup, (UsbSetup{0x40, 0x12, 7, 8, 2}));
    EXPECT_EQ(asked_[1].data, (Bytes{9, 8}));
    EXPECT_EQ(asked_[2].command.endpoint, 0x80);
    EXPECT_EQ(asked_[2].command.length, 4U);
    EXPECT_EQ(asked_[3].command.endpoint, 0x00) << "nothing comes back, so that it counts as OUT";
    EXPECT_EQ(asked_[4].command.endpoint, 0x85);
    // In any order.
    reply(asked_[4].command.sequence, TransferStatus::Ok, 3, {7, 7, 7});
    reply(asked_[2].command.sequence, TransferStatus::ShortRead, 1, {5});
    reply(asked_[0].command.sequence, TransferStatus::Ok, 3);
    reply(asked_[1].command.sequence, TransferStatus::Stall);
    EXPECT_EQ(ending(5).data, (Bytes{7, 7, 7}));
    EXPECT_EQ(ending(3).status, UsbStatus::Completed);
    EXPECT_EQ(ending(3).data, Bytes{5});
    EXPECT_EQ(ending(1).actual, 3U);
    EXPECT_TRUE(ending(1).data.empty());
    EXPECT_EQ(ending(2).status, UsbStatus::Stalled);
    EXPECT_TRUE(ended_[4].empty());
}

TEST_F(UsbipClientTest, EveryStatusHasAMeaning) {
    import();
    const std::pair<TransferStatus, UsbStatus> cases[] = {
        {TransferStatus::Overflow, UsbStatus::Overflow},
        {TransferStatus::Protocol, UsbStatus::Failed},
        {TransferStatus::TimedOut, UsbStatus::Failed},
        {TransferStatus::Reset, UsbStatus::Failed},
        {TransferStatus::Invalid, UsbStatus::Failed},
        {static_cast<TransferStatus>(-4711), UsbStatus::Failed},
        {static_cast<TransferStatus>(5), UsbStatus::Failed}};
    int number = 0;
    for (const auto& [status, expected] : cases) {
        reply(in(++number), status);
        EXPECT_EQ(ending(number).status, expected) << static_cast<int>(status);
    }
    EXPECT_TRUE(lost_.empty());
}

TEST_F(UsbipClientTest, BytesThatCameWithAFailureAreReadOver) {
    import();
    const auto failed = in(1);
    const auto good = in(2);
    Bytes both = encodeReply({Command::Kind::Submit, failed, TransferStatus::Overflow, 3}, Bytes{1, 2, 3});
    const Bytes next = encodeReply({Command::Kind::Submit, good, TransferStatus::Ok, 1}, Bytes{9});
    both.insert(both.end(), next.begin(), next.end());
    say(both);
    EXPECT_EQ(ending(1).status, UsbStatus::Overflow);
    EXPECT_EQ(ending(2).data, Bytes{9});
}

TEST_F(UsbipClientTest, AnUnlinkEndsTheTransferWithItsAnswer) {
    import();
    const auto sequence = in(1);
    client_->unlink(sequence);
    client_->unlink(sequence);
    settle();
    ASSERT_EQ(asked_.size(), 2U) << "asked once";
    EXPECT_EQ(asked_[1].command.kind, Command::Kind::Unlink);
    EXPECT_EQ(asked_[1].command.unlink, sequence);
    EXPECT_TRUE(ended_.empty());
    replyUnlink(asked_[1].command.sequence, TransferStatus::Reset);
    EXPECT_EQ(ending(1).status, UsbStatus::Cancelled);
}

TEST_F(UsbipClientTest, AnUnlinkThatCameTooLateChangesNothing) {
    import();
    const auto sequence = in(1);
    client_->unlink(sequence);
    settle();
    reply(sequence, TransferStatus::Ok, 2, {4, 2});
    replyUnlink(asked_[1].command.sequence, TransferStatus::Ok);
    EXPECT_EQ(ending(1).data, (Bytes{4, 2}));
    client_->unlink(sequence);
    client_->unlink(12345);
    settle();
    EXPECT_EQ(asked_.size(), 2U);
    EXPECT_TRUE(lost_.empty());
}

TEST_F(UsbipClientTest, TheServersEndIsTheEndOfEverything) {
    import();
    in(1);
    in(2);
    client_->control({0x40, 1, 0, 0, 0}, {}, [this](const UsbCompletion& completion) {
        EXPECT_EQ(completion.status, UsbStatus::NoDevice);
        EXPECT_TRUE(lost_.empty()) << "told before the last transfer";
    });
    server_->close();
    settle();
    EXPECT_EQ(ending(1).status, UsbStatus::NoDevice);
    EXPECT_EQ(ending(2).status, UsbStatus::NoDevice);
    ASSERT_EQ(lost_.size(), 1U);
    EXPECT_EQ(lost_[0].code, Errc::Disconnected);
}

TEST_F(UsbipClientTest, AnUnpluggedDeviceIsTheEndToo) {
    import();
    const auto first = in(1);
    in(2);
    reply(first, TransferStatus::Shutdown);
    EXPECT_EQ(ending(1).status, UsbStatus::NoDevice);
    EXPECT_EQ(ending(2).status, UsbStatus::NoDevice);
    expectLost(Errc::Disconnected, "the device was unplugged");
}

TEST_F(UsbipClientTest, AnAnswerToNothingEndsTheConnection) {
    import();
    in(1);
    reply(4711, TransferStatus::Ok, 64);
    EXPECT_EQ(ending(1).status, UsbStatus::NoDevice);
    expectLost(Errc::Malformed, "an answer to what was not asked");
}

TEST_F(UsbipClientTest, AnUnlinkThatWasNotAskedForEndsTheConnection) {
    import();
    replyUnlink(in(1), TransferStatus::Reset);
    expectLost(Errc::Malformed, "an answer to what was not asked");
}

TEST_F(UsbipClientTest, ASecondAnswerEndsTheConnection) {
    import();
    const auto sequence = in(1);
    reply(sequence, TransferStatus::Ok, 0);
    reply(sequence, TransferStatus::Ok, 0);
    EXPECT_EQ(ending(1).status, UsbStatus::Completed);
    expectLost(Errc::Malformed, "an answer to what was not asked");
}

TEST_F(UsbipClientTest, MoreBytesThanWereAskedForEndTheConnection) {
    import();
    const auto sequence = in(1, 4);
    reply(sequence, TransferStatus::Ok, 5, {1, 2, 3, 4, 5});
    expectLost(Errc::Malformed, "more bytes than were asked for");
}

TEST_F(UsbipClientTest, MoreBytesTakenThanWereSentEndTheConnection) {
    import();
    client_->out(0x05, Bytes{1, 2}, 1, record(1));
    settle();
    reply(asked_[0].command.sequence, TransferStatus::Ok, 3);
    expectLost(Errc::Malformed, "more bytes than were asked for");
}

TEST_F(UsbipClientTest, NonsenseEndsTheConnection) {
    import();
    in(1);
    say(Bytes(100, 0x55));
    expectLost(Errc::Malformed, "not an answer");
}

TEST_F(UsbipClientTest, AnAnswerBeforeAnyQuestionEndsTheConnection) {
    say({1});
    EXPECT_TRUE(left_);
}

TEST_F(UsbipClientTest, ASilentServerIsGivenUpWhileItIsAsked) {
    std::optional<Error> error;
    client_->list([&](const auto& result) { error = result ? Error{} : result.error(); });
    scheduler_.advance(2400ms);
    EXPECT_FALSE(error);
    scheduler_.advance(700ms);
    ASSERT_TRUE(error);
    EXPECT_EQ(error->code, Errc::TimedOut);
}

TEST_F(UsbipClientTest, ASilentServerIsGivenUpWhileSomethingWaits) {
    import();
    reply(in(1), TransferStatus::Ok);
    in(2);
    scheduler_.advance(2300ms);
    EXPECT_TRUE(lost_.empty());
    scheduler_.advance(1s);
    EXPECT_EQ(ending(2).status, UsbStatus::NoDevice);
    expectLost(Errc::TimedOut, "the server is silent");
}

TEST_F(UsbipClientTest, ASilentDeviceIsNotASilentServer) {
    import();
    const auto ended = in(1);
    reply(ended, TransferStatus::Ok);
    in(2);
    for (int round = 0; round < 20; ++round) {
        asked_.clear();
        scheduler_.advance(1200ms);
        for (const Asked& asked : asked_) {
            EXPECT_EQ(asked.command.kind, Command::Kind::Unlink);
            EXPECT_EQ(asked.command.unlink, ended) << "asks about nothing that still waits";
            replyUnlink(asked.command.sequence, TransferStatus::Ok);
        }
    }
    EXPECT_TRUE(lost_.empty());
    EXPECT_TRUE(ended_[2].empty());
}

TEST_F(UsbipClientTest, TheWayToTheServerIsMeasured) {
    import();
    reply(in(1), TransferStatus::Ok);
    in(2);
    EXPECT_FALSE(client_->roundTrip());
    asked_.clear();
    ASSERT_TRUE(scheduler_.runUntil([this] { return !asked_.empty(); }, 2s));
    scheduler_.advance(7ms);
    replyUnlink(asked_.front().command.sequence, TransferStatus::Ok);
    ASSERT_TRUE(client_->roundTrip());
    EXPECT_GE(*client_->roundTrip(), 7ms);
    EXPECT_LT(*client_->roundTrip(), 8ms);
}

TEST_F(UsbipClientTest, NobodyIsSilentWhileNothingIsAsked) {
    import();
    reply(in(1), TransferStatus::Ok);
    scheduler_.advance(1h);
    EXPECT_TRUE(lost_.empty());
    EXPECT_EQ(asked_.size(), 1U);
}

TEST_F(UsbipClientTest, APauseOfThisProgramIsNotOneOfTheServer) {
    import();
    const auto first = in(1);
    scheduler_.stall(1min);
    reply(first, TransferStatus::Ok, 1, {1});
    EXPECT_EQ(ending(1).data, Bytes{1});
    EXPECT_TRUE(lost_.empty());
}

TEST_F(UsbipClientTest, AServerThatReadsNothingIsGivenUp) {
    auto [near, far] = testing::makeMemoryStreams(scheduler_);
    UsbipClient client(scheduler_, std::move(near));
    std::optional<Error> lost;
    int ended = 0;
    // An end that is not started reads nothing; so what it answers is said beforehand.
    client.import(
        "1-1", [](const Result<Device>& device) { EXPECT_TRUE(device); },
        [&](const Error& error) { lost = error; });
    far->send(encodeImportReply(OpStatus::Ok, dongle()));
    settle();
    const Bytes packet(60000);
    for (int i = 0; i < 100; ++i)
        client.out(0x05, packet, 1, [&](const UsbCompletion&) { ++ended; });
    EXPECT_FALSE(lost) << "called back from inside the call";
    settle();
    ASSERT_TRUE(lost);
    EXPECT_EQ(lost->detail, "the server reads nothing");
    EXPECT_EQ(ended, 100);
}

TEST_F(UsbipClientTest, ACallbackMayDestroyTheClient) {
    import();
    const auto first = client_->in(0x85, 4, 1, [this](const UsbCompletion& completion) {
        client_.reset();
        EXPECT_EQ(completion.data.size(), 2U);
        EXPECT_EQ(completion.data[1], 6) << "the bytes outlive the client";
    });
    const auto second = client_->in(0x85, 4, 1, record(2));
    Bytes both = encodeReply({Command::Kind::Submit, first, TransferStatus::Ok, 2}, Bytes{5, 6});
    const Bytes next = encodeReply({Command::Kind::Submit, second, TransferStatus::Ok, 0});
    both.insert(both.end(), next.begin(), next.end());
    say(both);
    EXPECT_EQ(client_, nullptr);
    EXPECT_TRUE(ended_.empty());
    EXPECT_EQ(scheduler_.pending(), 0U) << "nothing of it is left";
}

}  // namespace
}  // namespace kickstand
