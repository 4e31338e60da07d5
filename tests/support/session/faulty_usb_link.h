#pragma once

#include <deque>
#include <map>
#include <memory>
#include <random>
#include <vector>

#include "core/base/scheduler.h"
#include "core/link/usb_link.h"

namespace kickstand::testing {

/// What goes wrong on a link, each with a probability for every packet. Everything is by chance, and by a
/// seed: the same plan and the same calls give the same faults.
struct FaultPlan {
    std::uint64_t seed = 1;
    double drop = 0;       ///< An IN packet never arrives.
    double duplicate = 0;  ///< An IN packet arrives twice.
    double truncate = 0;   ///< An IN packet has lost its end.
    double corrupt = 0;    ///< A byte of an IN packet is another one.
    double delay = 0;      ///< An IN packet, and all behind it, arrives up to longestDelay later.
    Duration longestDelay = std::chrono::milliseconds(20);
    double stall =
        0;  ///< A transfer of either direction ends with a stall; an OUT packet was not taken then.
};

/// Stands around a link and spoils what passes, without breaking the promises of UsbLink: every transfer that
/// was accepted still ends once, and never from inside a call.
class FaultyUsbLink final : public UsbLink {
  public:
    /// `step` is told before every submission how many there have been, and may do anything to the device.
    FaultyUsbLink(std::unique_ptr<UsbLink> inner, Scheduler& scheduler, const FaultPlan& plan,
                  std::function<void(std::uint64_t)> step = {});
    ~FaultyUsbLink() override;
    FaultyUsbLink(const FaultyUsbLink&) = delete;
    FaultyUsbLink& operator=(const FaultyUsbLink&) = delete;

    /// From now on no OUT packet is taken: the device answers that it has no room.
    void refuseOut() { refusing_ = true; }

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
    /// An end of a transfer that has not been told yet.
    struct Held {
        UsbCallback done;
        UsbStatus status = UsbStatus::Completed;
        Bytes data;
        std::size_t actual = 0;
    };

    void countStep();
    bool happens(double probability);
    std::size_t below(std::size_t bound);
    void ask(std::uint8_t endpoint, std::size_t size, const UsbCallback& done, UsbTransferId id);
    void arrived(std::uint8_t endpoint, std::size_t size, const UsbCallback& done, UsbTransferId id,
                 const UsbCompletion& completion);
    void tellLater(std::uint8_t endpoint, Duration delay, Held held);
    void endHeld(UsbStatus status);

    Scheduler& scheduler_;
    FaultPlan plan_;
    std::function<void(std::uint64_t)> step_;
    std::mt19937_64 random_;
    std::uint64_t steps_ = 0;
    bool open_ = false;
    bool refusing_ = false;
    UsbTransferId lastId_ = 0;
    std::map<UsbTransferId, UsbTransferId> innerIds_;
    std::map<std::uint8_t, std::deque<Held>> held_;
    std::map<UsbTransferId, std::pair<std::uint8_t, UsbCallback>> refused_;
    std::map<std::uint8_t, TimePoint> toldUntil_;
    std::map<std::uint8_t, std::deque<Bytes>> copies_;
    std::function<void(bool)> presence_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
    // Last, so that it goes first: its callbacks end here.
    std::unique_ptr<UsbLink> inner_;
};

}  // namespace kickstand::testing
