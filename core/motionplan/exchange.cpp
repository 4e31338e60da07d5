#include "core/motionplan/exchange.h"

#include <algorithm>
#include <utility>

#include "core/base/hex.h"
#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan {
namespace {

using wire::MessageKind;

bool same(ByteView a, ByteView b) {
    return std::ranges::equal(a, b);
}

/// What lies there may be no trigger plan at all; nothing is none too.
Result<void> checkTrigger(ByteView content) {
    if (content.empty()) return {};
    const auto message = wire::decodeMessage(content);
    if (message && message->kind == MessageKind::Trigger) return {};
    return fail({.code = Errc::Malformed, .subject = "trigger plan", .detail = toHex(content)});
}

std::string hexOrNothing(ByteView bytes) {
    return bytes.empty() ? "nothing" : toHex(bytes);
}

tl::unexpected<Error> refusal(int errorCode) {
    return fail(refusalError(Errc::PlanRefused, errorCode));
}

}  // namespace

Error refusalError(Errc code, int errorCode) {
    const wire::ErrorCode why = wire::errorCode(errorCode);
    return {.code = code, .subject = why.id, .got = errorCode, .detail = why.text};
}

Exchange::Exchange(Request request, TimePoint now, std::function<bool(ByteView)> isLate)
    : request_(std::move(request)), isLate_(std::move(isLate)), leftovers_(request_.leftovers) {
    if (request_.readsTrigger) {
        enter(Phase::Echo, now + kEchoLimit);
        attempts_ = 1;
        return;
    }
    const auto bytes = wire::encodeMessage(request_.message);
    if (!bytes) {
        finish(fail(bytes.error()));
        return;
    }
    bytes_ = *bytes;
    // The trigger plan has an outbox of its own, which holds one message and is no queue.
    if (request_.urgent || request_.message.kind == MessageKind::Trigger)
        send(now);
    else
        enter(Phase::Drain, now + kDrainLimit);
}

std::optional<wire::Message> Exchange::takeMessage() {
    return std::exchange(outgoing_, std::nullopt);
}

bool Exchange::readsTriggerBox() const {
    return !done() && (request_.readsTrigger || request_.message.kind == MessageKind::Trigger);
}

bool Exchange::neverAgain() const {
    return request_.message.kind == MessageKind::Execute || request_.message.kind == MessageKind::Adjust;
}

int Exchange::attemptsAllowed() const {
    return request_.urgent ? kStopAttempts : kAttempts;
}

void Exchange::enter(Phase phase, TimePoint deadline) {
    phase_ = phase;
    deadline_ = deadline;
}

void Exchange::finish(Result<void> result) {
    phase_ = Phase::Done;
    result_ = std::move(result);
}

void Exchange::abort(Errc code) {
    if (!done()) finish(fail(code, wire::name(request_.message.kind)));
}

void Exchange::withhold(Error why) {
    outgoing_.reset();
    attempts_ = std::max(attempts_ - 1, 0);
    finish(fail(std::move(why)));
}

void Exchange::send(TimePoint now) {
    outgoing_ = request_.message;
    ++attempts_;
    echoed_ = false;
    enter(Phase::Echo, now + kEchoLimit);
}

void Exchange::emptied(TimePoint now) {
    if (std::exchange(leftovers_, false) && copySeen_) send(now);
    if (phase_ != Phase::Drain) return;
    if (slotQueries_ == 0) {
        send(now);
        return;
    }
    wire::Message query;
    query.kind = MessageKind::Query;
    query.plan = wire::kDummyPlan;
    query.slot = request_.message.slot;
    outgoing_ = query;
    enter(Phase::SlotAnswer, now + kEchoLimit);
}

void Exchange::echoed(TimePoint now) {
    oddCopy_.reset();
    switch (request_.message.kind) {
        case MessageKind::Query:
            enter(Phase::Answer, now + kEchoLimit);
            break;
        case MessageKind::Create:
        case MessageKind::Update:
            // An error that follows may be lost: what is in the slot then tells.
            if (phase_ != Phase::SlotAnswer) askSlot(now);
            break;
        case MessageKind::Adjust:
            // The same: a robot that goes on executing says so, and again where the first was lost.
            enter(Phase::Status, now + kObeyedLimit);
            break;
        default:
            enter(Phase::Verdict, now + kVerdictLimit);
            break;
    }
}

void Exchange::askSlot(TimePoint now) {
    slotQueries_ = std::max(slotQueries_, 1);
    enter(Phase::Drain, now + kDrainLimit);
}

bool Exchange::takeError(int code) {
    if (wire::errorCode(code).about != request_.message.kind) return false;
    // A Stop that was sent again after it had worked finds nothing to stop.
    wasIdle_ = code == wire::kErrorStopIdle;
    if (wasIdle_ && (request_.urgent || attempts_ > 1))
        finish({});
    else
        finish(refusal(code));
    return true;
}

bool Exchange::takeStatus(const wire::Message& status) {
    const wire::Message& asked = request_.message;
    const bool idle = status.step == 0;
    const bool same = !idle && status.plan == asked.plan && status.slot == asked.slot;
    // After its copy the robot's rest can only be the end of what was started.
    const bool ended = idle && echoed_;
    if (asked.kind == MessageKind::Execute && (same || ended)) {
        planEnded_ = ended;
        finish({});
        return true;
    }
    if (asked.kind == MessageKind::Stop && idle && phase_ == Phase::Verdict) {
        finish({});
        return true;
    }
    // It confirms, and is news all the same.
    if (asked.kind == MessageKind::Adjust && echoed_ && (same || ended)) finish({});
    return false;
}

void Exchange::differs(const std::string& got) {
    finish(fail({.code = Errc::EchoDiffers,
                 .subject = wire::name(request_.message.kind),
                 .detail = "sent " + toHex(bytes_.view()) + ", got " + got}));
}

void Exchange::giveUp(Errc code) {
    if (oddCopy_)
        differs(*oddCopy_);
    else
        finish(fail(code, arrivedOnly() ? "adjust-arrived" : wire::name(request_.message.kind)));
}

bool Exchange::arrivedOnly() const {
    return request_.message.kind == MessageKind::Adjust && echoed_;
}

bool Exchange::received(ByteView bytes, TimePoint now) {
    // Before anything was sent nothing that comes belongs here; afterwards it does while drained too.
    if (done() || attempts_ == 0 || request_.readsTrigger) return false;
    const bool copy = same(bytes, bytes_.view());
    if (leftovers_) {
        // The copy, the word that nothing executes: all of it may be of a Stop of before.
        copySeen_ = copySeen_ || copy;
        return copy;
    }
    if (copy) {
        if (!std::exchange(echoed_, true)) echoed(now);
        return true;
    }
    const auto message = wire::decodeMessage(bytes);
    if (message && message->kind == MessageKind::Error) return takeError(message->error);
    if (message && message->kind == MessageKind::Status) return takeStatus(*message);
    if (message && message->kind == MessageKind::Query && takeQuery(*message, now)) return true;
    return takeOddCopy(bytes, message);
}

bool Exchange::takeOddCopy(ByteView bytes, const Result<wire::Message>& message) {
    const MessageKind kind = request_.message.kind;
    const bool awaited = !echoed_ || phase_ == Phase::Answer;
    if (!awaited || kind == MessageKind::Trigger || isLate_(bytes)) return false;
    if (message && message->kind == MessageKind::Query) {
        // Of a slot that was asked for before: late. What else may name another slot is a query's.
        wire::Message asked = *message;
        asked.plan = wire::kDummyPlan;
        const auto query = wire::encodeMessage(asked);
        if (kind != MessageKind::Query || (query && isLate_(query->view()))) return false;
    }
    oddCopy_ = hexOrNothing(bytes);
    // The robot has understood something else. A query may be asked again, and Stop has to be.
    const std::uint8_t first = bytes.empty() ? 0 : bytes[0];
    if (request_.urgent || kind == MessageKind::Query || first != bytes_[0]) return false;
    differs(*oddCopy_);
    return true;
}

bool Exchange::takeQuery(const wire::Message& message, TimePoint now) {
    if (message.slot != request_.message.slot) return false;
    const bool echo = message.plan == wire::kDummyPlan;
    if (phase_ == Phase::SlotAnswer) {
        if (!echo) slotKnown(message.plan, now);
        return true;
    }
    if (request_.message.kind != MessageKind::Query) return false;
    answeredPlan_ = message.plan;
    finish({});
    return true;
}

void Exchange::triggerRead(ByteView message) {
    if (!readsTriggerBox()) return;
    triggerContent_.clear();
    hasTriggerContent_ = triggerContent_.append(message);
    if (request_.readsTrigger)
        finish(checkTrigger(message));
    else if (same(message, bytes_.view()))
        finish({});
}

void Exchange::nxtRefused(std::uint8_t status) {
    if (done()) return;
    // What is urgent is tried again whatever the NXT says.
    if (request_.urgent) return;
    finish(fail({.code = Errc::NxtRefused,
                 .subject = wire::nxtStatus(status).id,
                 .got = status,
                 .detail = wire::nxtStatus(status).text}));
}

void Exchange::slotKnown(int plan, TimePoint now) {
    answeredPlan_ = plan;
    slotQueries_ = 0;
    const wire::Message& asked = request_.message;
    const bool own = plan == asked.plan;
    const bool empty = plan == wire::kNoPlan;
    switch (asked.kind) {
        case MessageKind::Create:
            if (own)
                oddCopy_ ? differs(*oddCopy_) : finish({});
            else
                empty ? sendAgain(now) : finish(refusal(wire::kErrorSlotFull));
            break;
        case MessageKind::Update:
            if (own)
                echoed_ ? finish({}) : sendAgain(now);
            else
                finish(refusal(empty ? wire::kErrorUpdateEmptySlot : wire::kErrorUpdateOtherPlan));
            break;
        default:
            if (own)
                finish({});
            else
                finish(refusal(empty ? wire::kErrorExecuteEmptySlot : wire::kErrorExecuteOtherPlan));
            break;
    }
}

void Exchange::sendAgain(TimePoint now) {
    if (attempts_ < attemptsAllowed())
        enter(Phase::Drain, now + kDrainLimit);
    else
        giveUp(Errc::Unconfirmed);
}

void Exchange::unanswered(TimePoint now) {
    const MessageKind kind = request_.message.kind;
    if (request_.readsTrigger) {
        if (attempts_ == attemptsAllowed()) {
            finish(fail(Errc::TimedOut, "trigger"));
            return;
        }
        ++attempts_;
        enter(Phase::Echo, now + kEchoLimit);
    } else if (neverAgain()) {
        enter(Phase::Status, now + kStatusLimit);
    } else if (kind == MessageKind::Create || kind == MessageKind::Update) {
        // Whether it came is asked for before it is sent again.
        askSlot(now);
    } else if (attempts_ < attemptsAllowed()) {
        if (request_.urgent || kind == MessageKind::Trigger)
            send(now);
        else
            enter(Phase::Drain, now + kDrainLimit);
    } else if (kind == MessageKind::Trigger && hasTriggerContent_) {
        differs(hexOrNothing(triggerContent_.view()));
    } else {
        giveUp(kind == MessageKind::Query ? Errc::TimedOut : Errc::Unconfirmed);
    }
}

void Exchange::tick(TimePoint now) {
    if (done() || now < deadline_) return;
    switch (phase_) {
        case Phase::Drain:
            // The outbox cannot be read, or never ends.
            giveUp(attempts_ == 0 ? Errc::TimedOut : Errc::Unconfirmed);
            break;
        case Phase::Echo:
        case Phase::Answer:
            unanswered(now);
            break;
        case Phase::Verdict:
            // Where no status says that it executes its error may be lost: what is in the slot then tells.
            request_.message.kind == MessageKind::Execute ? askSlot(now) : finish({});
            break;
        case Phase::SlotAnswer:
            if (++slotQueries_ <= kAttempts)
                enter(Phase::Drain, now + kDrainLimit);
            else
                giveUp(Errc::Unconfirmed);
            break;
        case Phase::Status:
            giveUp(Errc::Unconfirmed);
            break;
        case Phase::Done:
            break;
    }
}

}  // namespace kickstand::motionplan
