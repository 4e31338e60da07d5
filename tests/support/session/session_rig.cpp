#include "tests/support/session/session_rig.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/link/loopback/loopback_usb_link.h"
#include "core/link/tapped_usb_link.h"

namespace kickstand::testing {
namespace {

using namespace std::chrono_literals;

constexpr Duration kBeatEvery = 50ms;

}  // namespace

SessionRig::SessionRig(SessionRigOptions options)
    : options_(std::move(options)),
      sim_(scheduler_, options_.sim),
      core_(std::make_unique<EngineCore>(scheduler_, static_cast<LinkProvider&>(*this), options_.engine)) {
    heartbeat();
    core_->start();
}

SessionRig::~SessionRig() = default;

void SessionRig::heartbeat() {
    if (beating_) flows().heartbeat.beat(scheduler_.now());
    scheduler_.callAfter(kBeatEvery, [this] { heartbeat(); });
}

Result<ProvidedUsbLink> SessionRig::makeUsbLink(const LinkUri& uri, Scheduler& scheduler) {
    if (!uri.isSimulated()) return fail(Errc::BadUri, toString(uri));
    std::unique_ptr<UsbLink> link = options_.makeLink
                                        ? options_.makeLink(sim_.device(), scheduler)
                                        : std::make_unique<LoopbackUsbLink>(scheduler, sim_.device());
    if (options_.decorate) link = options_.decorate(std::move(link), scheduler);
    auto tapped = std::make_unique<TappedUsbLink>(std::move(link), scheduler);
    tapped->addObserver(this);
    if (options_.observer) tapped->addObserver(options_.observer);
    ProvidedUsbLink provided;
    provided.link = std::move(tapped);
    provided.sim = &sim_.control();
    return provided;
}

void SessionRig::discover(Scheduler& scheduler, std::function<void(FoundHardware)> found) {
    scheduler.post([found = std::move(found)] { found({}); });
}

void SessionRig::observe(const UsbTapRecord& record) {
    const bool taken = record.kind == UsbTapRecord::Kind::Completed &&
                       record.status == UsbStatus::Completed && !record.setup &&
                       !isInEndpoint(record.endpoint);
    if (options_.keepPackets && taken)
        packets_.push_back({record.time, record.endpoint, {record.data.begin(), record.data.end()}});
}

void SessionRig::beginConnect() {
    LinkUri uri;
    uri.scheme = "sim";
    uri.target = "thunderbots";
    ++session_;
    give(Connect{uri}, session_);
}

bool SessionRig::isRunning() {
    const thunderbots::Snapshot now = state();
    if (now.link != thunderbots::LinkState::Running) return false;
    for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
        const bool up = sim_.hasRobot(robot) && sim_.robot(robot).power == thunderbots::sim::RobotPower::Up;
        const auto& known = now.robots.at(static_cast<std::size_t>(robot));
        if (up && known.freshness != thunderbots::Freshness::Current) return false;
    }
    return true;
}

bool SessionRig::connect() {
    beginConnect();
    // Looked at once in a while: a snapshot is too large to be looked at after every call.
    for (int i = 0; i < 200; ++i) {
        scheduler_.advance(100ms);
        if (isRunning()) return true;
    }
    return false;
}

CommandId SessionRig::give(const thunderbots::Command& command) {
    return give(SystemCommand{command}, session_);
}

CommandId SessionRig::give(CommandBody body, SessionId session) {
    const CommandId id = ++lastCommand_;
    answers_[id];
    if (!flows().commands.tryPush(Command{id, session, std::move(body)}))
        answers_[id].push_back(fail(Errc::QueueFull, "command"));
    core_->wake();
    return id;
}

void SessionRig::readFlows() {
    while (auto answer = flows().answers.tryPop())
        answers_[answer->id].push_back(std::move(answer->result));
    for (;;) {
        const auto read = flows().events.read(eventCursor_);
        if (read.events.empty()) return;
        for (const auto& event : read.events) {
            if (const auto* system = std::get_if<SystemEvent>(&event.value.body))
                events_.push_back(std::get<thunderbots::Event>(*system));
        }
    }
}

std::optional<Result<void>> SessionRig::answer(CommandId id) {
    readFlows();
    if (answers_[id].empty()) return std::nullopt;
    return answers_[id].front();
}

std::size_t SessionRig::answers(CommandId id) {
    readFlows();
    return answers_[id].size();
}

std::vector<CommandId> SessionRig::unanswered() {
    readFlows();
    std::vector<CommandId> ids;
    for (const auto& [id, given] : answers_) {
        if (given.empty()) ids.push_back(id);
    }
    return ids;
}

Result<void> SessionRig::ask(const thunderbots::Command& command) {
    const CommandId id = give(command);
    waitUntil([this, id] { return answers(id) > 0; }, 2s);
    return answer(id).value_or(fail(Errc::TimedOut));
}

std::optional<Errc> SessionRig::refusal(const thunderbots::Command& command) {
    const auto done = ask(command);
    if (done) return std::nullopt;
    return done.error().code;
}

void SessionRig::stop(StopReason reason) {
    flows().stop.set(reason);
    core_->wake();
}

void SessionRig::rearm() {
    flows().stop.rearm();
    core_->wake();
}

thunderbots::Snapshot SessionRig::state() {
    const auto latest = flows().snapshots.latest().value;
    for (const SessionSnapshot& session : latest->sessions) {
        if (session.id == session_) return std::get<thunderbots::Snapshot>(session.system);
    }
    return {};
}

const std::vector<thunderbots::Event>& SessionRig::events() {
    readFlows();
    return events_;
}

std::size_t SessionRig::count(thunderbots::EventKind kind) {
    return static_cast<std::size_t>(
        std::ranges::count(events(), kind, [](const thunderbots::Event& event) { return event.kind; }));
}

std::optional<thunderbots::Event> SessionRig::last(thunderbots::EventKind kind) {
    for (std::size_t i = events().size(); i > 0; --i) {
        if (events_[i - 1].kind == kind) return events_[i - 1];
    }
    return std::nullopt;
}

void SessionRig::forget() {
    readFlows();
    std::erase_if(answers_, [](const auto& entry) { return !entry.second.empty(); });
    events_.clear();
    packets_.clear();
}

void SessionRig::killHost() {
    core_->endSessions();
}

void SessionRig::simulate(const char* action, double value, int unit) {
    // A test that asks for what the simulator does not know would prove nothing.
    if (!sim_.control().perform(action, unit, value)) std::abort();
}

bool SessionRig::anyWheelTurns() const {
    for (int unit = 0; unit < thunderbots::kRobots; ++unit) {
        if (!sim_.hasRobot(unit)) continue;
        const auto speeds = sim_.robot(unit).wheelSpeeds;
        if (std::ranges::any_of(speeds, [](double speed) { return std::abs(speed) > 1; })) return true;
    }
    return false;
}

}  // namespace kickstand::testing
