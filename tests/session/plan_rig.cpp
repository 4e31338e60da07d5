#include "tests/session/plan_rig.h"

#include <algorithm>
#include <utility>

#include "core/base/hex.h"
#include "core/link/paced/paced_byte_link.h"
#include "core/link/tapped_byte_link.h"
#include "core/motionplan/wire/message.h"

namespace kickstand::testing {

using motionplan::wire::Wheels;

const PlanRig::Movements PlanRig::kShort{{Wheels::BothForward, 20}, {Wheels::RightForward, 90}};
const PlanRig::Movements PlanRig::kLong{{Wheels::BothForward, 800}, {Wheels::BothBack, 800}};

class PlanRig::Samples final : public SampleSink {
  public:
    void sample(SignalId, TimePoint, float) override {}
    void gap(SignalId, TimePoint) override {}
};

PlanRig::PlanRig(const motionplan::sim::NxtOptions& options)
    : sim_(scheduler_, options), samples_(std::make_unique<Samples>()) {
    motionplan::Session::Host host{
        scheduler_, stop_, *samples_, [this](const motionplan::Event& event) { events_.push_back(event); },
        [this](CommandId id, Result<void> result) { answers_[id].push_back(std::move(result)); }};
    auto link =
        std::make_unique<TappedByteLink>(std::make_unique<PacedByteLink>(scheduler_, sim_), scheduler_);
    link->addObserver(this);
    session_ = std::make_unique<motionplan::Session>(std::move(host), std::move(link));
    step();
}

PlanRig::~PlanRig() = default;

void PlanRig::step() {
    session_->step(scheduler_.now(), beating_);
    scheduler_.callAfter(std::chrono::milliseconds(10), [this] { step(); });
}

bool PlanRig::connect() {
    session_->start();
    return waitUntil([this] { return state().link == motionplan::LinkState::Running && state().answers; });
}

CommandId PlanRig::give(const motionplan::Command& command) {
    const CommandId id = ++lastCommand_;
    session_->execute(id, command);
    return id;
}

std::optional<Result<void>> PlanRig::answer(CommandId id) const {
    const auto found = answers_.find(id);
    if (found == answers_.end()) return std::nullopt;
    return found->second.front();
}

std::size_t PlanRig::answers(CommandId id) const {
    const auto found = answers_.find(id);
    return found == answers_.end() ? 0 : found->second.size();
}

Result<void> PlanRig::ask(const motionplan::Command& command) {
    const CommandId id = give(command);
    if (!waitUntil([this, id] { return answer(id).has_value(); }, std::chrono::seconds(60)))
        return fail(Errc::Io, "no answer");
    return *answer(id);
}

std::optional<Errc> PlanRig::refusal(const motionplan::Command& command) {
    const auto result = ask(command);
    return result ? std::nullopt : std::optional(result.error().code);
}

bool PlanRig::create(int plan, int slot, const Movements& movements) {
    return ask(motionplan::CreatePlan{plan, slot, movements}).has_value();
}

void PlanRig::stop(StopReason reason) {
    stop_.set(reason);
    session_->halt();
}

std::size_t PlanRig::count(motionplan::EventKind kind) const {
    return static_cast<std::size_t>(std::ranges::count(events_, kind, &motionplan::Event::kind));
}

void PlanRig::simulate(const char* action, double value) {
    const auto done = sim_.control().perform(action, -1, value);
    if (!done) std::abort();
}

void PlanRig::observe(const ByteTapRecord& record) {
    if (record.kind != ByteTapRecord::Kind::Sent) return;
    watched_.feed(record.data, [this](const motionplan::wire::Telegram& telegram) {
        const auto* write = std::get_if<motionplan::wire::MessageWrite>(&telegram);
        if (write != nullptr)
            written_.push_back(toHex(write->content.view().first(write->content.size() - 1)));
    });
}

std::size_t PlanRig::writtenOf(motionplan::wire::MessageKind kind) const {
    const std::uint8_t first = static_cast<std::uint8_t>(kind);
    const std::string prefix = toHex({&first, 1});
    return static_cast<std::size_t>(
        std::ranges::count_if(written_, [&](const std::string& hex) { return hex.starts_with(prefix); }));
}

}  // namespace kickstand::testing
