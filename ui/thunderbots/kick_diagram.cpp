#include "ui/thunderbots/kick_diagram.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace kickstand::ui {

using namespace thunderbots::wire;

namespace {

PulseEdge endEdge(int solenoid) {
    return solenoid == 1 ? PulseEdge::End1 : PulseEdge::End2;
}

int widthOf(const KickPulses& pulses, int solenoid) {
    return solenoid == 1 ? pulses.width1_us : pulses.width2_us;
}

void setWidth(KickPulses& pulses, int solenoid, int width_us) {
    (solenoid == 1 ? pulses.width1_us : pulses.width2_us) = width_us;
}

}  // namespace

int solenoidOf(PulseEdge edge) {
    return edge == PulseEdge::Start1 || edge == PulseEdge::End1 ? 1 : 2;
}

bool isStart(PulseEdge edge) {
    return edge == PulseEdge::Start1 || edge == PulseEdge::Start2;
}

double PulseAxis::pixelOf(double time_us) const {
    return left_px + (right_px - left_px) * time_us / span_us;
}

int PulseAxis::timeOf(double pixel) const {
    if (!(right_px > left_px)) return 0;
    const double time_us = (pixel - left_px) / (right_px - left_px) * span_us;
    return snappedTime(static_cast<int>(std::lround(std::clamp<double>(time_us, 0, kKickMax_us))));
}

int onGrid(int value_us) {
    // As the encoder does it: half-way values towards zero.
    constexpr int half_us = kKickStep_us / 2 - 1;
    const int steps = (std::abs(value_us) + half_us) / kKickStep_us;
    return (value_us < 0 ? -steps : steps) * kKickStep_us;
}

int snappedTime(int time_us) {
    const int inRange_us = std::clamp(time_us, 0, kKickMax_us);
    return onGrid(inRange_us);
}

int startOf(const KickPulses& pulses, int solenoid) {
    // One pulse alone begins with the kick: the wire has an offset only between two.
    const bool both = pulses.width1_us > 0 && pulses.width2_us > 0;
    if (!both) return 0;
    return std::max(0, solenoid == 1 ? -pulses.offset_us : pulses.offset_us);
}

int timeOf(const KickPulses& pulses, PulseEdge edge) {
    const int solenoid = solenoidOf(edge);
    return startOf(pulses, solenoid) + (isStart(edge) ? 0 : widthOf(pulses, solenoid));
}

bool canPull(const KickPulses& pulses, PulseEdge edge) {
    if (!isStart(edge)) return true;
    if (pulses.width1_us <= 0 || pulses.width2_us <= 0) return false;
    return startOf(pulses, 3 - solenoidOf(edge)) == 0;
}

KickPulses pulled(const KickPulses& pulses, PulseEdge edge, int time_us) {
    if (!canPull(pulses, edge)) return pulses;
    const int solenoid = solenoidOf(edge);
    const int wanted_us = snappedTime(time_us);
    KickPulses result = pulses;
    if (!isStart(edge)) {
        setWidth(result, solenoid, std::max(0, wanted_us - startOf(pulses, solenoid)));
        // A pulse that comes out of nothing begins where it was drawn: with the kick.
        if (widthOf(pulses, solenoid) <= 0) result.offset_us = 0;
        return result;
    }
    // One step has to stay, or there is nothing left to pull back.
    const int end_us = timeOf(pulses, endEdge(solenoid));
    const int latest_us = std::min(end_us, kKickMax_us) - kKickStep_us;
    const int start_us = std::clamp(wanted_us, 0, snappedTime(std::max(0, latest_us)));
    result.offset_us = solenoid == 1 ? -start_us : start_us;
    setWidth(result, solenoid, end_us - start_us);
    return result;
}

}  // namespace kickstand::ui
