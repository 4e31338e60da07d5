#include "core/coach/session.h"

#include <utility>

namespace kickstand::coach {
namespace {

/// A port that is not there is looked for this often.
constexpr Duration kReopenEvery = std::chrono::seconds(1);
/// The next slot is at most 200 ms away.
constexpr Duration kStopLimit = std::chrono::milliseconds(300);
constexpr Duration kStopLook = std::chrono::milliseconds(10);

}  // namespace

Session::Session(Host host, std::unique_ptr<ByteLink> link)
    : host_(std::move(host)),
      link_(std::move(link)),
      line_(host_.scheduler, *link_,
            {[this](const Received& message) { messageCame(message); },
             [this](const xbee::AtResponse& response) { setup_.client().response(response); },
             [this](ByteView bytes) { setup_.client().text(bytes); },
             [this](std::uint8_t status) {
                 if (status <= 1) raise(EventKind::ModuleReset);
             }}),
      setup_(host_.scheduler, *link_, line_),
      coach_(host_.scheduler, output()),
      towrp_(host_.scheduler, output()),
      series_{"A", "B", "C"} {
    link_->setPresenceListener([this](bool present) { presence(present); });
}

Session::~Session() {
    host_.scheduler.cancel(timer_);
    link_->setPresenceListener({});
}

SideOutput Session::output() {
    return {[this](std::uint16_t destination, const wire::Message& message) {
                sendMessage(destination, message);
            },
            [this](EventKind kind, int team, std::int64_t code, std::int64_t previous) {
                sideEvent(kind, team, code, previous);
            }};
}

void Session::raise(EventKind kind, int team, std::int64_t code, std::int64_t previous, std::string text) {
    host_.event(Event{kind, host_.scheduler.now(), team, code, previous, std::move(text)});
}

void Session::sample(Signal signal, Team team, double value) {
    host_.samples.sample({team, static_cast<std::uint16_t>(signal)}, host_.scheduler.now(),
                         static_cast<float>(value));
}

void Session::enter(LinkState state) {
    state_ = state;
    ++version_;
}

void Session::start() {
    open();
}

void Session::open() {
    host_.scheduler.cancel(std::exchange(timer_, 0));
    enter(LinkState::Opening);
    link_->open([this](const Result<ByteLinkInfo>& result) { opened(result); });
}

void Session::opened(const Result<ByteLinkInfo>& result) {
    if (ending_ || state_ != LinkState::Opening) return;
    if (result) {
        port_ = *result;
        error_.reset();
        askModule();
        return;
    }
    const bool news = !error_ || error_->code != result.error().code;
    error_ = result.error();
    if (error_->code == Errc::NoDevice || error_->code == Errc::Disconnected) {
        enter(LinkState::Searching);
        if (news) raise(EventKind::Waiting);
        timer_ = host_.scheduler.callAfter(kReopenEvery, [this] {
            timer_ = 0;
            if (state_ == LinkState::Searching) open();
        });
        return;
    }
    enter(LinkState::Failed);
    raise(EventKind::LinkFailed, -1, static_cast<std::int64_t>(error_->code), 0, error_->detail);
}

void Session::askModule() {
    enter(LinkState::Asking);
    setup_.ask(port_.baud, [this](const Result<FoundRadio>& radio) { moduleAnswered(radio); });
}

void Session::moduleAnswered(const Result<FoundRadio>& radio) {
    if (radio && radio->settings.mode != ModuleMode::Transparent) {
        radio_ = *radio;
        ++connections_;
        coach_.linkOpened();
        towrp_.linkOpened();
        enter(LinkState::Running);
        raise(EventKind::Connected, -1, radio_->settings.address);
        return;
    }
    if (radio) radio_ = *radio;
    enter(LinkState::NoModule);
    raise(EventKind::NoModule);
}

void Session::presence(bool present) {
    if (ending_) return;
    if (present) {
        if (state_ == LinkState::Searching) open();
        return;
    }
    setup_.cancel();
    if (settingFor_ != 0) host_.answer(std::exchange(settingFor_, 0), fail(Errc::Disconnected));
    const bool moved = coach_.moves();
    endRole(Unpairing::LinkLost);
    radio_.reset();
    Error error;
    error.code = Errc::Disconnected;
    error_ = error;
    enter(LinkState::Searching);
    raise(EventKind::LinkLost);
    if (moved) host_.stop.set(StopReason::LinkLost);
}

void Session::messageCame(const Received& message) {
    const Team team = wire::teamOf(message.source);
    coach_.received(message);
    towrp_.received(message);
    if (coach_.state() != CoachState::Off) {
        sample(Signal::Rssi_dBm, team, message.rssi_dBm);
        const bool fromBoat = wire::roleOf(message.source) == wire::Role::Towrp;
        if (fromBoat && message.message.opcode == wire::Opcode::UpdateMorale)
            sample(Signal::Morale, team, static_cast<std::int8_t>(message.message.parameter));
    }
}

void Session::sendMessage(std::uint16_t destination, const wire::Message& message) {
    wire::Message sent = message;
    if (sent.opcode == wire::Opcode::Velocity) {
        // The latch may have been set a moment ago by another thread.
        if (host_.stop.isSet()) sent.parameter = 0;
        const wire::Velocity velocity = wire::velocityOf(sent.parameter);
        const Team team = wire::teamOf(destination);
        sample(Signal::Forward_percent, team, wire::percentOf(velocity.forward));
        sample(Signal::Turn_percent, team, wire::percentOf(velocity.turn));
    }
    line_.send(destination, sent);
}

void Session::sideEvent(EventKind kind, int team, std::int64_t code, std::int64_t previous) {
    if (kind == EventKind::Paired || kind == EventKind::Unpaired) mustPassZero_ = true;
    raise(kind, team, code, previous);
}

void Session::endRole(Unpairing why) {
    coach_.end(why);
    towrp_.end(why);
    ++version_;
}

void Session::halt() {
    mustPassZero_ = true;
    ++version_;
    coach_.halt();
    towrp_.halt();
}

void Session::step(TimePoint, bool heartbeatFresh) {
    if (std::exchange(heartbeatFresh_, heartbeatFresh) != heartbeatFresh && !heartbeatFresh && active()) {
        host_.stop.set(StopReason::HeartbeatStale);
        halt();
    }
    if (host_.stop.isSet()) return;
    coach_.release();
    towrp_.release();
}

void Session::shutdown(std::function<void()> done) {
    ending_ = true;
    setup_.cancel();
    if (settingFor_ != 0) host_.answer(std::exchange(settingFor_, 0), fail(Errc::Cancelled));
    host_.scheduler.cancel(std::exchange(timer_, 0));
    shutDown_ = std::move(done);
    shutDownLimit_ = host_.scheduler.now() + kStopLimit;
    halt();
    waitForStop();
}

void Session::waitForStop() {
    if (!coach_.stopWaits() || host_.scheduler.now() >= shutDownLimit_) return close();
    timer_ = host_.scheduler.callAfter(kStopLook, [this] {
        timer_ = 0;
        waitForStop();
    });
}

void Session::close() {
    endRole(Unpairing::RoleEnded);
    const bool was =
        state_ != LinkState::Idle && state_ != LinkState::Searching && state_ != LinkState::Failed;
    enter(LinkState::Idle);
    if (was) raise(EventKind::Disconnected);
    link_->close(std::exchange(shutDown_, {}));
}

Snapshot Session::snapshot() const {
    Snapshot snapshot;
    snapshot.time = host_.scheduler.now();
    snapshot.link = state_;
    snapshot.error = error_;
    snapshot.port = port_;
    snapshot.radio = radio_;
    if (state_ == LinkState::Setting) snapshot.tries = setup_.tries();
    if (coach_.state() != CoachState::Off) snapshot.role = wire::Role::Coach;
    if (towrp_.state() != TowrpState::Off) snapshot.role = wire::Role::Towrp;
    snapshot.coach = coach_.view();
    snapshot.towrp = towrp_.view();
    snapshot.series = series_;
    snapshot.mustPassZero = mustPassZero_;
    snapshot.traffic = line_.counters();
    snapshot.entries = line_.entries();
    snapshot.connections = connections_;
    return snapshot;
}

}  // namespace kickstand::coach
