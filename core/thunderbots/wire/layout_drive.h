#pragma once

#include <array>

#include "core/thunderbots/wire/drive.h"
#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/kick.h"

/// Where the fields of the drive block and of the kick message lie (protocol 4.1, 4.4).
namespace kickstand::thunderbots::wire::layout {

/// A quarter of a degree per 5 ms is 50 degrees a second.
inline constexpr FieldScale kWheelScale{50.0 / 6, 0, "rpm"};
inline constexpr FieldScale kKickScale{kKickStep_us, 0, "µs"};

namespace drive {

constexpr FieldSpec wheel(const char* name, std::uint16_t firstBit, const char* description) {
    return number(name, firstBit, 11, -kMaxWheel, kMaxWheel, description, kWheelScale);
}

inline constexpr FieldSpec kRun = flag("run", 0, "Motors run; 0: they brake");
inline constexpr FieldSpec kCharge = flag("charge", 1, "Capacitor charger on");
inline constexpr FieldSpec kDribble = flag("dribble", 2, "Dribbler on");
inline constexpr FieldSpec kMask1 = flag("mask1", 3, "Autokick: solenoid 1 begins at once; 0: after dt");
inline constexpr FieldSpec kMask2 = flag("mask2", 4, "Autokick: solenoid 2 begins at once; 0: after dt");
inline constexpr FieldSpec kArmed = flag("armed", 5, "Autokick armed");
inline constexpr FieldSpec kReserved = reserved("reserved", 6, 2);
inline constexpr std::array<FieldSpec, kWheelCount> kWheels{
    wheel("wheel1", 8, "Front left wheel, quarter-degrees per 5 ms"),
    wheel("wheel2", 19, "Back left wheel, quarter-degrees per 5 ms"),
    wheel("wheel3", 30, "Back right wheel, quarter-degrees per 5 ms"),
    wheel("wheel4", 41, "Front right wheel, quarter-degrees per 5 ms"),
};
inline constexpr FieldSpec kTestClass = number("test_class", 52, 3, 0, 7, "What the LEDs show; 0: nothing");
inline constexpr FieldSpec kTestTarget = number("test_target", 55, 3, 0, 7, "Which motor or wheel they show");
inline constexpr FieldSpec kT1 =
    number("t1", 58, 7, 0, kKickMaxSteps, "Autokick: end of the pulse of solenoid 1", kKickScale);
inline constexpr FieldSpec kT2 =
    number("t2", 65, 7, 0, kKickMaxSteps, "Autokick: end of the pulse of solenoid 2", kKickScale);
inline constexpr FieldSpec kDt =
    number("dt", 72, 7, 0, kKickMaxSteps, "Autokick: begin of a pulse whose mask is 0", kKickScale);
inline constexpr FieldSpec kLastBit = reserved("last_bit", 79, 1);

inline constexpr std::array kFields{kRun,        kCharge,    kDribble,   kMask1,     kMask2,     kArmed,
                                    kReserved,   kWheels[0], kWheels[1], kWheels[2], kWheels[3], kTestClass,
                                    kTestTarget, kT1,        kT2,        kDt,        kLastBit};

}  // namespace drive

namespace kick {

inline constexpr FieldSpec kT1 =
    number("t1", 0, 7, 0, kKickMaxSteps, "End of the pulse of solenoid 1", kKickScale);
inline constexpr FieldSpec kMask1 = flag("mask1", 7, "Solenoid 1 begins at once; 0: after dt");
inline constexpr FieldSpec kT2 =
    number("t2", 8, 7, 0, kKickMaxSteps, "End of the pulse of solenoid 2", kKickScale);
inline constexpr FieldSpec kMask2 = flag("mask2", 15, "Solenoid 2 begins at once; 0: after dt");
inline constexpr FieldSpec kDt =
    number("dt", 16, 7, 0, kKickMaxSteps, "Begin of a pulse whose mask is 0", kKickScale);
inline constexpr FieldSpec kReserved = reserved("reserved", 23, 1);

inline constexpr std::array kFields{kT1, kMask1, kT2, kMask2, kDt, kReserved};

}  // namespace kick
}  // namespace kickstand::thunderbots::wire::layout
