#include "core/framing/xbee.h"

#include "core/framing/byte_sum.h"

namespace kickstand::xbee {
namespace {

constexpr std::uint8_t kXon = 0x11;
constexpr std::uint8_t kXoff = 0x13;

constexpr std::uint8_t byteOf(FrameType type) {
    return static_cast<std::uint8_t>(type);
}

void put16(FrameData& data, std::uint16_t value) noexcept {
    data.append(static_cast<std::uint8_t>(value >> 8));
    data.append(static_cast<std::uint8_t>(value));
}

FrameData finished(const FrameData& data, bool fits) noexcept {
    return fits ? data : FrameData();
}

FrameData encoded(const OtherFrame& frame) noexcept {
    FrameData data;
    data.append(frame.type);
    return finished(data, data.append(frame.rest));
}

FrameData encoded(const Tx16& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::Tx16));
    data.append(frame.frameId);
    put16(data, frame.destination);
    data.append(frame.options);
    return finished(data, frame.payload.size() <= kMaxPayload && data.append(frame.payload));
}

FrameData encoded(const Rx16& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::Rx16));
    put16(data, frame.source);
    data.append(static_cast<std::uint8_t>(-frame.rssi_dBm));
    data.append(frame.options);
    const bool fits = frame.rssi_dBm <= 0 && frame.rssi_dBm >= -255 && frame.payload.size() <= kMaxPayload;
    return finished(data, fits && data.append(frame.payload));
}

FrameData encoded(const TxStatus& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::TxStatus));
    data.append(frame.frameId);
    data.append(frame.status);
    return data;
}

void putName(FrameData& data, std::array<char, 2> name) noexcept {
    data.append(static_cast<std::uint8_t>(name[0]));
    data.append(static_cast<std::uint8_t>(name[1]));
}

FrameData encoded(const AtCommand& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::AtCommand));
    data.append(frame.frameId);
    putName(data, frame.name);
    return finished(data, data.append(frame.value));
}

FrameData encoded(const AtResponse& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::AtResponse));
    data.append(frame.frameId);
    putName(data, frame.name);
    data.append(frame.status);
    return finished(data, data.append(frame.value));
}

FrameData encoded(const ModemStatus& frame) noexcept {
    FrameData data;
    data.append(byteOf(FrameType::ModemStatus));
    data.append(frame.status);
    return data;
}

std::array<char, 2> nameAt(ByteView data, std::size_t at) noexcept {
    return {static_cast<char>(data[at]), static_cast<char>(data[at + 1])};
}

/// How much of the data each kind needs at least, its type included.
constexpr std::size_t fewestBytes(std::uint8_t type) noexcept {
    switch (static_cast<FrameType>(type)) {
        case FrameType::Tx16:
        case FrameType::Rx16:
        case FrameType::AtResponse:
            return 5;
        case FrameType::AtCommand:
            return 4;
        case FrameType::TxStatus:
            return 3;
        case FrameType::ModemStatus:
            return 2;
    }
    return 1;
}

void putEscaped(LineFrame& line, std::uint8_t byte) noexcept {
    const bool special = byte == kDelimiter || byte == kEscape || byte == kXon || byte == kXoff;
    if (special) {
        line.append(kEscape);
        byte = static_cast<std::uint8_t>(byte ^ kEscapeMask);
    }
    line.append(byte);
}

}  // namespace

std::uint8_t checksum(ByteView data) noexcept {
    return static_cast<std::uint8_t>(0xFF - (byteSum(data) & 0xFF));
}

std::optional<Frame> decodeFrame(ByteView data) noexcept {
    if (data.empty() || data.size() < fewestBytes(data[0])) return std::nullopt;
    switch (static_cast<FrameType>(data[0])) {
        case FrameType::Tx16:
            return Tx16{data[1], loadBe16(data, 2), data[4], data.subspan(5)};
        case FrameType::Rx16:
            return Rx16{loadBe16(data, 1), -int{data[3]}, data[4], data.subspan(5)};
        case FrameType::TxStatus:
            return TxStatus{data[1], data[2]};
        case FrameType::AtCommand:
            return AtCommand{data[1], nameAt(data, 2), data.subspan(4)};
        case FrameType::AtResponse:
            return AtResponse{data[1], nameAt(data, 2), data[4], data.subspan(5)};
        case FrameType::ModemStatus:
            return ModemStatus{data[1]};
    }
    return OtherFrame{data[0], data.subspan(1)};
}

FrameData encodeFrame(const Frame& frame) {
    return std::visit([](const auto& one) { return encoded(one); }, frame);
}

LineFrame wrapFrame(ByteView data, ApiMode mode) noexcept {
    LineFrame line;
    if (data.empty() || data.size() > kMaxFrameData) return line;
    line.append(kDelimiter);
    const std::array<std::uint8_t, 2> length{0, static_cast<std::uint8_t>(data.size())};
    const std::uint8_t check = checksum(data);
    if (mode == ApiMode::Plain) {
        line.append(length);
        line.append(data);
        line.append(check);
        return line;
    }
    for (const std::uint8_t byte : length)
        putEscaped(line, byte);
    for (const std::uint8_t byte : data)
        putEscaped(line, byte);
    putEscaped(line, check);
    return line;
}

}  // namespace kickstand::xbee
