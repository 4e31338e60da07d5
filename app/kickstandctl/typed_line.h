#pragma once

#include <optional>
#include <string>

namespace kickstand::ctl {

/// Standard input, a line at a time and without ever waiting: robots need a heartbeat meanwhile. Main thread.
class TypedLine {
  public:
    /// The next line that was typed, without its end; none while there is no whole one.
    std::optional<std::string> take();
    /// Whether no more can come.
    bool ended() const { return ended_; }

  private:
    std::string typed_;
    bool ended_ = false;
};

}  // namespace kickstand::ctl
