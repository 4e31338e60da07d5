#include "core/smartdevice/sim/board_sim.h"

#include <chrono>
#include <utility>

namespace kickstand::smartdevice::sim {
namespace {

using std::chrono::milliseconds;

constexpr Duration kBeatEvery = milliseconds(250);
/// So many heartbeat requests without an answer, and a PolarBear disables itself.
constexpr int kMostUnanswered = 4;

constexpr wire::ParameterMask bit(std::size_t parameter) {
    return static_cast<wire::ParameterMask>(1U << parameter);
}

}  // namespace

BoardSim::BoardSim(Scheduler& scheduler, const wire::Uid& uid, std::unique_ptr<Body> body, Duration boot,
                   std::uint32_t seed)
    : scheduler_(scheduler),
      uid_(uid),
      body_(std::move(body)),
      boot_(boot),
      random_(seed),
      decoder_(uid.dialect),
      advancedTo_(scheduler.now()) {}

BoardSim::~BoardSim() {
    cancelTimers();
}

void BoardSim::cancelTimers() {
    for (TimerId* timer : {&bootTimer_, &sampleTimer_, &beatTimer_})
        scheduler_.cancel(std::exchange(*timer, 0));
}

void BoardSim::arm(TimerId& timer, Duration delay, void (BoardSim::*due)()) {
    scheduler_.cancel(timer);
    timer = scheduler_.callAfter(delay, [this, due] { (this->*due)(); });
}

bool BoardSim::happens(double probability) {
    return probability > 0 &&
           static_cast<double>(random_()) < probability * static_cast<double>(std::mt19937::max());
}

// ---- The line.

void BoardSim::lineOpened(Baud /*baud*/) {
    lineOpen_ = true;
    reset();
}

void BoardSim::lineClosed() {
    // The board keeps its power: it goes on, and finds that nobody answers its heartbeat requests.
    lineOpen_ = false;
    scheduler_.cancel(std::exchange(sampleTimer_, 0));
    subscription_ = {};
}

void BoardSim::lineBaudChanged(Baud /*baud*/) {
    // On USB the speed means nothing.
}

void BoardSim::hostSent(ByteView bytes) {
    if (booting_) return;
    const std::uint64_t before = decoder_.counts().checksums;
    decoder_.feed(bytes, [this](const wire::Message& message) { take(message); });
    if (decoder_.counts().checksums != before)
        send(wire::ErrorMessage{static_cast<std::uint8_t>(wire::ErrorCode::Checksum)});
}

void BoardSim::plug(bool in) {
    if (attached_ == in) return;
    attached_ = in;
    if (!in) {
        lineOpen_ = false;
        reset();
    }
    if (listener_ != nullptr) listener_->attachedChanged(in);
}

void BoardSim::reset() {
    advance();
    cancelTimers();
    decoder_.reset();
    subscription_ = {};
    disabled_ = false;
    unanswered_ = 0;
    body_->reset();
    ++report_.resets;
    booting_ = lineOpen_;
    if (booting_) arm(bootTimer_, boot_, &BoardSim::booted);
}

void BoardSim::booted() {
    booting_ = false;
    if (body_->wantsHeartbeats()) arm(beatTimer_, kBeatEvery, &BoardSim::beat);
}

void BoardSim::advance() {
    const TimePoint now = scheduler_.now();
    body_->advance(seconds(now - std::exchange(advancedTo_, now)));
}

// ---- The protocol.

void BoardSim::take(const wire::Message& message) {
    advance();
    if (std::holds_alternative<wire::Ping>(message)) {
        answerSubscription();
    } else if (const auto* request = std::get_if<wire::SubscriptionRequest>(&message)) {
        subscribe(*request);
    } else if (const auto* read = std::get_if<wire::DeviceRead>(&message)) {
        sendData(static_cast<wire::ParameterMask>(read->parameters & readable()));
    } else if (const auto* write = std::get_if<wire::DeviceWrite>(&message)) {
        take(*write);
    } else if (std::holds_alternative<wire::DeviceDisable>(message)) {
        ++report_.disables;
        disableSelf();
    } else if (const auto* beat = std::get_if<wire::HeartbeatRequest>(&message)) {
        send(wire::HeartbeatResponse{beat->id});
    } else if (std::holds_alternative<wire::HeartbeatResponse>(message)) {
        unanswered_ = 0;
    }
}

void BoardSim::disableSelf() {
    disabled_ = true;
    body_->disable();
}

wire::ParameterMask BoardSim::readable() const {
    wire::ParameterMask mask = 0;
    for (std::size_t i = 0; i < body_->parameters().size(); ++i) {
        if (body_->parameters()[i].readable) mask = static_cast<wire::ParameterMask>(mask | bit(i));
    }
    return mask;
}

void BoardSim::answerSubscription() {
    send(wire::SubscriptionResponse{subscription_.parameters, subscription_.delay_ms, uid_});
}

void BoardSim::subscribe(const wire::SubscriptionRequest& request) {
    if (faults_.deafToSubscriptions) return;
    subscription_ = request;
    subscription_.parameters = static_cast<wire::ParameterMask>(request.parameters & readable());
    scheduler_.cancel(std::exchange(sampleTimer_, 0));
    if (request.delay_ms > 0) arm(sampleTimer_, milliseconds(request.delay_ms), &BoardSim::sample);
    answerSubscription();
}

void BoardSim::sample() {
    arm(sampleTimer_, milliseconds(subscription_.delay_ms), &BoardSim::sample);
    advance();
    sendData(subscription_.parameters);
    if (subscription_.parameters == 0) send(wire::DeviceData{});
}

void BoardSim::beat() {
    arm(beatTimer_, kBeatEvery, &BoardSim::beat);
    advance();
    if (++unanswered_ > kMostUnanswered && !disabled_) {
        ++report_.selfDisables;
        disableSelf();
    }
    send(wire::HeartbeatRequest{nextBeat_++});
}

void BoardSim::take(const wire::DeviceWrite& message) {
    ++report_.writes;
    disabled_ = false;
    wire::ParameterMask taken = 0;
    ByteView left = message.values.view();
    for (std::size_t i = 0; i < body_->parameters().size(); ++i) {
        if ((message.parameters & bit(i)) == 0) continue;
        const SimParameter& parameter = body_->parameters()[i];
        const std::size_t width = wire::widthOf(parameter.type);
        if (left.size() < width)
            return send(wire::ErrorMessage{static_cast<std::uint8_t>(wire::ErrorCode::Generic)});
        const auto value = wire::readValue(parameter.type, left.first(width));
        left = left.subspan(width);
        if (value && parameter.writable && !happens(faults_.refuse) &&
            body_->write(static_cast<int>(i), *value) && parameter.readable)
            taken = static_cast<wire::ParameterMask>(taken | bit(i));
    }
    sendData(taken);
}

void BoardSim::sendData(wire::ParameterMask mask) {
    wire::DeviceData message;
    for (std::size_t i = 0; i < body_->parameters().size(); ++i) {
        if ((mask & bit(i)) == 0) continue;
        const wire::Value value = body_->read(static_cast<int>(i));
        const bool full = message.values.size() + wire::bytesOf(value).size() > longestData_;
        if (full && message.parameters != 0) {
            send(message);
            message = {};
        }
        message.parameters = static_cast<wire::ParameterMask>(message.parameters | bit(i));
        wire::appendValue(message.values, value);
    }
    if (message.parameters != 0) send(message);
}

void BoardSim::send(const wire::Message& message) {
    if (!lineOpen_ || faults_.silent || listener_ == nullptr) return;
    wire::FrameBytes frame = wire::encodeFrame(uid_.dialect, message);
    // The last byte but the delimiter is the checksum, or stands for it.
    if (happens(faults_.checksum)) frame.span()[frame.size() - 2] ^= 0x55;
    if (happens(faults_.noise)) {
        const auto bit = static_cast<std::uint8_t>(1U << random_() % 8);
        frame.span()[random_() % frame.size()] ^= bit;
    }
    if (happens(faults_.truncate)) frame.resize(frame.size() / 2);
    listener_->deviceSent(frame.view());
}

wire::Value BoardSim::value(int parameter) {
    advance();
    return body_->read(parameter);
}

BoardReport BoardSim::report() const {
    BoardReport report = report_;
    report.lineOpen = lineOpen_;
    report.booting = booting_;
    report.disabled = disabled_;
    report.heard = decoder_.counts();
    report.subscription = subscription_;
    return report;
}

}  // namespace kickstand::smartdevice::sim
