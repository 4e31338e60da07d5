#pragma once

#include <array>
#include <functional>

#include "core/motionplan/events.h"
#include "core/motionplan/snapshot.h"
#include "core/motionplan/wire/message.h"

namespace kickstand::motionplan {

/// What is known of the robot: its slots, its trigger plan, what it executes. Passive: told what was
/// confirmed and what the robot says. Engine thread.
class Model {
  public:
    /// A robot that executes says so once a second (protocol 4.5); after this much silence that is remarked.
    static constexpr Duration kStatusSilence = std::chrono::milliseconds(3500);

    explicit Model(std::function<void(const Event&)> event) : event_(std::move(event)) {}

    /// A new connection: nothing is known.
    void forget();
    /// Everything that was executing may still be.
    void outOfReach(bool gone);

    void slotRead(int slot, int plan, TimePoint now);
    /// What was known of it has turned out wrong.
    void slotUnknown(int slot);
    void planPut(const wire::Message& createOrUpdate, TimePoint now);
    void triggerPut(const wire::Message& trigger, TimePoint now);
    /// What is there is not known, but it may be this one.
    void triggerUnknown(int plan);
    /// Nothing: there is none. What is no trigger plan says nothing.
    void triggerRead(ByteView content, TimePoint now);
    void executeSent(const wire::Message& execute, TimePoint now);
    /// Confirmed, refused, or neither.
    void executeEnded(const Result<void>& result, TimePoint now);
    void stopped(bool wasIdle, TimePoint now);
    void status(const wire::Message& status, TimePoint now);
    /// The robot says that nothing executes.
    void idle(TimePoint now);
    /// Time has passed.
    void tick(TimePoint now);

    const std::array<SlotState, wire::kSlots>& slots() const { return slots_; }
    const TriggerState& trigger() const { return trigger_; }
    const Execution& execution() const { return execution_; }
    bool isOutOfReach() const { return outOfReach_; }

  private:
    void raise(EventKind kind, TimePoint now, std::int64_t code = 0, std::int64_t previous = 0,
               double value = 0);
    SlotState* slot(int number);

    std::function<void(const Event&)> event_;
    std::array<SlotState, wire::kSlots> slots_;
    TriggerState trigger_;
    Execution execution_;
    bool outOfReach_ = false;
};

}  // namespace kickstand::motionplan
