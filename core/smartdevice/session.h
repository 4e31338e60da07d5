#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/session_host.h"
#include "core/link/byte_ports.h"
#include "core/smartdevice/catalogue.h"
#include "core/smartdevice/commands.h"
#include "core/smartdevice/device.h"
#include "core/smartdevice/events.h"
#include "core/smartdevice/line.h"
#include "core/smartdevice/snapshot.h"

namespace kickstand::smartdevice {

/// What a session is made with.
struct SessionParts {
    std::unique_ptr<BytePorts> ports;
    std::string userCatalogue;        ///< The text of the user's catalogue file; empty for none.
    std::string userCatalogueSource;  ///< Where it was read from, for what is said about it.
};

/// All boards of a kit: the ports that they come and go at, and each board over all the times that it is
/// there. Boards are known by their UIDs. Engine thread.
class Session {
  public:
    using Host = SessionHost<Event>;

    Session(Host host, SessionParts parts);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Begins to watch the ports.
    void start();
    /// Does a command; the answer comes through the host, now or later, exactly once.
    void execute(CommandId id, const Command& command);
    /// Every 10 ms. What drives is stopped when a person's side is not alive.
    void step(TimePoint now, bool heartbeatFresh);
    /// STOP has been latched: zero to all that drives, everything disabled.
    void halt();
    /// Whether anything was told to drive.
    bool active() const;
    /// Stops what this session drove, ends its subscriptions and closes every port.
    void shutdown(std::function<void()> done);

    std::uint64_t version() const { return version_; }
    Snapshot snapshot() const;

  private:
    struct Place {
        std::unique_ptr<Line> line;
        Device* device = nullptr;
    };

    void portsChanged(const std::vector<BytePort>& ports);
    void addPort(const BytePort& port);
    void identified(Place& place, const wire::Uid& uid);
    Device* deviceFor(const wire::Uid& uid);
    Device* makeDevice(const wire::Uid& uid, int number);
    Place* placeOf(const Device& device);
    std::ptrdiff_t pluggedIn() const;
    void perform(CommandId id, const Subscribe& command);
    void perform(CommandId id, const ReadValues& command);
    void perform(CommandId id, const WriteValues& command);
    void perform(CommandId id, const DisableDevice& command);
    void perform(CommandId id, const SearchAgain& command);
    Result<Device*> find(int number);
    void raise(EventKind kind, int device, std::string text, std::int64_t code = 0);
    void stepDevices(TimePoint now);
    void noteHalt();

    Host host_;
    SessionParts parts_;
    Catalogue catalogue_;
    std::vector<std::unique_ptr<Device>> devices_;
    std::vector<std::unique_ptr<Place>> places_;
    std::optional<Error> catalogueError_;
    bool looked_ = false;
    bool blocked_ = false;
    bool halting_ = false;  ///< STOP is latched, and not every line has taken it yet.
    bool ending_ = false;
    std::uint64_t version_ = 0;
    TimePoint stoppedAt_{};
    std::size_t closing_ = 0;
    std::function<void()> shutDown_;
};

}  // namespace kickstand::smartdevice
