#pragma once

namespace kickstand::ui {

/// What a stick's position comes to.
struct StickCurve {
    double deadZone = 0.12;  ///< 0 to 0.9: this much around the middle is nothing.
    double bend = 0.4;       ///< 0: even. 1: gentle near the middle.

    friend bool operator==(const StickCurve&, const StickCurve&) = default;
};

/// −1 to 1 of a stick that stands at `position`; the ends stay the ends. What is no number is the middle.
/// Pure.
double shaped(double position, const StickCurve& curve);

}  // namespace kickstand::ui
