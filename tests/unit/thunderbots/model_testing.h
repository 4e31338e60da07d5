#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/thunderbots/fleet_model.h"
#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/micropacket.h"

namespace kickstand::thunderbots::testing {

/// Keeps every sample; a gap is an empty value.
class SampleRecorder final : public SampleSink {
  public:
    struct Entry {
        SignalId signal;
        TimePoint time{};
        std::optional<float> value;
        friend bool operator==(const Entry&, const Entry&) = default;
    };

    void sample(SignalId signal, TimePoint time, float value) override {
        entries.push_back({signal, time, value});
    }
    void gap(SignalId signal, TimePoint time) override { entries.push_back({signal, time, std::nullopt}); }

    std::vector<Entry> entries;
};

/// One record with the bytes that it shows.
struct OwnedRecord {
    UsbTapRecord record;
    std::vector<std::uint8_t> bytes;

    UsbTapRecord view() const {
        UsbTapRecord shown = record;
        shown.data = bytes;
        return shown;
    }
};

/// What a link could have shown, put together by hand. Time passes a millisecond from record to record.
class Wire {
  public:
    using Kind = UsbTapRecord::Kind;

    explicit Wire(UsbTapObserver& observer) : observer_(observer) {}

    void opened() { show({.kind = Kind::Opened}, {}); }
    void closed() { show({.kind = Kind::Closed}, {}); }
    void lost() { show({.kind = Kind::Lost, .status = UsbStatus::NoDevice}, {}); }
    void bytes(wire::Endpoint endpoint, ByteView data, UsbStatus status = UsbStatus::Completed) {
        show({.endpoint = wire::address(endpoint), .status = status, .actual = data.size()}, data);
    }
    void status(RobotMask alive, wire::EStop eStop = wire::EStop::Run,
                wire::RadioState radios = wire::RadioState::Running) {
        bytes(wire::Endpoint::Status, wire::encodeStatus({eStop, radios, alive}));
    }
    void feedback(int robot, const wire::FeedbackBlock& block) {
        wire::StatePacketBuilder packet;
        static_cast<void>(packet.add(static_cast<std::uint8_t>(robot), block));
        bytes(wire::Endpoint::StateIn, packet.packet());
    }
    void drive(int robot, const wire::DriveBlock& block) {
        wire::StatePacketBuilder packet;
        static_cast<void>(packet.add(static_cast<std::uint8_t>(robot), block));
        bytes(wire::Endpoint::StateOut, packet.packet());
    }
    void message(wire::Endpoint endpoint, int robot, wire::Pipe pipe, ByteView payload) {
        const auto packet = wire::encodeMessagePacket(static_cast<std::uint8_t>(robot), pipe, payload);
        if (packet) bytes(endpoint, packet->view());
    }
    void control(const UsbSetup& setup, ByteView data) {
        show({.setup = setup, .actual = data.size()}, data);
    }

    TimePoint now() const { return now_; }
    void pass(Duration span) { now_ += span; }

  private:
    void show(UsbTapRecord record, ByteView data) {
        now_ += std::chrono::milliseconds(1);
        record.time = now_;
        record.data = data;
        observer_.observe(record);
    }

    UsbTapObserver& observer_;
    TimePoint now_{};
};

/// A valid block with these raw readings.
inline wire::FeedbackBlock readings(std::uint16_t battery_adc, std::uint16_t capacitor_adc) {
    wire::FeedbackBlock block;
    block.valid = true;
    block.battery_adc = battery_adc;
    block.capacitor_adc = capacitor_adc;
    block.thermistor_adc = 400;
    block.light_adc = 17;
    return block;
}

}  // namespace kickstand::thunderbots::testing
