#include "core/base/hex.h"

namespace kickstand {
namespace {

int digitValue(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool isSeparator(char c) {
    return c == ' ' || c == '\t' || c == ':' || c == '\n' || c == '\r';
}

}  // namespace

std::string toHex(ByteView bytes) {
    static constexpr char kDigits[] = "0123456789abcdef";
    std::string text;
    text.reserve(bytes.size() * 3);
    for (const std::uint8_t byte : bytes) {
        if (!text.empty()) text += ' ';
        text += kDigits[byte >> 4];
        text += kDigits[byte & 0x0F];
    }
    return text;
}

Result<std::vector<std::uint8_t>> parseHex(std::string_view text) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(text.size() / 2);
    std::size_t at = 0;
    while (at < text.size()) {
        if (isSeparator(text[at])) {
            ++at;
            continue;
        }
        const bool prefixed =
            text[at] == '0' && at + 1 < text.size() && (text[at + 1] == 'x' || text[at + 1] == 'X');
        if (prefixed) at += 2;
        const int high = at < text.size() ? digitValue(text[at]) : -1;
        const int low = at + 1 < text.size() ? digitValue(text[at + 1]) : -1;
        if (high < 0 || low < 0) {
            Error error;
            error.code = Errc::Malformed;
            error.subject = "hex";
            error.got = static_cast<std::int64_t>(at);
            error.detail = std::string(text.substr(at, 2));
            return fail(std::move(error));
        }
        bytes.push_back(static_cast<std::uint8_t>(high << 4 | low));
        at += 2;
    }
    return bytes;
}

}  // namespace kickstand
