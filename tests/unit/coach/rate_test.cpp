#include <random>

#include <gtest/gtest.h>

#include "tests/unit/coach/side_testing.h"

namespace kickstand::coach::testing {
namespace {

constexpr int kSteps = 200'000;

wire::Opcode anyOpcode(std::mt19937& random) {
    const auto all = wire::messages();
    return all[random() % all.size()].opcode;
}

std::uint16_t anySource(std::mt19937& random) {
    const std::uint16_t sources[] = {boat(kOwn),      boat(kOwn),    boat(kOther), console(kOther),
                                     console(kOther), console(kOwn), 0x0102};
    return sources[random() % std::size(sources)];
}

template <class Rig>
void expectRate(const Rig& rig, const std::vector<TimePoint>& times) {
    for (std::size_t i = 1; i < times.size(); ++i)
        ASSERT_GE(times[i] - times[i - 1], kPacketGap) << i;
    ASSERT_GT(times.size(), 10'000U);
    EXPECT_LE(rig.scheduler.pending(), 2U) << "one timer for the deadlines, one for the slots";
}

// Hours of whatever can come and be asked, as fast as it can: two packets are never closer than the rate
// allows.

TEST(Rate, ACoachNeverSendsTwoPacketsWithinAFifthOfASecond) {
    SideRig<CoachSide> rig;
    std::mt19937 random(3);
    rig.side.begin(kOwn, wire::TeamColor::Red);
    std::vector<TimePoint> times;
    for (int step = 0; step < kSteps; ++step) {
        switch (random() % 12) {
            case 0:
                if (random() % 200 == 0) rig.side.begin(kOwn, wire::TeamColor::Blue);
                break;
            case 1:
                static_cast<void>(rig.side.pair(random() % 2 == 0 ? kOwn : kOther));
                break;
            case 2:
            case 3:
                static_cast<void>(rig.side.steer({static_cast<int>(random() % 15) - 7, 0}));
                break;
            case 4:
                static_cast<void>(rig.side.freeDigital());
                break;
            case 5:
                static_cast<void>(rig.side.suppress());
                break;
            case 6:
                if (random() % 50 == 0) static_cast<void>(rig.side.jettison());
                break;
            case 7:
                random() % 2 == 0 ? rig.side.halt() : rig.side.release();
                break;
            default:
                rig.hears(anySource(random), anyOpcode(random),
                          random() % 2 == 0 ? int{kOwn} : static_cast<int>(random() % 256));
                break;
        }
        rig.wait(static_cast<int>(random() % 120));
        for (const SentPacket& packet : rig.sent)
            times.push_back(packet.time);
        rig.sent.clear();
        rig.events.clear();
    }
    EXPECT_GT(rig.scheduler.now().time_since_epoch(), std::chrono::hours(3));
    expectRate(rig, times);
}

/// Whatever is asked for besides, and whatever is lost, as long as the boat is heard now and then.
TEST(Rate, APairedCoachNeverLetsASecondPassWithoutVelocity) {
    SideRig<CoachSide> rig;
    std::mt19937 random(5);
    rig.side.begin(kOwn, wire::TeamColor::Red);
    rig.wait(1);
    rig.hears(boat(kOwn), Opcode::AssertionResult, kOwn);
    ASSERT_EQ(rig.side.state(), CoachState::Paired);
    TimePoint last = rig.scheduler.now();
    Duration longest{};
    for (int step = 0; step < kSteps; ++step) {
        // Times when free commands come as fast as they can, and times when they come now and then.
        const bool flood = step / 1000 % 2 == 0;
        if (flood || random() % 10 == 0) static_cast<void>(rig.side.freeDigital());
        if (random() % 8 == 0) static_cast<void>(rig.side.steer({static_cast<int>(random() % 15) - 7, 0}));
        if (random() % 50 == 0) rig.hears(boat(kOwn), Opcode::MutinyInProgress);
        if (random() % 40 == 0) static_cast<void>(rig.side.suppress());
        if (random() % 300 == 0) random() % 2 == 0 ? rig.side.halt() : rig.side.release();
        if (step % 40 == 0) rig.hears(boat(kOwn), Opcode::UpdateMorale, 0);
        rig.wait(static_cast<int>(random() % 120));
        for (const SentPacket& packet : rig.sent) {
            if (packet.message.opcode != Opcode::Velocity) continue;
            longest = std::max(longest, packet.time - last);
            last = packet.time;
        }
        rig.sent.clear();
        rig.events.clear();
        ASSERT_EQ(rig.side.state(), CoachState::Paired) << step;
    }
    EXPECT_LE(longest, std::chrono::milliseconds(900));
    EXPECT_GT(longest, std::chrono::milliseconds(600)) << "there was something to hold it back";
}

TEST(Rate, ABoatNeverSendsTwoPacketsWithinAFifthOfASecond) {
    SideRig<TowrpSide> rig;
    std::mt19937 random(4);
    rig.side.begin(kOwn);
    std::vector<TimePoint> times;
    for (int step = 0; step < kSteps; ++step) {
        if (random() % 20 == 0) static_cast<void>(rig.side.setMorale(static_cast<int>(random() % 20) - 10));
        if (random() % 5000 == 0) rig.side.begin(kOwn);
        const Opcode opcode = random() % 3 == 0 ? anyOpcode(random) : Opcode::Velocity;
        if (opcode != Opcode::Jettison || random() % 20 == 0)
            rig.hears(anySource(random), opcode, static_cast<int>(random() % 2));
        rig.wait(static_cast<int>(random() % 120));
        for (const SentPacket& packet : rig.sent)
            times.push_back(packet.time);
        rig.sent.clear();
        rig.events.clear();
    }
    expectRate(rig, times);
}

}  // namespace
}  // namespace kickstand::coach::testing
