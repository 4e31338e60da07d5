#pragma once

#include <optional>
#include <string>

#include "core/base/time.h"

namespace kickstand::ctl {

/// Ends a command from outside: SIGINT, SIGTERM, SIGHUP, SIGQUIT, or the reader of standard output going away
/// (which SIGPIPE would say: it is ignored, so that robots are braked first). One object at a time. Main
/// thread.
class Interruption {
  public:
    Interruption();
    ~Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;

    /// Waits this long, or until something comes.
    void wait(Duration limit);
    /// "SIGTERM", or "the reader of the output is gone"; empty while nothing came.
    const std::optional<std::string>& cause() const { return cause_; }
    /// Whether it was a person's Ctrl+C, or what a script sends in its place: the way to end what has no end.
    bool isRequest() const { return isRequest_; }

  private:
    std::optional<std::string> cause_;
    bool isRequest_ = false;
};

}  // namespace kickstand::ctl
