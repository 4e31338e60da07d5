#include "core/smartdevice/wire/named_frame.h"

#include <algorithm>
#include <charconv>

#include "core/base/hex.h"
#include "core/smartdevice/wire/fields.h"
#include "core/smartdevice/wire/frame.h"

namespace kickstand::smartdevice::wire {
namespace {

constexpr std::size_t kHeader = 2;
constexpr char kMessageField[] = "message";

std::optional<Dialect> dialectOf(std::string_view name) {
    if (name == kFrameName) return Dialect::Current;
    if (name == kHibikeFrameName) return Dialect::Hibike;
    return std::nullopt;
}

tl::unexpected<Error> noFrame(std::string_view name) {
    return fail(Errc::UnknownName, std::string(name),
                std::string(kFrameName) + ", " + std::string(kHibikeFrameName));
}

tl::unexpected<Error> malformed(std::string detail) {
    return fail(Errc::Malformed, "the frame", std::move(detail));
}

/// The COBS bytes between what begins and what ends a frame.
Result<ByteView> insideOf(Dialect dialect, ByteView frame) {
    constexpr std::size_t kOpening = 2;
    if (dialect == Dialect::Current) {
        if (frame.size() < 2 || frame.back() != 0) return malformed("it does not end in 00");
        return frame.first(frame.size() - 1);
    }
    if (frame.size() < kOpening || frame[0] != 0)
        return malformed("it does not begin with 00 and its length");
    if (frame[1] != frame.size() - kOpening) return malformed("its length is another one");
    return frame.subspan(kOpening);
}

Result<std::vector<std::uint8_t>> messageIn(Dialect dialect, ByteView frame) {
    const auto inside = insideOf(dialect, frame);
    if (!inside) return fail(inside.error());
    std::vector<std::uint8_t> message(inside->size());
    const auto size = cobsDecode(*inside, message);
    if (!size) return malformed("it is no COBS");
    message.resize(*size);
    if (const auto read = decodeMessage(dialect, message); !read) return malformed(name(read.error()));
    return message;
}

std::int64_t numberIn(ByteView bytes) {
    std::int64_t number = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i)
        number |= std::int64_t{bytes[i]} << 8 * i;
    return number;
}

std::string maskText(std::int64_t mask) {
    std::string text;
    for (int bit = 0; bit < kMostParameters; ++bit) {
        if ((mask >> bit & 1) != 0) text += (text.empty() ? "parameters " : ", ") + std::to_string(bit);
    }
    return text;
}

NamedField fieldOf(const FieldSpec& spec, Dialect dialect, ByteView bytes) {
    NamedField field;
    field.name = spec.name;
    field.description = spec.description;
    if (spec.kind == FieldKind::Uid || spec.kind == FieldKind::Values) {
        field.isBytes = true;
        field.bytes.assign(bytes.begin(), bytes.end());
        field.value = static_cast<std::int64_t>(bytes.size());
        if (const auto uid = readUid(dialect, bytes); uid && spec.kind == FieldKind::Uid)
            field.label = toText(*uid);
        return field;
    }
    field.value = numberIn(bytes);
    field.unit = spec.unit;
    if (!field.unit.empty()) field.physical = static_cast<double>(field.value);
    if (spec.kind == FieldKind::Mask) field.label = maskText(field.value);
    if (spec.kind == FieldKind::Code) {
        const char* label = name(static_cast<ErrorCode>(field.value));
        field.label = label == nullptr ? "" : label;
    }
    return field;
}

/// A number as it was typed; nothing for what is none.
std::optional<std::int64_t> readNumber(std::string_view text) {
    int base = 10;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        text.remove_prefix(2);
        base = 16;
    }
    std::int64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number, base);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return number;
}

std::optional<std::int64_t> readCode(std::string_view text) {
    for (const ErrorCode code : {ErrorCode::Delimiter, ErrorCode::Checksum, ErrorCode::Generic}) {
        if (text == name(code)) return static_cast<std::int64_t>(code);
    }
    return readNumber(text);
}

using Bytes = std::vector<std::uint8_t>;

Result<Bytes> bytesOfField(const FieldSpec& spec, Dialect dialect, const std::string& text) {
    const std::size_t width = spec.bytes.at(static_cast<std::size_t>(dialect));
    const auto wrong = [&] { return fail(Errc::BadArgument, spec.name, "“" + text + "”"); };
    if (spec.kind == FieldKind::Uid) {
        const auto uid = uidFromText(text);
        if (!uid || uid->dialect != dialect) return wrong();
        return Bytes(uid->bytes.begin(), uid->bytes.end());
    }
    if (spec.kind == FieldKind::Values) {
        const auto bytes = parseHex(text);
        if (!bytes || bytes->size() > mostPayload(dialect) - 2) return wrong();
        return *bytes;
    }
    const auto number = spec.kind == FieldKind::Code ? readCode(text) : readNumber(text);
    if (!number) return wrong();
    const std::int64_t highest = spec.highest.at(static_cast<std::size_t>(dialect));
    if (*number < 0 || *number > highest)
        return fail({.code = Errc::OutOfRange,
                     .subject = spec.name,
                     .lowest = 0,
                     .highest = highest,
                     .got = *number,
                     .detail = text});
    Bytes bytes(width);
    for (std::size_t i = 0; i < width; ++i)
        bytes[i] = static_cast<std::uint8_t>(*number >> 8 * i);
    return bytes;
}

std::string knownMessages() {
    std::string names;
    for (const MessageSpec& message : messages())
        names += (names.empty() ? "" : ", ") + std::string(message.name);
    return names;
}

const NamedText* findField(std::span<const NamedText> fields, std::string_view name) {
    const auto found = std::ranges::find(fields, name, &NamedText::first);
    return found == fields.end() ? nullptr : &*found;
}

Result<const MessageSpec*> messageOf(std::span<const NamedText> fields) {
    const NamedText* given = findField(fields, kMessageField);
    if (given == nullptr) return fail(Errc::BadArgument, kMessageField, "it is needed");
    for (const MessageSpec& message : messages()) {
        if (given->second == message.name) return &message;
    }
    return fail(Errc::UnknownName, given->second, knownMessages());
}

/// Whether every field that is given belongs to the message, and once.
Result<void> checkGiven(const MessageSpec& message, std::span<const NamedText> fields) {
    std::string known = kMessageField;
    for (const FieldSpec& spec : message.fields)
        known += std::string(", ") + spec.name;
    for (const NamedText& field : fields) {
        const bool exists =
            field.first == kMessageField || std::ranges::any_of(message.fields, [&](const FieldSpec& spec) {
                return field.first == spec.name;
            });
        if (!exists) return fail(Errc::UnknownName, field.first, known);
        if (std::ranges::count(fields, field.first, &NamedText::first) > 1)
            return fail(Errc::BadArgument, field.first, "it is given twice");
    }
    return {};
}

Bytes frameOf(Dialect dialect, ByteView message) {
    Bytes cobs(cobsMost(message.size()));
    cobs.resize(cobsEncode(message, cobs));
    Bytes frame;
    if (dialect == Dialect::Hibike) frame = {0, static_cast<std::uint8_t>(cobs.size())};
    frame.insert(frame.end(), cobs.begin(), cobs.end());
    if (dialect == Dialect::Current) frame.push_back(0);
    return frame;
}

}  // namespace

Result<std::vector<NamedField>> decodeNamedFrame(std::string_view frameName, ByteView bytes) {
    const auto dialect = dialectOf(frameName);
    if (!dialect) return noFrame(frameName);
    const auto message = messageIn(*dialect, bytes);
    if (!message) return fail(message.error());
    const MessageSpec& spec = *messageSpec(static_cast<MessageId>(message->front()));
    std::vector<NamedField> fields(1);
    fields[0].name = kMessageField;
    fields[0].value = message->front();
    fields[0].label = spec.name;
    fields[0].description = spec.summary;
    ByteView payload = ByteView(*message).subspan(kHeader, message->size() - kMessageOverhead);
    for (const FieldSpec& field : spec.fields) {
        const std::size_t width = field.kind == FieldKind::Values
                                      ? payload.size()
                                      : field.bytes.at(static_cast<std::size_t>(*dialect));
        fields.push_back(fieldOf(field, *dialect, payload.first(width)));
        payload = payload.subspan(width);
    }
    return fields;
}

Result<std::vector<std::uint8_t>> encodeNamedFrame(std::string_view frameName,
                                                   std::span<const NamedText> fields) {
    const auto dialect = dialectOf(frameName);
    if (!dialect) return noFrame(frameName);
    const auto spec = messageOf(fields);
    if (!spec) return fail(spec.error());
    if (auto right = checkGiven(**spec, fields); !right) return fail(std::move(right.error()));
    Bytes message{static_cast<std::uint8_t>((*spec)->id), 0};
    for (const FieldSpec& field : (*spec)->fields) {
        const NamedText* given = findField(fields, field.name);
        const std::size_t width = field.bytes.at(static_cast<std::size_t>(*dialect));
        auto bytes =
            given == nullptr ? Result<Bytes>(Bytes(width)) : bytesOfField(field, *dialect, given->second);
        if (!bytes) return fail(std::move(bytes.error()));
        message.insert(message.end(), bytes->begin(), bytes->end());
    }
    message[1] = static_cast<std::uint8_t>(message.size() - kHeader);
    message.push_back(checksum(message));
    return frameOf(*dialect, message);
}

std::vector<std::string> namedFrameFields() {
    std::vector<std::string> names{kMessageField};
    for (const MessageSpec& message : messages()) {
        for (const FieldSpec& field : message.fields) {
            if (std::ranges::find(names, field.name) == names.end()) names.emplace_back(field.name);
        }
    }
    return names;
}

}  // namespace kickstand::smartdevice::wire
