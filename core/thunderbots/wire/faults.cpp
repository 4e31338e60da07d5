#include "core/thunderbots/wire/faults.h"

#include <array>
#include <cstddef>

namespace kickstand::thunderbots::wire {
namespace {

using S = FaultSubject;

/// Marks a text for the catalogues of translations; who shows it looks it up under the same context.
#define FAULT_TEXT(context, text) text

constexpr std::array kRobotFamilies{
    FaultFamily{0, 1, S::None, 0, "charge-timeout", FAULT_TEXT("Fault", "Capacitor charge timed out")},
    FaultFamily{1, 1, S::None, 0, "chicker-communication",
                FAULT_TEXT("Fault", "Chicker board does not communicate properly")},
    FaultFamily{2, 1, S::None, 0, "chicker-missing", FAULT_TEXT("Fault", "Chicker board missing")},
    FaultFamily{3, 1, S::None, 0, "fpga-dcm-lock", FAULT_TEXT("Fault", "FPGA clock manager failed to lock")},
    FaultFamily{4, 1, S::None, 0, "fpga-fabric-crc",
                FAULT_TEXT("Fault", "FPGA fabric failed its online CRC")},
    FaultFamily{5, 1, S::None, 0, "fpga-communication",
                FAULT_TEXT("Fault", "FPGA does not communicate properly")},
    FaultFamily{6, 1, S::None, 0, "fpga-no-bitstream", FAULT_TEXT("Fault", "FPGA has no bitstream")},
    FaultFamily{7, 1, S::None, 0, "fpga-configuration", FAULT_TEXT("Fault", "FPGA configuration failed")},
    FaultFamily{8, 1, S::None, 0, "oscillator-stopped", FAULT_TEXT("Fault", "Oscillator stopped")},
    FaultFamily{9, 5, S::Motor, 1, "hall-000", FAULT_TEXT("Fault", "Hall sensors read 000")},
    FaultFamily{14, 5, S::Motor, 1, "hall-111", FAULT_TEXT("Fault", "Hall sensors read 111")},
    FaultFamily{19, 4, S::Motor, 1, "hall-stuck",
                FAULT_TEXT("Fault", "Hall sensors stuck while the encoder moves")},
    FaultFamily{23, 4, S::Motor, 1, "encoder-stuck",
                FAULT_TEXT("Fault", "Encoder stuck while the Hall sensors move")},
    FaultFamily{27, 1, S::None, 0, "dribbler-hot", FAULT_TEXT("Fault", "Dribbler overheated")},
    FaultFamily{28, 1, S::None, 0, "dribbler-thermistor",
                FAULT_TEXT("Fault", "Dribbler thermistor out of range")},
    FaultFamily{29, 1, S::None, 0, "radio-protocol", FAULT_TEXT("Fault", "Radio protocol error")},
    FaultFamily{30, 2, S::Radio, 0, "framing", FAULT_TEXT("Fault", "Serial framing error")},
    FaultFamily{32, 2, S::Radio, 0, "hardware-overrun", FAULT_TEXT("Fault", "Hardware overrun")},
    FaultFamily{34, 2, S::Radio, 0, "software-overrun", FAULT_TEXT("Fault", "Software overrun")},
    FaultFamily{36, 2, S::Radio, 0, "checksum", FAULT_TEXT("Fault", "Received packet with a wrong checksum")},
    FaultFamily{38, 2, S::Radio, 0, "length-msb",
                FAULT_TEXT("Fault", "Received length with a nonzero high byte")},
    FaultFamily{40, 2, S::Radio, 0, "length-lsb",
                FAULT_TEXT("Fault", "Received length with an illegal low byte")},
    FaultFamily{42, 2, S::Radio, 0, "modem-timeout",
                FAULT_TEXT("Fault", "Local modem did not respond in time")},
    FaultFamily{44, 1, S::None, 0, "micropacket-length",
                FAULT_TEXT("Fault", "Dongle sent a micropacket of the wrong length")},
    FaultFamily{45, 1, S::None, 0, "no-such-pipe",
                FAULT_TEXT("Fault", "Dongle sent a message to a pipe that does not exist")},
    FaultFamily{46, 1, S::None, 0, "flash-communication",
                FAULT_TEXT("Fault", "SPI flash does not communicate properly")},
    FaultFamily{47, 1, S::None, 0, "parameters-corrupt",
                FAULT_TEXT("Fault", "Operational parameters absent or corrupt")},
};

constexpr std::array kDongleFamilies{
    FaultFamily{0, 2, S::Radio, 0, "framing", FAULT_TEXT("Fault", "Serial framing error")},
    FaultFamily{2, 2, S::Radio, 0, "hardware-overrun", FAULT_TEXT("Fault", "Hardware overrun")},
    FaultFamily{4, 2, S::Radio, 0, "software-overrun", FAULT_TEXT("Fault", "Software overrun")},
    FaultFamily{6, 2, S::Radio, 0, "checksum", FAULT_TEXT("Fault", "Received packet with a wrong checksum")},
    FaultFamily{8, 2, S::Radio, 0, "length-msb",
                FAULT_TEXT("Fault", "Received length with a nonzero high byte")},
    FaultFamily{10, 2, S::Radio, 0, "length-lsb",
                FAULT_TEXT("Fault", "Received length with an illegal low byte")},
    FaultFamily{12, 2, S::Radio, 0, "modem-timeout", FAULT_TEXT("Fault", "Modem did not respond in time")},
    FaultFamily{14, 2, S::Radio, 0, "at-mismatch",
                FAULT_TEXT("Fault", "Modem responded to another AT command")},
    FaultFamily{16, 2, S::Radio, 0, "at-failed",
                FAULT_TEXT("Fault", "AT command failed for an unknown reason")},
    FaultFamily{18, 2, S::Radio, 0, "at-invalid-command",
                FAULT_TEXT("Fault", "Modem does not know an AT command")},
    FaultFamily{20, 2, S::Radio, 0, "at-invalid-parameter",
                FAULT_TEXT("Fault", "Modem refused the parameter of an AT command")},
    FaultFamily{22, 2, S::Radio, 0, "reset-failed", FAULT_TEXT("Fault", "Reset failed")},
    FaultFamily{24, 2, S::Radio, 0, "rts-failed", FAULT_TEXT("Fault", "RTS could not be enabled")},
    FaultFamily{26, 2, S::Radio, 0, "version-failed",
                FAULT_TEXT("Fault", "Firmware version could not be read")},
    FaultFamily{28, 2, S::Radio, 0, "node-id-failed",
                FAULT_TEXT("Fault", "Node identifier could not be set")},
    FaultFamily{30, 2, S::Radio, 0, "channel-failed", FAULT_TEXT("Fault", "Channel could not be set")},
    FaultFamily{32, 2, S::Radio, 0, "pan-id-failed", FAULT_TEXT("Fault", "PAN identifier could not be set")},
    FaultFamily{34, 2, S::Radio, 0, "address-failed", FAULT_TEXT("Fault", "Address could not be set")},
    FaultFamily{36, 1, S::None, 0, "out-overflow", FAULT_TEXT("Fault", "Outbound micropacket overflow")},
    FaultFamily{37, 1, S::None, 0, "out-no-pipe", FAULT_TEXT("Fault", "Outbound micropacket to no pipe")},
    FaultFamily{38, 1, S::None, 0, "out-length",
                FAULT_TEXT("Fault", "Outbound micropacket of the wrong length")},
    FaultFamily{39, 1, S::None, 0, "debug-overflow", FAULT_TEXT("Fault", "Debug text overflow")},
    FaultFamily{40, 1, S::None, 0, "error-queue-overflow", FAULT_TEXT("Fault", "Error queue overflow")},
    FaultFamily{41, 16, S::Robot, 0, "send-failed", FAULT_TEXT("Fault", "Message could not be sent")},
    FaultFamily{57, 16, S::Robot, 0, "in-overflow", FAULT_TEXT("Fault", "Inbound micropacket overflow")},
    FaultFamily{73, 16, S::Robot, 0, "in-no-pipe", FAULT_TEXT("Fault", "Inbound micropacket to no pipe")},
    FaultFamily{89, 16, S::Robot, 0, "in-length",
                FAULT_TEXT("Fault", "Inbound micropacket of the wrong length")},
    FaultFamily{105, 1, S::None, 0, "usb-bit-stuff", FAULT_TEXT("Fault", "USB bit stuffing error")},
    FaultFamily{106, 1, S::None, 0, "usb-turnaround", FAULT_TEXT("Fault", "USB bus turnaround timed out")},
    FaultFamily{107, 1, S::None, 0, "usb-partial-byte",
                FAULT_TEXT("Fault", "USB data field is not whole bytes")},
    FaultFamily{108, 1, S::None, 0, "usb-crc16", FAULT_TEXT("Fault", "USB CRC16 error")},
    FaultFamily{109, 1, S::None, 0, "usb-crc5", FAULT_TEXT("Fault", "USB CRC5 error")},
    FaultFamily{110, 1, S::None, 0, "usb-pid", FAULT_TEXT("Fault", "USB packet identifier error")},
    FaultFamily{111, 1, S::None, 0, "usb-stall", FAULT_TEXT("Fault", "USB stall")},
};

#undef FAULT_TEXT

constexpr std::uint8_t kFirstSendFailed = 41;

/// Whether the families cover 0 to `count` - 1 in order, each code once.
template <std::size_t size>
constexpr bool covers(const std::array<FaultFamily, size>& families, int count) {
    int next = 0;
    for (const FaultFamily& family : families) {
        if (family.firstCode != next) return false;
        next += family.count;
    }
    return next == count;
}
static_assert(covers(kRobotFamilies, kRobotFaultCount));
static_assert(covers(kDongleFamilies, kDongleFaultCount));

Fault explain(std::span<const FaultFamily> families, std::uint8_t code) noexcept {
    for (const FaultFamily& family : families) {
        const int place = code - family.firstCode;
        if (place >= family.count) continue;
        const auto index = static_cast<std::uint8_t>(family.firstIndex + place);
        return {code, true, family.subject, index, family.id, family.text};
    }
    Fault unknown;
    unknown.code = code;
    return unknown;
}

const char* prefixOf(FaultSubject subject) noexcept {
    switch (subject) {
        case S::Motor:
            return "Motor ";
        case S::Radio:
            return "Radio ";
        case S::Robot:
            return "Robot ";
        case S::None:
            break;
    }
    return "";
}

}  // namespace

std::span<const FaultFamily> robotFaultFamilies() noexcept {
    return kRobotFamilies;
}
std::span<const FaultFamily> dongleFaultFamilies() noexcept {
    return kDongleFamilies;
}

Fault robotFault(std::uint8_t code) noexcept {
    return explain(kRobotFamilies, code);
}
Fault dongleFault(std::uint8_t code) noexcept {
    return explain(kDongleFamilies, code);
}

std::optional<std::uint8_t> sendFailedRobot(std::uint8_t dongleCode) noexcept {
    if (dongleCode < kFirstSendFailed || dongleCode >= kFirstSendFailed + kRobotCount) return std::nullopt;
    return static_cast<std::uint8_t>(dongleCode - kFirstSendFailed);
}

std::string describe(const Fault& fault) {
    if (!fault.known) return std::string(fault.text) + ' ' + std::to_string(fault.code);
    if (fault.subject == S::None) return fault.text;
    return prefixOf(fault.subject) + std::to_string(fault.index) + ": " + fault.text;
}

}  // namespace kickstand::thunderbots::wire
