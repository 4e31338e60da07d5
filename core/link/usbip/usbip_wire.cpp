#include "core/link/usbip/usbip_wire.h"

#include <algorithm>

namespace kickstand::usbip {
namespace {

constexpr std::size_t kOpHeaderSize = 8;
constexpr std::size_t kPathSize = 256;
constexpr std::size_t kBusIdSize = kMaxBusIdLength + 1;
/// Three numbers of four bytes, three of two, six of one.
constexpr std::size_t kDeviceNumbersSize = 24;
constexpr std::size_t kDeviceSize = kPathSize + kBusIdSize + kDeviceNumbersSize;
constexpr std::size_t kInterfaceSize = 4;
constexpr std::size_t kCommandSize = 48;
static_assert(kDeviceSize == 312);
static_assert(kReplySize == kCommandSize);

constexpr std::uint16_t kOpRequest = 0x8000;
constexpr std::uint16_t kOpImport = 0x0003;
constexpr std::uint16_t kOpDeviceList = 0x0005;

constexpr std::uint32_t kCmdSubmit = 1;
constexpr std::uint32_t kCmdUnlink = 2;
constexpr std::uint32_t kRetSubmit = 3;
constexpr std::uint32_t kRetUnlink = 4;
constexpr std::uint32_t kDirectionIn = 1;
constexpr std::uint32_t kHighestEndpoint = 15;
/// The number of isochronous packets in a transfer that has none; some clients say 0 instead.
constexpr std::uint32_t kNotIsochronous = 0xFFFFFFFF;

// Places in a command or reply (48 bytes).
constexpr std::size_t kSequenceAt = 4;
constexpr std::size_t kDeviceAt = 8;
constexpr std::size_t kDirectionAt = 12;
constexpr std::size_t kEndpointAt = 16;
constexpr std::size_t kFlagsAt = 20;
constexpr std::size_t kUnlinkAt = 20;
constexpr std::size_t kStatusAt = 20;
constexpr std::size_t kLengthAt = 24;
constexpr std::size_t kPacketsAt = 32;
constexpr std::size_t kIntervalAt = 36;
constexpr std::size_t kSetupAt = 40;

Parse complete(std::size_t bytes) {
    return {Parse::Status::Complete, bytes, ""};
}
Parse moreNeeded(std::size_t bytes) {
    return {Parse::Status::MoreNeeded, bytes, ""};
}
Parse malformed(const char* why) {
    return {Parse::Status::Malformed, 0, why};
}

void storeText(ByteSpan bytes, std::size_t at, std::size_t size, const std::string& text) {
    // The last byte stays zero: the text ends where it is read.
    std::copy_n(text.begin(), std::min(text.size(), size - 1),
                bytes.begin() + static_cast<std::ptrdiff_t>(at));
}

std::string loadText(ByteView bytes, std::size_t at, std::size_t size) {
    const ByteView field = bytes.subspan(at, size);
    return {field.begin(), std::find(field.begin(), field.end(), std::uint8_t{0})};
}

void storeOpHeader(ByteSpan bytes, std::uint16_t code, OpStatus status) {
    storeBe16(bytes, 0, kVersion);
    storeBe16(bytes, 2, code);
    storeBe32(bytes, 4, static_cast<std::uint32_t>(status));
}

/// Complete where the header is there and has this code.
Parse parseOpHeader(ByteView bytes, std::uint16_t code) {
    if (bytes.size() < kOpHeaderSize) return moreNeeded(kOpHeaderSize);
    if (loadBe16(bytes, 0) != kVersion) return malformed("not USB/IP 1.1.1");
    if (loadBe16(bytes, 2) != code) return malformed("not the answer to what was asked");
    return complete(kOpHeaderSize);
}

void storeDevice(ByteSpan bytes, const Device& device) {
    storeText(bytes, 0, kPathSize, device.path);
    storeText(bytes, kPathSize, kBusIdSize, device.busId);
    std::size_t at = kPathSize + kBusIdSize;
    for (const std::uint32_t number : {device.bus, device.number, static_cast<std::uint32_t>(device.speed)}) {
        storeBe32(bytes, at, number);
        at += 4;
    }
    for (const std::uint16_t number : {device.vendor, device.product, device.release}) {
        storeBe16(bytes, at, number);
        at += 2;
    }
    for (const std::uint8_t number :
         {device.deviceClass.deviceClass, device.deviceClass.subclass, device.deviceClass.protocol,
          device.configuration, device.configurations, static_cast<std::uint8_t>(device.interfaces.size())})
        bytes[at++] = number;
}

/// Gives the number of interfaces that are said to follow.
std::size_t loadDevice(ByteView bytes, Device& device) {
    device = {};
    device.path = loadText(bytes, 0, kPathSize);
    device.busId = loadText(bytes, kPathSize, kBusIdSize);
    const ByteView numbers = bytes.subspan(kPathSize + kBusIdSize);
    device.bus = loadBe32(numbers, 0);
    device.number = loadBe32(numbers, 4);
    device.speed = static_cast<Speed>(loadBe32(numbers, 8));
    device.vendor = loadBe16(numbers, 12);
    device.product = loadBe16(numbers, 14);
    device.release = loadBe16(numbers, 16);
    device.deviceClass = {numbers[18], numbers[19], numbers[20]};
    device.configuration = numbers[21];
    device.configurations = numbers[22];
    return numbers[23];
}

bool isIsochronous(ByteView bytes) {
    const std::uint32_t packets = loadBe32(bytes, kPacketsAt);
    return packets != 0 && packets != kNotIsochronous;
}

}  // namespace

std::vector<std::uint8_t> encodeRequest(const Request& request) {
    const bool isImport = request.kind == Request::Kind::Import;
    std::vector<std::uint8_t> bytes(kOpHeaderSize + (isImport ? kBusIdSize : 0));
    storeOpHeader(bytes, kOpRequest | (isImport ? kOpImport : kOpDeviceList), OpStatus::Ok);
    if (isImport) storeText(bytes, kOpHeaderSize, kBusIdSize, request.busId);
    return bytes;
}

Parse parseRequest(ByteView bytes, Request& request) {
    if (bytes.size() < kOpHeaderSize) return moreNeeded(kOpHeaderSize);
    if (loadBe16(bytes, 0) != kVersion) return malformed("not USB/IP 1.1.1");
    switch (loadBe16(bytes, 2)) {
        case kOpRequest | kOpDeviceList:
            request = {};
            return complete(kOpHeaderSize);
        case kOpRequest | kOpImport:
            if (bytes.size() < kOpHeaderSize + kBusIdSize) return moreNeeded(kOpHeaderSize + kBusIdSize);
            request = {Request::Kind::Import, loadText(bytes, kOpHeaderSize, kBusIdSize)};
            return complete(kOpHeaderSize + kBusIdSize);
        default:
            return malformed("neither a request for the list nor for a device");
    }
}

std::vector<std::uint8_t> encodeDeviceList(std::span<const Device> devices) {
    std::vector<std::uint8_t> bytes(kOpHeaderSize + 4);
    storeOpHeader(bytes, kOpDeviceList, OpStatus::Ok);
    storeBe32(bytes, kOpHeaderSize, static_cast<std::uint32_t>(devices.size()));
    for (const Device& device : devices) {
        const std::size_t at = bytes.size();
        bytes.resize(at + kDeviceSize);
        storeDevice(ByteSpan(bytes).subspan(at), device);
        for (const InterfaceClass& one : device.interfaces)
            bytes.insert(bytes.end(), {one.deviceClass, one.subclass, one.protocol, 0});
    }
    return bytes;
}

Parse parseDeviceList(ByteView bytes, OpStatus& status, std::vector<Device>& devices) {
    devices.clear();
    if (const Parse header = parseOpHeader(bytes, kOpDeviceList); header.status != Parse::Status::Complete)
        return header;
    status = static_cast<OpStatus>(loadBe32(bytes, 4));
    if (status != OpStatus::Ok) return complete(kOpHeaderSize);
    std::size_t at = kOpHeaderSize + 4;
    if (bytes.size() < at) return moreNeeded(at);
    const std::size_t count = loadBe32(bytes, kOpHeaderSize);
    if (count > kMaxDevices) return malformed("more devices than anyone has");
    for (std::size_t i = 0; i < count; ++i) {
        if (bytes.size() < at + kDeviceSize) return moreNeeded(at + kDeviceSize);
        Device& device = devices.emplace_back();
        const std::size_t interfaces = loadDevice(bytes.subspan(at), device);
        at += kDeviceSize;
        if (interfaces > kMaxInterfaces) return malformed("more interfaces than a device can have");
        if (bytes.size() < at + interfaces * kInterfaceSize)
            return moreNeeded(at + interfaces * kInterfaceSize);
        for (std::size_t k = 0; k < interfaces; ++k, at += kInterfaceSize)
            device.interfaces.push_back({bytes[at], bytes[at + 1], bytes[at + 2]});
    }
    return complete(at);
}

std::vector<std::uint8_t> encodeImportReply(OpStatus status, const Device& device) {
    std::vector<std::uint8_t> bytes(kOpHeaderSize + (status == OpStatus::Ok ? kDeviceSize : 0));
    storeOpHeader(bytes, kOpImport, status);
    if (status == OpStatus::Ok) storeDevice(ByteSpan(bytes).subspan(kOpHeaderSize), device);
    return bytes;
}

Parse parseImportReply(ByteView bytes, OpStatus& status, Device& device) {
    if (const Parse header = parseOpHeader(bytes, kOpImport); header.status != Parse::Status::Complete)
        return header;
    status = static_cast<OpStatus>(loadBe32(bytes, 4));
    if (status != OpStatus::Ok) return complete(kOpHeaderSize);
    if (bytes.size() < kOpHeaderSize + kDeviceSize) return moreNeeded(kOpHeaderSize + kDeviceSize);
    loadDevice(bytes.subspan(kOpHeaderSize), device);
    return complete(kOpHeaderSize + kDeviceSize);
}

std::vector<std::uint8_t> encodeCommand(const Command& command) {
    std::vector<std::uint8_t> bytes(kCommandSize);
    const bool isSubmit = command.kind == Command::Kind::Submit;
    storeBe32(bytes, 0, isSubmit ? kCmdSubmit : kCmdUnlink);
    storeBe32(bytes, kSequenceAt, command.sequence);
    storeBe32(bytes, kDeviceAt, command.device);
    storeBe32(bytes, kDirectionAt, isInEndpoint(command.endpoint) ? kDirectionIn : 0);
    storeBe32(bytes, kEndpointAt, command.endpoint & kHighestEndpoint);
    if (!isSubmit) {
        storeBe32(bytes, kUnlinkAt, command.unlink);
        return bytes;
    }
    storeBe32(bytes, kFlagsAt, command.flags);
    storeBe32(bytes, kLengthAt, command.length);
    storeBe32(bytes, kPacketsAt, kNotIsochronous);
    storeBe32(bytes, kIntervalAt, command.interval);
    const ByteSpan setup = ByteSpan(bytes).subspan(kSetupAt);
    setup[0] = command.setup.requestType;
    setup[1] = command.setup.request;
    storeLe16(setup, 2, command.setup.value);
    storeLe16(setup, 4, command.setup.index);
    storeLe16(setup, 6, command.setup.length);
    bytes.insert(bytes.end(), command.data.begin(), command.data.end());
    return bytes;
}

Parse parseCommand(ByteView bytes, Command& command) {
    if (bytes.size() < kCommandSize) return moreNeeded(kCommandSize);
    const std::uint32_t code = loadBe32(bytes, 0);
    if (code != kCmdSubmit && code != kCmdUnlink) return malformed("neither a submit nor an unlink");
    const std::uint32_t direction = loadBe32(bytes, kDirectionAt);
    const std::uint32_t endpoint = loadBe32(bytes, kEndpointAt);
    if (direction > kDirectionIn) return malformed("a direction that is neither in nor out");
    if (endpoint > kHighestEndpoint) return malformed("an endpoint above 15");
    command = {};
    command.kind = code == kCmdSubmit ? Command::Kind::Submit : Command::Kind::Unlink;
    command.sequence = loadBe32(bytes, kSequenceAt);
    command.device = loadBe32(bytes, kDeviceAt);
    command.endpoint = static_cast<std::uint8_t>(endpoint | (direction == kDirectionIn ? 0x80 : 0));
    if (command.kind == Command::Kind::Unlink) {
        command.unlink = loadBe32(bytes, kUnlinkAt);
        return complete(kCommandSize);
    }
    command.flags = loadBe32(bytes, kFlagsAt);
    command.length = loadBe32(bytes, kLengthAt);
    command.interval = loadBe32(bytes, kIntervalAt);
    const ByteView setup = bytes.subspan(kSetupAt);
    command.setup = {setup[0], setup[1], loadLe16(setup, 2), loadLe16(setup, 4), loadLe16(setup, 6)};
    if (command.length > kMaxTransferBytes) return malformed("a transfer longer than is taken");
    if (isIsochronous(bytes)) return malformed("an isochronous transfer");
    if (direction == kDirectionIn) return complete(kCommandSize);
    if (bytes.size() < kCommandSize + command.length) return moreNeeded(kCommandSize + command.length);
    command.data = bytes.subspan(kCommandSize, command.length);
    return complete(kCommandSize + command.length);
}

std::vector<std::uint8_t> encodeReply(const Reply& reply, ByteView data) {
    std::vector<std::uint8_t> bytes(kReplySize);
    const bool isSubmit = reply.kind == Command::Kind::Submit;
    storeBe32(bytes, 0, isSubmit ? kRetSubmit : kRetUnlink);
    storeBe32(bytes, kSequenceAt, reply.sequence);
    storeBe32(bytes, kStatusAt, static_cast<std::uint32_t>(reply.status));
    if (!isSubmit) return bytes;
    storeBe32(bytes, kLengthAt, reply.actual);
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
}

Parse parseReply(ByteView bytes, Reply& reply) {
    if (bytes.size() < kReplySize) return moreNeeded(kReplySize);
    const std::uint32_t code = loadBe32(bytes, 0);
    if (code != kRetSubmit && code != kRetUnlink) return malformed("not an answer");
    reply = {};
    reply.kind = code == kRetSubmit ? Command::Kind::Submit : Command::Kind::Unlink;
    reply.sequence = loadBe32(bytes, kSequenceAt);
    reply.status = static_cast<TransferStatus>(static_cast<std::int32_t>(loadBe32(bytes, kStatusAt)));
    if (reply.kind == Command::Kind::Unlink) return complete(kReplySize);
    reply.actual = loadBe32(bytes, kLengthAt);
    if (reply.actual > kMaxTransferBytes) return malformed("more bytes than can have been asked for");
    if (isIsochronous(bytes)) return malformed("an isochronous answer");
    return complete(kReplySize);
}

}  // namespace kickstand::usbip
