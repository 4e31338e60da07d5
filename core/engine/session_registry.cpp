#include "core/engine/session_registry.h"

#include <array>
#include <string>
#include <string_view>

#include "core/coach/session.h"
#include "core/motionplan/session.h"
#include "core/smartdevice/session.h"
#include "core/thunderbots/session.h"

namespace kickstand {
namespace {

/// Many boards have many parameters, each seldom as fast as a robot's: more series, each shorter, in less
/// memory than the robots' take.
constexpr TelemetryLimits kManyBoards{.series = 512, .samples = 30'000, .pastBlocks = 4'000};

using Maker = Result<MadeSession> (*)(const LinkUri&, LinkProvider&, const SessionEnvironment&);

struct System {
    std::string_view name;
    bool (*takes)(const LinkUri& uri);
    Maker make;
};

Result<MadeSession> makeThunderbots(const LinkUri& uri, LinkProvider& links,
                                    const SessionEnvironment& environment) {
    auto provided = links.makeUsbLink(uri, environment.scheduler);
    if (!provided) return fail(provided.error());
    MadeSession made;
    made.keepAlive = std::move(provided->keepAlive);
    made.sim = provided->sim;
    thunderbots::Session::Host host{environment.scheduler, environment.stop, environment.samples,
                                    environment.event, environment.answer};
    made.session = std::make_unique<SystemSessionOf<thunderbots::Session, thunderbots::Command>>(
        std::move(host), std::move(provided->link));
    return made;
}

/// A session that works over one serial line.
template <class Session, class SystemCommandType>
Result<MadeSession> makeOnLine(const LinkUri& uri, LinkProvider& links,
                               const SessionEnvironment& environment) {
    auto provided = links.makeByteLink(uri, environment.scheduler);
    if (!provided) return fail(provided.error());
    MadeSession made;
    made.keepAlive = std::move(provided->keepAlive);
    made.sim = provided->sim;
    typename Session::Host host{environment.scheduler, environment.stop, environment.samples,
                                environment.event, environment.answer};
    made.session = std::make_unique<SystemSessionOf<Session, SystemCommandType>>(std::move(host),
                                                                                 std::move(provided->link));
    return made;
}

/// Whether a URI is of the system that is simulated, and spoken to over a serial port, under this name.
bool isOnLine(const LinkUri& uri, std::string_view system) {
    if (uri.scheme == "sim") return uri.target == system;
    const auto protocol = uri.options.find("protocol");
    return uri.scheme == "serial" && protocol != uri.options.end() && protocol->second == system;
}

Result<MadeSession> makeSmartDevices(const LinkUri& uri, LinkProvider& links,
                                     const SessionEnvironment& environment) {
    auto provided = links.makeBytePorts(uri, environment.scheduler);
    if (!provided) return fail(provided.error());
    MadeSession made;
    made.keepAlive = std::move(provided->keepAlive);
    made.sim = provided->sim;
    made.telemetry = kManyBoards;
    smartdevice::Session::Host host{environment.scheduler, environment.stop, environment.samples,
                                    environment.event, environment.answer};
    made.session = std::make_unique<SystemSessionOf<smartdevice::Session, smartdevice::Command>>(
        std::move(host), smartdevice::SessionParts{std::move(provided->ports), std::move(provided->catalogue),
                                                   std::move(provided->catalogueSource)});
    return made;
}

/// Without a protocol a serial port is one for smart devices.
bool isSmartDevices(const LinkUri& uri) {
    return isOnLine(uri, "smartdevice") || (uri.scheme == "serial" && !uri.options.contains("protocol"));
}

bool isMotionplan(const LinkUri& uri) {
    return isOnLine(uri, "motionplan");
}

bool isCoach(const LinkUri& uri) {
    return isOnLine(uri, "coach");
}

bool isThunderbots(const LinkUri& uri) {
    if (uri.scheme == "sim") return uri.target == "thunderbots";
    return uri.scheme == "usb" || uri.scheme == "usb-cable" || uri.scheme == "usbip";
}

constexpr std::array kSystems{
    System{"thunderbots", isThunderbots, makeThunderbots},
    System{"smartdevice", isSmartDevices, makeSmartDevices},
    System{"motionplan", isMotionplan, makeOnLine<motionplan::Session, motionplan::Command>},
    System{"coach", isCoach, makeOnLine<coach::Session, coach::Command>},
};

}  // namespace

Result<MadeSession> makeSession(const LinkUri& uri, LinkProvider& links,
                                const SessionEnvironment& environment) {
    for (const System& system : kSystems) {
        if (system.takes(uri)) return system.make(uri, links, environment);
    }
    std::string known;
    for (const System& system : kSystems)
        known += (known.empty() ? "the systems here are " : ", ") + std::string(system.name);
    return fail(Errc::Unsupported, toString(uri), std::move(known));
}

}  // namespace kickstand
