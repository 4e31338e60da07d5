#pragma once

#include <memory>
#include <optional>
#include <random>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/byte_device_model.h"
#include "core/smartdevice/sim/body.h"
#include "core/smartdevice/wire/frame.h"

namespace kickstand::smartdevice::sim {

/// How a board sends what it sends.
struct BoardFaults {
    bool silent = false;               ///< Says nothing.
    bool deafToSubscriptions = false;  ///< Loses what it is asked for updates.
    double checksum = 0;               ///< Probability, 0-1, that a message's checksum is wrong.
    double truncate = 0;               ///< Probability, 0-1, that a frame breaks off.
    double refuse = 0;                 ///< Probability, 0-1, that it leaves a written value.
    double noise = 0;                  ///< Probability, 0-1, that a bit of a frame is turned, wherever it is.
};

/// As many bytes of values as a board usually puts into one message.
inline constexpr std::size_t kUsualLongestData = 40;

/// What a test may want to know about a board.
struct BoardReport {
    bool lineOpen = false;
    bool booting = false;
    bool disabled = false;
    wire::DecoderCounts heard;
    std::uint64_t resets = 0;
    std::uint64_t writes = 0;    ///< Messages.
    std::uint64_t disables = 0;  ///< Told to.
    std::uint64_t selfDisables = 0;
    wire::SubscriptionRequest subscription;  ///< What it sends now.
};

/// A board of the kit: the protocol, around the body of its kind. Opening its line resets it. The scheduler's
/// thread.
class BoardSim final : public ByteDeviceModel {
  public:
    /// `scheduler` outlives it.
    BoardSim(Scheduler& scheduler, const wire::Uid& uid, std::unique_ptr<Body> body, Duration boot,
             std::uint32_t seed);
    /// Sends Data with more bytes of values than this in several messages (protocol 3); at least a value
    /// each.
    void setLongestData(std::size_t bytes) { longestData_ = bytes; }
    ~BoardSim() override;
    BoardSim(const BoardSim&) = delete;
    BoardSim& operator=(const BoardSim&) = delete;

    bool attached() const override { return attached_; }
    void setListener(ByteDeviceListener* listener) override { listener_ = listener; }
    void lineOpened(Baud baud) override;
    void lineClosed() override;
    void lineBaudChanged(Baud baud) override;
    void hostSent(ByteView bytes) override;

    /// Plugs it in or pulls it out.
    void plug(bool in);
    /// As its button would.
    void reset();
    BoardFaults& faults() { return faults_; }
    Body& body() { return *body_; }
    const wire::Uid& uid() const { return uid_; }
    /// The value as the board has it now.
    wire::Value value(int parameter);
    BoardReport report() const;

  private:
    void advance();
    void booted();
    void take(const wire::Message& message);
    void take(const wire::DeviceWrite& message);
    void answerSubscription();
    void subscribe(const wire::SubscriptionRequest& request);
    void sample();
    void beat();
    void sendData(wire::ParameterMask mask);
    void send(const wire::Message& message);
    void disableSelf();
    wire::ParameterMask readable() const;
    bool happens(double probability);
    void arm(TimerId& timer, Duration delay, void (BoardSim::*due)());
    void cancelTimers();

    Scheduler& scheduler_;
    const wire::Uid uid_;
    const std::unique_ptr<Body> body_;
    const Duration boot_;
    std::mt19937 random_;
    ByteDeviceListener* listener_ = nullptr;
    BoardFaults faults_;
    wire::Decoder decoder_;
    wire::SubscriptionRequest subscription_;
    bool attached_ = true;
    bool lineOpen_ = false;
    bool booting_ = false;
    bool disabled_ = false;
    std::size_t longestData_ = kUsualLongestData;
    int unanswered_ = 0;  ///< Heartbeat requests in a row.
    std::uint8_t nextBeat_ = 0;
    TimePoint advancedTo_;
    TimerId bootTimer_ = 0;
    TimerId sampleTimer_ = 0;
    TimerId beatTimer_ = 0;
    BoardReport report_;
};

}  // namespace kickstand::smartdevice::sim
