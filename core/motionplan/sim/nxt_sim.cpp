#include "core/motionplan/sim/nxt_sim.h"

#include <algorithm>
#include <utility>

#include "core/motionplan/sim/nxt_actions.h"
#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan::sim {

NxtSim::NxtSim(Scheduler& scheduler, const NxtOptions& options)
    : scheduler_(scheduler),
      options_(options),
      random_(options.seed),
      program_([this](ByteView message) { put(message); }),
      control_(std::make_unique<NxtActions>(*this)) {
    program_.setPace(options.pace);
    tick();
}

NxtSim::~NxtSim() = default;

void NxtSim::later(Duration delay, std::function<void()> act) {
    scheduler_.callAfter(delay, [act = std::move(act), alive = std::weak_ptr(alive_)] {
        if (!alive.expired()) act();
    });
}

void NxtSim::tick() {
    if (programRuns_) program_.tick(scheduler_.now());
    later(kTick, [this] { tick(); });
}

bool NxtSim::byChance(double probability) {
    return probability > 0 && std::uniform_real_distribution<double>(0, 1)(random_) < probability;
}

NxtReport NxtSim::report() const {
    NxtReport report = counters_;
    report.attached = attached_;
    report.open = open_;
    report.programRuns = programRuns_;
    report.skipped = parser_.counters().skipped;
    return report;
}

void NxtSim::loseNext(int toRobot, int fromRobot) {
    loseToRobot_ = toRobot;
    loseFromRobot_ = fromRobot;
}

void NxtSim::lineOpened(Baud) {
    parser_.abandon();
    open_ = true;
    ++connection_;
}

void NxtSim::lineClosed() {
    gone();
}

void NxtSim::lineBaudChanged(Baud) {}  // Bluetooth has no speed that a host could choose.

void NxtSim::gone() {
    if (!std::exchange(open_, false)) return;
    if (programRuns_) program_.connectionLost(scheduler_.now());
}

void NxtSim::setAttached(bool attached) {
    if (std::exchange(attached_, attached) == attached) return;
    if (!attached) gone();
    if (listener_ != nullptr) listener_->attachedChanged(attached);
}

void NxtSim::setProgramRuns(bool runs) {
    if (std::exchange(programRuns_, runs) == runs) return;
    program_.restart();
    outbox_.clear();
    triggerBox_.clear();
}

void NxtSim::hostSent(ByteView bytes) {
    parser_.feed(bytes, [this](const wire::Telegram& telegram) { take(telegram); });
}

void NxtSim::take(const wire::Telegram& telegram) {
    if (const auto* message = std::get_if<wire::MessageWrite>(&telegram)) {
        const std::uint8_t status = write(*message);
        if (message->reply) reply(wire::WriteReply{status});
    } else if (const auto* asked = std::get_if<wire::MessageRead>(&telegram)) {
        if (byChance(options_.weather.replyLoss)) {
            ++counters_.lost;
            return;
        }
        later(kReplyTime, [this, asked = *asked, connection = connection_] {
            if (connection == connection_) reply(read(asked));
        });
    }
}

std::uint8_t NxtSim::write(const wire::MessageWrite& message) {
    if (!programRuns_) return wire::kStatusNoProgram;
    const bool lost = loseToRobot_ > 0 || byChance(options_.weather.loss);
    loseToRobot_ = std::max(loseToRobot_ - 1, 0);
    if (lost) {
        ++counters_.lost;
        return wire::kStatusSuccess;
    }
    later(kProgramTime, [this, box = message.box, content = message.content] { arrived(box, content); });
    return wire::kStatusSuccess;
}

void NxtSim::arrived(std::uint8_t box, const wire::MailboxBytes& content) {
    if (!programRuns_) return;
    ++counters_.written;
    ByteView bytes = content.view().first(content.size() - 1);
    if (options_.text)
        bytes = bytes.first(static_cast<std::size_t>(std::ranges::find(bytes, 0) - bytes.begin()));
    if (box == wire::kCommandBox) program_.command(bytes, scheduler_.now());
    if (box != wire::kTriggerBox) return;
    program_.triggerPlan(bytes);
    triggerBox_.clear();
    triggerBox_.append(bytes);
    triggerBox_.append(std::uint8_t{0});
}

void NxtSim::put(ByteView message) {
    const bool lost = loseFromRobot_ > 0 || loseOneFromRobot_ == 1 || byChance(options_.weather.loss);
    loseFromRobot_ = std::max(loseFromRobot_ - 1, 0);
    loseOneFromRobot_ = std::max(loseOneFromRobot_ - 1, 0);
    if (lost) {
        ++counters_.lost;
        return;
    }
    wire::MailboxBytes content;
    content.append(message);
    content.append(std::uint8_t{0});
    const int copies = byChance(options_.weather.duplicate) ? 2 : 1;
    for (int copy = 0; copy < copies; ++copy) {
        if (options_.weather.delay == Duration::zero())
            putNow(content);
        else
            later(options_.weather.delay, [this, content] { putNow(content); });
    }
}

void NxtSim::putNow(const wire::MailboxBytes& content) {
    outbox_.push_back(content);
    if (outbox_.size() <= kOutbox) return;
    outbox_.pop_front();
    ++counters_.overflows;
}

wire::ReadReply NxtSim::read(const wire::MessageRead& asked) {
    ++counters_.reads;
    wire::ReadReply reply{wire::kStatusMailboxEmpty, asked.localBox, {}};
    if (!programRuns_) {
        reply.status = wire::kStatusNoProgram;
    } else if (asked.remoteBox == wire::kTriggerOutbox && !triggerBox_.empty()) {
        reply.status = wire::kStatusSuccess;
        reply.content = triggerBox_;
    } else if (asked.remoteBox == wire::kCommandOutbox && !outbox_.empty()) {
        reply.status = wire::kStatusSuccess;
        reply.content = outbox_.front();
        if (asked.remove) outbox_.pop_front();
    }
    return reply;
}

void NxtSim::reply(const wire::Telegram& telegram) {
    const auto bytes = wire::encodeTelegram(telegram);
    if (bytes && open_ && attached_ && listener_ != nullptr) listener_->deviceSent(bytes->view());
}

}  // namespace kickstand::motionplan::sim
