#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace kickstand {

/// What went wrong, as a kind that code can decide on. The sentence a person reads is made at the edge
/// (core/engine/describe.h); an Error carries only the facts it needs.
enum class Errc : std::uint8_t {
    // What was asked for makes no sense.
    BadArgument,
    OutOfRange,
    UnknownName,
    BadUri,
    Unsupported,
    NoEncoding,
    // Bytes from outside.
    Malformed,
    // Links and devices.
    NoDevice,
    SeveralDevices,
    PermissionDenied,
    ClaimedElsewhere,
    Disconnected,
    Stalled,
    TimedOut,
    Cancelled,
    Io,
    RadioFailed,
    ChannelsLocked,
    // Refusals that keep people safe, and back-pressure.
    NotConnected,
    StopLatched,
    NotArmed,
    RobotNotAlive,
    EmergencyStopNotRun,
    KickOutstanding,
    KickExpired,
    MustPassZero,
    NotDischarging,
    ReadingsUnknown,
    SweepRunning,
    CheckRunning,
    NotCharging,
    QueueFull,
    HeartbeatStale,
    // Firmware: requests to robots, and uploads.
    RequestPending,
    Unanswered,
    NotBraked,
    CapacitorLive,
    BatteryLow,
    NotCommitted,
    RebootNeeded,
    ParametersUnread,
    FlashRunning,
    FlashNotRunning,
    AlreadyThere,
    NotVerified,
    WrongSignature,
    // Motion plans.
    NoMovementCode,
    PlanRefused,
    WouldBeRefused,
    PlanExecuting,
    EchoDiffers,
    Unconfirmed,
    NxtRefused,
    // COACH and TOWRP.
    NotPaired,
    PairedElsewhere,
    RoleRunning,
    RadioNotReady,
    RadioNotSet,
    RadioDiffers,
    // Smart devices.
    DeviceRefused,
};

/// An error as a value: what kind, and the facts of this case. Plain, copyable, usable from any thread.
struct Error {
    Errc code = Errc::Io;
    /// The thing it is about, as the caller named it: a field, an option, a URI, a device.
    std::string subject{};
    /// Robot 0-15, where one is concerned.
    std::optional<int> robot{};
    /// USB endpoint address, where one is concerned.
    std::optional<std::uint8_t> endpoint{};
    /// Bounds of what would have been accepted.
    std::optional<std::int64_t> lowest{};
    std::optional<std::int64_t> highest{};
    /// What there was instead.
    std::optional<std::int64_t> got{};
    /// A fact that fits nowhere else, such as the operating system's own word or the text that was given.
    std::string detail{};
    /// The serial port, where one is concerned.
    std::string port{};

    friend bool operator==(const Error&, const Error&) = default;
};

/// The stable, lower-case, hyphenated name of a code ("robot-not-alive"), for JSON and logs. Any thread.
const char* name(Errc code);

}  // namespace kickstand
