#pragma once

#include <functional>
#include <memory>
#include <random>
#include <vector>

#include "core/base/scheduler.h"
#include "core/framing/xbee.h"

namespace kickstand::coach::sim {

/// A radio on the air: its addresses, and what it hears. Called on the simulator's thread.
class RadioNode {
  public:
    virtual ~RadioNode() = default;
    virtual std::uint16_t address() const = 0;
    virtual std::uint8_t channel() const = 0;
    virtual std::uint16_t pan() const = 0;
    /// Whether it is switched on.
    virtual bool listens() const = 0;
    /// The probability, 0 to 1, that a packet from or to it is lost, besides what the medium loses.
    virtual double loss() const { return 0; }
    /// A packet came; the bytes are valid during the call.
    virtual void heard(std::uint16_t source, int rssi_dBm, bool broadcast, ByteView payload) = 0;
};

/// A packet on the air, as a test may judge it.
struct AirPacket {
    std::uint16_t source = 0;
    std::uint16_t destination = 0;
    ByteView payload;
};

/// The air between simulated radios: a packet takes some milliseconds, is heard by the radios of its channel
/// and network, and can be lost. The scheduler's thread.
class RadioMedium {
  public:
    RadioMedium(Scheduler& scheduler, std::uint32_t seed) : scheduler_(scheduler), random_(seed) {}
    RadioMedium(const RadioMedium&) = delete;
    RadioMedium& operator=(const RadioMedium&) = delete;

    /// The node must be taken away before it is destroyed.
    void add(RadioNode& node);
    void remove(RadioNode& node);

    /// Sends; `done` tells what the sender's module says of it, unless the sender is gone by then.
    void send(RadioNode& from, std::uint16_t destination, ByteView payload,
              std::function<void(xbee::TxOutcome)> done);

    /// The probability, 0 to 1, that a receiver misses a packet.
    void setLoss(double probability) { loss_ = probability; }
    double loss() const { return loss_; }
    /// Loses the packets for which it says so, besides. For tests.
    void setThief(std::function<bool(const AirPacket&)> thief) { thief_ = std::move(thief); }
    /// Sees every packet as it is sent. For tests.
    void setWitness(std::function<void(const AirPacket&)> witness) { witness_ = std::move(witness); }

  private:
    struct Flight;
    bool isThere(const RadioNode* node) const;
    void land(const Flight& flight);
    int rssiBetween(std::uint16_t a, std::uint16_t b);

    Scheduler& scheduler_;
    std::mt19937 random_;
    double loss_ = 0;
    std::vector<RadioNode*> nodes_;
    std::function<bool(const AirPacket&)> thief_;
    std::function<void(const AirPacket&)> witness_;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace kickstand::coach::sim
