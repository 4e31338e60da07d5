#pragma once

#include <string>

#include "core/coach/sim/radio_medium.h"
#include "core/framing/xbee_parser.h"
#include "core/link/byte_device_model.h"

namespace kickstand::coach::sim {

/// What a simulated module holds in its memory.
struct ModuleMemory {
    std::uint16_t address = 0;
    std::uint8_t channel = 0x0C;
    std::uint16_t pan = 0x3332;
    std::uint8_t mode = 0;
    std::uint32_t baudCode = 3;
    std::string name = " ";
};

/// A radio module on a serial line: frames in both API modes, transparent with its command mode behind +++,
/// AT commands, and the air (coach protocol 2). One thread, the scheduler's.
class XbeeSim final : public ByteDeviceModel, public RadioNode {
  public:
    XbeeSim(Scheduler& scheduler, RadioMedium& medium, ModuleMemory memory, std::uint64_t serial);
    ~XbeeSim() override;
    XbeeSim(const XbeeSim&) = delete;
    XbeeSim& operator=(const XbeeSim&) = delete;

    bool attached() const override { return attached_; }
    void setListener(ByteDeviceListener* listener) override { listener_ = listener; }
    void lineOpened(Baud baud) override;
    void lineClosed() override {}
    void lineBaudChanged(Baud baud) override { lineBaud_ = baud; }
    void hostSent(ByteView bytes) override;

    std::uint16_t address() const override { return now_.address; }
    std::uint8_t channel() const override { return now_.channel; }
    std::uint16_t pan() const override { return now_.pan; }
    bool listens() const override { return attached_; }
    void heard(std::uint16_t source, int rssi_dBm, bool broadcast, ByteView payload) override;

    /// Pulls it out, or plugs it in: it begins with what is in its memory.
    void setAttached(bool attached);
    /// As if its power had failed for a moment; it says so.
    void restart();
    const ModuleMemory& memory() const { return saved_; }
    const ModuleMemory& settings() const { return now_; }
    std::uint64_t packetsSent() const { return packetsSent_; }

  private:
    struct Reply {
        xbee::AtOutcome outcome = xbee::AtOutcome::Ok;
        std::vector<std::uint8_t> value{};
    };

    Baud baud() const;
    void powerUp();
    void toHost(ByteView bytes);
    void frameToHost(const xbee::Frame& frame);
    void hear(std::uint8_t byte);
    void hearCommand(std::uint8_t byte);
    void plusCame(std::uint8_t byte);
    void line(const std::string& text);
    void take(const xbee::Frame& frame);
    void transmit(const xbee::Tx16& packet);
    Reply at(std::array<char, 2> name, ByteView value);
    Reply ask(std::array<char, 2> name) const;
    xbee::AtOutcome set(std::array<char, 2> name, ByteView value);
    void settle();
    void awaitCommand();
    void leaveCommandMode();

    Scheduler& scheduler_;
    RadioMedium& medium_;
    const std::uint64_t serial_;
    ModuleMemory saved_;
    ModuleMemory now_;
    std::uint8_t wantedMode_ = 0;  ///< Counts from the answer on.
    std::uint32_t wantedBaudCode_ = 3;
    ByteDeviceListener* listener_ = nullptr;
    bool attached_ = true;
    Baud lineBaud_ = 9600;
    xbee::Parser parser_;
    bool commandMode_ = false;
    std::string text_;
    int pluses_ = 0;
    TimePoint lastByte_{};
    TimerId guard_ = 0;
    TimerId commandEnd_ = 0;
    std::uint64_t packetsSent_ = 0;
    std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace kickstand::coach::sim
