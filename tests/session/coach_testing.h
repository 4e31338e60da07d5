#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/coach/session.h"
#include "core/coach/sim/coach_sim.h"
#include "core/link/paced/paced_byte_link.h"

namespace kickstand::coach::testing {

/// A whole session on a simulated module, as the engine runs it, on a fake clock.
class SessionBench : private SampleSink {
  public:
    SessionBench(FakeScheduler& scheduler, sim::XbeeSim& module)
        : scheduler_(scheduler),
          link_(new PacedByteLink(scheduler, module, {"sim", "XBee adapter", 9600, {}})),
          session_(
              {scheduler, stop_, *this, [this](const Event& event) { events.push_back(event); },
               [this](CommandId id, Result<void> result) { answers_.emplace_back(id, std::move(result)); }},
              std::unique_ptr<ByteLink>(link_)) {
        session_.start();
        step();
    }
    ~SessionBench() override { scheduler_.cancel(stepper_); }

    Session& session() { return session_; }
    StopLatch& stop() { return stop_; }
    PacedByteLink& link() { return *link_; }
    Snapshot state() const { return session_.snapshot(); }
    /// Gives a command and lets the time pass that its answer takes; half a minute at most.
    Result<void> give(const Command& command) {
        const CommandId id = ++lastId_;
        session_.execute(id, command);
        const auto answer = [this, id]() -> Result<void>* {
            for (auto& [answered, result] : answers_) {
                if (answered == id) return &result;
            }
            return nullptr;
        };
        scheduler_.runUntil([&] { return answer() != nullptr; }, std::chrono::seconds(30));
        return answer() != nullptr ? *answer() : fail(Errc::Io, "no answer");
    }
    void press(StopReason reason = StopReason::Person) {
        stop_.set(reason);
        session_.halt();
    }
    std::size_t count(EventKind kind) const {
        std::size_t count = 0;
        for (const Event& event : events)
            count += event.kind == kind ? 1 : 0;
        return count;
    }
    bool heartbeat = true;
    std::vector<Event> events;
    std::vector<std::pair<SignalId, float>> samples;

  private:
    void sample(SignalId signal, TimePoint, float value) override { samples.emplace_back(signal, value); }
    void gap(SignalId, TimePoint) override {}
    void step() {
        session_.step(scheduler_.now(), heartbeat);
        stepper_ = scheduler_.callAfter(std::chrono::milliseconds(10), [this] { step(); });
    }

    FakeScheduler& scheduler_;
    StopLatch stop_;
    PacedByteLink* link_;
    std::vector<std::pair<CommandId, Result<void>>> answers_;
    CommandId lastId_ = 0;
    Session session_;
    TimerId stepper_ = 0;
};

/// Simulated radios, and a session on each module.
struct CoachBench {
    explicit CoachBench(const sim::CoachSimOptions& options) : sim(scheduler, options) {
        for (std::size_t i = 0; i < sim.modules(); ++i)
            sessions.push_back(std::make_unique<SessionBench>(scheduler, sim.module(i)));
        wait(2000);
    }

    SessionBench& operator[](std::size_t index) { return *sessions[index]; }
    void wait(int ms) { scheduler.advance(std::chrono::milliseconds(ms)); }
    bool within(int ms, const std::function<bool()>& done) {
        return scheduler.runUntil(done, std::chrono::milliseconds(ms));
    }

    FakeScheduler scheduler;
    sim::CoachSim sim;
    std::vector<std::unique_ptr<SessionBench>> sessions;
};

inline sim::CoachSimOptions boats(std::vector<Team> teams) {
    sim::CoachSimOptions options;
    options.boats = std::move(teams);
    options.fall = Duration::zero();
    return options;
}

/// The modules of a COACH and of a boat of team 5, and nothing else.
inline sim::CoachSimOptions twoSides() {
    sim::CoachSimOptions options = boats({});
    options.modules = {0xBC05, 0xAF05};
    return options;
}

}  // namespace kickstand::coach::testing
