#pragma once

#include <string>

namespace kickstand::sim {

/// The signals that end a program that serves until it is told to stop: SIGINT, SIGTERM, SIGHUP (unless it
/// was started to outlive its terminal) and SIGQUIT. Made before any thread, so that none takes them
/// instead. A reader of the output that goes away ends nothing: SIGPIPE is ignored.
class EndSignals {
  public:
    EndSignals();
    /// Waits for one; "SIGTERM". Main thread.
    std::string wait();
};

}  // namespace kickstand::sim
