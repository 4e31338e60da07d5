#include "core/smartdevice/wire/uid.h"

#include <algorithm>

namespace kickstand::smartdevice::wire {
namespace {

constexpr std::size_t deviceBytes(Dialect dialect) {
    return dialect == Dialect::Current ? 1 : 2;
}

void appendHex(std::string& text, std::uint8_t byte) {
    constexpr char kDigits[] = "0123456789abcdef";
    text += kDigits[byte >> 4];
    text += kDigits[byte & 0x0F];
}

std::optional<std::uint8_t> digit(char c) {
    if (c >= '0' && c <= '9') return static_cast<std::uint8_t>(c - '0');
    if (c >= 'a' && c <= 'f') return static_cast<std::uint8_t>(c - 'a' + 10);
    if (c >= 'A' && c <= 'F') return static_cast<std::uint8_t>(c - 'A' + 10);
    return std::nullopt;
}

}  // namespace

const char* name(Dialect dialect) noexcept {
    return dialect == Dialect::Current ? "current" : "hibike";
}

std::uint16_t Uid::device() const noexcept {
    return dialect == Dialect::Current ? bytes[0] : loadLe16(bytes, 0);
}

std::uint8_t Uid::year() const noexcept {
    return bytes.at(deviceBytes(dialect));
}

std::optional<Uid> readUid(Dialect dialect, ByteView bytes) noexcept {
    if (bytes.size() != kUidSize) return std::nullopt;
    Uid uid;
    uid.dialect = dialect;
    std::copy(bytes.begin(), bytes.end(), uid.bytes.begin());
    return uid;
}

std::string toText(const Uid& uid) {
    std::string text;
    const std::size_t device = deviceBytes(uid.dialect);
    // The kind is a number, its high byte first; the rest are bytes.
    for (std::size_t i = device; i > 0; --i)
        appendHex(text, uid.bytes.at(i - 1));
    text += '-';
    appendHex(text, uid.year());
    text += '-';
    for (std::size_t i = device + 1; i < kUidSize; ++i)
        appendHex(text, uid.bytes.at(i));
    return text;
}

std::optional<Uid> uidFromText(std::string_view text) {
    const std::size_t dash = text.find('-');
    if (dash != 2 && dash != 4) return std::nullopt;
    Uid uid;
    uid.dialect = dash == 2 ? Dialect::Current : Dialect::Hibike;
    std::array<std::uint8_t, kUidSize> read{};
    std::size_t count = 0;
    for (std::size_t at = 0; at < text.size(); at += 2) {
        if (at == dash || at == dash + 3) {
            if (text[at] != '-') return std::nullopt;
            ++at;
        }
        const auto high = digit(text[at < text.size() ? at : text.size() - 1]);
        const auto low = at + 1 < text.size() ? digit(text[at + 1]) : std::nullopt;
        if (!high || !low || count == kUidSize) return std::nullopt;
        read.at(count++) = static_cast<std::uint8_t>(*high << 4 | *low);
    }
    if (count != kUidSize) return std::nullopt;
    if (uid.dialect == Dialect::Hibike) std::swap(read[0], read[1]);
    uid.bytes = read;
    return uid;
}

}  // namespace kickstand::smartdevice::wire
