#pragma once

#include <array>

#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/indicator.h"
#include "core/thunderbots/wire/parameters.h"
#include "core/thunderbots/wire/readings.h"
#include "core/thunderbots/wire/test_mode.h"

/// Where the fields of the remaining robot messages lie: feedback, test mode, pipe 6, parameters
/// (protocol 4.3, 4.5, 4.6, 4.8).
namespace kickstand::thunderbots::wire::layout {

constexpr FieldScale scaled(const LinearScale& scale, const char* unit) {
    return {scale.gain, scale.offset, unit};
}

namespace feedback {

inline constexpr FieldSpec kValid = flag("valid", 0, "The rest means something; 0: no feedback yet");
inline constexpr FieldSpec kBall = flag("ball", 1, "Ball in the break beam");
inline constexpr FieldSpec kBallLoad = flag("ball_load", 2, "Ball loading the dribbler (never set)");
inline constexpr FieldSpec kCharged = flag("charged", 3, "Capacitor charged");
inline constexpr FieldSpec kReserved = reserved("reserved", 4, 4);
inline constexpr FieldSpec kBattery =
    number("battery", 8, 16, 0, kMaxAdc10, "Battery, raw reading", scaled(kBatteryScale_V, "V"));
inline constexpr FieldSpec kCapacitor =
    number("capacitor", 24, 16, 0, kMaxAdc12, "Capacitor, raw reading", scaled(kCapacitorScale_V, "V"));
inline constexpr FieldSpec kThermistor = number(
    "thermistor", 40, 16, 0, kMaxAdc10, "Dribbler thermistor, raw reading", scaled(kDribblerScale_C, "°C"));
inline constexpr FieldSpec kLight = number("light", 56, 16, 0, kMaxAdc10, "Break beam sensor, raw reading");

inline constexpr std::array kFields{kValid,   kBall,      kBallLoad,   kCharged, kReserved,
                                    kBattery, kCapacitor, kThermistor, kLight};

}  // namespace feedback

namespace test_mode {

inline constexpr std::array<const char*, kTestClassCount> kClassNames{"none",    "lamp",          "hall",
                                                                      "encoder", "encoder-count", "charger"};
inline constexpr FieldSpec kClass = choice("class", 0, 8, kClassNames, "What the LEDs show");
inline constexpr FieldSpec kTarget = number(
    "target", 8, 8, 0, 255, "Hall: motor 1-5; encoder and encoder-count: wheel 1-4; else without meaning");

inline constexpr std::array kFields{kClass, kTarget};

}  // namespace test_mode

namespace experiment {

inline constexpr FieldSpec kOffset =
    number("offset", 0, 8, 0, kExperimentMaxOffset, "Where in the 256-byte buffer the data belongs");
inline constexpr FieldSpec kData =
    bytes("data", 8, kExperimentPieceBytes, kExperimentPieceBytes, "32 bytes of the buffer");

inline constexpr std::array kFields{kOffset, kData};

}  // namespace experiment

/// The parameters stand alone, and behind the opcode of two firmware messages: `firstBit` tells where.
namespace parameters {

struct Fields {
    FieldSpec flashContents, channel0, channel1, robotNumber, dribblerDuty, tail;
};

constexpr Fields at(std::uint16_t bit) {
    const auto place = [bit](int byte) { return static_cast<std::uint16_t>(bit + 8 * byte); };
    return {
        number("flash_contents", place(0), 8, 0, 255,
               "SPI flash holds 0: FPGA, 1: microcontroller, else no data"),
        lenient(
            number("channel0", place(1), 8, 0, kHighestChannel, "Radio 0 channel, 11-26; 0: not configured")),
        lenient(
            number("channel1", place(2), 8, 0, kHighestChannel, "Radio 1 channel, 11-26; 0: not configured")),
        lenient(number("robot_number", place(3), 8, 0, kRobotCount - 1, "Robot number")),
        number("dribbler_duty", place(4), 8, 0, 255, "PWM duty of the dribbler while it is on"),
        bytes("tail", place(5), 0, kMaxParameterBytes - kDefinedParameterBytes,
              "Reserved: kept as it was read"),
    };
}

inline constexpr Fields kAlone = at(0);
inline constexpr std::array kFields{kAlone.flashContents, kAlone.channel0,     kAlone.channel1,
                                    kAlone.robotNumber,   kAlone.dribblerDuty, kAlone.tail};

}  // namespace parameters
}  // namespace kickstand::thunderbots::wire::layout
