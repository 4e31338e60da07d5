#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/smartdevice/catalogue.h"
#include "core/smartdevice/wire/frame.h"
#include "core/smartdevice/wire/uid.h"

namespace kickstand::smartdevice {

/// How many boards a session works with at once, and how many it knows again when they come back; after
/// that, the number of the one that was lost first is given to another.
inline constexpr int kMostDevices = 32;
inline constexpr int kMostKnownDevices = 2 * kMostDevices;

/// What became of the last write of a parameter (help: how writes are judged).
enum class WriteVerdict : std::uint8_t {
    None,  ///< Nothing was written.
    Pending,
    Done,
    Refused,      ///< The device left it out of its answer.
    Changed,      ///< The device has another value now.
    Unconfirmed,  ///< Sent; what cannot be read cannot be confirmed.
};
/// "none", "pending", … Any thread.
const char* name(WriteVerdict verdict) noexcept;

struct ParameterState {
    std::optional<wire::Value> value{};    ///< As the device told it last.
    TimePoint at{};                        ///< When it did.
    std::optional<wire::Value> written{};  ///< What was written last and, as far as is known, still holds.
    WriteVerdict verdict = WriteVerdict::None;
};

/// How near a device is.
enum class Presence : std::uint8_t { Live, Quiet, Lost };
/// "live", "quiet", "lost". Any thread.
const char* name(Presence presence) noexcept;

/// How long a device takes to answer.
struct Latency {
    Duration median{};
    Duration p99{};
};

struct DeviceState {
    int number = 0;
    wire::Uid uid;
    SharedDeviceSpec spec;  ///< Never null; its parameters may still be found out.
    bool learning = false;  ///< Whether they are.
    std::string port;
    Presence presence = Presence::Lost;
    TimePoint heardAt{};
    std::vector<ParameterState> parameters;  ///< As many as the spec has.
    wire::ParameterMask wanted = 0;          ///< The subscription that was asked for, and its delay.
    std::uint16_t wantedDelay_ms = 0;
    wire::ParameterMask subscribed = 0;  ///< What the device granted.
    std::uint16_t delay_ms = 0;
    bool ungranted = false;  ///< It was asked for updates as often as makes sense, and granted none.
    bool disabled = false;   ///< Told to stop; the next write resumes it.
    bool driving = false;    ///< A speed other than zero was written and not taken back, or a position.
    std::optional<Latency> latency{};
    std::uint64_t samples = 0;  ///< Data messages so far.
    wire::DecoderCounts line;   ///< What its line carried and what was damaged.
    std::optional<std::uint8_t> lastError{};
};

/// What goes on at a port.
enum class PortPhase : std::uint8_t {
    Opening,
    Asking,  ///< Open: the board may still start, and is asked who it is.
    Talking,
    Silent,  ///< Nothing answered.
    Failed,  ///< It cannot be opened; `error` says why.
};
/// "opening", … Any thread.
const char* name(PortPhase phase) noexcept;

struct PortState {
    std::string name;
    std::string description;
    PortPhase phase = PortPhase::Opening;
    std::optional<Error> error{};
    int device = -1;  ///< Who answered there.
};

/// How the whole stands: it runs once the ports have been looked at, and what is at one of them is its own
/// affair.
enum class LinkState : std::uint8_t { Idle, Searching, Opening, Running, Failed };

/// Everything as it is now.
struct Snapshot {
    TimePoint time{};
    LinkState link = LinkState::Idle;
    std::optional<Error> error{};  ///< Never any: ports fail one by one.
    bool blocked = false;          ///< STOP is latched: nothing is written.
    std::vector<PortState> ports;
    std::vector<DeviceState> devices;       ///< Device n at place n.
    TimePoint stoppedAt{};                  ///< When STOP was sent to all devices last.
    std::optional<Error> catalogueError{};  ///< Why the user's catalogue was left out.
};

}  // namespace kickstand::smartdevice
