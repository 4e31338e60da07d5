#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"
#include "core/base/scheduler.h"
#include "core/link/byte_device_model.h"

namespace kickstand {

/// A simulated device as a serial port of this machine: a pseudo-terminal that any program may open, under a
/// name that stays when the terminal's own changes. While the device is pulled out there is no port, and a
/// program that holds it open sees it hang up.
class PtyPort {
  public:
    virtual ~PtyPort() = default;
    /// The terminal's own name now ("/dev/pts/7"); empty while the device is pulled out.
    virtual std::string terminal() const = 0;
    /// What the device sent while nobody read and no room was left, in bytes.
    virtual std::uint64_t lost() const = 0;
};

/// Serves `model`, whose listener it is as long as it lives, on a pseudo-terminal. `link` becomes a symbolic
/// link to it, in place of an old one to a terminal that is gone; empty for none. The scheduler is the
/// model's; both must outlive the port. Errors: BadArgument where something else than such a link has the
/// name; ClaimedElsewhere where its terminal is there, and so belongs to another program; Io. Scheduler's
/// thread.
Result<std::unique_ptr<PtyPort>> makePtyPort(Scheduler& scheduler, ByteDeviceModel& model, std::string link);

}  // namespace kickstand
