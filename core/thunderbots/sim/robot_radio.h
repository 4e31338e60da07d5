#pragma once

#include <cstdint>
#include <optional>

#include "core/thunderbots/sim/robot_sim.h"
#include "core/thunderbots/sim/sequence.h"

namespace kickstand::thunderbots::sim {

/// A message as it travels by radio, either way (protocol 5.3, 5.5).
struct RadioMessage {
    wire::Pipe pipe = wire::Pipe::Kick;
    std::uint8_t sequence = 0;
    wire::MessagePayload payload;
};

/// What a polled robot says (protocol 5.5).
struct RadioAnswer {
    RobotSim::FeedbackBytes feedback{};
    std::optional<RadioMessage> message;
};

/// A robot's end of the radio hop (protocol 5). It deals with nobody until it was discovered, and a boot
/// makes it forget that it was.
class RobotRadio {
  public:
    /// `robot` must outlive it.
    explicit RobotRadio(RobotSim& robot) : robot_(&robot) {}

    RobotSim& robot() const { return *robot_; }
    /// Whether it is up and listens there.
    bool hears(std::uint8_t number, const wire::Channels& channels) const {
        return robot_->up() && robot_->number() == number && robot_->channels() == channels;
    }
    /// The dongle looks for it: sequence numbers begin anew, what waited to be sent is given up.
    void discover();
    /// Its part of a drive broadcast.
    void takeDrive(ByteView block) const;
    /// True where the message is acknowledged: taken now, or a repetition of one that was taken.
    bool takeMessage(const RadioMessage& message);
    /// The answer to a poll; none where it does not answer.
    std::optional<RadioAnswer> poll() const;
    /// Whether it has a message to send.
    bool hasMessage() const { return discovered() && robot_->outgoing() != nullptr; }
    /// The dongle has acknowledged this message.
    void acknowledged(const RadioMessage& message);

  private:
    bool discovered() const { return robot_->up() && bootDiscovered_ == robot_->boots(); }

    RobotSim* robot_;
    std::uint32_t bootDiscovered_ = 0;
    SequenceNumbers next_;     ///< Of what comes.
    SequenceNumbers sending_;  ///< Of what goes.
};

}  // namespace kickstand::thunderbots::sim
