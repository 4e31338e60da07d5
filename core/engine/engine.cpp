#include "core/engine/engine.h"

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <utility>

#include "core/base/thread_scheduler.h"
#include "core/engine/engine_core.h"

namespace kickstand {

class Engine::Impl {
  public:
    Impl(std::unique_ptr<LinkProvider> links, const EngineOptions& options)
        : links_(std::move(links)),
          wallStart_(std::chrono::system_clock::now()),
          start_(scheduler_->now()),
          core_(std::make_unique<EngineCore>(*scheduler_, *links_, options)),
          flows_(core_->flows()) {
        scheduler_->post([this] { core_->start(); });
    }

    ~Impl() {
        shutdown();
        // Sessions end on the thread they ran on, after everything that was posted for them.
        onEngineThread([this](const std::function<void()>& done) {
            core_.reset();
            done();
        });
        // First whoever may still post, then the thread that runs what was posted.
        links_.reset();
        scheduler_.reset();
    }

    void shutdown() {
        if (shutDown_.exchange(true)) return;
        onEngineThread([this](std::function<void()> done) { core_->shutdown(std::move(done)); });
    }

    /// Runs `work` on the engine's thread and waits until it has called what it is given.
    void onEngineThread(std::function<void(std::function<void()>)> work) {
        struct Wait {
            std::mutex mutex;
            std::condition_variable changed;
            bool done = false;
        };
        const auto wait = std::make_shared<Wait>();
        scheduler_->post([wait, work = std::move(work)] {
            work([wait] {
                const std::lock_guard lock(wait->mutex);
                wait->done = true;
                wait->changed.notify_all();
            });
        });
        std::unique_lock lock(wait->mutex);
        wait->changed.wait(lock, [&wait] { return wait->done; });
    }

    Result<CommandId> submit(SessionId session, CommandBody body) {
        const CommandId id = ++lastCommand_;
        if (!flows_.commands.tryPush(Command{id, session, std::move(body)})) {
            Error error;
            error.code = Errc::QueueFull;
            error.subject = "command";
            error.highest = static_cast<std::int64_t>(EngineFlows::kCommands);
            return fail(std::move(error));
        }
        core_->wake();
        return id;
    }

    std::unique_ptr<LinkProvider> links_;
    std::unique_ptr<ThreadScheduler> scheduler_ = std::make_unique<ThreadScheduler>();
    const std::chrono::system_clock::time_point wallStart_;
    const TimePoint start_;
    std::unique_ptr<EngineCore> core_;
    EngineFlows& flows_;
    std::atomic<CommandId> lastCommand_{0};
    std::atomic<SessionId> lastSession_{0};
    std::atomic<bool> shutDown_{false};
};

Engine::Engine(std::unique_ptr<LinkProvider> links, const EngineOptions& options)
    : impl_(std::make_unique<Impl>(std::move(links), options)) {}

Engine::~Engine() = default;

Result<SessionId> Engine::connect(const LinkUri& uri) {
    const SessionId session = ++impl_->lastSession_;
    const auto submitted = impl_->submit(session, Connect{uri});
    if (!submitted) return fail(submitted.error());
    return session;
}

Result<CommandId> Engine::submit(SessionId session, CommandBody body) {
    return impl_->submit(session, std::move(body));
}

std::vector<Answer> Engine::takeAnswers() {
    std::vector<Answer> answers;
    while (auto answer = impl_->flows_.answers.tryPop())
        answers.push_back(std::move(*answer));
    return answers;
}

void Engine::stop(StopReason reason) {
    impl_->flows_.stop.set(reason);
    impl_->core_->wake();
}

void Engine::rearm() {
    impl_->flows_.stop.rearm();
    impl_->core_->wake();
}

bool Engine::isStopped() const {
    return impl_->flows_.stop.isSet();
}

void Engine::heartbeat() {
    impl_->flows_.heartbeat.beat(impl_->scheduler_->now());
}

std::shared_ptr<const EngineSnapshot> Engine::snapshot() const {
    return impl_->flows_.snapshots.latest().value;
}

std::uint64_t Engine::snapshotVersion() const {
    return impl_->flows_.snapshots.version();
}

EventRing<EngineEvent>::Read Engine::readEvents(std::uint64_t& cursor) const {
    return impl_->flows_.events.read(cursor);
}

TimePoint Engine::now() const {
    return impl_->scheduler_->now();
}

std::chrono::system_clock::time_point Engine::wallTime(TimePoint time) const {
    return impl_->wallStart_ +
           std::chrono::duration_cast<std::chrono::system_clock::duration>(time - impl_->start_);
}

void Engine::shutdown() {
    impl_->shutdown();
}

}  // namespace kickstand
