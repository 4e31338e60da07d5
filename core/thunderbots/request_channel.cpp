#include "core/thunderbots/request_channel.h"

#include <algorithm>
#include <utility>

namespace kickstand::thunderbots {
namespace {

using wire::FirmwareOp;

/// On top of what the robot needs for the work itself: sixteen robots on a radio at its true pace are polled
/// twice a second each.
constexpr Duration kMargin = std::chrono::seconds(2);
/// A dongle that takes no message for so long takes none any more.
constexpr Duration kTakenLimit = std::chrono::seconds(10);
/// How long after a request to reboot a robot is expected to vanish: a dongle with sixteen of them takes some
/// eight seconds to notice.
constexpr Duration kRebootWindow = std::chrono::seconds(20);
/// Robots may be slower than the ones that were timed.
constexpr int kSlack = 2;

// What a sign is asked for with: odd where every other request is even, and another address every round.
constexpr std::uint32_t kSignBase = 0x100001;
constexpr std::uint32_t kSignRounds = 0x40000;
constexpr std::uint32_t kSignLength = 17;

constexpr std::uint32_t signAddress(std::uint32_t round) {
    return kSignBase + 2 * (round % kSignRounds);
}
static_assert(signAddress(kSignRounds - 1) + kSignLength <= wire::kFlashBytes);

bool isAnySign(const wire::BlockCrcResponse& response) {
    return response.length == kSignLength && response.address >= kSignBase && response.address % 2 == 1;
}

/// The robot's own time for a request (protocol 6.7).
Duration workOf(const wire::FirmwareRequest& request) {
    using namespace std::chrono_literals;
    switch (wire::opOf(request)) {
        case FirmwareOp::EraseChip:
            return 8s;
        case FirmwareOp::ProgramPage:
            return 1500us;
        case FirmwareOp::BlockCrc:
            return 1us * std::get<wire::BlockCrcRequest>(request).length;
        case FirmwareOp::ReadSignatures:
            return 1us * wire::kFlashBytes;
        default:
            return 0s;
    }
}

/// Whether its response can be told from another one of its kind: all others consist of an opcode alone.
bool isEchoed(FirmwareOp op) {
    return op == FirmwareOp::BlockCrc;
}

Error about(int robot, Errc code, FirmwareOp op) {
    Error error;
    error.code = code;
    error.robot = robot;
    error.subject = wire::name(op);
    return error;
}

}  // namespace

RequestChannel::RequestChannel(int robot, Scheduler& scheduler, MessageTurns& turns,
                               const std::function<void()>& changed)
    : robot_(robot),
      scheduler_(scheduler),
      turns_(turns),
      changed_(changed),
      // Not where an earlier program began: a sign that one asked for may still be on its way.
      round_(static_cast<std::uint32_t>(scheduler.now().time_since_epoch() / std::chrono::milliseconds(1))) {}

RequestChannel::~RequestChannel() {
    scheduler_.cancel(timer_);
}

Result<void> RequestChannel::ask(const std::vector<wire::FillPageRequest>& fills,
                                 const wire::FirmwareRequest& request, int attempts, Done done, Gate gate) {
    const FirmwareOp op = wire::opOf(request);
    if (exchange_) return fail(about(robot_, Errc::RequestPending, op));
    if (!alive_) return fail(about(robot_, Errc::RobotNotAlive, op));
    Exchange exchange;
    for (std::size_t i = 0; i <= fills.size(); ++i) {
        const auto message = wire::encodeFirmwareRequest(i < fills.size() ? fills[i] : request);
        if (!message) return fail(wire::toError(message.error(), wire::name(op)));
        exchange.messages.push_back(*message);
    }
    exchange.request = request;
    exchange.attempts = attempts;
    exchange.done = std::move(done);
    exchange.gate = std::move(gate);
    exchange_ = std::move(exchange);
    begin();
    return {};
}

void RequestChannel::begin() {
    if (inDoubt_) {
        ++round_;
        exchange_->signTries = 0;
        askForSign();
    } else {
        send();
    }
}

void RequestChannel::send() {
    ++exchange_->sent;
    exchange_->phase = Phase::Sending;
    exchange_->tainted = false;
    if (wire::opOf(exchange_->request) == FirmwareOp::Reboot)
        rebootingUntil_ = scheduler_.now() + kRebootWindow;
    waitFor(kTakenLimit, &RequestChannel::giveUp);
    turns_.push(robot_, exchange_->messages,
                [this](Result<void> result) { requestTaken(std::move(result)); });
    show();
}

void RequestChannel::requestTaken(Result<void> result) {
    if (!result) {
        inDoubt_ = true;
        finish(fail(std::move(result.error())));
        return;
    }
    exchange_->phase = Phase::Waiting;
    waitFor(kSlack * workOf(exchange_->request) + kMargin, &RequestChannel::unanswered);
}

void RequestChannel::unanswered() {
    ++state_.unanswered;
    inDoubt_ = true;
    begin();
}

void RequestChannel::askForSign() {
    exchange_->phase = Phase::SendingSign;
    ++exchange_->signTries;
    const auto message = wire::encodeFirmwareRequest(wire::BlockCrcRequest{signAddress(round_), kSignLength});
    waitFor(kTakenLimit, &RequestChannel::giveUp);
    turns_.push(robot_, {*message}, [this](Result<void> result) { signTaken(std::move(result)); });
    show();
}

void RequestChannel::signTaken(Result<void> result) {
    if (!result) {
        finish(fail(std::move(result.error())));
        return;
    }
    exchange_->phase = Phase::AwaitingSign;
    waitFor(kMargin,
            exchange_->signTries < kSignTries ? &RequestChannel::askForSign : &RequestChannel::giveUp);
}

void RequestChannel::giveUp() {
    inDoubt_ = true;
    finish(fail(about(robot_, Errc::TimedOut, wire::opOf(exchange_->request))));
}

void RequestChannel::signReceived() {
    inDoubt_ = false;
    if (exchange_->sent < exchange_->attempts) {
        const auto may = exchange_->gate ? exchange_->gate() : Result<void>();
        if (may) {
            send();
        } else {
            finish(fail(may.error()));
        }
    } else {
        Error error = about(robot_, Errc::Unanswered, wire::opOf(exchange_->request));
        error.got = exchange_->sent;
        finish(fail(std::move(error)));
    }
}

bool RequestChannel::isSign(const wire::FirmwareResponse& response) const {
    const auto* block = std::get_if<wire::BlockCrcResponse>(&response);
    return block && block->address == signAddress(round_) && block->length == kSignLength;
}

bool RequestChannel::answers(const wire::FirmwareResponse& response) const {
    if (wire::opOf(response) != wire::opOf(exchange_->request)) return false;
    const auto* block = std::get_if<wire::BlockCrcResponse>(&response);
    if (!block) return true;
    const auto& asked = std::get<wire::BlockCrcRequest>(exchange_->request);
    return block->address == asked.address && block->length == asked.length;
}

void RequestChannel::received(ByteView payload) {
    const auto response = wire::decodeFirmwareResponse(payload);
    if (!response) return stray();
    const bool signWanted = exchange_ && exchange_->phase == Phase::AwaitingSign;
    if (signWanted && isSign(*response)) return signReceived();
    // A sign of an earlier try says nothing new, and can be taken for nothing else.
    if (const auto* block = std::get_if<wire::BlockCrcResponse>(&*response); block && isAnySign(*block))
        return;
    const bool answerWanted = exchange_ && exchange_->phase == Phase::Waiting;
    if (!answerWanted || !answers(*response)) return stray();
    if (exchange_->tainted && !isEchoed(wire::opOf(*response))) return unanswered();
    finish(*response);
}

void RequestChannel::stray() {
    ++state_.strays;
    if (exchange_ && exchange_->phase == Phase::Sending) exchange_->tainted = true;
    inDoubt_ = true;
    show();
}

void RequestChannel::waitFor(Duration time, void (RequestChannel::*then)()) {
    scheduler_.cancel(timer_);
    timer_ = scheduler_.callAfter(time, [this, then] {
        timer_ = 0;
        (this->*then)();
    });
}

void RequestChannel::finish(Result<wire::FirmwareResponse> result) {
    scheduler_.cancel(std::exchange(timer_, 0));
    turns_.drop(robot_);
    if (!result && wire::opOf(exchange_->request) == FirmwareOp::Reboot) rebootingUntil_ = {};
    const Done done = std::move(exchange_->done);
    exchange_.reset();
    show();
    if (done) done(std::move(result));
}

void RequestChannel::found() {
    alive_ = true;
    inDoubt_ = true;
    rebootingUntil_ = {};
}

void RequestChannel::lost(const Error& why) {
    alive_ = false;
    inDoubt_ = true;
    if (!exchange_) return;
    const bool wentAsTold = wire::opOf(exchange_->request) == FirmwareOp::Reboot && exchange_->sent > 0 &&
                            why.code == Errc::RobotNotAlive;
    if (wentAsTold) {
        finish(wire::FirmwareResponse{wire::RebootResponse{}});
    } else {
        abandon(why);
    }
}

void RequestChannel::abandon(const Error& why) {
    if (!exchange_) return;
    inDoubt_ = true;
    Error error = why;
    error.robot = robot_;
    error.subject = wire::name(wire::opOf(exchange_->request));
    finish(fail(std::move(error)));
}

void RequestChannel::show() {
    RequestState now = state_;
    now.op.reset();
    now.attempt = 0;
    now.attempts = 0;
    now.awaitingSign = false;
    if (exchange_) {
        now.op = wire::opOf(exchange_->request);
        now.attempt = std::max(exchange_->sent, 1);
        now.attempts = exchange_->attempts;
        now.awaitingSign = exchange_->phase == Phase::SendingSign || exchange_->phase == Phase::AwaitingSign;
    }
    state_ = now;
    changed_();
}

}  // namespace kickstand::thunderbots
