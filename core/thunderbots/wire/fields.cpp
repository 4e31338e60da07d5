#include "core/thunderbots/wire/fields.h"

#include <array>
#include <string_view>

#include "core/thunderbots/wire/layout_dongle.h"
#include "core/thunderbots/wire/layout_drive.h"
#include "core/thunderbots/wire/layout_firmware.h"
#include "core/thunderbots/wire/layout_robot.h"

namespace kickstand::thunderbots::wire {
namespace {

constexpr auto kLsb = BitOrder::LsbFirst;
constexpr auto kMsb = BitOrder::MsbFirst;

template <class T>
WireResult<void> verdictOf(const WireResult<T>& result) noexcept {
    if (!result) return tl::unexpected(result.error());
    return {};
}
/// Of an encoder that cannot fail.
template <std::size_t count>
WireResult<void> verdictOf(const std::array<std::uint8_t, count>&) noexcept {
    return {};
}

template <auto decode>
WireResult<void> reads(ByteView bytes) noexcept {
    return verdictOf(decode(bytes));
}

template <auto decode, auto encode>
WireResult<void> sends(ByteView bytes) noexcept {
    const auto message = decode(bytes);
    if (!message) return tl::unexpected(message.error());
    return verdictOf(encode(*message));
}

WireResult<void> anyByte(ByteView bytes) noexcept {
    const auto error = lengthFault(bytes.size(), 1, 1);
    if (error) return tl::unexpected(*error);
    return {};
}

WireResult<void> checkedParameters(ByteView bytes) noexcept {
    const auto parameters = decodeParameters(bytes);
    if (!parameters) return tl::unexpected(parameters.error());
    return checkParameters(*parameters);
}

WireResult<void> readsMessagePacket(ByteView bytes) noexcept {
    const auto pipe = bytes.empty() ? std::nullopt : pipeFromNumber(pipeNumberOfHeader(bytes[0]));
    return verdictOf(decodeMessagePacket(bytes, pipe ? directionOf(*pipe) : Direction::Out));
}

/// One micropacket, whichever way it goes.
WireResult<void> readsMicropacket(ByteView bytes) noexcept {
    const bool feedback =
        bytes.size() > 1 && pipeNumberOfHeader(bytes[1]) == static_cast<int>(Pipe::Feedback);
    MicropacketReader reader(bytes, feedback ? Direction::In : Direction::Out);
    while (const auto micropacket = reader.next()) {
        if (!*micropacket) return tl::unexpected(micropacket->error());
    }
    return {};
}

constexpr std::uint8_t size(std::size_t bytes) {
    return static_cast<std::uint8_t>(bytes);
}

/// A message of fixed length and its codec.
template <auto decode, auto encode>
constexpr MessageSpec fixed(const char* name, BitOrder order, std::size_t bytes, const char* section,
                            const char* summary, std::span<const FieldSpec> fields) {
    return {name,    order,   size(bytes), size(bytes),   0,
            section, summary, fields,      reads<decode>, sends<decode, encode>};
}

constexpr MessageSpec request(const char* name, std::size_t fewest, std::size_t most, const char* summary,
                              std::span<const FieldSpec> fields) {
    return {name,
            kLsb,
            size(fewest),
            size(most),
            0,
            "4.7",
            summary,
            fields,
            reads<decodeFirmwareRequest>,
            sends<decodeFirmwareRequest, encodeFirmwareRequest>};
}

constexpr MessageSpec response(const char* name, std::size_t fewest, std::size_t most, const char* summary,
                               std::span<const FieldSpec> fields) {
    return {name,
            kLsb,
            size(fewest),
            size(most),
            0,
            "4.7",
            summary,
            fields,
            reads<decodeFirmwareResponse>,
            sends<decodeFirmwareResponse, encodeFirmwareResponse>};
}

template <FirmwareOp op>
constexpr MessageSpec bareRequest(const char* name, const char* summary) {
    return request(name, 1, 1, summary, layout::firmware::kBareFields<op>);
}
template <FirmwareOp op>
constexpr MessageSpec bareResponse(const char* name, const char* summary) {
    return response(name, 1, 1, summary, layout::firmware::kBareFields<op>);
}

constexpr std::size_t kFewestCarriedParameters = 1 + kDefinedParameterBytes;
namespace at = layout;
namespace fw = layout::firmware;
using Op = FirmwareOp;

constexpr std::array kMessages{
    fixed<decodeDrive, encodeDrive>("thunderbots.drive", kMsb, kDriveBytes, "4.1",
                                    "What a robot is told over and over", at::drive::kFields),
    fixed<decodeFeedback, encodeFeedback>("thunderbots.feedback", kLsb, kFeedbackBytes, "4.3",
                                          "What a robot says of itself", at::feedback::kFields),
    fixed<decodeKick, encodeKick>("thunderbots.kick", kLsb, kKickBytes, "4.4", "Kick or chip once",
                                  at::kick::kFields),
    fixed<decodeTestMode, encodeTestMode>("thunderbots.test-mode", kLsb, kTestModeBytes, "4.5",
                                          "What the LEDs show from now on", at::test_mode::kFields),
    fixed<decodeIndicator, encodeIndicator>("thunderbots.autokick", kLsb, 0, "4.6",
                                            "The robot fired its autokick", {}),
    fixed<decodeIndicator, encodeIndicator>("thunderbots.experiment", kLsb, 1 + kExperimentPieceBytes, "4.6",
                                            "A piece of the experiment buffer", at::experiment::kFields),

    bareRequest<Op::EraseChip>("thunderbots.firmware-request.erase", "Erase the SPI flash"),
    request("thunderbots.firmware-request.fill-page", 3, kMaxMessagePayload, "Put data into the page buffer",
            fw::fill_page::kFields),
    request("thunderbots.firmware-request.program-page", 5, 5, "Burn the page buffer",
            fw::program_page::kFields),
    request("thunderbots.firmware-request.block-crc", 6, 6, "Compute the CRC of a block of flash",
            fw::block_crc::kRequestFields),
    bareRequest<Op::ReadParameters>("thunderbots.firmware-request.read-parameters",
                                    "Read the operational parameters"),
    request("thunderbots.firmware-request.set-parameters", kFewestCarriedParameters, kMaxMessagePayload,
            "Change the operational parameters until reboot", fw::kParametersFields<Op::SetParameters>),
    bareRequest<Op::CommitParameters>("thunderbots.firmware-request.commit-parameters",
                                      "Keep the operational parameters for good"),
    bareRequest<Op::Reboot>("thunderbots.firmware-request.reboot", "Reboot the robot"),
    bareRequest<Op::ReadSignatures>("thunderbots.firmware-request.signatures", "Read the build signatures"),

    bareResponse<Op::EraseChip>("thunderbots.firmware-response.erase", "The SPI flash is erased"),
    bareResponse<Op::ProgramPage>("thunderbots.firmware-response.program-page", "The page is burnt"),
    response("thunderbots.firmware-response.block-crc", 8, 8, "The CRC of a block of flash",
             fw::block_crc::kResponseFields),
    response("thunderbots.firmware-response.read-parameters", kFewestCarriedParameters, kMaxMessagePayload,
             "The operational parameters in force", fw::kParametersFields<Op::ReadParameters>),
    bareResponse<Op::SetParameters>("thunderbots.firmware-response.set-parameters",
                                    "The parameters are in force"),
    bareResponse<Op::CommitParameters>("thunderbots.firmware-response.commit-parameters",
                                       "The parameters are kept"),
    bareResponse<Op::Reboot>("thunderbots.firmware-response.reboot", "The robot is about to reboot"),
    response("thunderbots.firmware-response.signatures", 5, 5, "The build signatures",
             fw::signatures::kFields),

    MessageSpec{"thunderbots.parameters", kLsb, size(kDefinedParameterBytes), size(kMaxParameterBytes), 0,
                "4.8", "The operational parameters block", at::parameters::kFields, reads<decodeParameters>,
                checkedParameters},
    fixed<decodeStatus, encodeStatus>("thunderbots.status", kLsb, kStatusBytes, "3.8",
                                      "What the dongle says of itself", at::status::kFields),
    fixed<decodeChannels, encodeChannels>("thunderbots.channels", kLsb, kChannelsBytes, "3.3",
                                          "The dongle's radio channels", at::channels::kFields),
    fixed<decodeRadioVersions, encodeRadioVersions>("thunderbots.radio-versions", kLsb, kRadioVersionsBytes,
                                                    "3.3", "The firmware versions of the dongle's radios",
                                                    at::radio_versions::kFields),
    MessageSpec{"thunderbots.message", kLsb, 1, size(kMaxMessagePacket), 0, "3.7", "A message packet",
                at::message::kFields, readsMessagePacket, readsMessagePacket},
    MessageSpec{"thunderbots.state-packet", kLsb, size(kFeedbackMicropacketBytes),
                size(kDriveMicropacketBytes), size(kMaxStatePacket), "3.6",
                "State transport: a list of micropackets", at::micropacket::kFields, readsMicropacket,
                readsMicropacket},
    MessageSpec{"thunderbots.error-queue", kLsb, 1, 1, size(kPacketBytes), "3.9", "The dongle's fault codes",
                at::error_queue::kFields, anyByte, anyByte},
};

bool isVariantOf(std::string_view message, std::string_view family) noexcept {
    return message.size() > family.size() && message.starts_with(family) && message[family.size()] == '.';
}

}  // namespace

std::span<const MessageSpec> messages() noexcept {
    return kMessages;
}

const MessageSpec* findMessage(std::string_view name) noexcept {
    for (const MessageSpec& message : kMessages) {
        if (message.name == name) return &message;
    }
    return nullptr;
}

const MessageSpec* findMessageFor(std::string_view name, ByteView bytes) noexcept {
    if (const MessageSpec* const exact = findMessage(name)) return exact;
    for (const MessageSpec& message : kMessages) {
        if (!isVariantOf(message.name, name) || message.fields.empty() || bytes.empty()) continue;
        const FieldSpec& first = message.fields.front();
        if (first.kind == FieldKind::Opcode && first.lowest == bytes[0]) return &message;
    }
    return nullptr;
}

std::int32_t readField(const MessageSpec& message, const FieldSpec& field, ByteView bytes) noexcept {
    if (message.order == kMsb) return FieldReader<kMsb>(bytes).number(field);
    return FieldReader<kLsb>(bytes).number(field);
}

void writeField(const MessageSpec& message, const FieldSpec& field, ByteSpan bytes,
                std::int32_t value) noexcept {
    if (message.order == kMsb) {
        FieldWriter<kMsb>(bytes).put(field, value);
    } else {
        FieldWriter<kLsb>(bytes).put(field, value);
    }
}

}  // namespace kickstand::thunderbots::wire
