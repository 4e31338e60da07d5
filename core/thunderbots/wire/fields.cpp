#include "core/thunderbots/wire/fields.h"

#include <algorithm>
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

/// Of a message of fixed length, one of several that its decoder may take.
template <std::size_t length, auto rule>
WireResult<void> ofLength(ByteView bytes) noexcept {
    if (const auto error = lengthFault(bytes.size(), length, length)) return tl::unexpected(*error);
    return rule(bytes);
}

WireResult<void> anything(ByteView) noexcept {
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
template <std::size_t length, auto decode, auto encode>
constexpr MessageSpec fixed(const char* name, BitOrder order, const char* section, const char* summary,
                            std::span<const FieldSpec> fields) {
    return {name,
            order,
            size(length),
            size(length),
            0,
            section,
            summary,
            fields,
            ofLength<length, reads<decode>>,
            ofLength<length, sends<decode, encode>>};
}

/// Of one variant: its decoder takes them all, so the opcode has to be looked at.
template <FirmwareOp op, auto decode>
WireResult<void> readsVariant(ByteView bytes) noexcept {
    const auto message = decode(bytes);
    if (!message) return tl::unexpected(message.error());
    if (opOf(*message) == op) return {};
    return tl::unexpected(fault(WireFault::UnknownKind, layout::firmware::kOpcode<op>, bytes[0]));
}
template <FirmwareOp op, auto decode, auto encode>
WireResult<void> sendsVariant(ByteView bytes) noexcept {
    const auto read = readsVariant<op, decode>(bytes);
    return read ? sends<decode, encode>(bytes) : read;
}

template <FirmwareOp op>
constexpr MessageSpec request(const char* name, std::size_t fewest, std::size_t most, const char* summary,
                              std::span<const FieldSpec> fields = layout::firmware::kBareFields<op>) {
    return {name,
            kLsb,
            size(fewest),
            size(most),
            0,
            "4.7",
            summary,
            fields,
            readsVariant<op, decodeFirmwareRequest>,
            sendsVariant<op, decodeFirmwareRequest, encodeFirmwareRequest>};
}

template <FirmwareOp op>
constexpr MessageSpec response(const char* name, std::size_t fewest, std::size_t most, const char* summary,
                               std::span<const FieldSpec> fields = layout::firmware::kBareFields<op>) {
    return {name,
            kLsb,
            size(fewest),
            size(most),
            0,
            "4.7",
            summary,
            fields,
            readsVariant<op, decodeFirmwareResponse>,
            sendsVariant<op, decodeFirmwareResponse, encodeFirmwareResponse>};
}

constexpr std::size_t kFewestCarriedParameters = 1 + kDefinedParameterBytes;
namespace at = layout;
namespace fw = layout::firmware;
using Op = FirmwareOp;

constexpr std::array kMessages{
    fixed<kDriveBytes, decodeDrive, encodeDrive>("thunderbots.drive", kMsb, "4.1",
                                                 "What a robot is told over and over", at::drive::kFields),
    fixed<kFeedbackBytes, decodeFeedback, encodeFeedback>(
        "thunderbots.feedback", kLsb, "4.3", "What a robot says of itself", at::feedback::kFields),
    fixed<kKickBytes, decodeKick, encodeKick>("thunderbots.kick", kLsb, "4.4", "Kick or chip once",
                                              at::kick::kFields),
    fixed<kTestModeBytes, decodeTestMode, encodeTestMode>(
        "thunderbots.test-mode", kLsb, "4.5", "What the LEDs show from now on", at::test_mode::kFields),
    fixed<0, decodeIndicator, encodeIndicator>("thunderbots.autokick", kLsb, "4.6",
                                               "The robot fired its autokick", {}),
    fixed<1 + kExperimentPieceBytes, decodeIndicator, encodeIndicator>(
        "thunderbots.experiment", kLsb, "4.6", "A piece of the experiment buffer", at::experiment::kFields),

    request<Op::EraseChip>("thunderbots.firmware-request.erase", 1, 1, "Erase the SPI flash"),
    request<Op::FillPage>("thunderbots.firmware-request.fill-page", 3, kMaxMessagePayload,
                          "Put data into the page buffer", fw::fill_page::kFields),
    request<Op::ProgramPage>("thunderbots.firmware-request.program-page", 5, 5, "Burn the page buffer",
                             fw::program_page::kFields),
    request<Op::BlockCrc>("thunderbots.firmware-request.block-crc", 6, 6,
                          "Compute the CRC of a block of flash", fw::block_crc::kRequestFields),
    request<Op::ReadParameters>("thunderbots.firmware-request.read-parameters", 1, 1,
                                "Read the operational parameters"),
    request<Op::SetParameters>("thunderbots.firmware-request.set-parameters", kFewestCarriedParameters,
                               kMaxMessagePayload, "Change the operational parameters until reboot",
                               fw::kParametersFields<Op::SetParameters>),
    request<Op::CommitParameters>("thunderbots.firmware-request.commit-parameters", 1, 1,
                                  "Keep the operational parameters for good"),
    request<Op::Reboot>("thunderbots.firmware-request.reboot", 1, 1, "Reboot the robot"),
    request<Op::ReadSignatures>("thunderbots.firmware-request.signatures", 1, 1, "Read the build signatures"),

    response<Op::EraseChip>("thunderbots.firmware-response.erase", 1, 1, "The SPI flash is erased"),
    response<Op::ProgramPage>("thunderbots.firmware-response.program-page", 1, 1, "The page is burnt"),
    response<Op::BlockCrc>("thunderbots.firmware-response.block-crc", 8, 8, "The CRC of a block of flash",
                           fw::block_crc::kResponseFields),
    response<Op::ReadParameters>("thunderbots.firmware-response.read-parameters", kFewestCarriedParameters,
                                 kMaxMessagePayload, "The operational parameters in force",
                                 fw::kParametersFields<Op::ReadParameters>),
    response<Op::SetParameters>("thunderbots.firmware-response.set-parameters", 1, 1,
                                "The parameters are in force"),
    response<Op::CommitParameters>("thunderbots.firmware-response.commit-parameters", 1, 1,
                                   "The parameters are kept"),
    response<Op::Reboot>("thunderbots.firmware-response.reboot", 1, 1, "The robot is about to reboot"),
    response<Op::ReadSignatures>("thunderbots.firmware-response.signatures", 5, 5, "The build signatures",
                                 fw::signatures::kFields),

    MessageSpec{"thunderbots.parameters", kLsb, size(kDefinedParameterBytes), size(kMaxParameterBytes), 0,
                "4.8", "The operational parameters block", at::parameters::kFields, reads<decodeParameters>,
                checkedParameters},
    fixed<kStatusBytes, decodeStatus, encodeStatus>("thunderbots.status", kLsb, "3.8",
                                                    "What the dongle says of itself", at::status::kFields),
    fixed<kChannelsBytes, decodeChannels, encodeChannels>(
        "thunderbots.channels", kLsb, "3.3", "The dongle's radio channels", at::channels::kFields),
    fixed<kRadioVersionsBytes, decodeRadioVersions, encodeRadioVersions>(
        "thunderbots.radio-versions", kLsb, "3.3", "The firmware versions of the dongle's radios",
        at::radio_versions::kFields),
    MessageSpec{"thunderbots.message", kLsb, 1, size(kMaxMessagePacket), 0, "3.7", "A message packet",
                at::message::kFields, readsMessagePacket, readsMessagePacket},
    MessageSpec{"thunderbots.state-packet", kLsb, size(kFeedbackMicropacketBytes),
                size(kDriveMicropacketBytes), size(kMaxStatePacket), "3.6",
                "State transport: a list of micropackets", at::micropacket::kFields, readsMicropacket,
                readsMicropacket},
    MessageSpec{"thunderbots.error-queue", kLsb, 1, 1, size(kPacketBytes), "3.9", "The dongle's fault codes",
                at::error_queue::kFields, ofLength<1, anything>, ofLength<1, anything>},
};

/// Whether a message's name is the family's, a dot, and an opcode's name; by the opcode it can be told apart.
bool isVariantOf(const MessageSpec& message, std::string_view family) noexcept {
    const std::string_view name = message.name;
    return name.starts_with(family) && name.rfind('.') == family.size() && !message.fields.empty() &&
           message.fields.front().kind == FieldKind::Opcode;
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
    if (bytes.empty()) return nullptr;
    for (const MessageSpec& message : kMessages) {
        if (isVariantOf(message, name) && message.fields.front().lowest == bytes[0]) return &message;
    }
    return nullptr;
}

bool isFamily(std::string_view name) noexcept {
    return std::any_of(kMessages.begin(), kMessages.end(),
                       [name](const MessageSpec& message) { return isVariantOf(message, name); });
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
