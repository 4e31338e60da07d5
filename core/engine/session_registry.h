#pragma once

#include <memory>

#include "core/engine/link_provider.h"
#include "core/engine/system_session.h"
#include "core/link/link_uri.h"
#include "core/telemetry/store.h"

namespace kickstand {

/// What every session needs of the engine, whichever system it is of.
struct SessionEnvironment {
    Scheduler& scheduler;
    StopLatch& stop;
    SampleSink& samples;
    std::function<void(SystemEvent)> event;
    std::function<void(CommandId, Result<void>)> answer;
};

/// A session that was made, with the simulator behind its link where there is one.
struct MadeSession {
    std::shared_ptr<void> keepAlive;  ///< Destroyed after the session.
    std::unique_ptr<SystemSession> session;
    SimControl* sim = nullptr;
    TelemetryLimits telemetry{};
};

/// Makes the session of the system that a URI belongs to. Errors: BadUri, Unsupported, and the provider's.
/// Engine thread.
Result<MadeSession> makeSession(const LinkUri& uri, LinkProvider& links,
                                const SessionEnvironment& environment);

}  // namespace kickstand
