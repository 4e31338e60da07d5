#pragma once

#include <cstddef>
#include <cstdint>
#include <variant>

#include "core/base/bytes.h"
#include "core/framing/inline_bytes.h"
#include "core/thunderbots/wire/message_packet.h"
#include "core/thunderbots/wire/parameters.h"
#include "core/thunderbots/wire/wire_error.h"

namespace kickstand::thunderbots::wire {

/// The first byte of every message on the firmware pipes (protocol 4.7). 6 does not exist.
enum class FirmwareOp : std::uint8_t {
    EraseChip = 0,
    FillPage = 1,
    ProgramPage = 2,
    BlockCrc = 3,
    ReadParameters = 4,
    SetParameters = 5,
    CommitParameters = 7,
    Reboot = 8,
    ReadSignatures = 9,
};

/// "erase", "fill-page", "program-page", "block-crc", "read-parameters", "set-parameters",
/// "commit-parameters", "reboot", "signatures": stable names. Any thread.
const char* name(FirmwareOp op) noexcept;

/// The robot's flash memory (protocol 6.7): 2 MiB in pages of 256 bytes.
inline constexpr std::size_t kFlashPageBytes = 256;
inline constexpr std::size_t kFlashPageCount = 8192;
inline constexpr std::uint32_t kFlashBytes = kFlashPageBytes * kFlashPageCount;
/// The most data that one Fill Page Buffer message carries.
inline constexpr std::size_t kMaxFillBytes = kMaxMessagePayload - 2;
/// The longest block of one Compute Block CRC; on the wire it is 0.
inline constexpr std::uint32_t kMaxCrcBlock = 65536;
inline constexpr std::uint32_t kMaxFlashAddress = 0xFFFFFF;

/// A message that is nothing but its opcode.
template <FirmwareOp op>
struct BareFirmwareMessage {
    friend constexpr bool operator==(const BareFirmwareMessage&, const BareFirmwareMessage&) = default;
};

using EraseChipRequest = BareFirmwareMessage<FirmwareOp::EraseChip>;
/// Puts data into the page buffer; there is no response to it. The data stays within the page.
struct FillPageRequest {
    std::uint8_t offset = 0;
    InlineBytes<kMaxFillBytes> data;  ///< 1-61 bytes.
    friend constexpr bool operator==(const FillPageRequest&, const FillPageRequest&) = default;
};
/// Burns the page buffer; with a wrong CRC there is no response to it.
struct ProgramPageRequest {
    std::uint16_t page = 0;  ///< Address / 256.
    std::uint16_t crc = 0;   ///< Of the whole page buffer.
    friend constexpr bool operator==(const ProgramPageRequest&, const ProgramPageRequest&) = default;
};
struct BlockCrcRequest {
    std::uint32_t address = 0;  ///< 24 bits.
    std::uint32_t length = 1;   ///< 1-65536 bytes.
    friend constexpr bool operator==(const BlockCrcRequest&, const BlockCrcRequest&) = default;
};
using ReadParametersRequest = BareFirmwareMessage<FirmwareOp::ReadParameters>;
/// Writes the volatile shadow of the block; lost at a reboot unless committed.
struct SetParametersRequest {
    OperationalParameters parameters;
    friend constexpr bool operator==(const SetParametersRequest&, const SetParametersRequest&) = default;
};
using CommitParametersRequest = BareFirmwareMessage<FirmwareOp::CommitParameters>;
using RebootRequest = BareFirmwareMessage<FirmwareOp::Reboot>;
using ReadSignaturesRequest = BareFirmwareMessage<FirmwareOp::ReadSignatures>;

using FirmwareRequest = std::variant<EraseChipRequest, FillPageRequest, ProgramPageRequest, BlockCrcRequest,
                                     ReadParametersRequest, SetParametersRequest, CommitParametersRequest,
                                     RebootRequest, ReadSignaturesRequest>;

using EraseChipResponse = BareFirmwareMessage<FirmwareOp::EraseChip>;
using ProgramPageResponse = BareFirmwareMessage<FirmwareOp::ProgramPage>;
/// Repeats what was asked for and gives its CRC.
struct BlockCrcResponse {
    std::uint32_t address = 0;
    std::uint32_t length = 1;
    std::uint16_t crc = 0;
    friend constexpr bool operator==(const BlockCrcResponse&, const BlockCrcResponse&) = default;
};
/// The operational parameters' volatile shadow (protocol 4.7, 4.8).
struct ReadParametersResponse {
    OperationalParameters parameters;
    friend constexpr bool operator==(const ReadParametersResponse&, const ReadParametersResponse&) = default;
};
using SetParametersResponse = BareFirmwareMessage<FirmwareOp::SetParameters>;
using CommitParametersResponse = BareFirmwareMessage<FirmwareOp::CommitParameters>;
using RebootResponse = BareFirmwareMessage<FirmwareOp::Reboot>;
struct ReadSignaturesResponse {
    std::uint16_t microcontrollerCrc = 0;  ///< Of addresses 0-0x1EFFF.
    std::uint16_t flashCrc = 0;            ///< Of the whole SPI flash.
    friend constexpr bool operator==(const ReadSignaturesResponse&, const ReadSignaturesResponse&) = default;
};

using FirmwareResponse =
    std::variant<EraseChipResponse, ProgramPageResponse, BlockCrcResponse, ReadParametersResponse,
                 SetParametersResponse, CommitParametersResponse, RebootResponse, ReadSignaturesResponse>;

/// The opcode of a message.
FirmwareOp opOf(const FirmwareRequest& request) noexcept;
FirmwareOp opOf(const FirmwareResponse& response) noexcept;
/// Whether a robot answers such a request when all is well: all but Fill Page Buffer (protocol 4.7).
constexpr bool isAnswered(FirmwareOp op) noexcept {
    return op != FirmwareOp::FillPage;
}

/// The message's bytes (protocol 4.7). Errors: OutOfRange naming the field: data that is empty or leaves the
/// page, an address past 24 bits, a length of 0 or past 65536; and, for a request that would write them, what
/// checkParameters() refuses. Any thread.
WireResult<MessagePayload> encodeFirmwareRequest(const FirmwareRequest& request) noexcept;
WireResult<MessagePayload> encodeFirmwareResponse(const FirmwareResponse& response) noexcept;

/// Reads a message of the firmware pipes. Errors: TooShort, TooLong; UnknownKind for an opcode that does not
/// exist or has no response; BadLength for data that leaves the page. Any thread.
WireResult<FirmwareRequest> decodeFirmwareRequest(ByteView payload) noexcept;
WireResult<FirmwareResponse> decodeFirmwareResponse(ByteView payload) noexcept;

}  // namespace kickstand::thunderbots::wire
