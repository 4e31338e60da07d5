#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kickstand::thunderbots {

/// Robots are numbered 0-15 (protocol 1).
constexpr int kRobots = 16;
/// Wheels 1 front left, 2 back left, 3 back right, 4 front right, at index 0-3 (protocol 6.6).
constexpr int kWheels = 4;
/// Set points as the wire has them: quarters of a degree per 5 ms, −1023…1023 (protocol 4.1).
using WheelSpeeds = std::array<int, kWheels>;
constexpr int kFastestWheel = 1023;
/// What the engine allows until a person raises it for the connection.
constexpr int kStartingWheelLimit = 100;

/// A choice of robots: bit n is robot n.
using RobotMask = std::uint16_t;
constexpr RobotMask kAllRobots = 0xFFFF;
constexpr RobotMask maskOf(int robot) {
    return static_cast<RobotMask>(1U << robot);
}
constexpr bool contains(RobotMask mask, int robot) {
    return (mask >> robot & 1) != 0;
}

/// Revolutions per minute of a wheel set point: 42 units are 350 rpm (protocol 6.6).
constexpr double wheel_rpm(int units) {
    return units * 350.0 / 42.0;
}

/// The signals of one robot, as SignalId::signal numbers them.
enum class Signal : std::uint16_t { Battery_V = 0, Capacitor_V = 1, Dribbler_C = 2, Light = 3 };
constexpr int kSignals = 4;

/// How far a link to a dongle or cable has come.
enum class LinkState : std::uint8_t {
    Idle,       ///< Nothing asked for yet, or closed on purpose.
    Searching,  ///< Waiting for the device to be plugged in.
    Opening,    ///< Claiming and configuring it.
    Starting,   ///< Radios are coming up.
    Braking,    ///< Sixteen braked blocks on their way, before anything else.
    Running,
    Failed,  ///< Cannot go on without a person; the snapshot's error says why.
};

/// "idle", "searching", …: stable names for JSON. Any thread.
std::string_view name(LinkState state);
/// "battery_V", …: stable names for JSON and CSV. Any thread.
std::string_view name(Signal signal);

}  // namespace kickstand::thunderbots
