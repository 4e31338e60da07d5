#pragma once

#include <atomic>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/link/byte_link.h"

namespace kickstand::pty {

/// What a terminal says, on its own thread.
struct TerminalEvents {
    std::function<void(Baud)> opened;  ///< A program has it open now.
    std::function<void()> closed;      ///< No program has it open any longer.
    std::function<void(Baud)> baudChanged;
    std::function<void(std::vector<std::uint8_t>)> received;
};

/// The device's end of one pseudo-terminal, read and written by a thread of its own. Destroying it hangs up.
class Terminal {
  public:
    /// Errors: Io with the system's word.
    static Result<std::unique_ptr<Terminal>> open(TerminalEvents events);
    ~Terminal();
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;

    const std::string& name() const { return name_; }
    /// Sends as soon as there is room; what nobody has opened it for, or has no room any longer, is lost. Any
    /// thread. False where something was lost.
    bool send(ByteView bytes);

  private:
    Terminal(int master, int wakeRead, int wakeWrite, std::string name, TerminalEvents events);

    void run();
    /// One look at the terminal; false when the thread is to end.
    bool turn();
    void receive();
    void sendWaiting();
    void watchBaud();
    void setHeld(bool held);
    void wake() const;

    const int master_;
    const int wakeRead_;
    const int wakeWrite_;
    const std::string name_;
    const TerminalEvents events_;
    // The thread's.
    bool held_ = false;
    Baud baud_ = 0;
    // Shared.
    std::mutex mutex_;
    std::deque<std::uint8_t> waiting_;
    bool heldShared_ = false;
    std::atomic<bool> ending_{false};
    std::thread thread_;
};

}  // namespace kickstand::pty
