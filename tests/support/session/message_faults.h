#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/usb_link.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::testing {

/// A firmware message that passes a MessageFaults, in either direction.
struct PassingMessage {
    std::size_t index = 0;  ///< From 0, both directions counted together.
    thunderbots::wire::Direction direction = thunderbots::wire::Direction::Out;
    ByteView packet;  ///< Header byte and payload.
};

/// What becomes of it.
struct MessageFate {
    int copies = 1;  ///< 0: lost.
    /// It, and all behind it, arrives that much later.
    Duration delay{};
    /// One more copy of a response arrives that much after the message, overtaken by what is sent meanwhile.
    std::optional<Duration> echo{};
    /// What arrives in its place, where that is not empty.
    std::vector<std::uint8_t> replacement{};
};

/// Stands around a link to a dongle and decides message by message what becomes of those on the firmware
/// pipes (protocol 4.7). Everything else passes. Keeps the promises of UsbLink.
class MessageFaults final : public UsbLink {
  public:
    using Judge = std::function<MessageFate(const PassingMessage& message)>;

    MessageFaults(std::unique_ptr<UsbLink> inner, Scheduler& scheduler, Judge judge);
    ~MessageFaults() override;
    MessageFaults(const MessageFaults&) = delete;
    MessageFaults& operator=(const MessageFaults&) = delete;

    void open(std::function<void(Result<UsbDeviceInfo>)> done) override;
    void close(std::function<void()> done) override;
    void control(const UsbSetup& setup, ByteView data, Duration deadline, UsbCallback done) override;
    Result<UsbTransferId> submitOut(std::uint8_t endpoint, ByteView data, UsbCallback done) override;
    Result<UsbTransferId> submitIn(std::uint8_t endpoint, std::size_t size, UsbCallback done) override;
    void cancel(UsbTransferId id) override;
    void clearHalt(std::uint8_t endpoint, UsbCallback done) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

  private:
    using Bytes = std::vector<std::uint8_t>;
    struct Arrived {
        TimePoint due{};
        Bytes packet;
    };
    struct Asked {
        std::size_t size = 0;
        UsbCallback done;
    };

    MessageFate judge(thunderbots::wire::Direction direction, ByteView packet);
    void sendCopies(std::uint8_t endpoint, const Bytes& packet, int copies, UsbCallback done);
    void callLater(Duration delay, std::function<void()> call);
    void askInner();
    void innerEnded(const UsbCompletion& completion);
    void arrive(const UsbCompletion& completion);
    void deliver();

    Scheduler& scheduler_;
    Judge judge_;
    std::size_t index_ = 0;
    UsbTransferId lastId_ = 0;
    std::map<UsbTransferId, UsbTransferId> innerIds_;
    std::deque<Asked> asked_;  ///< For messages, oldest first.
    std::size_t asking_ = 0;   ///< Of them, passed on.
    std::deque<Arrived> arrived_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    // Last, so that it goes first: its callbacks end here.
    std::unique_ptr<UsbLink> inner_;
};

}  // namespace kickstand::testing
