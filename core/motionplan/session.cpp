#include "core/motionplan/session.h"

#include <utility>

#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan {

using wire::MessageKind;

Session::Session(Host host, std::unique_ptr<ByteLink> link)
    : host_(std::move(host)),
      link_(std::move(link)),
      model_([this](const Event& event) {
          ++version_;
          host_.event(event);
      }),
      station_(hooks()),
      nxtStatus_(wire::kStatusMailboxEmpty) {
    link_->setReceiver([this](ByteView bytes) {
        ++version_;
        station_.received(bytes, host_.scheduler.now());
    });
    link_->setPresenceListener([this](bool present) { presence(present); });
}

Session::~Session() {
    host_.scheduler.cancel(shutdownDeadline_);
}

Station::Hooks Session::hooks() {
    Station::Hooks hooks;
    hooks.write = [this](ByteView bytes) { return link_->write(bytes); };
    hooks.maySend = [this](const wire::Message& message) { return maySend(message); };
    hooks.message = [this](const wire::Message& message, bool belonged) { heard(message, belonged); };
    hooks.malformed = [this](const Error& error) {
        ++malformed_;
        malformedText_ = error.subject;
    };
    hooks.nxtStatus = [this](std::uint8_t status) {
        const std::uint8_t before = std::exchange(nxtStatus_, status);
        const bool fine = status == wire::kStatusSuccess || status == wire::kStatusMailboxEmpty;
        const bool wasFine = before == wire::kStatusSuccess || before == wire::kStatusMailboxEmpty;
        if (status != before && !(fine && wasFine)) raise(EventKind::NxtStatus, status);
        if (!std::exchange(answers_, true)) ++version_;
    };
    hooks.answering = [this](int missed) { answering(missed); };
    return hooks;
}

void Session::raise(EventKind kind, std::int64_t code, std::int64_t previous, std::string text) {
    ++version_;
    host_.event(Event{kind, host_.scheduler.now(), -1, code, previous, 0, std::move(text)});
}

void Session::start() {
    open();
}

void Session::open() {
    state_ = LinkState::Opening;
    ++version_;
    link_->open([this](const Result<ByteLinkInfo>& result) { opened(result); });
}

void Session::opened(const Result<ByteLinkInfo>& result) {
    ++version_;
    if (state_ != LinkState::Opening) return;
    if (!result) {
        error_ = result.error();
        const bool mayCome =
            result.error().code == Errc::NoDevice || result.error().code == Errc::Disconnected;
        state_ = mayCome ? LinkState::Searching : LinkState::Failed;
        if (mayCome)
            raise(EventKind::Waiting);
        else
            raise(EventKind::LinkFailed, static_cast<std::int64_t>(error_->code), 0, error_->port);
        return;
    }
    error_.reset();
    port_ = *result;
    state_ = LinkState::Running;
    answers_ = false;
    nxtStatus_ = wire::kStatusMailboxEmpty;
    startedHere_ = false;
    triggerAsked_ = false;
    stop_ = StopState::None;
    ++connections_;
    model_.forget();
    station_.reset(Errc::Cancelled);
    raise(EventKind::Connected);
    if (host_.stop.isSet()) sendStop(Errc::StopLatched);
}

void Session::presence(bool present) {
    if (ending_) return;
    if (present && state_ == LinkState::Searching) open();
    if (!present && state_ == LinkState::Running) lost();
}

void Session::lost() {
    state_ = LinkState::Searching;
    error_ = Error{.code = Errc::Disconnected, .port = port_.port};
    const bool executing = active();
    const bool starts = !model_.trigger().known || model_.trigger().plan != wire::kNoPlan;
    // Its trigger plan starts, or may, or what executes goes on: nothing that is sent reaches it now.
    model_.outOfReach(true);
    station_.reset(Errc::Disconnected);
    answers_ = false;
    raise(EventKind::LinkLost, executing ? 1 : 0);
    if (executing || starts) host_.stop.set(StopReason::LinkLost);
    raise(EventKind::Waiting);
}

void Session::step(TimePoint now, bool heartbeatFresh) {
    const bool wasFresh = std::exchange(heartbeatFresh_, heartbeatFresh);
    if (state_ != LinkState::Running) return;
    // A plan runs without keep-alives: nobody who watches means that it is stopped.
    if (wasFresh && !heartbeatFresh && startedHere_ && active() && host_.stop.set(StopReason::HeartbeatStale))
        halt();
    askTrigger();
    const bool hadRequest = !station_.idle();
    station_.tick(now, active());
    model_.tick(now);
    tellMalformed(now);
    if (hadRequest || !station_.idle()) ++version_;
}

void Session::askTrigger() {
    if (triggerAsked_ || ending_ || !answers_ || nxtStatus_ == wire::kStatusNoProgram) return;
    // What a person asks goes first, and may ask for the same.
    if (model_.trigger().known || !station_.idle()) return;
    wire::Message message;
    message.kind = MessageKind::Trigger;
    message.plan = wire::kFirstPlan;
    const auto queued = station_.submit({std::move(message), true}, [this](const Exchange& exchange) {
        ended(exchange);
        if (exchange.result()) return;
        // What came and says nothing would say nothing again; what was broken off is asked for once more.
        const Error& error = exchange.result().error();
        const bool ofProgram = error.code == Errc::NxtRefused && error.got == wire::kStatusNoProgram;
        triggerAsked_ = !ofProgram && (error.code == Errc::Malformed || error.code == Errc::NxtRefused);
    });
    triggerAsked_ = queued.has_value();
}

void Session::tellMalformed(TimePoint now) {
    if (malformed_ == 0 || now - malformedAt_ < kMalformedEvery) return;
    malformedAt_ = now;
    raise(EventKind::Malformed, std::exchange(malformed_, 0), 0, malformedText_);
}

Result<void> Session::maySend(const wire::Message& message) {
    const bool execute = message.kind == MessageKind::Execute;
    const bool adjust = message.kind == MessageKind::Adjust;
    const bool harmless = message.kind == MessageKind::Stop || message.kind == MessageKind::Query;
    if (harmless) return {};
    if (host_.stop.isSet()) return fail(Errc::StopLatched);
    // Whatever was so when it was asked for: it may have waited behind what has changed that.
    if (execute && active()) return fail(Errc::PlanExecuting);
    if (auto fits = adjust ? checkAdjust(message) : checkSlot(message); !fits) return fits;
    if (execute || adjust) startedHere_ = true;
    if (execute) model_.executeSent(message, host_.scheduler.now());
    return {};
}

void Session::halt() {
    ++version_;
    if (state_ == LinkState::Running) sendStop(Errc::StopLatched);
}

void Session::sendStop(Errc why) {
    stop_ = StopState::UnderWay;
    // One that is under way ends here, and leaves what is to be told to the new one.
    station_.stopNow(host_.scheduler.now(), why, [this, number = ++stops_](const Exchange& exchange) {
        if (number == stops_) stopEnded(exchange);
    });
}

void Session::stopEnded(const Exchange& exchange) {
    const TimePoint now = host_.scheduler.now();
    // One that was sent again finds nothing to stop where the first has worked.
    const bool nothing = exchange.wasIdle() && exchange.attempts() == 1;
    stop_ = exchange.result() ? StopState::Confirmed : StopState::Unconfirmed;
    if (exchange.result()) {
        stopConfirmedAt_ = now;
        model_.stopped(nothing, now);
    } else {
        raise(EventKind::StopUnconfirmed);
    }
    for (const CommandId id : std::exchange(stopAskers_, {}))
        host_.answer(id, nothing ? Result<void>(fail(refusalError(Errc::PlanRefused, wire::kErrorStopIdle)))
                                 : exchange.result());
    if (shutDown_) close();
}

void Session::heard(const wire::Message& message, bool belonged) {
    const TimePoint now = host_.scheduler.now();
    if (message.kind == MessageKind::Status) {
        // Where it belongs to a Stop, the end of that tells.
        const bool ofStop = belonged && message.step == 0;
        if (!ofStop) model_.status(message, now);
    } else if (message.kind == MessageKind::Query && message.plan != wire::kDummyPlan) {
        // What belongs to a request is known with its end.
        if (!belonged) model_.slotRead(message.slot, message.plan, now);
    } else if (message.kind == MessageKind::Error) {
        if (message.error == wire::kErrorStopIdle || message.error == wire::kErrorAdjustIdle)
            model_.idle(now);
        // And told with it.
        if (!belonged) raise(EventKind::Refused, message.error, 1);
    }
}

void Session::answering(int missed) {
    if (missed == 0) {
        if (!std::exchange(answers_, true)) raise(EventKind::Answers);
    } else if (missed == Station::kSilentAfter) {
        answers_ = false;
        raise(EventKind::Silent, missed);
    }
}

void Session::shutdown(std::function<void()> done) {
    ending_ = true;
    shutDown_ = std::move(done);
    ++version_;
    const bool stops = active() && startedHere_;
    const bool stopping = stop_ == StopState::UnderWay;
    if (state_ != LinkState::Running || (!stops && !stopping)) {
        close();
        return;
    }
    shutdownDeadline_ = host_.scheduler.callAfter(kLastStopLimit, [this] { close(); });
    if (!stopping) sendStop(Errc::Cancelled);
}

void Session::close() {
    host_.scheduler.cancel(std::exchange(shutdownDeadline_, 0));
    if (!shutDown_) return;
    const bool wasRunning = state_ == LinkState::Running;
    state_ = LinkState::Idle;
    const std::function<void()> done = std::exchange(shutDown_, {});
    station_.reset(Errc::Cancelled);
    if (wasRunning) raise(EventKind::Disconnected);
    link_->close(done);
}

Snapshot Session::snapshot() const {
    Snapshot snapshot;
    snapshot.time = host_.scheduler.now();
    snapshot.link = state_;
    snapshot.error = error_;
    snapshot.port = port_;
    snapshot.answers = answers_;
    snapshot.nxtStatus = nxtStatus_;
    snapshot.slotStates = model_.slots();
    snapshot.trigger = model_.trigger();
    snapshot.execution = model_.execution();
    snapshot.request = station_.request();
    snapshot.stop = stop_;
    snapshot.stopConfirmedAt = stopConfirmedAt_;
    snapshot.outOfReach = model_.isOutOfReach();
    snapshot.traffic = station_.traffic();
    snapshot.connections = connections_;
    return snapshot;
}

}  // namespace kickstand::motionplan
