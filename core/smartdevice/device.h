#pragma once

#include <functional>
#include <vector>

#include "core/base/session_host.h"
#include "core/smartdevice/commands.h"
#include "core/smartdevice/events.h"
#include "core/smartdevice/heartbeat.h"
#include "core/smartdevice/sample_pieces.h"
#include "core/smartdevice/snapshot.h"
#include "core/smartdevice/update_request.h"
#include "core/smartdevice/write_judge.h"

namespace kickstand::smartdevice {

/// What a device works with. Engine thread; everything outlives it.
struct DeviceHost {
    std::function<bool(const wire::Message&)> send;  ///< False where its line does not take it.
    std::function<void(Event)> event;                ///< Without time and device.
    std::function<void(CommandId, Result<void>)> answer;
    std::function<void()> changed;
    SampleSink* samples = nullptr;
};

/// One board, over all the times that it is plugged in: what is known of it, and what is under way with it.
/// Engine thread.
class Device {
  public:
    /// `spec` is null for a board that no catalogue knows: its parameters are found out by reading them one
    /// by one.
    Device(int number, const wire::Uid& uid, SharedDeviceSpec spec, DeviceHost host);

    /// It answered at a port. Asks for the updates that were asked for last; writes nothing.
    void connected(const std::string& port, TimePoint now);
    /// Its line is gone: what was under way is answered with Disconnected.
    void disconnected(TimePoint now);
    void message(const wire::Message& message, TimePoint now);
    /// Every 10 ms: heartbeats, deadlines, and what a silence means.
    void step(TimePoint now);
    /// What its line has carried.
    void setLineCounts(const wire::DecoderCounts& counts) { state_.line = counts; }

    void subscribe(CommandId id, const Subscribe& command, TimePoint now);
    void read(CommandId id, const ReadValues& command, TimePoint now);
    void write(CommandId id, const WriteValues& command, TimePoint now);
    Result<void> disable();
    /// STOP: zero to all that drives, then disable.
    void stop();

    /// Whether its line has yet to take what STOP sends.
    bool owesStop() const { return stopOwed_; }
    bool isLive() const { return state_.presence != Presence::Lost; }
    const DeviceState& state() const { return state_; }

  private:
    struct PendingRead {
        CommandId id = 0;
        wire::ParameterMask missing = 0;
        int left = 0;  ///< How often it may still be asked, with this time.
        TimePoint deadline{};
    };
    struct PendingSubscription {
        CommandId id = 0;
        TimePoint deadline{};
    };

    void take(const wire::SubscriptionResponse& message, TimePoint now);
    void take(const wire::DeviceData& message, TimePoint now);
    void store(const wire::DeviceData& message, TimePoint now);
    bool fits(const wire::DeviceData& message);
    bool answerReads(wire::ParameterMask mask, bool sample);
    void askForUpdates(TimePoint now);
    void requestUpdates();
    bool send(PendingRead& read, TimePoint now);
    void learnNext(TimePoint now);
    void askLearning(TimePoint now);
    void learned(const wire::DeviceData& message, TimePoint now);
    void endLearning(TimePoint now);
    Result<void> checkWrite(const WriteValues& command) const;
    bool sendValues(const std::vector<std::pair<int, wire::Value>>& values);
    void sendStop();
    void noteDriving(int parameter, const wire::Value& value);
    void noteStopped();
    enum class Forget { WhatMoves, All };
    void forgetWritten(Forget what);
    void applyJudgements();
    Result<void> resultOf(const WriteJudge::Ended& ended) const;
    void setPresence(Presence presence);
    void watchUpdates(TimePoint now);
    void raise(EventKind kind, std::string text = {}, std::int64_t code = 0, std::int64_t previous = 0,
               double value = 0);

    DeviceHost host_;
    DeviceState state_;
    Heartbeat heartbeat_;
    WriteJudge judge_;
    std::vector<PendingRead> reads_;
    std::vector<PendingSubscription> subscriptions_;
    UpdateRequest request_;
    SamplePieces pieces_;
    bool stopOwed_ = false;  ///< The line did not take what STOP sends.
    bool told_ = false;      ///< Whether each Data is an event.
    std::uint64_t updates_ = 0;
    wire::ParameterMask driving_ = 0;  ///< Speeds that were written and are not zero, and positions.
    TimePoint sampleAt_{};             ///< The last Data, or when updates were asked for.
    bool misfitTold_ = false;
    int learning_ = -1;  ///< The parameter that is being read to find out its width.
    int learningReadsLeft_ = 0;
    TimePoint learnUntil_{};
    DeviceSpec learnt_;
};

}  // namespace kickstand::smartdevice
