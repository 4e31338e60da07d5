#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "core/base/scheduler.h"
#include "core/link/byte_ports.h"
#include "core/smartdevice/events.h"
#include "core/smartdevice/snapshot.h"
#include "core/smartdevice/wire/frame.h"

namespace kickstand::smartdevice {

/// What a line says. None of it may destroy the line.
struct LineEvents {
    std::function<void(const wire::Uid&)> identified;
    std::function<void(const wire::Message&)> message;
    std::function<void()> gone;  ///< Nobody is there any longer.
    std::function<void(EventKind, std::int64_t code)> event;
};

/// One serial port with, perhaps, a board at its end: opens it, waits out the board's reset, asks in both
/// dialects who is there, and from then on carries messages (protocol 1). Engine thread.
class Line {
  public:
    Line(Scheduler& scheduler, BytePorts& ports, const BytePort& port, LineEvents events);
    Line(const Line&) = delete;
    Line& operator=(const Line&) = delete;

    /// Opens the port, or tries again where it is silent or failed.
    void start();
    /// Every 10 ms.
    void step(TimePoint now);
    /// False where nobody is there or no more fits.
    bool send(const wire::Message& message);
    /// Closes the port and begins anew: the board has gone quiet.
    void restart();
    /// The board that answered cannot be used; the port is given up until start().
    void refuse(const Error& error);
    void close(std::function<void()> done);
    /// Whose it is, for the snapshot; -1 for nobody's.
    void setDevice(int number) { state_.device = number; }

    const PortState& state() const { return state_; }
    /// What came in the dialect that is spoken here.
    wire::DecoderCounts counts() const;

  private:
    void opened(Result<ByteLinkInfo> info);
    void received(ByteView bytes);
    void heard(wire::Dialect dialect, const wire::Message& message);
    void presence(bool present);
    void ask(TimePoint now);
    void leave(PortPhase phase);
    wire::Decoder& decoder(wire::Dialect dialect);

    Scheduler& scheduler_;
    LineEvents events_;
    PortState state_;
    std::optional<wire::Dialect> dialect_;
    wire::Dialect asking_ = wire::Dialect::Current;
    TimePoint askAt_{};
    TimePoint askUntil_{};
    std::optional<TimePoint> retryAt_;
    wire::Decoder current_{wire::Dialect::Current};
    wire::Decoder hibike_{wire::Dialect::Hibike};
    // Last, so that it goes first: its callbacks end here.
    std::unique_ptr<ByteLink> link_;
};

}  // namespace kickstand::smartdevice
