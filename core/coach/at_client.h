#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/coach/radio_line.h"

namespace kickstand::coach {

/// The two letters of an AT command.
using AtName = std::array<char, 2>;

/// Asks a radio module one thing after another, in frames or, where it is transparent, in its command mode
/// (coach protocol 2.3, 2.4). The scheduler's thread.
class AtClient {
  public:
    /// What came back: the value's bytes as a frame carries them; empty where something was set.
    using Done = std::function<void(Result<std::vector<std::uint8_t>>)>;

    AtClient(Scheduler& scheduler, RadioLine& line) : scheduler_(scheduler), line_(line) {}
    ~AtClient();
    AtClient(const AtClient&) = delete;
    AtClient& operator=(const AtClient&) = delete;

    /// Brings a transparent module into its command mode: a second of silence, +++, a second of silence.
    /// TimedOut where no OK comes. A module that speaks in frames is always ready.
    void enterCommandMode(Done done);
    /// Asks (`value` empty) or sets a parameter, or commands. One at a time. Errors: TimedOut; Malformed;
    /// BadArgument where the module refuses it.
    void ask(AtName name, std::vector<std::uint8_t> value, Done done);
    /// Breaks off what is asked, unanswered.
    void cancel();

    // What comes from the line.
    void response(const xbee::AtResponse& response);
    void text(ByteView bytes);

  private:
    void begin(Done done, Duration limit);
    void finish(Result<std::vector<std::uint8_t>> result);
    void lineCame(std::string_view line);

    Scheduler& scheduler_;
    RadioLine& line_;
    Done done_;
    AtName name_{};
    bool sets_ = false;
    std::uint8_t frameId_ = 0;
    std::string text_;
    TimerId timer_ = 0;
};

}  // namespace kickstand::coach
