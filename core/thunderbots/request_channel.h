#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/thunderbots/message_turns.h"
#include "core/thunderbots/request_state.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots {

/// One robot's firmware requests (protocol 4.7): one at a time, each with its own response. Engine thread.
///
/// Most responses carry nothing but their opcode, so an old one could be taken for a new one. What prevents
/// it: messages of one pipe keep their order (protocol 1); a response is only looked for once the dongle has
/// the whole request; and after anything unexpected (a time-out, a response that nobody waits for, a robot
/// found anew) nothing is sent before the robot has answered a Compute Block CRC whose address and length no
/// other request uses and which its response repeats. Whatever comes before that answer belongs to the past.
class RequestChannel {
  public:
    using Done = std::function<void(Result<wire::FirmwareResponse>)>;
    /// Whether a request may still be sent, asked whenever the robot has been waited for meanwhile: that may
    /// take seconds.
    using Gate = std::function<Result<void>()>;

    /// How often a request is sent before it is given up.
    static constexpr int kAttempts = 4;
    /// How often the robot is asked for a sign of life: longer in all than its longest work, so that one that
    /// still erases is waited for.
    static constexpr int kSignTries = 8;

    /// `changed` is called when state() changes. All outlive it.
    RequestChannel(int robot, Scheduler& scheduler, MessageTurns& turns,
                   const std::function<void()>& changed);
    ~RequestChannel();
    RequestChannel(const RequestChannel&) = delete;
    RequestChannel& operator=(const RequestChannel&) = delete;

    /// Sends `fills`, which nobody answers, and then `request`, up to `attempts` times. `done` comes once,
    /// never from inside this call, with a response of the request's kind, or: Unanswered when the robot
    /// answers, but not this; TimedOut when it answers nothing; RobotNotAlive, Disconnected, Cancelled; what
    /// the pipe says; what `gate` says. Errors at once: RequestPending, RobotNotAlive, what the encoder
    /// refuses.
    Result<void> ask(const std::vector<wire::FillPageRequest>& fills, const wire::FirmwareRequest& request,
                     int attempts, Done done, Gate gate = {});
    bool busy() const { return exchange_.has_value(); }
    const RequestState& state() const { return state_; }

    /// A message of the robot's response pipe.
    void received(ByteView payload);
    /// The dongle has found the robot, or lost it; `why` ends a request. A robot that was told to reboot has
    /// done so when it is lost.
    void found();
    void lost(const Error& why);
    /// Ends the request, if there is one, with this error. What the robot does with it is not known then.
    void abandon(const Error& why);
    /// Whether the robot was told to reboot a moment ago, so that losing it is no surprise.
    bool rebooting() const { return scheduler_.now() < rebootingUntil_; }

  private:
    enum class Phase : std::uint8_t { Sending, Waiting, SendingSign, AwaitingSign };
    struct Exchange {
        std::vector<wire::MessagePayload> messages;
        wire::FirmwareRequest request;
        int attempts = 1;
        Done done;
        Gate gate;
        Phase phase = Phase::Sending;
        int sent = 0;          ///< Attempts begun.
        int signTries = 0;     ///< In this round.
        bool tainted = false;  ///< Something old came in between: its answer may be old as well.
    };

    void begin();
    void send();
    void requestTaken(Result<void> result);
    void askForSign();
    void signTaken(Result<void> result);
    void signReceived();
    bool isSign(const wire::FirmwareResponse& response) const;
    bool answers(const wire::FirmwareResponse& response) const;
    void stray();
    void waitFor(Duration time, void (RequestChannel::*then)());
    void unanswered();
    void giveUp();
    void finish(Result<wire::FirmwareResponse> result);
    void show();

    const int robot_;
    Scheduler& scheduler_;
    MessageTurns& turns_;
    const std::function<void()>& changed_;
    std::optional<Exchange> exchange_;
    RequestState state_;
    bool alive_ = false;
    bool inDoubt_ = true;  ///< The robot has to give a sign before anything else is sent.
    std::uint32_t round_;  ///< Of asking for signs.
    TimerId timer_ = 0;
    TimePoint rebootingUntil_{};
};

}  // namespace kickstand::thunderbots
