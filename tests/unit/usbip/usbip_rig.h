#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/base/fake_scheduler.h"
#include "core/usbip/usbip_connection.h"
#include "tests/support/usb/memory_stream.h"

namespace kickstand::testing {

/// A client of a USB/IP server that says exactly what a test tells it to, and keeps all that it hears.
class RawClient {
  public:
    struct Answer {
        usbip::Reply reply;
        std::vector<std::uint8_t> data;
        TimePoint time{};
    };

    RawClient(Scheduler& scheduler, std::unique_ptr<ByteStream> stream);

    /// Begins to read what has come and comes.
    void read();
    void send(ByteView bytes) { stream_->send(bytes); }
    void list();
    void import(const std::string& busId);
    /// Each gives the sequence number of its command.
    std::uint32_t in(std::uint8_t endpoint, std::uint32_t length);
    std::uint32_t out(std::uint8_t endpoint, std::vector<std::uint8_t> bytes, std::uint32_t flags = 0);
    std::uint32_t controlIn(const UsbSetup& setup, std::uint32_t length);
    std::uint32_t controlOut(const UsbSetup& setup, std::vector<std::uint8_t> bytes = {});
    std::uint32_t unlink(std::uint32_t sequence);
    std::uint32_t submit(usbip::Command command);
    void close() { stream_->close(); }

    std::optional<usbip::OpStatus> status() const { return status_; }
    const std::vector<usbip::Device>& devices() const { return devices_; }
    /// What it imported.
    const usbip::Device& device() const { return device_; }
    const std::vector<Answer>& answers() const { return answers_; }
    /// The answer to a command; null before it has come.
    const Answer* answer(std::uint32_t sequence) const;
    bool closed() const { return closed_; }
    /// Whether all it heard made sense.
    bool sane() const { return sane_; }

  private:
    void received(ByteView bytes);
    usbip::Parse take(ByteView bytes);
    usbip::Parse takeReply(ByteView bytes);

    Scheduler& scheduler_;
    std::unique_ptr<ByteStream> stream_;
    std::vector<std::uint8_t> unread_;
    enum class Stage { List, Import, Transfers } stage_ = Stage::Transfers;
    std::optional<usbip::OpStatus> status_;
    std::vector<usbip::Device> devices_;
    usbip::Device device_;
    std::set<std::uint32_t> ins_;  ///< Sequence numbers whose answers bring bytes.
    std::uint32_t lastSequence_ = 0;
    std::vector<Answer> answers_;
    bool closed_ = false;
    bool sane_ = true;
};

/// A server of some devices without sockets, and its clients, on a fake clock.
class UsbipRig {
  public:
    explicit UsbipRig(const std::vector<UsbipExport>& exports, const UsbipLimits& limits = {},
                      std::uint32_t seed = 1);
    /// A client that has just connected, and reads unless told otherwise.
    RawClient& connect(bool reads = true);
    /// A client that has imported a device; anything else fails the test.
    RawClient& connectAndImport(const std::string& busId);
    void advance(Duration span) { scheduler_.advance(span); }
    /// Advances until the answer to a command has come and gives it; a watchdog gives an empty one.
    RawClient::Answer await(RawClient& client, std::uint32_t sequence);

    FakeScheduler& scheduler() { return scheduler_; }
    const UsbipServerReport& report() const { return hall_.report; }
    bool inUse() const { return hall_.exports.anyTaken(); }
    /// Connections that have not ended.
    std::size_t connections() const { return connections_.size(); }
    const std::vector<std::string>& log() const { return log_; }

  private:
    FakeScheduler scheduler_;
    const UsbipLimits limits_;
    std::uint32_t seed_;
    std::vector<std::string> log_;
    UsbipHall hall_;
    std::list<std::unique_ptr<UsbipConnection>> connections_;
    std::list<RawClient> clients_;
};

}  // namespace kickstand::testing
