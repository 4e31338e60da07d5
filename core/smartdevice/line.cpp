#include "core/smartdevice/line.h"

#include <chrono>
#include <utility>

namespace kickstand::smartdevice {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr Baud kBaud = 115200;
/// Opening the port resets the board, which then may be silent for two seconds.
constexpr Duration kAskFor = seconds(5);
constexpr Duration kAskEvery = milliseconds(250);
/// A port that somebody else holds is tried again; it costs nothing.
constexpr Duration kRetryEvery = seconds(3);

}  // namespace

Line::Line(Scheduler& scheduler, BytePorts& ports, const BytePort& port, LineEvents events)
    : scheduler_(scheduler), events_(std::move(events)), link_(ports.makeLink(port.name, kBaud)) {
    state_.name = port.name;
    state_.description = port.description;
    link_->setReceiver([this](ByteView bytes) { received(bytes); });
    link_->setPresenceListener([this](bool present) { presence(present); });
}

void Line::start() {
    if (state_.phase == PortPhase::Asking || state_.phase == PortPhase::Talking) return;
    retryAt_.reset();
    // An error that has been shown stays until it is known to be over.
    if (state_.phase != PortPhase::Failed) state_.phase = PortPhase::Opening;
    link_->open([this](Result<ByteLinkInfo> info) { opened(std::move(info)); });
}

void Line::opened(Result<ByteLinkInfo> info) {
    if (!info) {
        if (info.error().code == Errc::Cancelled) return;
        if (info.error().code == Errc::BadArgument) {
            // It was still being closed.
            retryAt_ = scheduler_.now() + kRetryEvery;
            return;
        }
        const bool news = !state_.error || state_.error->code != info.error().code;
        state_.phase = PortPhase::Failed;
        state_.error = info.error();
        retryAt_ = scheduler_.now() + kRetryEvery;
        if (news) events_.event(EventKind::PortFailed, static_cast<std::int64_t>(info.error().code));
        return;
    }
    retryAt_.reset();
    state_.phase = PortPhase::Asking;
    state_.error.reset();
    if (!info->description.empty()) state_.description = info->description;
    current_.reset();
    hibike_.reset();
    dialect_.reset();
    asking_ = wire::Dialect::Current;
    askAt_ = scheduler_.now();
    askUntil_ = askAt_ + kAskFor;
}

void Line::step(TimePoint now) {
    if (retryAt_ && now >= *retryAt_) start();
    if (state_.phase != PortPhase::Asking) return;
    if (now >= askUntil_) {
        leave(PortPhase::Silent);
        link_->close({});
        events_.event(EventKind::PortSilent, 0);
    } else if (now >= askAt_) {
        ask(now);
    }
}

void Line::ask(TimePoint now) {
    askAt_ = now + kAskEvery;
    // A zero first ends whatever the board may have heard so far.
    const std::uint8_t flush = 0;
    static_cast<void>(link_->write({&flush, 1}));
    static_cast<void>(link_->write(wire::encodeFrame(asking_, wire::Ping{}).view()));
    asking_ = asking_ == wire::Dialect::Current ? wire::Dialect::Hibike : wire::Dialect::Current;
}

wire::Decoder& Line::decoder(wire::Dialect dialect) {
    return dialect == wire::Dialect::Current ? current_ : hibike_;
}

wire::DecoderCounts Line::counts() const {
    return dialect_ == wire::Dialect::Hibike ? hibike_.counts() : current_.counts();
}

void Line::received(ByteView bytes) {
    for (const wire::Dialect dialect : {wire::Dialect::Current, wire::Dialect::Hibike}) {
        if (dialect_ && *dialect_ != dialect) continue;
        decoder(dialect).feed(bytes,
                              [this, dialect](const wire::Message& message) { heard(dialect, message); });
    }
}

void Line::heard(wire::Dialect dialect, const wire::Message& message) {
    if (state_.phase == PortPhase::Talking) {
        if (dialect == dialect_) events_.message(message);
        return;
    }
    const auto* response = std::get_if<wire::SubscriptionResponse>(&message);
    if (response == nullptr || state_.phase != PortPhase::Asking) return;
    dialect_ = dialect;
    state_.phase = PortPhase::Talking;
    events_.identified(response->uid);
}

bool Line::send(const wire::Message& message) {
    return state_.phase == PortPhase::Talking && dialect_ &&
           link_->write(wire::encodeFrame(*dialect_, message).view()).has_value();
}

void Line::leave(PortPhase phase) {
    const bool talked = std::exchange(state_.phase, phase) == PortPhase::Talking;
    state_.device = -1;
    if (talked) events_.gone();
}

void Line::presence(bool present) {
    if (!present) {
        leave(PortPhase::Opening);
        // Where it comes back without a word, as a port that is always there does.
        retryAt_ = scheduler_.now() + kRetryEvery;
    } else {
        start();
    }
}

void Line::restart() {
    leave(PortPhase::Opening);
    link_->close([this] { start(); });
}

void Line::refuse(const Error& error) {
    leave(PortPhase::Failed);
    state_.error = error;
    link_->close({});
    events_.event(EventKind::PortFailed, static_cast<std::int64_t>(error.code));
}

void Line::close(std::function<void()> done) {
    retryAt_.reset();
    leave(PortPhase::Silent);
    link_->close(std::move(done));
}

}  // namespace kickstand::smartdevice
