#include "core/coach/sim/radio_medium.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace kickstand::coach::sim {
namespace {

/// A short packet, its wait for a free channel, and its acknowledgement.
constexpr Duration kAirTime = std::chrono::milliseconds(4);

}  // namespace

struct RadioMedium::Flight {
    RadioNode* from = nullptr;
    std::uint16_t source = 0;
    std::uint8_t channel = 0;
    std::uint16_t pan = 0;
    std::uint16_t destination = 0;
    double loss = 0;  ///< The sender's own.
    std::vector<std::uint8_t> payload;
    std::function<void(xbee::TxOutcome)> done;
};

void RadioMedium::add(RadioNode& node) {
    nodes_.push_back(&node);
}

void RadioMedium::remove(RadioNode& node) {
    nodes_.erase(std::remove(nodes_.begin(), nodes_.end(), &node), nodes_.end());
}

bool RadioMedium::isThere(const RadioNode* node) const {
    return std::find(nodes_.begin(), nodes_.end(), node) != nodes_.end();
}

void RadioMedium::send(RadioNode& from, std::uint16_t destination, ByteView payload,
                       std::function<void(xbee::TxOutcome)> done) {
    if (witness_) witness_({from.address(), destination, payload});
    Flight flight{&from,
                  from.address(),
                  from.channel(),
                  from.pan(),
                  destination,
                  from.loss(),
                  {payload.begin(), payload.end()},
                  std::move(done)};
    scheduler_.callAfter(kAirTime, [this, alive = std::weak_ptr<bool>(alive_), flight = std::move(flight)] {
        if (!alive.expired()) land(flight);
    });
}

/// The same for each pair, with a little that changes.
int RadioMedium::rssiBetween(std::uint16_t a, std::uint16_t b) {
    const auto steady = static_cast<int>((unsigned{a} * 31U ^ unsigned{b} * 31U) % 30U);
    return -38 - steady - static_cast<int>(random_() % 3U);
}

void RadioMedium::land(const Flight& flight) {
    const bool broadcast = flight.destination == xbee::kBroadcast;
    bool delivered = broadcast;
    const bool stolen = thief_ && thief_({flight.source, flight.destination, flight.payload});
    const std::vector<RadioNode*> nodes = nodes_;
    for (RadioNode* node : nodes) {
        if (node == flight.from || !isThere(node) || !node->listens()) continue;
        if (node->channel() != flight.channel || node->pan() != flight.pan) continue;
        if (!broadcast && node->address() != flight.destination) continue;
        const double arrives = (1 - loss_) * (1 - flight.loss) * (1 - node->loss());
        const bool lost = std::uniform_real_distribution<>(0, 1)(random_) >= arrives;
        if (lost || stolen) continue;
        delivered = true;
        node->heard(flight.source, rssiBetween(flight.source, node->address()), broadcast, flight.payload);
    }
    if (flight.done && isThere(flight.from))
        flight.done(delivered ? xbee::TxOutcome::Success : xbee::TxOutcome::NoAcknowledgement);
}

}  // namespace kickstand::coach::sim
