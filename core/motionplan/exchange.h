#pragma once

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/motionplan/wire/message.h"

namespace kickstand::motionplan {

/// A refusal by one of the robot's error codes (protocol 4.10), as PlanRefused or WouldBeRefused. Any thread.
Error refusalError(Errc code, int errorCode);

/// One request to the robot, from before it is sent until it is confirmed or given up (protocol 6.1, 6.2). No
/// message has a sequence number: what is left from before is drained first, and then the robot's copy of the
/// message is waited for; what would show that the robot refused, if its error was lost, is looked at after
/// that. What may be sent again is; Execute and Adjust never are. Pure: told what comes and what time it is,
/// it says what to send. Not thread-safe.
class Exchange {
  public:
    // How long for each is waited (protocol 6.1, 6.2).
    static constexpr Duration kDrainLimit = std::chrono::seconds(3);
    static constexpr Duration kEchoLimit = std::chrono::seconds(1);
    static constexpr Duration kStatusLimit = std::chrono::milliseconds(1500);
    /// Two of the robot's statuses, for one may be lost.
    static constexpr Duration kObeyedLimit = std::chrono::milliseconds(2500);
    static constexpr Duration kVerdictLimit = std::chrono::milliseconds(300);
    static constexpr int kAttempts = 3;
    static constexpr int kStopAttempts = 5;

    /// What it stands for: a message, or a look at the trigger plan.
    struct Request {
        wire::Message message{};
        bool readsTrigger = false;
        bool urgent = false;     ///< Stop: sent before anything is drained.
        bool leftovers = false;  ///< What it drains then may hold copies of an earlier Stop.
    };

    /// `isLate` says whether bytes are a copy of what an earlier exchange has sent.
    Exchange(Request request, TimePoint now, std::function<bool(ByteView)> isLate);

    const Request& request() const { return request_; }
    bool done() const { return phase_ == Phase::Done; }
    /// Of one that is done. Errors: commands.h.
    const Result<void>& result() const { return result_; }
    int attempts() const { return attempts_; }
    /// Of a query that was answered: the plan in the slot. Of a Create, Update or Execute whose slot was
    /// asked for too.
    std::optional<int> answeredPlan() const { return answeredPlan_; }
    /// The trigger plan as it was read; empty where there is none.
    const wire::MessageBytes& triggerContent() const { return triggerContent_; }
    bool hasTriggerContent() const { return hasTriggerContent_; }
    /// Stop was confirmed by the robot's word that nothing executed.
    bool wasIdle() const { return wasIdle_; }
    /// Execute was confirmed by the robot's word that what it had started is over.
    bool planEnded() const { return planEnded_; }

    /// What is to be written now, if anything; asked for after every call below, each message given once.
    std::optional<wire::Message> takeMessage();
    /// Whether the trigger plan's outbox is to be read too.
    bool readsTriggerBox() const;

    /// The command outbox was found empty.
    void emptied(TimePoint now);
    /// A message was read from it. Whether it belonged here.
    bool received(ByteView message, TimePoint now);
    /// The trigger plan's outbox holds this; nothing where it is empty.
    void triggerRead(ByteView message);
    /// The NXT answers a read with a status that is no success.
    void nxtRefused(std::uint8_t status);
    /// Time has passed.
    void tick(TimePoint now);
    /// Ends it with this error.
    void abort(Errc code);
    /// What takeMessage() gave, or would have given, is not sent after all.
    void withhold(Error why);

  private:
    enum class Phase : std::uint8_t { Drain, Echo, Answer, Verdict, SlotAnswer, Status, Done };

    void send(TimePoint now);
    void enter(Phase phase, TimePoint deadline);
    void finish(Result<void> result);
    void echoed(TimePoint now);
    void unanswered(TimePoint now);
    void slotKnown(int plan, TimePoint now);
    bool takeQuery(const wire::Message& message, TimePoint now);
    bool takeError(int code);
    bool takeStatus(const wire::Message& status);
    bool takeOddCopy(ByteView bytes, const Result<wire::Message>& message);
    void askSlot(TimePoint now);
    void sendAgain(TimePoint now);
    void differs(const std::string& got);
    void giveUp(Errc code);
    bool neverAgain() const;
    /// The copy of an Adjust has come, and no status.
    bool arrivedOnly() const;
    int attemptsAllowed() const;

    Request request_;
    std::function<bool(ByteView)> isLate_;
    bool leftovers_;  ///< Nothing that comes confirms it before the outbox was empty once.
    bool copySeen_ = false;
    bool echoed_ = false;                   ///< The copy of what was sent last has come.
    std::optional<std::string> oddCopy_{};  ///< What came in its place, as hex.
    wire::MessageBytes bytes_;
    Phase phase_ = Phase::Drain;
    TimePoint deadline_{};
    int attempts_ = 0;
    int slotQueries_ = 0;
    std::optional<wire::Message> outgoing_;
    std::optional<int> answeredPlan_;
    wire::MessageBytes triggerContent_;
    bool hasTriggerContent_ = false;
    bool wasIdle_ = false;
    bool planEnded_ = false;
    Result<void> result_{};
};

}  // namespace kickstand::motionplan
