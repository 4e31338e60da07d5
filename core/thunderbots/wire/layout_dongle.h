#pragma once

#include <array>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/faults.h"
#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/micropacket.h"
#include "core/thunderbots/wire/parameters.h"

/// Where the fields of what only the dongle and the host say lie (protocol 3.3, 3.6-3.9).
namespace kickstand::thunderbots::wire::layout {

namespace status {

inline constexpr std::array kEStopNames{"uninitialized", "disconnected", "stop", "run"};
inline constexpr std::array kRadioNames{"pre-init", "init-radio-0",   "init-radio-1",
                                        "running",  "radio-0-failed", "radio-1-failed"};
inline constexpr FieldSpec kEStop = choice("estop", 0, 8, kEStopNames, "The emergency stop switch");
inline constexpr FieldSpec kRadios = choice("radios", 8, 8, kRadioNames, "The dongle's radios");
inline constexpr FieldSpec kAlive = number("alive", 16, 16, 0, 65535, "Bit n: robot n is alive");

inline constexpr std::array kFields{kEStop, kRadios, kAlive};

}  // namespace status

namespace channels {

inline constexpr FieldSpec kChannel0 =
    number("channel0", 0, 8, kLowestChannel, kHighestChannel, "Channel of radio 0");
inline constexpr FieldSpec kChannel1 =
    number("channel1", 8, 8, kLowestChannel, kHighestChannel, "Channel of radio 1");

inline constexpr std::array kFields{kChannel0, kChannel1};

}  // namespace channels

namespace radio_versions {

inline constexpr FieldSpec kRadio0 = number("radio0", 0, 16, 0, 65535, "Firmware version of radio 0");
inline constexpr FieldSpec kRadio1 = number("radio1", 16, 16, 0, 65535, "Firmware version of radio 1");

inline constexpr std::array kFields{kRadio0, kRadio1};

}  // namespace radio_versions

namespace message {

inline constexpr FieldSpec kPipe =
    number("pipe", 0, 4, static_cast<std::int32_t>(Pipe::Kick), kPipeCount - 1,
           "2 kick, 3 firmware request, 4 firmware response, 5 test mode, 6 indicator");
inline constexpr FieldSpec kRobot = number("robot", 4, 4, 0, kRobotCount - 1, "Robot number");
inline constexpr FieldSpec kPayload = bytes("payload", 8, 0, kMaxMessagePayload, "The message itself");

inline constexpr std::array kFields{kPipe, kRobot, kPayload};

}  // namespace message

namespace micropacket {

inline constexpr FieldSpec kLength{"length",
                                   FieldKind::Length,
                                   0,
                                   8,
                                   kFeedbackMicropacketBytes,
                                   kDriveMicropacketBytes,
                                   "Bytes of the micropacket, this one included"};
inline constexpr FieldSpec kPipe = number("pipe", 8, 4, 0, 1, "0 drive, 1 feedback");
inline constexpr FieldSpec kRobot = number("robot", 12, 4, 0, kRobotCount - 1, "Robot number");
inline constexpr FieldSpec kPayload =
    bytes("payload", 16, kFeedbackBytes, kDriveBytes, "The drive block or the feedback block");

inline constexpr std::array kFields{kLength, kPipe, kRobot, kPayload};

}  // namespace micropacket

namespace error_queue {

inline constexpr FieldSpec kCode{
    "code", FieldKind::FaultCode, 0, 8, 0, kDongleFaultCount - 1, "Fault code", {}, {}, true};

inline constexpr std::array kFields{kCode};

}  // namespace error_queue
}  // namespace kickstand::thunderbots::wire::layout
