#pragma once

#include <memory>
#include <string>

#include "core/base/scheduler.h"
#include "core/link/byte_device_model.h"
#include "core/link/byte_link.h"
#include "core/link/paced/byte_faults.h"
#include "core/link/paced/paced_queue.h"

namespace kickstand {

/// How a line to a simulated device is.
struct PacedLineOptions {
    std::string port{};         ///< The name that it has in ByteLinkInfo.
    std::string description{};  ///< What the device says it is.
    Baud baud = 115200;
    ByteFaultOptions faults{};
};

/// The line to a simulated device in this process, as fast as its baud rate lets bytes pass.
class PacedByteLink final : public ByteLink, private ByteDeviceListener {
  public:
    /// `scheduler` is the one that the model was made with. Both must outlive the link, which is the model's
    /// listener as long as it lives.
    PacedByteLink(Scheduler& scheduler, ByteDeviceModel& model, PacedLineOptions options = {});
    ~PacedByteLink() override;
    PacedByteLink(const PacedByteLink&) = delete;
    PacedByteLink& operator=(const PacedByteLink&) = delete;

    void open(std::function<void(Result<ByteLinkInfo>)> done) override;
    void close(std::function<void()> done) override;
    Result<void> write(ByteView bytes) override;
    std::size_t waiting() const override { return toDevice_.size(); }
    void setBaud(Baud baud, std::function<void(Result<void>)> done) override;
    void setReceiver(std::function<void(ByteView)> receiver) override;
    void setPresenceListener(std::function<void(bool present)> listener) override;

    /// How the line treats bytes from now on.
    void setFaults(const ByteFaultOptions& faults) { faults_.setOptions(faults); }

  private:
    enum class State : std::uint8_t { Closed, Opening, Open, Closing, Losing };

    void deviceSent(ByteView bytes) override;
    void attachedChanged(bool attached) override;
    void opened();
    void reachedDevice(ByteView bytes);
    void finishClosing();
    void releaseLine();
    void lost();
    void post(std::function<void()> callback);

    Scheduler& scheduler_;
    ByteDeviceModel& model_;
    PacedLineOptions options_;
    ByteFaults faults_;
    State state_ = State::Closed;
    bool lineOpen_ = false;      ///< Whether the model was told so.
    std::uint64_t opening_ = 0;  ///< Tells the answer to an earlier open() from that to this one.
    std::function<void(Result<ByteLinkInfo>)> done_;
    std::vector<std::function<void()>> closers_;
    std::function<void(ByteView)> receiver_;
    std::function<void(bool)> presence_;
    TimerId closingTimer_ = 0;
    PacedQueue toDevice_;
    PacedQueue toHost_;
    std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);
};

}  // namespace kickstand
