#pragma once

#include "core/base/bytes.h"
#include "core/link/byte_link.h"

namespace kickstand {

/// Hears from a device at the other end of a serial line. Called on the model's thread, possibly from inside
/// a call into the model.
class ByteDeviceListener {
  public:
    virtual ~ByteDeviceListener() = default;
    /// The device sends these; they are valid during the call.
    virtual void deviceSent(ByteView bytes) = 0;
    /// The device was plugged in (true) or pulled out (false).
    virtual void attachedChanged(bool attached) = 0;
};

/// A device on a serial line, in software. Implemented by the simulators; served in this process
/// (PacedByteLink) and on pseudo-terminals. One thread, that of the scheduler it was made with.
class ByteDeviceModel {
  public:
    virtual ~ByteDeviceModel() = default;

    /// Whether it is plugged in. While it is not, none of the rest may be called.
    virtual bool attached() const = 0;
    /// At most one listener; nullptr to have none.
    virtual void setListener(ByteDeviceListener* listener) = 0;
    /// A host opened the line, at this speed: many boards reset on it.
    virtual void lineOpened(Baud baud) = 0;
    virtual void lineClosed() = 0;
    /// The host changed its speed. A device on USB may not care; one on a real line understands nothing at
    /// any speed but its own.
    virtual void lineBaudChanged(Baud baud) = 0;
    /// The host sent these.
    virtual void hostSent(ByteView bytes) = 0;
};

}  // namespace kickstand
