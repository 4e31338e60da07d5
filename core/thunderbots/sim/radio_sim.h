#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "core/thunderbots/sim/radio_medium.h"
#include "core/thunderbots/sim/robot_radio.h"
#include "core/thunderbots/sim/timers.h"
#include "core/thunderbots/wire/pipes.h"

namespace kickstand::thunderbots::sim {

/// Bytes of a transmission besides its data: delimiter, length, type, frame ID, address, options, checksum.
inline constexpr std::size_t kRadioFrameBytes = 9;

/// How fast the radio hop is (protocol 5.7).
enum class RadioPace : std::uint8_t {
    True,   ///< Every byte takes its time at 250,000 baud: some 110 polls a second, shared by all robots.
    Ideal,  ///< Messages and new drive blocks arrive at once; every robot is polled 200 times a second.
};

/// The dongle, as its radios see it.
class RadioHost {
  public:
    using DriveBytes = std::array<std::uint8_t, wire::kDriveBytes>;

    virtual ~RadioHost() = default;
    /// The block to broadcast to a robot now.
    virtual DriveBytes driveBlock(std::uint8_t robot) const = 0;
    virtual void feedbackCame(std::uint8_t robot, const RobotSim::FeedbackBytes& feedback) = 0;
    /// False where there is no room: the robot then sends it again.
    virtual bool messageCame(std::uint8_t robot, wire::Pipe pipe, const wire::MessagePayload& payload) = 0;
    /// A message given to send() has ended: its robot has it, or was dropped.
    virtual void messageEnded(std::uint8_t robot, bool delivered) = 0;
    virtual void aliveChanged() = 0;
};

/// The radio hop, dongle side (protocol 5): broadcasts, polls, messages that are repeated until acknowledged,
/// discovery, and robots dropped after 50 failures in a row. On the scheduler's thread.
class RadioSim {
  public:
    /// All but the scheduler are used while the hop runs and must outlive it.
    RadioSim(Scheduler& scheduler, RadioMedium& medium, RadioPace pace, std::vector<RobotRadio>& robots,
             RadioHost& host);
    RadioSim(const RadioSim&) = delete;
    RadioSim& operator=(const RadioSim&) = delete;

    /// Begins on these channels, knowing no robot.
    void start(const wire::Channels& channels);
    /// Forgets all robots and, without a word to the host, all messages.
    void stop();
    /// Drops every robot, as after too many failures, and stops.
    void breakDown();
    /// Bit n: robot n is alive.
    std::uint16_t alive() const;
    bool alive(std::uint8_t robot) const { return peers_[robot].alive; }
    /// Sends a message to a robot that is alive.
    void send(std::uint8_t robot, wire::Pipe pipe, ByteView payload);
    /// The host has a new block for a robot.
    void driveChanged(std::uint8_t robot);
    /// A robot has something to say.
    void messageWaiting(std::uint8_t robot);

  private:
    enum class Phase : std::uint8_t { FirstBroadcast, SecondBroadcast, Messages, Discovery, Gap };

    /// What the dongle knows of one robot.
    struct Peer {
        bool alive = false;
        int failures = 0;
        std::optional<TimePoint> polled;
        SequenceNumbers sending;
        SequenceNumbers next;
        std::deque<RadioMessage> outgoing;  ///< Bounded by the dongle's buffers.
        bool underWay = false;
        std::uint64_t attempt = 0;  ///< Numbers all that were ever made, so that a late end finds no other.
        std::uint32_t session = 0;  ///< Counts the times it was found or lost.
    };

    // The pace: radio_pace.cpp.
    void idealTick();
    void beginPhase();
    Duration phaseTime();
    void endPhase();
    void broadcastPart(std::size_t first);
    void pollNext();
    bool findMessage();
    Duration airTime(std::size_t bytes) const;

    // What is sent and what comes back: radio_sim.cpp.
    template <class Deliver>
    bool carry(wire::Direction direction, Duration air, Deliver deliver);
    RobotRadio* find(std::uint8_t robot);
    void broadcast(std::uint8_t robot);
    void poll(std::uint8_t robot);
    void answerPoll(std::uint8_t robot);
    void takeAnswer(std::uint8_t robot, const RadioAnswer& answer);
    bool takeMessage(std::uint8_t robot, const RadioMessage& message);
    void expirePolls();
    void transmit(std::uint8_t robot);
    void attemptEnded(std::uint8_t robot, std::uint64_t attempt, bool acknowledged);
    void discoverNext();
    void discover(std::uint8_t robot);
    void failed(std::uint8_t robot);
    void drop(std::uint8_t robot);
    void forget(std::uint8_t robot);

    Scheduler& scheduler_;
    RadioMedium& medium_;
    const RadioPace pace_;
    std::vector<RobotRadio>& robots_;
    RadioHost& host_;
    Timer step_;
    Timers flights_;
    bool running_ = false;
    wire::Channels channels_;
    std::array<Peer, wire::kRobotCount> peers_;

    Phase phase_ = Phase::FirstBroadcast;
    std::vector<std::uint8_t> cycleRobots_;  ///< Alive when the cycle began.
    std::uint8_t lastPolled_ = wire::kRobotCount - 1;
    std::uint8_t lastDiscovered_ = wire::kRobotCount - 1;
    std::uint8_t messageTurn_ = 0;
};

}  // namespace kickstand::thunderbots::sim
