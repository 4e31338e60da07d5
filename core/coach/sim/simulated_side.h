#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "core/coach/sim/radio_medium.h"
#include "core/coach/wire/message.h"

namespace kickstand::coach::sim {

/// What a simulated COACH or TOWRP stands on: its radio, and its microcontroller's loop that looks at the
/// clock every 20 ms and sends at most one packet in 200 ms. One thread, the scheduler's.
class SimulatedSide : public RadioNode {
  public:
    SimulatedSide(Scheduler& scheduler, RadioMedium& medium, std::uint16_t address, std::uint8_t channel,
                  std::uint16_t pan)
        : scheduler_(scheduler), medium_(medium), address_(address), channel_(channel), pan_(pan) {
        medium_.add(*this);
        timer_ = scheduler_.callAfter(kLoop, [this] { turn(); });
    }
    ~SimulatedSide() override {
        scheduler_.cancel(timer_);
        medium_.remove(*this);
    }
    SimulatedSide(const SimulatedSide&) = delete;
    SimulatedSide& operator=(const SimulatedSide&) = delete;

    std::uint16_t address() const override { return address_; }
    std::uint8_t channel() const override { return channel_; }
    std::uint16_t pan() const override { return pan_; }
    bool listens() const override { return on_; }
    double loss() const override { return loss_; }
    void heard(std::uint16_t source, int, bool, ByteView payload) override {
        if (const auto message = wire::decodeMessage(payload)) came(source, *message);
    }

    /// Switches it on or off; on, it begins anew.
    void setOn(bool on) {
        if (on && !on_) wake();
        on_ = on;
    }
    bool isOn() const { return on_; }
    /// How bad its radio is: 0 to 1.
    void setLoss(double probability) { loss_ = probability; }

  protected:
    /// A message came.
    virtual void came(std::uint16_t source, const wire::Message& message) = 0;
    /// It was switched on.
    virtual void wake() = 0;
    /// A turn of its loop; `slot` when a packet may be sent.
    virtual void loop(bool slot) = 0;

    TimePoint now() const { return scheduler_.now(); }
    bool since(TimePoint time, Duration span) const { return now() - time >= span; }
    void send(std::uint16_t destination, wire::Opcode opcode, std::uint8_t parameter) {
        lastSent_ = now();
        everSent_ = true;
        medium_.send(*this, destination, wire::encodeMessage({opcode, parameter}), {});
    }

  private:
    static constexpr Duration kLoop = std::chrono::milliseconds(20);
    static constexpr Duration kGap = std::chrono::milliseconds(200);

    void turn() {
        timer_ = scheduler_.callAfter(kLoop, [this] { turn(); });
        if (on_) loop(!everSent_ || since(lastSent_, kGap));
    }

    Scheduler& scheduler_;
    RadioMedium& medium_;
    const std::uint16_t address_;
    const std::uint8_t channel_;
    const std::uint16_t pan_;
    bool on_ = true;
    double loss_ = 0;
    bool everSent_ = false;
    TimePoint lastSent_{};
    TimerId timer_ = 0;
};

}  // namespace kickstand::coach::sim
