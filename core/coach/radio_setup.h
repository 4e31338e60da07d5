#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "core/coach/at_client.h"

namespace kickstand::coach {

/// Finds a radio module at whatever speed and in whatever mode it is, reads it, and sets it (coach protocol
/// 2.5). One job at a time; a new one breaks the last one off, unanswered. The scheduler's thread.
class RadioSetup {
  public:
    using Done = std::function<void(Result<FoundRadio>)>;

    RadioSetup(Scheduler& scheduler, ByteLink& link, RadioLine& line);

    /// Asks a module that is to be at `baud` and to speak in frames. TimedOut where none answers.
    void ask(Baud baud, Done done);
    /// Looks at every usual speed, first for frames, then for a transparent module; `baud` comes first.
    /// TimedOut where there is none.
    void find(Baud baud, Done done);
    /// Sets what differs from `present`, which was read before, writes it to the module's memory, finds it
    /// again and reads it back. Errors: checkSettings()'s; BadArgument with the module's word where it
    /// refuses; RadioDiffers where it says something else afterwards; TimedOut; Unsupported with the speed
    /// where the port does not have the one that is wanted, and then nothing was said to the module.
    void apply(const RadioSettings& present, const RadioSettings& wanted, Done done);
    /// Breaks off.
    void cancel();
    bool busy() const { return static_cast<bool>(done_); }
    /// So far, for a person: the speed that is tried.
    Baud tries() const { return baud_; }

    AtClient& client() { return client_; }

  private:
    struct Step {
        AtName name{};
        std::vector<std::uint8_t> value{};
    };
    struct Place {
        Baud baud = 0;
        bool frames = true;
    };

    void begin(Done done);
    void finish(Result<FoundRadio> result);
    void tryNext();
    void setBaud(Baud baud, std::function<void()> then);
    void tryFrames();
    void tryText();
    void read();
    void readNext();
    void take(AtName name, const std::vector<std::uint8_t>& value);
    void leave(std::function<void()> then);
    void tryWantedBaud(std::function<void()> then);
    void planChanges(const RadioSettings& present);
    void setNext();
    void afterSetting(AtName name);
    void verify();

    Scheduler& scheduler_;
    ByteLink& link_;
    RadioLine& line_;
    AtClient client_;
    Done done_;
    std::vector<Place> places_;  ///< Still to be tried, the next one last.
    std::vector<Step> steps_;    ///< Still to be done, the next one last.
    std::optional<RadioSettings> wanted_;
    bool written_ = false;
    Baud baud_ = 9600;
    FoundRadio found_;
    std::uint64_t job_ = 0;
};

}  // namespace kickstand::coach
