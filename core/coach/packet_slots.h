#pragma once

#include <functional>
#include <utility>

#include "core/base/scheduler.h"
#include "core/coach/types.h"

namespace kickstand::coach {

/// Lets one side send at most one packet in kPacketGap, whatever it wants to send (coach protocol 5). The
/// scheduler's thread.
class PacketSlots {
  public:
    /// `send` sends what is most urgent, and tells whether there was anything; called when a slot is open and
    /// something was wanted.
    PacketSlots(Scheduler& scheduler, std::function<bool()> send)
        : scheduler_(scheduler), send_(std::move(send)) {}
    ~PacketSlots() { scheduler_.cancel(timer_); }
    PacketSlots(const PacketSlots&) = delete;
    PacketSlots& operator=(const PacketSlots&) = delete;

    /// Waits a slot first: what another program sent a moment ago over the same radio is not known here.
    void rest() {
        used_ = true;
        last_ = scheduler_.now();
    }

    /// Something waits to be sent.
    void want() {
        if (timer_ != 0) return;
        const TimePoint open = used_ ? last_ + kPacketGap : scheduler_.now();
        timer_ = scheduler_.callAt(open, [this] { openSlot(); });
    }

  private:
    void openSlot() {
        timer_ = 0;
        if (!send_()) return;
        used_ = true;
        last_ = scheduler_.now();
        // What else waits takes the next slot; where nothing does, that one passes unused.
        want();
    }

    Scheduler& scheduler_;
    std::function<bool()> send_;
    TimerId timer_ = 0;
    bool used_ = false;
    TimePoint last_{};
};

}  // namespace kickstand::coach
