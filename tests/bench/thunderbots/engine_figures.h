#pragma once

#include <functional>
#include <string>

#include "core/engine/link_provider.h"

namespace kickstand::bench {

/// A way from the engine to a simulated dongle with sixteen robots on an ideal radio.
struct BenchedLink {
    std::string uri;
    /// Makes the link; called on the engine's thread, once a connection.
    std::function<Result<ProvidedUsbLink>(const LinkUri& uri, Scheduler& scheduler)> make;
    int samples = 2000;  ///< Of each figure, where the command line does not say.
    int starts = 20;     ///< Sessions that are started before the one that is measured.
};

/// Measures how long a command and a STOP take from the caller's thread until the link has taken the last
/// block, while sixteen robots feed back at 200 Hz, and how long a session takes to start. Prints one JSON
/// object. `count` and `arguments` are main()'s; so is what it returns.
int measureEngine(const BenchedLink& benched, int count, char** arguments);

}  // namespace kickstand::bench
