#pragma once

#include <array>

#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/firmware.h"
#include "core/thunderbots/wire/layout_robot.h"

/// Where the fields of the firmware messages lie (protocol 4.7).
namespace kickstand::thunderbots::wire::layout::firmware {

template <FirmwareOp op>
inline constexpr FieldSpec kOpcode = opcode(static_cast<std::int32_t>(op));

/// The fields of a message that is nothing but its opcode.
template <FirmwareOp op>
inline constexpr std::array kBareFields{kOpcode<op>};

namespace fill_page {

inline constexpr FieldSpec kOffset = number("offset", 8, 8, 0, 255, "Where in the page buffer the data goes");
inline constexpr FieldSpec kData =
    bytes("data", 16, 1, kMaxFillBytes, "Data, within the 256 bytes of the page");
inline constexpr std::array kFields{kOpcode<FirmwareOp::FillPage>, kOffset, kData};

}  // namespace fill_page

namespace program_page {

inline constexpr FieldSpec kPage = number("page", 8, 16, 0, 65535, "Address of the page / 256");
inline constexpr FieldSpec kCrc = number("crc", 24, 16, 0, 65535, "CRC-16 of the page buffer");
inline constexpr std::array kFields{kOpcode<FirmwareOp::ProgramPage>, kPage, kCrc};

}  // namespace program_page

namespace block_crc {

inline constexpr FieldSpec kAddress =
    number("address", 8, 24, 0, static_cast<std::int32_t>(kMaxFlashAddress), "First byte of the block");
inline constexpr FieldSpec kLength = number("length", 32, 16, 0, 65535, "Bytes in the block; 0 means 65536");
inline constexpr FieldSpec kCrc = number("crc", 48, 16, 0, 65535, "CRC-16 of the block");
inline constexpr std::array kRequestFields{kOpcode<FirmwareOp::BlockCrc>, kAddress, kLength};
inline constexpr std::array kResponseFields{kOpcode<FirmwareOp::BlockCrc>, kAddress, kLength, kCrc};

}  // namespace block_crc

inline constexpr parameters::Fields kBlock = parameters::at(8);

/// The opcode and the operational parameters block behind it.
template <FirmwareOp op>
inline constexpr std::array kParametersFields{kOpcode<op>,     kBlock.flashContents, kBlock.channel0,
                                              kBlock.channel1, kBlock.robotNumber,   kBlock.dribblerDuty,
                                              kBlock.tail};

namespace signatures {

inline constexpr FieldSpec kMicrocontroller =
    number("microcontroller_crc", 8, 16, 0, 65535, "CRC-16 of the microcontroller's firmware, 0-0x1EFFF");
inline constexpr FieldSpec kFlash = number("flash_crc", 24, 16, 0, 65535, "CRC-16 of the whole SPI flash");
inline constexpr std::array kFields{kOpcode<FirmwareOp::ReadSignatures>, kMicrocontroller, kFlash};

}  // namespace signatures
}  // namespace kickstand::thunderbots::wire::layout::firmware
