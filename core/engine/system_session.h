#pragma once

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "core/base/session_host.h"
#include "core/engine/systems.h"

namespace kickstand {

/// A session of any system, as the engine runs it. Engine thread.
class SystemSession {
  public:
    virtual ~SystemSession() = default;

    /// Begins to open the link. Once, first.
    virtual void start() = 0;
    /// Answers through the host, exactly once; BadArgument for another system's command.
    virtual void execute(CommandId id, const SystemCommand& command) = 0;
    /// The safety step, every 10 ms.
    virtual void step(TimePoint now, bool heartbeatFresh) = 0;
    /// STOP has been latched.
    virtual void halt() = 0;
    /// Whether anything moves, charges, is armed or executes: what a stale heartbeat or a lost focus must
    /// stop.
    virtual bool active() const = 0;
    /// Brakes and closes the link; `done` comes once, when it is closed.
    virtual void shutdown(std::function<void()> done) = 0;
    /// Grows whenever snapshot() would give something else.
    virtual std::uint64_t version() const = 0;
    /// Everything as it is now, as plain values.
    virtual SystemSnapshot snapshot() const = 0;
};

/// Makes a SystemSession of a system's own Session class, which knows nothing of the engine. `Session` has
/// the methods above with its own types, and Command is what it takes.
template <class Session, class SystemCommandType>
class SystemSessionOf final : public SystemSession {
  public:
    template <class... Args>
    explicit SystemSessionOf(typename Session::Host host, Args&&... args)
        : answer_(host.answer), session_(std::move(host), std::forward<Args>(args)...) {}

    void start() override { session_.start(); }
    void execute(CommandId id, const SystemCommand& command) override {
        if (const auto* own = std::get_if<SystemCommandType>(&command)) {
            session_.execute(id, *own);
        } else {
            answer_(id, fail(Errc::BadArgument, "command"));
        }
    }
    void step(TimePoint now, bool heartbeatFresh) override { session_.step(now, heartbeatFresh); }
    void halt() override { session_.halt(); }
    bool active() const override { return session_.active(); }
    void shutdown(std::function<void()> done) override { session_.shutdown(std::move(done)); }
    std::uint64_t version() const override { return session_.version(); }
    SystemSnapshot snapshot() const override { return session_.snapshot(); }

  private:
    std::function<void(CommandId, Result<void>)> answer_;
    Session session_;
};

}  // namespace kickstand
