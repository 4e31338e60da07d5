#include "core/motionplan/station.h"

#include <algorithm>
#include <utility>

#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan {
namespace {

/// Copies may come late, but not from before so many messages.
constexpr std::size_t kRemembered = 8;

}  // namespace

void Station::reset(Errc why) {
    readAt_.reset();
    parser_.abandon();
    missed_ = 0;
    sent_.clear();
    nextRead_ = {};
    drained_ = false;
    lastError_.reset();
    endAll(why);
}

void Station::endAll(Errc why) {
    std::deque<Waiting> queue = std::exchange(queue_, {});
    if (current_) {
        current_->abort(why);
        endCurrent();
    }
    for (Waiting& waiting : queue) {
        Exchange never(std::move(waiting.request), {}, [](ByteView) { return false; });
        never.withhold({.code = why, .subject = wire::name(never.request().message.kind)});
        waiting.done(never);
    }
}

Result<void> Station::submit(Exchange::Request request, Done done) {
    if (queue_.size() >= kQueue) return fail(Errc::QueueFull);
    queue_.push_back({std::move(request), std::move(done)});
    return {};
}

void Station::stopNow(TimePoint now, Errc why, Done done) {
    endAll(why);
    Exchange::Request stop;
    stop.message.kind = wire::MessageKind::Stop;
    stop.urgent = true;
    stop.leftovers = !drained_;
    begin({std::move(stop), std::move(done)}, now);
    pump(now);
}

void Station::begin(Waiting waiting, TimePoint now) {
    current_ = std::make_unique<Exchange>(std::move(waiting.request), now,
                                          [this](ByteView bytes) { return isLate(bytes); });
    currentDone_ = std::move(waiting.done);
    currentSince_ = now;
    nextRead_ = std::min(nextRead_, now);
}

bool Station::isLate(ByteView bytes) const {
    return std::ranges::any_of(
        sent_, [bytes](const wire::MessageBytes& sent) { return std::ranges::equal(sent.view(), bytes); });
}

void Station::endCurrent() {
    const std::unique_ptr<Exchange> ended = std::move(current_);
    const Done done = std::exchange(currentDone_, {});
    done(*ended);
}

void Station::writeMessage(const wire::Message& message) {
    const auto bytes = wire::encodeMessage(message);
    if (!bytes) return;
    wire::MessageWrite write;
    write.box = wire::specOf(message.kind).box;
    write.content.append(bytes->view());
    write.content.append(std::uint8_t{0});
    const auto telegram = wire::encodeTelegram(write);
    // What the line does not take now is sent again, or not, as if it had been lost on its way.
    if (!telegram || !hooks_.write(telegram->view())) return;
    ++counters_.telegramsOut;
    sent_.push_back(*bytes);
    if (sent_.size() > kRemembered) sent_.pop_front();
}

void Station::pump(TimePoint now) {
    while (current_) {
        if (const auto message = current_->takeMessage()) {
            if (auto may = hooks_.maySend(*message); !may) {
                current_->withhold(std::move(may.error()));
            } else {
                if (current_->attempts() > 1) ++counters_.resends;
                writeMessage(*message);
                nextRead_ = std::min(nextRead_, now);
            }
        }
        if (!current_->done()) return;
        endCurrent();
        if (current_ || queue_.empty()) continue;
        Waiting next = std::move(queue_.front());
        queue_.pop_front();
        begin(std::move(next), now);
    }
}

void Station::tick(TimePoint now, bool busy) {
    busy_ = busy;
    if (readAt_ && now - *readAt_ >= kReadLimit) {
        readAt_.reset();
        parser_.abandon();
        ++counters_.timeouts;
        nextRead_ = now;
        hooks_.answering(++missed_);
    }
    if (!current_ && !queue_.empty()) {
        Waiting next = std::move(queue_.front());
        queue_.pop_front();
        begin(std::move(next), now);
    }
    if (current_) current_->tick(now);
    pump(now);
    if (!readAt_ && now >= nextRead_) read(now);
}

void Station::read(TimePoint now) {
    readTriggerBox_ = current_ && current_->readsTriggerBox() && !readTriggerBox_;
    const wire::MessageRead look = readTriggerBox_
                                       ? wire::MessageRead{wire::kTriggerOutbox, wire::kTriggerBox, false}
                                       : wire::MessageRead{wire::kCommandOutbox, wire::kCommandBox, true};
    const auto telegram = wire::encodeTelegram(look);
    if (!telegram || !hooks_.write(telegram->view())) {
        nextRead_ = now + kIdlePoll;
        return;
    }
    ++counters_.telegramsOut;
    readAt_ = now;
}

void Station::received(ByteView bytes, TimePoint now) {
    parser_.feed(bytes, [this, now](const wire::Telegram& telegram) { take(telegram, now); });
    pump(now);
}

void Station::take(const wire::Telegram& telegram, TimePoint now) {
    if (const auto* reply = std::get_if<wire::ReadReply>(&telegram))
        take(*reply, now);
    else
        ++counters_.unexpected;
}

void Station::take(const wire::ReadReply& reply, TimePoint now) {
    if (std::exchange(missed_, 0) > 0) hooks_.answering(0);
    const bool triggerBox = reply.localBox == wire::kTriggerBox;
    if (readAt_ && triggerBox == readTriggerBox_) readAt_.reset();
    hooks_.nxtStatus(reply.status);
    const Duration pause = busy_ || current_ ? kBusyPoll : kIdlePoll;
    nextRead_ = now + pause;
    if (reply.status == wire::kStatusMailboxEmpty || reply.status == wire::kStatusSuccess) {
        const bool empty = reply.status == wire::kStatusMailboxEmpty;
        const ByteView message = empty ? ByteView{} : wire::withoutTerminator(reply.content.view());
        if (triggerBox) {
            if (current_) current_->triggerRead(message);
        } else if (empty) {
            drained_ = true;
            if (current_) current_->emptied(now);
        } else {
            // There may be more: it is a queue.
            nextRead_ = now;
            takeCommandBox(message, now);
        }
    } else if (current_ && reply.status != wire::kStatusPending) {
        current_->nxtRefused(reply.status);
    }
}

void Station::takeCommandBox(ByteView content, TimePoint now) {
    const bool belonged = current_ && current_->received(content, now);
    const auto message = wire::decodeMessage(content);
    if (message && message->kind == wire::MessageKind::Error && isDoubled(message->error, belonged, now)) {
        ++counters_.unexpected;
        return;
    }
    if (message)
        hooks_.message(*message, belonged);
    else if (!belonged)
        hooks_.malformed(message.error());
    if (!message) ++counters_.malformed;
    const bool news =
        message && (message->kind == wire::MessageKind::Status || message->kind == wire::MessageKind::Error);
    if (message && !news && !belonged) ++counters_.unexpected;
}

bool Station::isDoubled(int error, bool belonged, TimePoint now) {
    if (!belonged && lastError_ == error && now - lastErrorAt_ < kDoubledWithin) return true;
    lastError_ = error;
    lastErrorAt_ = now;
    return false;
}

std::optional<RequestState> Station::request() const {
    if (!current_) return std::nullopt;
    return RequestState{current_->request().message.kind, current_->request().readsTrigger,
                        current_->attempts(), currentSince_, queue_.size()};
}

TrafficCounters Station::traffic() const {
    TrafficCounters traffic = counters_;
    traffic.telegramsIn = parser_.counters().telegrams;
    traffic.skipped = parser_.counters().skipped;
    traffic.malformed += parser_.counters().malformed;
    return traffic;
}

}  // namespace kickstand::motionplan
