#include "core/smartdevice/device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace kickstand::smartdevice {
namespace {

using std::chrono::milliseconds;

constexpr Duration kQuietAfter = std::chrono::seconds(1);
constexpr Duration kLostAfter = std::chrono::seconds(3);
/// Long enough for a request or two to get lost on the way.
constexpr Duration kGrantLimit = milliseconds(1600);
/// So long until a question is asked again: a line with noise may have lost it, or its answer.
constexpr Duration kAskAgainAfter = milliseconds(200);
constexpr int kReads = 3;
/// So long without a sample that should have come, while heartbeats are answered: the board began anew.
constexpr Duration kUpdatesMissing = std::chrono::seconds(1);
/// A board that talks answers every heartbeat; one may get lost.
constexpr Duration kTalksEvery = 2 * Heartbeat::kEvery;
constexpr std::uint16_t kUsualDelay_ms = 40;

constexpr wire::ParameterMask bit(int parameter) {
    return static_cast<wire::ParameterMask>(1U << parameter);
}

Error errorOf(Errc code, std::string subject = {}) {
    Error error;
    error.code = code;
    error.subject = std::move(subject);
    return error;
}

bool isWhole(double number) {
    return number == std::trunc(number) && std::abs(number) < 1e15;
}

/// A value past its bounds. Bounds that are no whole numbers, or only one, are told in words.
Error outside(const ParameterSpec& spec, const wire::Value& value) {
    Error error = errorOf(Errc::OutOfRange, spec.name);
    error.detail = wire::toText(value);
    if (spec.lowest && spec.highest && isWhole(*spec.lowest) && isWhole(*spec.highest)) {
        error.lowest = static_cast<std::int64_t>(*spec.lowest);
        error.highest = static_cast<std::int64_t>(*spec.highest);
        return error;
    }
    if (spec.lowest) error.detail += ", at least " + wire::toText(wire::Value(*spec.lowest));
    if (spec.highest) error.detail += ", at most " + wire::toText(wire::Value(*spec.highest));
    return error;
}

/// The kind of a board that nobody knows, before anything was found out.
SharedDeviceSpec unknownKind(const wire::Uid& uid) {
    DeviceSpec spec;
    spec.id = uid.device();
    spec.name = "Device" + std::to_string(spec.id);
    spec.known = false;
    return std::make_shared<const DeviceSpec>(std::move(spec));
}

}  // namespace

Device::Device(int number, const wire::Uid& uid, SharedDeviceSpec spec, DeviceHost host)
    : host_(std::move(host)) {
    state_.number = number;
    state_.uid = uid;
    state_.learning = spec == nullptr;
    state_.spec = spec == nullptr ? unknownKind(uid) : std::move(spec);
    state_.parameters.resize(state_.spec->parameters.size());
    state_.wanted = state_.spec->readable();
    state_.wantedDelay_ms = kUsualDelay_ms;
    learnt_ = *state_.spec;
}

void Device::raise(EventKind kind, std::string text, std::int64_t code, std::int64_t previous, double value) {
    Event event;
    event.kind = kind;
    event.text = std::move(text);
    event.code = code;
    event.previous = previous;
    event.value = value;
    host_.event(std::move(event));
}

// ---- Coming and going.

void Device::connected(const std::string& port, TimePoint now) {
    state_.port = port;
    state_.heardAt = now;
    state_.disabled = false;
    state_.presence = Presence::Live;
    heartbeat_.restart(now);
    if (state_.learning) {
        learning_ = -1;
        learnt_.parameters.clear();
        learnNext(now);
    } else {
        askForUpdates(now);
    }
    host_.changed();
}

void Device::disconnected(TimePoint now) {
    state_.presence = Presence::Lost;
    state_.subscribed = 0;
    state_.delay_ms = 0;
    request_.end();
    stopOwed_ = false;
    noteStopped();
    // The port will be opened anew, which resets the board.
    forgetWritten(Forget::All);
    for (const CommandId id : judge_.abandon())
        host_.answer(id, fail(Errc::Disconnected, state_.spec->name));
    for (const PendingRead& read : std::exchange(reads_, {}))
        host_.answer(read.id, fail(Errc::Disconnected, state_.spec->name));
    for (const PendingSubscription& one : std::exchange(subscriptions_, {}))
        host_.answer(one.id, fail(Errc::Disconnected, state_.spec->name));
    for (std::size_t i = 0; i < state_.parameters.size(); ++i)
        host_.samples->gap({static_cast<std::uint16_t>(state_.number), static_cast<std::uint16_t>(i)}, now);
    host_.changed();
}

void Device::setPresence(Presence presence) {
    if (state_.presence == presence) return;
    state_.presence = presence;
    if (presence == Presence::Quiet) raise(EventKind::DeviceQuiet);
    host_.changed();
}

void Device::step(TimePoint now) {
    if (!isLive()) return;
    if (stopOwed_) sendStop();
    if (const auto beat = heartbeat_.due(now)) host_.send(wire::HeartbeatRequest{*beat});
    if (learning_ >= 0 && now >= learnUntil_) {
        if (--learningReadsLeft_ > 0)
            askLearning(now);
        else
            learnNext(now);
    }
    const Duration silence = now - state_.heardAt;
    if (silence >= kLostAfter) return setPresence(Presence::Lost);
    if (silence >= kQuietAfter) setPresence(Presence::Quiet);
    judge_.step(now);
    applyJudgements();
    std::erase_if(reads_, [&](PendingRead& read) {
        if (now < read.deadline) return false;
        if (--read.left > 0) return !send(read, now);
        host_.answer(read.id, fail(Errc::TimedOut, state_.spec->name));
        return true;
    });
    std::erase_if(subscriptions_, [&](const PendingSubscription& pending) {
        if (now < pending.deadline) return false;
        host_.answer(pending.id, fail(Errc::TimedOut, state_.spec->name));
        return true;
    });
    watchUpdates(now);
}

bool Device::send(PendingRead& read, TimePoint now) {
    read.deadline = now + kAskAgainAfter;
    if (host_.send(wire::DeviceRead{read.missing})) return true;
    host_.answer(read.id, fail(Errc::QueueFull, state_.port));
    return false;
}

void Device::watchUpdates(TimePoint now) {
    if (state_.presence != Presence::Live) return;
    switch (request_.due(now)) {
        case UpdateRequest::Due::AskAgain:
            return requestUpdates();
        case UpdateRequest::Due::GiveUp:
            state_.ungranted = true;
            return raise(EventKind::Ungranted, {}, UpdateRequest::kAsks);
        case UpdateRequest::Due::Nothing:
            break;
    }
    if (request_.isOpen() || state_.subscribed == 0 || state_.delay_ms == 0) return;
    const Duration limit = std::max<Duration>(kUpdatesMissing, 4 * milliseconds(state_.delay_ms));
    if (state_.heardAt - sampleAt_ < limit) return;
    raise(EventKind::DeviceReset);
    noteStopped();
    forgetWritten(Forget::All);
    askForUpdates(now);
}

// ---- What comes.

void Device::message(const wire::Message& message, TimePoint now) {
    // Only a board that talks and sends no updates began anew: while nothing comes at all, none can.
    if (const Duration silence = now - state_.heardAt; silence > kTalksEvery)
        sampleAt_ = std::min(now, sampleAt_ + silence);
    state_.heardAt = now;
    setPresence(Presence::Live);
    if (const auto* response = std::get_if<wire::SubscriptionResponse>(&message)) {
        take(*response, now);
    } else if (const auto* data = std::get_if<wire::DeviceData>(&message)) {
        take(*data, now);
    } else if (const auto* beat = std::get_if<wire::HeartbeatRequest>(&message)) {
        host_.send(wire::HeartbeatResponse{beat->id});
    } else if (const auto* answer = std::get_if<wire::HeartbeatResponse>(&message)) {
        if (heartbeat_.answered(answer->id, now)) state_.latency = heartbeat_.latency();
    } else if (const auto* error = std::get_if<wire::ErrorMessage>(&message)) {
        state_.lastError = error->code;
        raise(EventKind::DeviceError, {}, error->code);
    }
    host_.changed();
}

void Device::take(const wire::SubscriptionResponse& message, TimePoint now) {
    state_.subscribed = message.delay_ms == 0 ? wire::ParameterMask{0} : message.parameters;
    const std::uint16_t before = std::exchange(state_.delay_ms, message.delay_ms);
    sampleAt_ = now;
    pieces_.restart(state_.subscribed, state_.delay_ms != 0);
    if (before != message.delay_ms) raise(EventKind::Subscribed, {}, message.delay_ms, state_.wantedDelay_ms);
    const bool settled = request_.settledBy(message);
    state_.ungranted = state_.ungranted && !settled && message.delay_ms == 0;
    if (!settled) return;
    // There is one subscription: what holds now holds for whoever asked.
    for (const PendingSubscription& one : std::exchange(subscriptions_, {}))
        host_.answer(one.id, {});
}

bool Device::fits(const wire::DeviceData& message) {
    std::size_t expected = 0;
    bool known = true;
    for (int i = 0; i < wire::kMostParameters; ++i) {
        if ((message.parameters & bit(i)) == 0) continue;
        const auto at = static_cast<std::size_t>(i);
        known = known && at < state_.parameters.size();
        if (known) expected += state_.spec->parameters[at].width();
    }
    if (known && expected == message.values.size()) return true;
    if (!std::exchange(misfitTold_, true))
        raise(EventKind::Misfit, {}, static_cast<std::int64_t>(message.values.size()),
              static_cast<std::int64_t>(expected));
    return false;
}

void Device::take(const wire::DeviceData& message, TimePoint now) {
    if (learning_ >= 0) return learned(message, now);
    ++state_.samples;
    sampleAt_ = now;
    if (!fits(message)) return;
    store(message, now);
    const SamplePieces::Part part = pieces_.take(message.parameters);
    const bool answersRead = answerReads(message.parameters, part != SamplePieces::Part::None);
    using Role = WriteJudge::Role;
    const bool answers = part == SamplePieces::Part::None && !answersRead;
    judge_.data(message.parameters,
                part == SamplePieces::Part::End ? Role::SampleEnd
                : answers                       ? Role::Answer
                                                : Role::Other,
                state_.parameters);
    applyJudgements();
}

/// Whether it may be the answer to one of them; a sample is as good, but answers none.
bool Device::answerReads(wire::ParameterMask mask, bool sample) {
    const bool answers = !sample && mask != 0 && std::ranges::any_of(reads_, [&](const PendingRead& read) {
        return (mask & ~read.missing) == 0;
    });
    std::erase_if(reads_, [&](PendingRead& read) {
        read.missing = static_cast<wire::ParameterMask>(read.missing & ~mask);
        if (read.missing == 0) host_.answer(read.id, {});
        return read.missing == 0;
    });
    return answers;
}

void Device::store(const wire::DeviceData& message, TimePoint now) {
    ByteView left = message.values.view();
    if (told_)
        raise(EventKind::Update, std::string(left.begin(), left.end()), message.parameters,
              static_cast<std::int64_t>(updates_));
    ++updates_;
    for (std::size_t i = 0; i < state_.parameters.size(); ++i) {
        if ((message.parameters & bit(static_cast<int>(i))) == 0) continue;
        const ParameterSpec& spec = state_.spec->parameters[i];
        const auto value = wire::readValue(spec.type, left.first(spec.width()));
        left = left.subspan(spec.width());
        if (!value) continue;
        state_.parameters[i].value = value;
        state_.parameters[i].at = now;
        if (const auto number = wire::toNumber(*value))
            host_.samples->sample({static_cast<std::uint16_t>(state_.number), static_cast<std::uint16_t>(i)},
                                  now, static_cast<float>(*number));
    }
}

// ---- What is asked for.

void Device::askForUpdates(TimePoint now) {
    sampleAt_ = now;
    state_.ungranted = false;
    request_.begin({state_.wanted, state_.wantedDelay_ms}, now);
    requestUpdates();
}

void Device::requestUpdates() {
    host_.send(wire::SubscriptionRequest{state_.wanted, state_.wantedDelay_ms});
}

void Device::subscribe(CommandId id, const Subscribe& command, TimePoint now) {
    state_.wanted = static_cast<wire::ParameterMask>(command.parameters & state_.spec->readable());
    state_.wantedDelay_ms = command.delay_ms;
    told_ = command.told;
    subscriptions_.push_back({id, now + kGrantLimit});
    askForUpdates(now);
    host_.changed();
}

void Device::read(CommandId id, const ReadValues& command, TimePoint now) {
    const auto mask = static_cast<wire::ParameterMask>(command.parameters & state_.spec->readable());
    if (mask == 0)
        return host_.answer(id, fail(Errc::BadArgument, state_.spec->name, "nothing of it can be read"));
    PendingRead request{id, mask, kReads, {}};
    if (send(request, now)) reads_.push_back(request);
}

Result<void> Device::checkWrite(const WriteValues& command) const {
    if (command.values.empty()) return fail(Errc::BadArgument, state_.spec->name, "no value was given");
    for (const auto& [parameter, value] : command.values) {
        if (parameter < 0 || parameter >= static_cast<int>(state_.spec->parameters.size()))
            return fail(Errc::BadArgument, std::to_string(parameter),
                        state_.spec->name + " has no such parameter");
        const ParameterSpec& spec = state_.spec->parameters[static_cast<std::size_t>(parameter)];
        if (!spec.writable()) return fail(Errc::BadArgument, spec.name, "it can only be read");
        if (spec.width() == 0) return fail(Errc::BadArgument, spec.name, "nobody knows how wide it is");
        if (wire::typeOf(value) != spec.type || wire::bytesOf(value).size() != spec.width())
            return fail(Errc::BadArgument, spec.name, std::string("it is a ") + wire::name(spec.type));
        const auto number = wire::toNumber(value);
        if (!number) continue;
        if (!std::isfinite(*number)) return fail(Errc::BadArgument, spec.name, wire::toText(value));
        if ((spec.lowest && *number < *spec.lowest) || (spec.highest && *number > *spec.highest))
            return fail(outside(spec, value));
    }
    return {};
}

void Device::write(CommandId id, const WriteValues& command, TimePoint now) {
    if (auto right = checkWrite(command); !right) return host_.answer(id, std::move(right));
    if (!sendValues(command.values)) return host_.answer(id, fail(Errc::QueueFull, state_.port));
    std::map<int, wire::Value> readable;
    for (const auto& [parameter, value] : command.values) {
        ParameterState& state = state_.parameters[static_cast<std::size_t>(parameter)];
        const bool confirmed = state_.spec->parameters[static_cast<std::size_t>(parameter)].readable();
        state.written = value;
        state.verdict = confirmed ? WriteVerdict::Pending : WriteVerdict::Unconfirmed;
        if (confirmed) readable.insert_or_assign(parameter, value);
    }
    if (readable.empty())
        host_.answer(id, {});
    else
        judge_.begin(id, std::move(readable), state_.parameters, now);
    applyJudgements();
    host_.changed();
}

bool Device::sendValues(const std::vector<std::pair<int, wire::Value>>& values) {
    wire::DeviceWrite message;
    std::map<int, wire::Value> ascending;
    for (const auto& [parameter, value] : values)
        ascending.insert_or_assign(parameter, value);
    for (const auto& [parameter, value] : ascending) {
        message.parameters = static_cast<wire::ParameterMask>(message.parameters | bit(parameter));
        wire::appendValue(message.values, value);
    }
    if (!host_.send(message)) return false;
    for (const auto& [parameter, value] : ascending)
        noteDriving(parameter, value);
    state_.disabled = false;
    return true;
}

void Device::noteDriving(int parameter, const wire::Value& value) {
    const ParameterSpec& spec = state_.spec->parameters[static_cast<std::size_t>(parameter)];
    if (!spec.moves) return;
    // Zero ends a speed, but is a place like any other; whether one has been reached nobody says.
    const bool drives = !spec.zeroOnStop || wire::toNumber(value).value_or(0) != 0;
    driving_ =
        static_cast<wire::ParameterMask>(drives ? driving_ | bit(parameter) : driving_ & ~bit(parameter));
    state_.driving = driving_ != 0;
}

void Device::noteStopped() {
    driving_ = 0;
    state_.driving = false;
}

void Device::forgetWritten(Forget what) {
    for (std::size_t i = 0; i < state_.parameters.size(); ++i) {
        if (what == Forget::WhatMoves && !state_.spec->parameters[i].moves) continue;
        state_.parameters[i].written.reset();
        state_.parameters[i].verdict = WriteVerdict::None;
    }
}

void Device::applyJudgements() {
    for (const auto& [parameter, verdict] : judge_.takeJudgements()) {
        ParameterState& state = state_.parameters[static_cast<std::size_t>(parameter)];
        const std::string& name = state_.spec->parameters[static_cast<std::size_t>(parameter)].name;
        state.verdict = verdict;
        if (verdict == WriteVerdict::Refused) raise(EventKind::WriteRefused, name);
        if (verdict == WriteVerdict::Changed)
            raise(EventKind::WriteChanged, name, 0, 0,
                  state.value ? wire::toNumber(*state.value).value_or(0) : 0);
        host_.changed();
    }
    for (const WriteJudge::Ended& ended : judge_.takeEnded())
        host_.answer(ended.id, resultOf(ended));
}

Result<void> Device::resultOf(const WriteJudge::Ended& ended) const {
    const auto nameOf = [this](int parameter) {
        return state_.spec->parameters[static_cast<std::size_t>(parameter)].name;
    };
    if (ended.firstRefused >= 0)
        return fail(Errc::DeviceRefused, nameOf(ended.firstRefused), state_.spec->name);
    if (ended.firstSilent >= 0) return fail(Errc::TimedOut, state_.spec->name, nameOf(ended.firstSilent));
    return {};
}

// ---- Stopping.

Result<void> Device::disable() {
    if (!host_.send(wire::DeviceDisable{})) return fail(Errc::QueueFull, state_.port);
    noteStopped();
    forgetWritten(Forget::WhatMoves);
    state_.disabled = true;
    host_.changed();
    raise(EventKind::Disabled);
    return {};
}

void Device::stop() {
    for (const CommandId id : judge_.abandon())
        host_.answer(id, fail(Errc::StopLatched));
    for (ParameterState& parameter : state_.parameters) {
        if (parameter.verdict == WriteVerdict::Pending) parameter.verdict = WriteVerdict::None;
    }
    if (isLive()) sendStop();
}

void Device::sendStop() {
    std::vector<std::pair<int, wire::Value>> zeros;
    for (std::size_t i = 0; i < state_.spec->parameters.size(); ++i) {
        const ParameterSpec& spec = state_.spec->parameters[i];
        const auto zero = wire::fromNumber(spec.type, 0);
        if (spec.zeroOnStop && zero) zeros.emplace_back(static_cast<int>(i), *zero);
    }
    const bool zeroed = zeros.empty() || sendValues(zeros);
    // The one is worth sending without the other.
    stopOwed_ = !host_.send(wire::DeviceDisable{}) || !zeroed;
    if (stopOwed_) return;
    noteStopped();
    forgetWritten(Forget::WhatMoves);
    for (const auto& [parameter, zero] : zeros)
        state_.parameters[static_cast<std::size_t>(parameter)].written = zero;
    state_.disabled = true;
    host_.changed();
    raise(EventKind::Stopped, state_.spec->name);
}

}  // namespace kickstand::smartdevice
