#include "core/link/link_uri.h"

#include <optional>

namespace kickstand {
namespace {

constexpr char kHexDigits[] = "0123456789ABCDEF";

bool isControl(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
}
bool isLower(char c) {
    return c >= 'a' && c <= 'z';
}
bool isUpper(char c) {
    return c >= 'A' && c <= 'Z';
}
bool isDigit(char c) {
    return c >= '0' && c <= '9';
}
bool isNameCharacter(char c) {
    return isLower(c) || isDigit(c) || c == '-' || c == '_';
}

std::optional<int> hexValue(char c) {
    if (isDigit(c)) return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return std::nullopt;
}

void appendEscaped(std::string& text, char c) {
    const auto byte = static_cast<unsigned char>(c);
    text += '%';
    text += kHexDigits[byte >> 4];
    text += kHexDigits[byte & 0x0F];
}

/// What may be shown of text from outside: control characters become escapes.
std::string printable(std::string_view text) {
    std::string shown;
    for (const char c : text) {
        if (isControl(c))
            appendEscaped(shown, c);
        else
            shown += c;
    }
    return shown;
}

/// A reader of one URI: knows the whole text, so that an error can say where the bad piece stands.
class Reader {
  public:
    explicit Reader(std::string_view text) : text_(text) {}

    Result<LinkUri> read() const {
        LinkUri uri;
        const std::size_t colon = text_.find(':');
        if (colon == std::string_view::npos) return bad(text_);
        const std::string_view rest = text_.substr(colon + 1);
        const std::size_t mark = rest.find('?');
        if (auto scheme = readScheme(text_.substr(0, colon)))
            uri.scheme = std::move(*scheme);
        else
            return fail(std::move(scheme.error()));
        if (auto target = decode(rest.substr(0, mark)))
            uri.target = std::move(*target);
        else
            return fail(std::move(target.error()));
        if (mark == std::string_view::npos) return uri;
        if (auto read = readOptions(rest.substr(mark + 1), uri.options); !read)
            return fail(std::move(read.error()));
        return uri;
    }

  private:
    tl::unexpected<Error> bad(std::string_view piece) const {
        Error error;
        error.code = Errc::BadUri;
        error.subject = printable(text_);
        error.got = piece.data() - text_.data();
        error.detail = printable(piece);
        return fail(std::move(error));
    }

    Result<std::string> readScheme(std::string_view piece) const {
        std::string scheme;
        for (const char c : piece) {
            const char lower = isUpper(c) ? static_cast<char>(c - 'A' + 'a') : c;
            if (!isLower(lower) && (scheme.empty() || !(isDigit(lower) || lower == '-'))) return bad(piece);
            scheme += lower;
        }
        if (scheme.empty()) return bad(piece);
        return scheme;
    }

    Result<std::string> decode(std::string_view piece) const {
        std::string decoded;
        for (std::size_t at = 0; at < piece.size(); ++at) {
            char c = piece[at];
            if (c == '%') {
                const auto high = at + 1 < piece.size() ? hexValue(piece[at + 1]) : std::nullopt;
                const auto low = at + 2 < piece.size() ? hexValue(piece[at + 2]) : std::nullopt;
                if (!high || !low) return bad(piece.substr(at, 3));
                c = static_cast<char>(*high << 4 | *low);
                if (isControl(c)) return bad(piece.substr(at, 3));
                at += 2;
            } else if (isControl(c) || c == '#') {
                return bad(piece.substr(at, 1));
            }
            decoded += c;
        }
        return decoded;
    }

    Result<void> readOptions(std::string_view rest, std::map<std::string, std::string>& options) const {
        for (bool more = true; more;) {
            const std::size_t end = rest.find('&');
            const std::string_view piece = rest.substr(0, end);
            more = end != std::string_view::npos;
            if (more) rest.remove_prefix(end + 1);
            if (auto read = readOption(piece, options); !read) return read;
        }
        return {};
    }

    Result<void> readOption(std::string_view piece, std::map<std::string, std::string>& options) const {
        const std::size_t equals = piece.find('=');
        if (equals == std::string_view::npos || equals == 0) return bad(piece);
        auto key = decode(piece.substr(0, equals));
        if (!key) return fail(std::move(key.error()));
        for (const char c : *key) {
            if (!isNameCharacter(c)) return bad(piece.substr(0, equals));
        }
        auto value = decode(piece.substr(equals + 1));
        if (!value) return fail(std::move(value.error()));
        if (!options.emplace(std::move(*key), std::move(*value)).second) return bad(piece);
        return {};
    }

    std::string_view text_;
};

void appendEncoded(std::string& text, std::string_view piece, std::string_view reserved) {
    for (const char c : piece) {
        if (isControl(c) || c == ' ' || c == '%' || c == '#' || reserved.find(c) != std::string_view::npos)
            appendEscaped(text, c);
        else
            text += c;
    }
}

}  // namespace

Result<LinkUri> parseLinkUri(std::string_view text) {
    return Reader(text).read();
}

std::string toString(const LinkUri& uri) {
    std::string text = uri.scheme + ':';
    appendEncoded(text, uri.target, "?");
    char separator = '?';
    for (const auto& [key, value] : uri.options) {
        text += separator;
        appendEncoded(text, key, "&=");
        text += '=';
        appendEncoded(text, value, "&");
        separator = '&';
    }
    return text;
}

}  // namespace kickstand
