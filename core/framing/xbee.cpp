#include "core/framing/xbee.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "core/framing/byte_places.h"
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

bool isSpecial(std::uint8_t byte) noexcept {
    return byte == kDelimiter || byte == kEscape || byte == kXon || byte == kXoff;
}

std::uint8_t* putEscaped(std::uint8_t* out, std::uint8_t byte) noexcept {
    if (isSpecial(byte)) {
        *out++ = kEscape;
        byte = static_cast<std::uint8_t>(byte ^ kEscapeMask);
    }
    *out++ = byte;
    return out;
}

/// Puts `size` bytes there, escaped, and gives the place behind them. Whole stripes are read and written,
/// which costs less than to count: behind both there must be room for one.
std::uint8_t* putEscaped(std::uint8_t* out, const std::uint8_t* bytes, std::size_t size) noexcept {
    std::size_t at = 0;
    for (std::size_t stripe = 0; stripe < size; stripe += kStripe) {
        const std::size_t end = std::min(size, stripe + kStripe);
        const std::uint8_t* const here = bytes + stripe;
        std::uint64_t specials = placesOf(here, kDelimiter) | placesOf(here, kEscape) | placesOf(here, kXon) |
                                 placesOf(here, kXoff);
        if (end - stripe < kStripe) specials &= (std::uint64_t{1} << (end - stripe)) - 1;
        for (; specials != 0; specials &= specials - 1) {
            const std::size_t found = stripe + static_cast<std::size_t>(std::countr_zero(specials));
            std::memcpy(out, bytes + at, kStripe);
            out += found - at;
            *out++ = kEscape;
            *out++ = static_cast<std::uint8_t>(bytes[found] ^ kEscapeMask);
            at = found + 1;
        }
        std::memcpy(out, bytes + at, kStripe);
        out += end - at;
        at = end;
    }
    return out;
}

LineFrame wrapPlain(ByteView data) noexcept {
    LineFrame line;
    std::uint8_t* const out = line.room().data();
    out[0] = kDelimiter;
    out[1] = 0;
    out[2] = static_cast<std::uint8_t>(data.size());
    std::memcpy(out + 3, data.data(), data.size());
    out[3 + data.size()] = checksum(data);
    line.take(3 + data.size() + 1);
    return line;
}

LineFrame wrapEscaped(ByteView data) noexcept {
    LineFrame line;
    alignas(kStripe) std::array<std::uint8_t, kMaxFrameData + kStripe> bytes;
    std::memcpy(bytes.data(), data.data(), data.size());
    std::uint8_t* const begin = line.room().data();
    std::uint8_t* out = begin;
    *out++ = kDelimiter;
    *out++ = 0;
    out = putEscaped(out, static_cast<std::uint8_t>(data.size()));
    out = putEscaped(out, bytes.data(), data.size());
    out = putEscaped(out, checksum(data));
    line.take(static_cast<std::size_t>(out - begin));
    return line;
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
    if (data.empty() || data.size() > kMaxFrameData) return {};
    return mode == ApiMode::Plain ? wrapPlain(data) : wrapEscaped(data);
}

}  // namespace kickstand::xbee
