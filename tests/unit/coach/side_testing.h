#pragma once

#include <algorithm>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/coach/coach_side.h"
#include "core/coach/towrp_side.h"

namespace kickstand::coach::testing {

using wire::Opcode;
using wire::Role;

/// What a side has sent, and when.
struct SentPacket {
    TimePoint time{};
    std::uint16_t destination = 0;
    wire::Message message;
};

/// One side on a fake clock, with everything that it does written down.
template <class Side>
struct SideRig {
    FakeScheduler scheduler;
    std::vector<SentPacket> sent;
    std::vector<Event> events;
    Side side{scheduler,
              {[this](std::uint16_t destination, const wire::Message& message) {
                   sent.push_back({scheduler.now(), destination, message});
               },
               [this](EventKind kind, int team, std::int64_t code, std::int64_t previous) {
                   events.push_back({kind, scheduler.now(), team, code, previous});
               }}};

    void wait(int ms) { scheduler.advance(std::chrono::milliseconds(ms)); }
    void hears(std::uint16_t source, Opcode opcode, int parameter = 0) {
        side.received({source, -50, {opcode, static_cast<std::uint8_t>(parameter)}});
    }
    std::size_t count(Opcode opcode) const {
        return static_cast<std::size_t>(
            std::count_if(sent.begin(), sent.end(),
                          [=](const SentPacket& packet) { return packet.message.opcode == opcode; }));
    }
    bool told(EventKind kind) const {
        return std::any_of(events.begin(), events.end(),
                           [=](const Event& event) { return event.kind == kind; });
    }
    /// Milliseconds between the last two packets of that kind; -1 where there are not two.
    std::int64_t lastGap_ms(Opcode opcode) const {
        std::vector<TimePoint> times;
        for (const SentPacket& packet : sent) {
            if (packet.message.opcode == opcode) times.push_back(packet.time);
        }
        if (times.size() < 2) return -1;
        return std::chrono::duration_cast<std::chrono::milliseconds>(times.back() - times[times.size() - 2])
            .count();
    }
    /// The shortest time between any two packets that follow each other.
    Duration shortestGap() const {
        Duration gap = std::chrono::hours(1);
        for (std::size_t i = 1; i < sent.size(); ++i)
            gap = std::min(gap, sent[i].time - sent[i - 1].time);
        return gap;
    }
};

inline constexpr Team kOwn = 5;
inline constexpr Team kOther = 7;
inline std::uint16_t boat(Team team) {
    return wire::addressOf(Role::Towrp, team);
}
inline std::uint16_t console(Team team) {
    return wire::addressOf(Role::Coach, team);
}

}  // namespace kickstand::coach::testing
