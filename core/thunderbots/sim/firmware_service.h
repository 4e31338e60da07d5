#pragma once

#include <cstdint>
#include <functional>

#include "core/base/bytes.h"
#include "core/thunderbots/sim/flash_chip.h"
#include "core/thunderbots/sim/microcontroller.h"
#include "core/thunderbots/sim/timers.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots::sim {

/// The robot's side of the firmware pipes (protocol 4.7): takes one request at a time, each as long as the
/// protocol says. What it cannot make sense of it passes over in silence, and counts.
class FirmwareService {
  public:
    /// Hands a response to whoever carries it. After a reboot's response is delivered the robot reboots.
    using Respond = std::function<void(const wire::MessagePayload& response, bool rebootAfterwards)>;

    /// The other two must outlive it.
    FirmwareService(Scheduler& scheduler, FlashChip& flash, Microcontroller& controller, Respond respond);

    /// Gives up what it was doing and empties the page buffer, as a reboot or loss of power does.
    void reset();
    /// Takes a message of the firmware request pipe.
    void handle(ByteView message);
    /// Messages passed over: malformed, outside the flash, of a parameters block of the wrong length, or sent
    /// while another request was under way.
    std::uint64_t ignored() const { return ignored_; }
    /// Page programs refused for the CRC.
    std::uint64_t wrongCrcs() const { return wrongCrcs_; }

  private:
    void execute(const wire::EraseChipRequest& request);
    void execute(const wire::FillPageRequest& request);
    void execute(const wire::ProgramPageRequest& request);
    void execute(const wire::BlockCrcRequest& request);
    void execute(const wire::ReadParametersRequest& request);
    void execute(const wire::SetParametersRequest& request);
    void execute(const wire::CommitParametersRequest& request);
    void execute(const wire::RebootRequest& request);
    void execute(const wire::ReadSignaturesRequest& request);

    void answer(const wire::FirmwareResponse& response, bool rebootAfterwards = false);
    void answerAfter(Duration time, std::function<wire::FirmwareResponse()> finish);

    FlashChip& flash_;
    Microcontroller& controller_;
    Respond respond_;
    Timer busy_;
    FlashChip::Page page_{};
    std::uint64_t ignored_ = 0;
    std::uint64_t wrongCrcs_ = 0;
};

}  // namespace kickstand::thunderbots::sim
