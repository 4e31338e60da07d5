#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/base/scheduler.h"
#include "core/coach/radio_settings.h"
#include "core/coach/side.h"
#include "core/coach/traffic.h"
#include "core/link/byte_link.h"

namespace kickstand::coach {

/// The serial line to a radio module: frames in and out, packets matched to their TX status, and what passed
/// remembered (coach protocol 2). The scheduler's thread.
class RadioLine {
  public:
    struct Listener {
        std::function<void(const Received&)> message;
        std::function<void(const xbee::AtResponse&)> atResponse;
        std::function<void(ByteView)> text;  ///< While the module does not speak in frames.
        std::function<void(std::uint8_t status)> modemStatus;
    };

    /// The link must outlive it.
    RadioLine(Scheduler& scheduler, ByteLink& link, Listener listener);
    ~RadioLine();
    RadioLine(const RadioLine&) = delete;
    RadioLine& operator=(const RadioLine&) = delete;

    /// How the module speaks from now on.
    void setMode(ModuleMode mode);
    ModuleMode mode() const { return mode_; }

    /// Sends a packet, and asks for its TX status.
    void send(std::uint16_t destination, const wire::Message& message);
    /// Sends an AT command in a frame; an empty value asks. Gives its frame ID.
    std::uint8_t sendAt(std::array<char, 2> name, ByteView value);
    /// Sends bytes as they are.
    void sendText(std::string_view text);

    const TrafficCounters& counters() const { return counters_; }
    /// Never null, immutable.
    std::shared_ptr<const TrafficEntries> entries() const;
    std::uint64_t version() const { return version_; }

  private:
    static constexpr std::size_t kRemembered = 200;

    void received(ByteView bytes);
    void take(const xbee::Frame& frame);
    void take(const xbee::Rx16& packet);
    void take(const xbee::TxStatus& status);
    void write(const xbee::Frame& frame);
    std::uint8_t nextFrameId();
    void remember(TrafficEntry entry);

    Scheduler& scheduler_;
    ByteLink& link_;
    Listener listener_;
    ModuleMode mode_ = ModuleMode::Api;
    xbee::Parser parser_;
    std::uint8_t lastFrameId_ = 0;
    TrafficCounters counters_;
    TrafficEntries entries_;
    std::uint64_t lastNumber_ = 0;
    mutable std::shared_ptr<const TrafficEntries> published_;
    std::uint64_t version_ = 0;
};

}  // namespace kickstand::coach
