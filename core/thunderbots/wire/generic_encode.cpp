#include <algorithm>
#include <charconv>
#include <map>

#include "core/base/hex.h"
#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/generic.h"
#include "core/thunderbots/wire/generic_names.h"

namespace kickstand::thunderbots::wire {
namespace {

using Bytes = std::vector<std::uint8_t>;
/// What was given for one message, by field name.
using Given = std::map<std::string, std::string, std::less<>>;

std::string subjectOf(const MessageSpec& message, const FieldSpec& field) {
    return std::string(message.name) + ' ' + field.name;
}

Error outOfRange(const MessageSpec& message, const FieldSpec& field, std::int64_t lowest,
                 std::int64_t highest, std::int64_t got) {
    Error error;
    error.code = Errc::OutOfRange;
    error.subject = subjectOf(message, field);
    error.lowest = lowest;
    error.highest = highest;
    error.got = got;
    return error;
}

/// A decimal or 0x number that is all of `text`.
std::optional<std::int64_t> parseNumber(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        base = 16;
    }
    std::uint32_t magnitude = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), magnitude, base);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return negative ? -static_cast<std::int64_t>(magnitude) : static_cast<std::int64_t>(magnitude);
}

std::optional<std::int64_t> parseValue(const FieldSpec& field, std::string_view text) {
    if (field.kind == FieldKind::Flag && (text == "true" || text == "false")) return text == "true" ? 1 : 0;
    const auto label = std::find(field.labels.begin(), field.labels.end(), text);
    if (label != field.labels.end()) return label - field.labels.begin();
    return parseNumber(text);
}

/// The number for a field, given or not, within its range.
Result<std::int32_t> numberFor(const MessageSpec& message, const FieldSpec& field, const Given& given) {
    const std::int64_t highest = field.kind == FieldKind::Reserved ? 0 : field.highest;
    std::int64_t value = field.kind == FieldKind::Opcode ? field.lowest : 0;
    if (const auto entry = given.find(field.name); entry != given.end()) {
        const auto parsed = parseValue(field, entry->second);
        if (!parsed) return fail(Errc::BadArgument, subjectOf(message, field), entry->second);
        value = *parsed;
    } else if (value < field.lowest) {
        return fail(Errc::BadArgument, subjectOf(message, field), "not given");
    }
    if (value < field.lowest || value > highest) {
        return fail(outOfRange(message, field, field.lowest, highest, value));
    }
    return static_cast<std::int32_t>(value);
}

Result<Bytes> bytesFor(const MessageSpec& message, const FieldSpec& field, const Given& given) {
    Bytes bytes;
    if (const auto entry = given.find(field.name); entry != given.end()) {
        auto parsed = parseHex(entry->second);
        if (!parsed) {
            parsed.error().code = Errc::BadArgument;
            parsed.error().subject = subjectOf(message, field);
            return parsed;
        }
        bytes = std::move(*parsed);
    } else if (field.lowest > 0) {
        return fail(Errc::BadArgument, subjectOf(message, field), "not given");
    }
    const auto count = static_cast<std::int64_t>(bytes.size());
    if (count < field.lowest || count > field.highest) {
        Error error = outOfRange(message, field, field.lowest, field.highest, count);
        error.detail = "bytes";
        return fail(std::move(error));
    }
    return bytes;
}

/// Numbers fill the bytes before a message's rest, whose place tells how many those are.
std::size_t fixedBytes(const MessageSpec& message) {
    const bool hasRest = !message.fields.empty() && message.fields.back().kind == FieldKind::Bytes;
    return hasRest ? message.fields.back().firstBit / 8U : message.minBytes;
}

/// Writes a length that counts its own message; one that was given must say the same.
Result<void> writeLength(const MessageSpec& message, const FieldSpec& field, const Given& given,
                         Bytes& bytes) {
    const auto length = static_cast<std::int32_t>(bytes.size());
    if (given.contains(field.name)) {
        const auto value = numberFor(message, field, given);
        if (!value) return fail(value.error());
        if (*value != length) return fail(outOfRange(message, field, length, length, *value));
    }
    writeField(message, field, bytes, length);
    return {};
}

Result<Bytes> encodeOne(const MessageSpec& message, const Given& given) {
    Bytes bytes(fixedBytes(message));
    for (const FieldSpec& field : message.fields) {
        if (field.kind == FieldKind::Length) continue;
        if (field.kind == FieldKind::Bytes) {
            auto rest = bytesFor(message, field, given);
            if (!rest) return rest;
            bytes.insert(bytes.end(), rest->begin(), rest->end());
            continue;
        }
        const auto value = numberFor(message, field, given);
        if (!value) return fail(value.error());
        writeField(message, field, bytes, *value);
    }
    for (const FieldSpec& field : message.fields) {
        if (field.kind != FieldKind::Length) continue;
        if (const auto written = writeLength(message, field, given, bytes); !written)
            return fail(written.error());
    }
    if (const auto verdict = message.mayBeSent(bytes); !verdict) {
        Error error = toError(verdict.error(), message.name);
        error.code = Errc::OutOfRange;
        return fail(std::move(error));
    }
    return bytes;
}

/// "2.robot" is the robot of the second message; without a number it is the first's. Gives 0 for no such
/// number.
std::pair<int, std::string_view> splitName(std::string_view name) {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos) return {1, name};
    int number = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + dot, number);
    const bool valid = error == std::errc{} && end == name.data() + dot && number >= 1;
    return {valid ? number : 0, name.substr(dot + 1)};
}

/// Sorts what was given by the message of the list that it belongs to; what is no list has one message.
Result<std::map<int, Given>> sortGiven(const MessageSpec& message, std::span<const FieldText> fields) {
    std::map<int, Given> sorted;
    const bool list = message.maxListBytes != 0;
    for (const auto& [name, text] : fields) {
        const auto [number, field] = list ? splitName(name) : std::pair<int, std::string_view>{1, name};
        const bool known =
            number >= 1 && std::any_of(message.fields.begin(), message.fields.end(),
                                       [wanted = field](const FieldSpec& f) { return f.name == wanted; });
        if (!known)
            return fail(Errc::UnknownName, std::string(message.name) + ' ' + name, knownFieldNames(message));
        if (!sorted[number].emplace(field, text).second) {
            return fail(Errc::BadArgument, std::string(message.name) + ' ' + name, "given twice");
        }
    }
    return sorted;
}

Result<Bytes> encodeList(const MessageSpec& message, const std::map<int, Given>& given) {
    Bytes all;
    int expected = 1;
    for (const auto& [number, fields] : given) {
        if (number != expected) {
            return fail(Errc::BadArgument, std::string(message.name) + ' ' + std::to_string(expected),
                        "not given");
        }
        ++expected;
        auto one = encodeOne(message, fields);
        if (!one) return one;
        all.insert(all.end(), one->begin(), one->end());
    }
    if (const auto error = lengthFault(all.size(), 0, message.maxListBytes)) {
        Error refused = toError(*error, message.name);
        refused.code = Errc::OutOfRange;
        return fail(std::move(refused));
    }
    return all;
}

}  // namespace

Result<std::vector<std::uint8_t>> encodeMessage(std::string_view name, std::span<const FieldText> fields) {
    const MessageSpec* const message = findMessage(name);
    if (message == nullptr) return fail(Errc::UnknownName, std::string(name), knownMessageNames());
    auto given = sortGiven(*message, fields);
    if (!given) return fail(given.error());
    return message->maxListBytes != 0 ? encodeList(*message, *given) : encodeOne(*message, (*given)[1]);
}

}  // namespace kickstand::thunderbots::wire
