// The pulse diagram against the kick timing: whatever a hand can pull, the wire can say, and says the same.

#include "ui/thunderbots/kick_diagram.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace kickstand::ui {
namespace {

using namespace thunderbots::wire;

bool isPair(const KickPulses& pulses) {
    return pulses.width1_us > 0 && pulses.width2_us > 0;
}

/// Whether the wire says exactly what the diagram shows.
void expectOnTheWire(const KickPulses& pulses) {
    const auto encoded = encodePulses(pulses);
    ASSERT_TRUE(encoded) << pulses.width1_us << " " << pulses.width2_us << " " << pulses.offset_us;
    if (isPair(pulses) || pulses.offset_us == 0) {
        EXPECT_FALSE(encoded->snapped);
        EXPECT_EQ(encoded->sent, pulses);
    }
    const auto sent = pulsesOf(encoded->times);
    for (const int solenoid : {1, 2}) {
        const Pulse& pulse = sent[static_cast<std::size_t>(solenoid - 1)];
        const PulseEdge start = solenoid == 1 ? PulseEdge::Start1 : PulseEdge::Start2;
        const PulseEdge end = solenoid == 1 ? PulseEdge::End1 : PulseEdge::End2;
        EXPECT_EQ(pulse.width_us, timeOf(pulses, end) - timeOf(pulses, start));
        if (pulse.width_us > 0) {
            EXPECT_EQ(pulse.start_us, timeOf(pulses, start));
        }
    }
}

/// Whether pulling did what a hand expects: that edge moved there, or stayed, and no other moved.
void expectOneEdgeMoved(const KickPulses& before, const KickPulses& after, PulseEdge pulledEdge,
                        int time_us) {
    for (const PulseEdge edge : kPulseEdges) {
        if (edge == pulledEdge || (isPair(before) && !isPair(after))) continue;
        EXPECT_EQ(timeOf(after, edge), timeOf(before, edge));
    }
    const int now_us = timeOf(after, pulledEdge);
    EXPECT_EQ(now_us % kKickStep_us, 0);
    const bool hasRoom = canPull(before, pulledEdge);
    if (!hasRoom) {
        EXPECT_EQ(after, before);
        return;
    }
    const int solenoid = solenoidOf(pulledEdge);
    const int start_us = std::max(startOf(before, solenoid), startOf(after, solenoid));
    const int end_us = timeOf(before, solenoid == 1 ? PulseEdge::End1 : PulseEdge::End2);
    const bool reachable = isStart(pulledEdge) ? snappedTime(time_us) < end_us
                                               : snappedTime(time_us) > start_us || snappedTime(time_us) == 0;
    if (reachable) {
        EXPECT_EQ(now_us, snappedTime(time_us));
    }
}

TEST(KickDiagram, EveryReachableDragIsOnTheWireAsItIsDrawn) {
    std::mt19937 dice(7);
    std::uniform_int_distribution<int> edge(0, 3);
    std::uniform_int_distribution<int> time(-500, kKickMax_us + 500);
    KickPulses pulses{2400, 1280, 384};
    for (int i = 0; i < 20'000; ++i) {
        const auto one = static_cast<PulseEdge>(edge(dice));
        const int time_us = time(dice);
        const KickPulses next = pulled(pulses, one, time_us);
        expectOneEdgeMoved(pulses, next, one, time_us);
        expectOnTheWire(next);
        if (::testing::Test::HasFailure()) return;
        pulses = next;
    }
}

TEST(KickDiagram, EveryEdgeReachesEveryStepThatItsPulseHasRoomFor) {
    const std::vector<KickPulses> shapes = {{2400, 0, 0},       {0, 640, 0},     {2400, 1280, 384},
                                            {1280, 2400, -384}, {4064, 4064, 0}, {32, 32, 4032}};
    for (const KickPulses& shape : shapes) {
        for (const PulseEdge edge : kPulseEdges) {
            for (int step = 0; step <= kKickMaxSteps; ++step) {
                const KickPulses next = pulled(shape, edge, step * kKickStep_us);
                expectOneEdgeMoved(shape, next, edge, step * kKickStep_us);
                expectOnTheWire(next);
            }
        }
    }
}

TEST(KickDiagram, PullingAnEdgeAndBackChangesNothing) {
    const KickPulses shape{2400, 1280, 384};
    for (const PulseEdge edge : kPulseEdges) {
        const KickPulses away = pulled(shape, edge, timeOf(shape, edge) + 160);
        EXPECT_EQ(pulled(away, edge, timeOf(shape, edge)), shape);
    }
}

TEST(KickDiagram, TheEarlierLeadingEdgeIsTheKickAndStays) {
    EXPECT_FALSE(canPull({2400, 1280, 384}, PulseEdge::Start1));
    EXPECT_TRUE(canPull({2400, 1280, 384}, PulseEdge::Start2));
    EXPECT_TRUE(canPull({2400, 1280, -384}, PulseEdge::Start1));
    EXPECT_FALSE(canPull({2400, 1280, -384}, PulseEdge::Start2));
    EXPECT_TRUE(canPull({2400, 1280, 0}, PulseEdge::Start1)) << "from 0 either may be put off";
    EXPECT_TRUE(canPull({2400, 1280, 0}, PulseEdge::Start2));
    EXPECT_FALSE(canPull({2400, 0, 0}, PulseEdge::Start1)) << "one pulse alone begins with the kick";
    EXPECT_TRUE(canPull({2400, 0, 0}, PulseEdge::End2)) << "the way to make a pulse";
}

TEST(KickDiagram, APulseThatIsTooLateCanBePulledBack) {
    const KickPulses impossible{2400, 4064, 384};
    ASSERT_FALSE(encodePulses(impossible));
    expectOnTheWire(pulled(impossible, PulseEdge::End2, 4064));
    EXPECT_EQ(pulled(impossible, PulseEdge::End2, 4064).width2_us, 3680);
}

TEST(KickDiagram, OnePulseAloneBeginsWithTheKickWhateverTheOffset) {
    for (const KickPulses& pulses : {KickPulses{0, 640, 384}, KickPulses{4064, 0, -320}}) {
        EXPECT_EQ(startOf(pulses, 1), 0);
        EXPECT_EQ(startOf(pulses, 2), 0);
        expectOnTheWire(pulses);
    }
    EXPECT_EQ(pulled({640, 0, 384}, PulseEdge::End2, 1024), (KickPulses{640, 1024, 0}));
}

TEST(KickDiagram, PixelsGoToTheNearestStepAndBack) {
    for (const double width_px : {280.0, 411.5, 700.0, 3000.0}) {
        const PulseAxis axis{28, 28 + width_px, kKickMax_us};
        for (int step = 0; step <= kKickMaxSteps; ++step)
            EXPECT_EQ(axis.timeOf(axis.pixelOf(step * kKickStep_us)), step * kKickStep_us);
        EXPECT_EQ(axis.timeOf(-1000), 0);
        EXPECT_EQ(axis.timeOf(1e9), kKickMax_us);
    }
    EXPECT_EQ((PulseAxis{10, 10, kKickMax_us}.timeOf(50)), 0) << "no room at all";
}

TEST(KickDiagram, SnapsAsTheEncoderDoes) {
    for (int value_us = 0; value_us <= kKickMax_us; ++value_us)
        EXPECT_EQ(onGrid(value_us), encodePulses({value_us, 0, 0})->sent.width1_us) << value_us;
    EXPECT_EQ(onGrid(-17), -32);
    EXPECT_EQ(onGrid(-16), 0);
}

}  // namespace
}  // namespace kickstand::ui
