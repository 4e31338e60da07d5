#include "core/thunderbots/wire/firmware.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/thunderbots/wire/layout_firmware.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::firmware;
namespace {

using Reader = FieldReader<BitOrder::LsbFirst>;
using Writer = FieldWriter<BitOrder::LsbFirst>;

/// The bytes up to the end of a message's last numeric field.
constexpr std::size_t endOf(const FieldSpec& field) noexcept {
    return (field.firstBit + field.width) / 8U;
}
constexpr std::size_t kBareBytes = 1;
constexpr std::size_t kFillHeaderBytes = endOf(at::fill_page::kOffset);
constexpr std::size_t kProgramBytes = endOf(at::program_page::kCrc);
constexpr std::size_t kCrcRequestBytes = endOf(at::block_crc::kLength);
constexpr std::size_t kCrcResponseBytes = endOf(at::block_crc::kCrc);
constexpr std::size_t kSignaturesBytes = endOf(at::signatures::kFlash);

/// A message of `size` bytes whose first is the opcode.
MessagePayload begin(FirmwareOp op, std::size_t size) noexcept {
    MessagePayload payload;
    payload.resize(size);
    payload.span()[0] = static_cast<std::uint8_t>(op);
    return payload;
}

template <FirmwareOp op>
WireResult<MessagePayload> encode(const BareFirmwareMessage<op>&) noexcept {
    return begin(op, kBareBytes);
}

std::optional<WireError> fillFault(WireFault kind, std::uint8_t offset, std::size_t size) noexcept {
    const std::size_t room = std::min(kMaxFillBytes, kFlashPageBytes - offset);
    if (size >= 1 && size <= room) return std::nullopt;
    return WireError{kind, at::fill_page::kData.name, 1, static_cast<std::int32_t>(room),
                     static_cast<std::int32_t>(size)};
}

WireResult<MessagePayload> encode(const FillPageRequest& request) noexcept {
    if (const auto error = fillFault(WireFault::OutOfRange, request.offset, request.data.size())) {
        return tl::unexpected(*error);
    }
    MessagePayload payload = begin(FirmwareOp::FillPage, kFillHeaderBytes);
    Writer out(payload.span());
    out.number(at::fill_page::kOffset, request.offset);
    payload.append(request.data.view());
    return out.result(payload);
}

WireResult<MessagePayload> encode(const ProgramPageRequest& request) noexcept {
    MessagePayload payload = begin(FirmwareOp::ProgramPage, kProgramBytes);
    Writer out(payload.span());
    out.number(at::program_page::kPage, request.page);
    out.number(at::program_page::kCrc, request.crc);
    return out.result(payload);
}

/// The fields that request and response share, into a message that has been begun.
template <class T>
WireResult<MessagePayload> encodeBlock(const T& block, MessagePayload payload) noexcept {
    if (block.length < 1 || block.length > kMaxCrcBlock) {
        const auto got = static_cast<std::int32_t>(std::min<std::uint32_t>(block.length, INT32_MAX));
        return tl::unexpected(
            WireError{WireFault::OutOfRange, at::block_crc::kLength.name, 1, kMaxCrcBlock, got});
    }
    Writer out(payload.span());
    out.number(at::block_crc::kAddress,
               static_cast<std::int32_t>(std::min<std::uint32_t>(block.address, INT32_MAX)));
    out.put(at::block_crc::kLength, static_cast<std::int32_t>(block.length));
    return out.result(payload);
}

WireResult<MessagePayload> encode(const BlockCrcRequest& request) noexcept {
    return encodeBlock(request, begin(FirmwareOp::BlockCrc, kCrcRequestBytes));
}

WireResult<MessagePayload> encode(const BlockCrcResponse& response) noexcept {
    MessagePayload payload = begin(FirmwareOp::BlockCrc, kCrcResponseBytes);
    Writer(payload.span()).put(at::block_crc::kCrc, response.crc);
    return encodeBlock(response, payload);
}

MessagePayload withParameters(FirmwareOp op, const OperationalParameters& parameters) noexcept {
    MessagePayload payload = begin(op, kBareBytes);
    payload.append(encodeParameters(parameters).view());
    return payload;
}

WireResult<MessagePayload> encode(const SetParametersRequest& request) noexcept {
    const auto checked = checkParameters(request.parameters);
    if (!checked) return tl::unexpected(checked.error());
    return withParameters(FirmwareOp::SetParameters, request.parameters);
}

WireResult<MessagePayload> encode(const ReadParametersResponse& response) noexcept {
    return withParameters(FirmwareOp::ReadParameters, response.parameters);
}

WireResult<MessagePayload> encode(const ReadSignaturesResponse& response) noexcept {
    MessagePayload payload = begin(FirmwareOp::ReadSignatures, kSignaturesBytes);
    Writer out(payload.span());
    out.number(at::signatures::kMicrocontroller, response.microcontrollerCrc);
    out.number(at::signatures::kFlash, response.flashCrc);
    return out.result(payload);
}

template <class Message, FirmwareOp op>
WireResult<Message> decodeBare(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kBareBytes, kBareBytes)) return tl::unexpected(*error);
    return Message{BareFirmwareMessage<op>{}};
}

WireResult<FirmwareRequest> decodeFillPage(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kFillHeaderBytes + 1, kMaxMessagePayload)) {
        return tl::unexpected(*error);
    }
    Reader in(payload);
    FillPageRequest request;
    request.offset = in.byte(at::fill_page::kOffset);
    const ByteView data = payload.subspan(kFillHeaderBytes);
    if (const auto error = fillFault(WireFault::BadLength, request.offset, data.size())) {
        return tl::unexpected(*error);
    }
    request.data.append(data);
    return in.result(FirmwareRequest{request});
}

WireResult<FirmwareRequest> decodeProgramPage(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kProgramBytes, kProgramBytes))
        return tl::unexpected(*error);
    Reader in(payload);
    return in.result(FirmwareRequest{
        ProgramPageRequest{in.word(at::program_page::kPage), in.word(at::program_page::kCrc)}});
}

/// On the wire a length of 0 is a block of 64 KiB.
template <class T>
void readBlock(Reader& in, T& block) noexcept {
    block.address = static_cast<std::uint32_t>(in.number(at::block_crc::kAddress));
    block.length = in.word(at::block_crc::kLength);
    if (block.length == 0) block.length = kMaxCrcBlock;
}

WireResult<FirmwareRequest> decodeBlockCrcRequest(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kCrcRequestBytes, kCrcRequestBytes)) {
        return tl::unexpected(*error);
    }
    Reader in(payload);
    BlockCrcRequest request;
    readBlock(in, request);
    return in.result(FirmwareRequest{request});
}

WireResult<FirmwareResponse> decodeBlockCrcResponse(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kCrcResponseBytes, kCrcResponseBytes)) {
        return tl::unexpected(*error);
    }
    Reader in(payload);
    BlockCrcResponse response;
    readBlock(in, response);
    response.crc = in.word(at::block_crc::kCrc);
    return in.result(FirmwareResponse{response});
}

template <class Message, class Carrier>
WireResult<Message> decodeCarriedParameters(ByteView payload) noexcept {
    const std::size_t fewest = kBareBytes + kDefinedParameterBytes;
    if (const auto error = lengthFault(payload.size(), fewest, kMaxMessagePayload))
        return tl::unexpected(*error);
    const auto parameters = decodeParameters(payload.subspan(kBareBytes));
    if (!parameters) return tl::unexpected(parameters.error());
    return Message{Carrier{*parameters}};
}

WireResult<FirmwareResponse> decodeSignatures(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kSignaturesBytes, kSignaturesBytes)) {
        return tl::unexpected(*error);
    }
    Reader in(payload);
    return in.result(FirmwareResponse{
        ReadSignaturesResponse{in.word(at::signatures::kMicrocontroller), in.word(at::signatures::kFlash)}});
}

WireError unknownOpcode(std::uint8_t opcode) noexcept {
    return {WireFault::UnknownKind, "opcode", 0, static_cast<std::int32_t>(FirmwareOp::ReadSignatures),
            opcode};
}

template <FirmwareOp op>
constexpr FirmwareOp opOfMessage(const BareFirmwareMessage<op>&) noexcept {
    return op;
}
constexpr FirmwareOp opOfMessage(const FillPageRequest&) noexcept {
    return FirmwareOp::FillPage;
}
constexpr FirmwareOp opOfMessage(const ProgramPageRequest&) noexcept {
    return FirmwareOp::ProgramPage;
}
constexpr FirmwareOp opOfMessage(const BlockCrcRequest&) noexcept {
    return FirmwareOp::BlockCrc;
}
constexpr FirmwareOp opOfMessage(const BlockCrcResponse&) noexcept {
    return FirmwareOp::BlockCrc;
}
constexpr FirmwareOp opOfMessage(const SetParametersRequest&) noexcept {
    return FirmwareOp::SetParameters;
}
constexpr FirmwareOp opOfMessage(const ReadParametersResponse&) noexcept {
    return FirmwareOp::ReadParameters;
}
constexpr FirmwareOp opOfMessage(const ReadSignaturesResponse&) noexcept {
    return FirmwareOp::ReadSignatures;
}

/// std::visit without the exception that it may throw: these variants never lose their value.
template <std::size_t index = 0, class Variant, class Visitor>
auto visitMessage(const Variant& variant, Visitor visitor) noexcept {
    if constexpr (index + 1 < std::variant_size_v<Variant>) {
        if (variant.index() != index) return visitMessage<index + 1>(variant, visitor);
    }
    return visitor(*std::get_if<index>(&variant));
}

}  // namespace

const char* name(FirmwareOp op) noexcept {
    switch (op) {
        case FirmwareOp::EraseChip:
            return "erase";
        case FirmwareOp::FillPage:
            return "fill-page";
        case FirmwareOp::ProgramPage:
            return "program-page";
        case FirmwareOp::BlockCrc:
            return "block-crc";
        case FirmwareOp::ReadParameters:
            return "read-parameters";
        case FirmwareOp::SetParameters:
            return "set-parameters";
        case FirmwareOp::CommitParameters:
            return "commit-parameters";
        case FirmwareOp::Reboot:
            return "reboot";
        case FirmwareOp::ReadSignatures:
            return "signatures";
    }
    return "undefined";
}

FirmwareOp opOf(const FirmwareRequest& request) noexcept {
    return visitMessage(request, [](const auto& message) { return opOfMessage(message); });
}
FirmwareOp opOf(const FirmwareResponse& response) noexcept {
    return visitMessage(response, [](const auto& message) { return opOfMessage(message); });
}

WireResult<MessagePayload> encodeFirmwareRequest(const FirmwareRequest& request) noexcept {
    return visitMessage(request, [](const auto& message) { return encode(message); });
}
WireResult<MessagePayload> encodeFirmwareResponse(const FirmwareResponse& response) noexcept {
    return visitMessage(response, [](const auto& message) { return encode(message); });
}

WireResult<FirmwareRequest> decodeFirmwareRequest(ByteView payload) noexcept {
    using M = FirmwareRequest;
    if (const auto error = lengthFault(payload.size(), kBareBytes, kMaxMessagePayload)) {
        return tl::unexpected(*error);
    }
    switch (static_cast<FirmwareOp>(payload[0])) {
        case FirmwareOp::EraseChip:
            return decodeBare<M, FirmwareOp::EraseChip>(payload);
        case FirmwareOp::FillPage:
            return decodeFillPage(payload);
        case FirmwareOp::ProgramPage:
            return decodeProgramPage(payload);
        case FirmwareOp::BlockCrc:
            return decodeBlockCrcRequest(payload);
        case FirmwareOp::ReadParameters:
            return decodeBare<M, FirmwareOp::ReadParameters>(payload);
        case FirmwareOp::SetParameters:
            return decodeCarriedParameters<M, SetParametersRequest>(payload);
        case FirmwareOp::CommitParameters:
            return decodeBare<M, FirmwareOp::CommitParameters>(payload);
        case FirmwareOp::Reboot:
            return decodeBare<M, FirmwareOp::Reboot>(payload);
        case FirmwareOp::ReadSignatures:
            return decodeBare<M, FirmwareOp::ReadSignatures>(payload);
    }
    return tl::unexpected(unknownOpcode(payload[0]));
}

WireResult<FirmwareResponse> decodeFirmwareResponse(ByteView payload) noexcept {
    using M = FirmwareResponse;
    if (const auto error = lengthFault(payload.size(), kBareBytes, kMaxMessagePayload)) {
        return tl::unexpected(*error);
    }
    switch (static_cast<FirmwareOp>(payload[0])) {
        case FirmwareOp::EraseChip:
            return decodeBare<M, FirmwareOp::EraseChip>(payload);
        case FirmwareOp::FillPage:
            break;
        case FirmwareOp::ProgramPage:
            return decodeBare<M, FirmwareOp::ProgramPage>(payload);
        case FirmwareOp::BlockCrc:
            return decodeBlockCrcResponse(payload);
        case FirmwareOp::ReadParameters:
            return decodeCarriedParameters<M, ReadParametersResponse>(payload);
        case FirmwareOp::SetParameters:
            return decodeBare<M, FirmwareOp::SetParameters>(payload);
        case FirmwareOp::CommitParameters:
            return decodeBare<M, FirmwareOp::CommitParameters>(payload);
        case FirmwareOp::Reboot:
            return decodeBare<M, FirmwareOp::Reboot>(payload);
        case FirmwareOp::ReadSignatures:
            return decodeSignatures(payload);
    }
    return tl::unexpected(unknownOpcode(payload[0]));
}

}  // namespace kickstand::thunderbots::wire
