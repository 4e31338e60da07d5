#include "core/thunderbots/session.h"

#include <utility>

#include "core/thunderbots/wire/readings.h"

namespace kickstand::thunderbots {
namespace {

/// Just before the dongle's dead-man acts (protocol 3.5).
constexpr Duration kSilenceLimit = std::chrono::milliseconds(1800);

}  // namespace
namespace {

/// A dongle that has not taken the last blocks by then takes none: its own dead-man brakes the robots.

}  // namespace

Session::Session(Host host, std::unique_ptr<UsbLink> link)
    : host_(std::move(host)),
      link_(std::move(link), host_.scheduler),
      kickLog_(host_.samples, [this](const Event& event) { host_.event(event); }),
      model_(kickLog_, [this](const Event& event) { modelEvent(event); }),
      controller_(host_.scheduler, link_, host_.stop, [this] { stateChanged(); }),
      requests_(host_.scheduler, controller_.messages()),
      parameters_(host_.scheduler, requests_, host_.event),
      flash_(
          host_.scheduler, requests_,
          [this](int robot) { return checkAtRest(robot, flashOptions_[static_cast<std::size_t>(robot)]); },
          [this] { return controller_.isCable(); }, [this] { return model_.channels(); },
          [this](int robot) { raise(EventKind::FlashPaused, robot); },
          [this](int robot, const FlashProgress& progress) { flashEnded(robot, progress); }) {
    link_.addObserver(&model_);
    controller_.setMessageListener([this](ByteView packet) { requests_.received(packet); });
}

Session::~Session() {
    host_.scheduler.cancel(shutdownDeadline_);
    host_.scheduler.cancel(restartDeadline_);
}

void Session::start() {
    ++version_;
    controller_.start();
}

void Session::raise(EventKind kind, int robot, std::int64_t code, std::int64_t previous, std::string text) {
    host_.event(Event{kind, host_.scheduler.now(), robot, code, previous, 0, std::move(text)});
}

bool Session::active() const {
    for (const RobotDriver& driver : drivers_) {
        if (driver.intent().active()) return true;
    }
    return kickOutstanding_;
}

void Session::modelEvent(const Event& event) {
    // A discharge gives very many short pulses: that it began and how it ended is all that is to be told.
    if (event.kind != EventKind::KickGiven || kickLog_.expectsKick()) host_.event(event);
    if (event.robot >= 0) kickLog_.heard(event, model_.robot(event.robot));
    if (event.kind == EventKind::RobotLost) robotLost(event.robot, event.time);
    if (event.kind == EventKind::RobotFound) {
        driver(event.robot).halt();
        sendBlock(event.robot);
        requests_.found(event.robot);
        if (controller_.state() == LinkState::Running) flash_.found(event.robot);
        parameters_.found(event.robot);
    }
    const auto run = static_cast<std::int64_t>(wire::EStop::Run);
    if (event.kind == EventKind::EmergencyStop && event.previous == run && event.code != run &&
        host_.stop.set(StopReason::EmergencyStop))
        halt();
}

void Session::robotLost(int robot, TimePoint time) {
    // A check goes on to the next robot, which nothing moves before a person has said so: where nothing but
    // the check was at work, the loss is the lost robot's alone.
    const bool checked =
        checker_.running(robot) && model_.isOpen() && model_.status().radios == wire::RadioState::Running;
    const bool wasActive = checked ? othersBusy(robot) : active();
    if (checker_.running(robot)) checkedRobotLost(robot);
    if (discharger_.running(robot)) {
        discharger_.end(robot);
        host_.event(Event{EventKind::DischargeEnded,
                          time,
                          robot,
                          static_cast<std::int64_t>(Errc::RobotNotAlive),
                          0,
                          model_.robot(robot).readings.capacitor_V,
                          {}});
    }
    if (sweeper_.running(robot)) endSweep(model_.isOpen() ? Errc::RobotNotAlive : Errc::Disconnected);
    driver(robot).halt();
    sendBlock(robot);
    // A robot that was told to reboot goes away for a while: nothing is wrong, and nobody is surprised.
    const bool rebooting = requests_.rebooting(robot) || flash_.expectsLoss(robot);
    const bool expected = rebooting && model_.isOpen();
    const Errc why = model_.isOpen() ? Errc::RobotNotAlive : Errc::Disconnected;
    requests_.lost(robot, why);
    flash_.lost(robot, why);
    parameters_.lost(robot, aliveRobots());
    if (expected) return;
    // With its radios down a dongle loses all of them at once: that is the link, not a robot.
    const bool radios = model_.status().radios == wire::RadioState::Running;
    const StopReason reason = radios ? StopReason::RobotLost : StopReason::LinkLost;
    if (wasActive && model_.isOpen() && host_.stop.set(reason)) halt();
}

void Session::halt() {
    controller_.messages().dropKicks(Errc::StopLatched);
    haltDrivers();
    if (host_.stop.isSet()) flash_.pause();
    if (controller_.state() == LinkState::Running) controller_.stateTransport().brakeAll();
}

void Session::haltDrivers() {
    if (sweeper_.running()) endSweep(Errc::StopLatched);
    if (checker_.running()) endCheck(Errc::StopLatched);
    for (int robot = 0; robot < kRobots; ++robot) {
        if (discharger_.running(robot)) {
            discharger_.end(robot);
            raise(EventKind::DischargeEnded, robot, static_cast<std::int64_t>(Errc::StopLatched));
        }
        driver(robot).halt();
    }
    ++version_;
}

void Session::resetConnection() {
    haltDrivers();
    wheelLimit_ = kStartingWheelLimit;
    kickOutstanding_ = false;
    sweepKickOutstanding_ = false;
}

void Session::stateChanged() {
    ++version_;
    const LinkState state = controller_.state();
    const LinkState before = std::exchange(lastState_, state);
    if (state == before) return;
    if (before == LinkState::Running) {
        if (sweeper_.running()) endSweep(Errc::Disconnected);
        if (checker_.running()) endCheck(Errc::Disconnected);
        resetConnection();
        if (!wentWithItsRobot()) host_.stop.set(StopReason::LinkLost);
        const bool gone = state == LinkState::Searching;
        raise(EventKind::LinkLost, -1, 0, 0,
              gone ? link_.health().lostBecause : "the device is there, and failed");
    }
    if (state == LinkState::Running) {
        ++connections_;
        raise(EventKind::Connected);
        // A robot on a cable is heard before it can be asked anything.
        for (int robot = 0; robot < kRobots; ++robot) {
            if (model_.robot(robot).live) flash_.found(robot);
        }
    } else if (state == LinkState::Searching) {
        raise(EventKind::Waiting);
    } else if (state == LinkState::Failed) {
        const Error& error = *controller_.error();
        raise(EventKind::LinkFailed, -1, static_cast<std::int64_t>(error.code), 0, error.subject);
    }
}

void Session::step(TimePoint now, bool heartbeatFresh) {
    model_.tick(now);
    kickLog_.tick(now);
    flash_.tick(now);
    if (controller_.state() != LinkState::Running) {
        heartbeatFresh_ = heartbeatFresh;
        return;
    }
    brakeForStaleHeartbeat(heartbeatFresh);
    stopAfterSilence();
    sendRamps(now);
    for (int robot = 0; robot < kRobots; ++robot) {
        if (discharger_.running(robot)) stepDischarge(robot, now);
    }
    if (sweeper_.running()) stepSweep(now);
    if (checker_.running()) stepCheck(now);
    if (heartbeatFresh) controller_.stateTransport().keepAliveIfDue();
}

void Session::brakeForStaleHeartbeat(bool fresh) {
    if (std::exchange(heartbeatFresh_, fresh) == fresh || fresh) return;
    if (active()) host_.stop.set(StopReason::HeartbeatStale);
    halt();
}

void Session::stopAfterSilence() {
    // With a fresh heartbeat something goes every 300 ms. Where the link has taken nothing for so long, the
    // dongle's own dead-man has braked the robots, and what is wanted of them is not what they do.
    if (!heartbeatFresh_ || !active() || controller_.stateTransport().silence() < kSilenceLimit) return;
    host_.stop.set(StopReason::LinkLost);
    halt();
}

void Session::sendRamps(TimePoint now) {
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!driver(robot).ramping()) continue;
        driver(robot).advance(now, wheelLimit_ <= kStartingWheelLimit);
        sendBlock(robot);
        ++version_;
    }
}

void Session::sendBlock(int robot) {
    if (controller_.state() != LinkState::Running) return;
    if (controller_.stateTransport().set(robot, driver(robot).block())) return;
    // Every command is checked against the wire before it is taken, so this is a fault of this program. A
    // robot that cannot be told what it should do is told to stop, never left with what it was told before.
    driver(robot).halt();
    static_cast<void>(controller_.stateTransport().set(robot, wire::brakedBlock()));
}

void Session::beginDischarge(int robot) {
    const double capacitor_V = model_.robot(robot).readings.capacitor_V;
    driver(robot).setDischarging(true);
    sendBlock(robot);
    discharger_.begin(robot, capacitor_V, host_.scheduler.now());
    host_.event(Event{EventKind::DischargeStarted, host_.scheduler.now(), robot, 0, 0, capacitor_V, {}});
}

void Session::stepDischarge(int robot, TimePoint now) {
    using Finding = Discharger::Finding;
    const Finding finding = discharger_.look(robot, model_.robot(robot), now);
    switch (finding) {
        case Finding::Wait:
            return;
        case Finding::Pulse:
            if (kickOutstanding_) return;
            discharger_.pulsed(robot, now);
            giveKick(robot, Discharger::kPulse, std::nullopt, [](const Result<void>&) {});
            return;
        case Finding::Empty:
            endDischarge(robot, 0);
            return;
        case Finding::NoEffect:
            endDischarge(robot, static_cast<std::int64_t>(Errc::NotDischarging));
            return;
        case Finding::Unknown:
            endDischarge(robot, static_cast<std::int64_t>(Errc::ReadingsUnknown));
            return;
    }
}

void Session::endDischarge(int robot, std::int64_t code) {
    discharger_.end(robot);
    driver(robot).setDischarging(false);
    ++version_;
    host_.event(Event{EventKind::DischargeEnded,
                      host_.scheduler.now(),
                      robot,
                      code,
                      0,
                      model_.robot(robot).readings.capacitor_V,
                      {}});
}

void Session::shutdown(std::function<void()> done) {
    ending_ = true;
    for (int robot = 0; robot < kRobots; ++robot)
        flash_.cancel(robot);
    if (controller_.state() != LinkState::Running) {
        resetConnection();
        lastState_ = LinkState::Idle;
        ++version_;
        controller_.close(std::move(done));
        return;
    }
    halt();
    shutDown_ = std::move(done);
    shutdownDeadline_ = host_.scheduler.callAfter(kLastBlocksLimit, [this] { close(); });
    controller_.stateTransport().whenDrained([this](bool) { close(); });
}

void Session::close() {
    host_.scheduler.cancel(std::exchange(shutdownDeadline_, 0));
    auto done = std::exchange(shutDown_, {});
    // Closing ends what still waits for the last blocks, and that is this again.
    if (!done) return;
    raise(EventKind::Disconnected);
    lastState_ = LinkState::Idle;
    ++version_;
    controller_.close(std::move(done));
}

Snapshot Session::snapshot() const {
    Snapshot snapshot;
    snapshot.time = host_.scheduler.now();
    snapshot.link = controller_.state();
    snapshot.error = controller_.error();
    snapshot.device = controller_.device();
    snapshot.roundTrip = link_.health().roundTrip;
    snapshot.cable = controller_.isCable();
    snapshot.eStop = model_.status().eStop;
    snapshot.radios = model_.status().radios;
    snapshot.channels = model_.channels();
    snapshot.radioVersions = model_.radioVersions();
    snapshot.wheelLimit = wheelLimit_;
    snapshot.kicks = kickLog_.records();
    snapshot.charges = kickLog_.charges();
    snapshot.sweep = sweeper_.progress();
    snapshot.check = checker_.progress();
    snapshot.traffic = model_.traffic();
    snapshot.connections = connections_;
    for (int robot = 0; robot < kRobots; ++robot) {
        snapshot.robots[static_cast<std::size_t>(robot)] = model_.robot(robot);
        snapshot.intents[static_cast<std::size_t>(robot)] = driver(robot).intent();
        snapshot.requests[static_cast<std::size_t>(robot)] = requests_.state(robot);
        if (const FlashProgress* progress = flash_.progress(robot))
            snapshot.flash[static_cast<std::size_t>(robot)] = *progress;
        snapshot.parameters[static_cast<std::size_t>(robot)] = parameters_.state(robot);
    }
    return snapshot;
}

}  // namespace kickstand::thunderbots
