#include "core/smartdevice/session.h"

#include <algorithm>
#include <utility>

namespace kickstand::smartdevice {
namespace {

/// More ports than boards: some have something else at their end.
constexpr std::size_t kMostPorts = 64;

}  // namespace

Session::Session(Host host, SessionParts parts) : host_(std::move(host)), parts_(std::move(parts)) {}

Session::~Session() {
    // The lines first: they speak to the devices.
    places_.clear();
}

void Session::raise(EventKind kind, int device, std::string text, std::int64_t code) {
    Event event;
    event.kind = kind;
    event.time = host_.scheduler.now();
    event.robot = device;
    if (device >= 0) event.device = devices_[static_cast<std::size_t>(device)]->state().spec->name;
    event.text = std::move(text);
    event.code = code;
    host_.event(event);
    ++version_;
}

void Session::start() {
    auto catalogue = makeCatalogue(parts_.userCatalogue, parts_.userCatalogueSource);
    if (!catalogue) {
        catalogueError_ = catalogue.error();
        raise(EventKind::CatalogueBad, -1, catalogue.error().subject + ": " + catalogue.error().detail);
        catalogue = makeCatalogue();
    }
    if (catalogue) catalogue_ = std::move(*catalogue);
    parts_.ports->watch([this](const std::vector<BytePort>& ports) { portsChanged(ports); });
}

// ---- Ports and who is there.

void Session::portsChanged(const std::vector<BytePort>& ports) {
    if (ending_) return;
    looked_ = true;
    const auto isThere = [&](const std::unique_ptr<Place>& place) {
        return std::ranges::find(ports, place->line->state().name, &BytePort::name) != ports.end();
    };
    for (const auto& place : places_) {
        if (isThere(place)) continue;
        const std::string name = place->line->state().name;
        place->line->close({});
        raise(EventKind::PortGone, -1, name);
    }
    std::erase_if(places_, [&](const auto& place) { return !isThere(place); });
    for (const BytePort& port : ports) {
        const bool known = std::ranges::any_of(
            places_, [&](const auto& place) { return place->line->state().name == port.name; });
        if (!known && places_.size() < kMostPorts) addPort(port);
    }
    ++version_;
}

void Session::addPort(const BytePort& port) {
    places_.push_back(std::make_unique<Place>());
    Place& place = *places_.back();
    LineEvents events;
    events.identified = [this, &place](const wire::Uid& uid) { identified(place, uid); };
    events.message = [this, &place](const wire::Message& message) {
        place.device->message(message, host_.scheduler.now());
    };
    events.gone = [this, &place] {
        if (Device* device = std::exchange(place.device, nullptr)) {
            device->disconnected(host_.scheduler.now());
            raise(EventKind::DeviceLost, device->state().number, device->state().spec->name);
        }
    };
    events.event = [this, name = port.name](EventKind kind, std::int64_t code) {
        raise(kind, -1, name, code);
    };
    place.line = std::make_unique<Line>(host_.scheduler, *parts_.ports, port, std::move(events));
    raise(EventKind::PortFound, -1, port.name);
    place.line->start();
}

Session::Place* Session::placeOf(const Device& device) {
    const auto found =
        std::ranges::find_if(places_, [&](const auto& place) { return place->device == &device; });
    return found == places_.end() ? nullptr : found->get();
}

Device* Session::deviceFor(const wire::Uid& uid) {
    const auto known =
        std::ranges::find_if(devices_, [&](const auto& device) { return device->state().uid == uid; });
    if (known != devices_.end()) return known->get();
    const auto count = static_cast<int>(devices_.size());
    if (count < kMostKnownDevices) {
        devices_.emplace_back();
        return makeDevice(uid, count);
    }
    // More are known than can be plugged in, so that one of them is lost.
    const auto lostAt = [this](const auto& device) {
        return placeOf(*device) != nullptr ? TimePoint::max() : device->state().heardAt;
    };
    return makeDevice(uid, (*std::ranges::min_element(devices_, {}, lostAt))->state().number);
}

Device* Session::makeDevice(const wire::Uid& uid, int number) {
    DeviceHost host;
    host.send = [this, number](const wire::Message& message) {
        Place* place = placeOf(*devices_[static_cast<std::size_t>(number)]);
        return place != nullptr && place->line->send(message);
    };
    host.event = [this, number](Event event) {
        event.robot = number;
        event.device = devices_[static_cast<std::size_t>(number)]->state().spec->name;
        event.time = host_.scheduler.now();
        host_.event(event);
        ++version_;
    };
    host.answer = [this](CommandId id, Result<void> result) { host_.answer(id, std::move(result)); };
    host.changed = [this] { ++version_; };
    host.samples = &host_.samples;
    auto& device = devices_[static_cast<std::size_t>(number)];
    device = std::make_unique<Device>(number, uid, catalogue_.find(uid.device()), std::move(host));
    return device.get();
}

std::ptrdiff_t Session::pluggedIn() const {
    return std::ranges::count_if(places_, [](const auto& place) { return place->device != nullptr; });
}

void Session::identified(Place& place, const wire::Uid& uid) {
    const auto refuse = [&](Errc code, std::string detail) {
        Error error;
        error.code = code;
        error.subject = wire::toText(uid);
        error.detail = std::move(detail);
        place.line->refuse(error);
    };
    if (pluggedIn() >= kMostDevices) return refuse(Errc::QueueFull, "32 boards are the most at once");
    Device* device = deviceFor(uid);
    if (placeOf(*device) != nullptr) return refuse(Errc::BadArgument, "two boards have the same UID");
    const bool back = !device->state().port.empty();
    place.device = device;
    place.line->setDevice(device->state().number);
    device->connected(place.line->state().name, host_.scheduler.now());
    raise(back ? EventKind::DeviceBack : EventKind::DeviceFound, device->state().number,
          device->state().spec->name + " at " + place.line->state().name);
    // What was moving when everything was stopped has to stop, wherever it was meanwhile.
    if (host_.stop.isSet()) device->stop();
}

// ---- Commands.

Result<Device*> Session::find(int number) {
    if (number < 0 || number >= static_cast<int>(devices_.size()))
        return fail(Errc::UnknownName, "device " + std::to_string(number), "the devices of the list");
    Device* device = devices_[static_cast<std::size_t>(number)].get();
    if (placeOf(*device) == nullptr) return fail(Errc::NotConnected, device->state().spec->name);
    return device;
}

void Session::execute(CommandId id, const Command& command) {
    if (ending_) return host_.answer(id, fail(Errc::NotConnected));
    std::visit([this, id](const auto& own) { perform(id, own); }, command);
}

void Session::perform(CommandId id, const Subscribe& command) {
    const auto device = find(command.device);
    if (!device) return host_.answer(id, fail(device.error()));
    (*device)->subscribe(id, command, host_.scheduler.now());
}

void Session::perform(CommandId id, const ReadValues& command) {
    const auto device = find(command.device);
    if (!device) return host_.answer(id, fail(device.error()));
    (*device)->read(id, command, host_.scheduler.now());
}

void Session::perform(CommandId id, const WriteValues& command) {
    if (host_.stop.isSet()) return host_.answer(id, fail(Errc::StopLatched));
    const auto device = find(command.device);
    if (!device) return host_.answer(id, fail(device.error()));
    (*device)->write(id, command, host_.scheduler.now());
}

void Session::perform(CommandId id, const DisableDevice& command) {
    const auto device = find(command.device);
    host_.answer(id, device ? (*device)->disable() : Result<void>(fail(device.error())));
}

void Session::perform(CommandId id, const SearchAgain& /*command*/) {
    for (const auto& place : places_)
        place->line->start();
    ++version_;
    host_.answer(id, {});
}

// ---- Time, and stopping.

void Session::step(TimePoint now, bool heartbeatFresh) {
    if (std::exchange(blocked_, host_.stop.isSet()) != blocked_) ++version_;
    if (ending_) return;
    if (!heartbeatFresh && active()) host_.stop.set(StopReason::HeartbeatStale);
    for (const auto& place : places_) {
        const PortPhase before = place->line->state().phase;
        place->line->step(now);
        if (place->line->state().phase != before) ++version_;
        if (place->device != nullptr) place->device->setLineCounts(place->line->counts());
    }
    stepDevices(now);
}

void Session::stepDevices(TimePoint now) {
    for (const auto& device : devices_) {
        Place* place = placeOf(*device);
        if (place == nullptr) continue;
        device->step(now);
        if (!device->isLive()) place->line->restart();
    }
    noteHalt();
}

void Session::noteHalt() {
    if (!halting_ || std::ranges::any_of(devices_, [](const auto& device) { return device->owesStop(); }))
        return;
    halting_ = false;
    stoppedAt_ = host_.scheduler.now();
    ++version_;
}

void Session::halt() {
    blocked_ = true;
    halting_ = true;
    ++version_;
    for (const auto& device : devices_)
        device->stop();
    noteHalt();
}

bool Session::active() const {
    return std::ranges::any_of(devices_, [](const auto& device) { return device->state().driving; });
}

void Session::shutdown(std::function<void()> done) {
    ending_ = true;
    shutDown_ = std::move(done);
    parts_.ports->watch({});
    for (const auto& place : places_) {
        if (place->device == nullptr) continue;
        if (place->device->state().driving) place->device->stop();
        place->line->send(wire::SubscriptionRequest{});
    }
    closing_ = places_.size() + 1;
    const auto closed = [this] {
        if (--closing_ == 0) std::exchange(shutDown_, nullptr)();
    };
    for (const auto& place : places_)
        place->line->close(closed);
    host_.scheduler.post(closed);
}

Snapshot Session::snapshot() const {
    Snapshot snapshot;
    snapshot.time = host_.scheduler.now();
    snapshot.link = looked_ ? LinkState::Running : LinkState::Opening;
    snapshot.stoppedAt = stoppedAt_;
    snapshot.blocked = blocked_;
    snapshot.catalogueError = catalogueError_;
    for (const auto& place : places_)
        snapshot.ports.push_back(place->line->state());
    for (const auto& device : devices_)
        snapshot.devices.push_back(device->state());
    return snapshot;
}

}  // namespace kickstand::smartdevice
