#include "core/coach/wire/named_frame.h"

#include <algorithm>
#include <charconv>

#include "core/coach/wire/velocity.h"
#include "core/framing/xbee_parser.h"

namespace kickstand::coach::wire {
namespace {

constexpr const char* kOutcomes[] = {"success", "no-acknowledgement", "channel-busy", "purged"};

// The headers of the three kinds of frames; firstBit counts in the frame data, from its type on.
constexpr FieldSpec kTx[] = {
    {"frame_id", FieldKind::Unsigned, 8, 8, 0, 255, "", "What its TX status is known by; 0 asks for none"},
    {"destination", FieldKind::Address, 16, 16, 0, 0xFFFF, "", "The radio that it is for; 0xFFFF is all"},
    {"options", FieldKind::Unsigned, 32, 8, 0, 255, "", "1 asks for no acknowledgement by radio"}};
constexpr FieldSpec kRx[] = {{"source", FieldKind::Address, 8, 16, 0, 0xFFFF, "", "The radio that sent it"},
                             {"rssi", FieldKind::Rssi, 24, 8, -255, 0, "dBm", "How strongly it was received"},
                             {"options", FieldKind::Unsigned, 32, 8, 0, 255, "", "2: it was sent to all"}};
constexpr FieldSpec kStatus[] = {
    {"frame_id", FieldKind::Unsigned, 8, 8, 0, 255, "", "The packet that it is about"},
    {"status", FieldKind::Unsigned, 16, 8, 0, 3, "", "What became of it", kOutcomes}};

struct KindSpec {
    const char* name;
    xbee::FrameType type;
    std::span<const FieldSpec> header;
    bool hasMessage;
    std::size_t headerBytes;
};
constexpr KindSpec kKinds[] = {{"tx", xbee::FrameType::Tx16, kTx, true, 5},
                               {"rx", xbee::FrameType::Rx16, kRx, true, 5},
                               {"tx-status", xbee::FrameType::TxStatus, kStatus, false, 3}};

using Fields = std::vector<std::pair<std::string, std::string>>;

Result<xbee::ApiMode> modeOf(std::string_view name) {
    if (name == kFrameName) return xbee::ApiMode::Plain;
    if (name == kEscapedFrameName) return xbee::ApiMode::Escaped;
    return fail(Errc::UnknownName, std::string(name),
                std::string(kFrameName) + ", " + std::string(kEscapedFrameName));
}

const KindSpec* kindOf(std::uint8_t type) {
    for (const KindSpec& kind : kKinds) {
        if (static_cast<std::uint8_t>(kind.type) == type) return &kind;
    }
    return nullptr;
}

NamedField named(const FieldSpec& spec, std::int32_t value) {
    NamedField field;
    field.name = spec.name;
    field.value = value;
    field.unit = spec.unit;
    field.description = spec.description;
    if (spec.kind == FieldKind::Level) field.physical = percentOf(value);
    if (!field.unit.empty() && !field.physical) field.physical = value;
    if (value >= 0 && static_cast<std::size_t>(value) < spec.labels.size())
        field.label = spec.labels[static_cast<std::size_t>(value)];
    return field;
}

tl::unexpected<Error> malformed(const char* subject, std::int64_t lowest, std::int64_t highest,
                                std::int64_t got) {
    Error error;
    error.code = Errc::Malformed;
    error.subject = subject;
    error.lowest = lowest;
    error.highest = highest;
    error.got = got;
    return tl::unexpected(std::move(error));
}

/// The data of the one frame that `bytes` are.
Result<ByteView> soleFrame(xbee::Parser& parser, ByteView bytes) {
    ByteView rest = bytes;
    const ByteView data = parser.next(rest);
    if (!data.empty() && rest.empty() && parser.counters().skipped == 0) return data;
    if (bytes.empty() || bytes[0] != xbee::kDelimiter)
        return malformed("delimiter", xbee::kDelimiter, xbee::kDelimiter, bytes.empty() ? 0 : bytes[0]);
    if (bytes.size() > 2 && parser.counters().badLength > 0)
        return malformed("length", 1, xbee::kMaxFrameData, loadBe16(bytes, 1));
    if (parser.counters().badChecksum > 0 && bytes.size() > 4) {
        const std::uint8_t right = xbee::checksum(bytes.subspan(3, bytes.size() - 4));
        return malformed("checksum", right, right, bytes.back());
    }
    return fail(Errc::Malformed, "frame", rest.empty() ? "it ends too early" : "more follows it");
}

void appendMessage(std::vector<NamedField>& fields, const Message& message) {
    const MessageSpec& spec = specOf(message.opcode);
    NamedField opcode;
    opcode.name = "message";
    opcode.value = static_cast<std::int64_t>(message.opcode);
    opcode.label = spec.name;
    opcode.description = spec.summary;
    fields.push_back(std::move(opcode));
    NamedField parameter;
    parameter.name = "parameter";
    parameter.value = message.parameter;
    parameter.description = "The parameter byte as it stands";
    fields.push_back(std::move(parameter));
    for (const FieldSpec& field : spec.fields)
        fields.push_back(named(field, readField(field, ByteView{&message.parameter, 1})));
}

const std::string* textOf(const Fields& fields, std::string_view name) {
    for (const auto& [field, text] : fields) {
        if (field == name) return &text;
    }
    return nullptr;
}

/// A decimal or 0x number, or one of the field's labels.
Result<std::int32_t> valueOf(const FieldSpec& spec, const std::string& text) {
    for (std::size_t i = 0; i < spec.labels.size(); ++i) {
        if (text == spec.labels[i]) return static_cast<std::int32_t>(i);
    }
    const bool hex = text.starts_with("0x") || text.starts_with("0X");
    const char* begin = text.data() + (hex ? 2 : 0);
    const char* end = text.data() + text.size();
    std::int32_t value = 0;
    const auto [at, error] = std::from_chars(begin, end, value, hex ? 16 : 10);
    if (error != std::errc() || at != end) return fail(Errc::BadArgument, spec.name, text);
    if (value < spec.lowest || value > spec.highest) {
        Error range;
        range.code = Errc::OutOfRange;
        range.subject = spec.name;
        range.lowest = spec.lowest;
        range.highest = spec.highest;
        range.got = value;
        return fail(std::move(range));
    }
    return value;
}

Result<void> writeFields(std::span<const FieldSpec> specs, const Fields& fields, ByteSpan bytes) {
    for (const FieldSpec& spec : specs) {
        const std::string* text = textOf(fields, spec.name);
        if (text == nullptr) continue;
        const auto value = valueOf(spec, *text);
        if (!value) return fail(value.error());
        writeField(spec, bytes, *value);
    }
    return {};
}

bool has(std::span<const FieldSpec> specs, std::string_view name) {
    return std::any_of(specs.begin(), specs.end(), [&](const FieldSpec& spec) { return name == spec.name; });
}

Result<void> checkNames(const Fields& fields, const KindSpec& kind, const MessageSpec* message) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const std::string& name = fields[i].first;
        const bool ofMessage =
            message != nullptr && (name == "message" || name == "parameter" || has(message->fields, name));
        if (name != "kind" && !ofMessage && !has(kind.header, name)) {
            std::string known = "kind";
            for (const FieldSpec& spec : kind.header)
                known += std::string(", ") + spec.name;
            if (message != nullptr) known += ", message, parameter";
            for (const FieldSpec& spec : message != nullptr ? message->fields : kind.header.first(0))
                known += std::string(", ") + spec.name;
            return fail(Errc::UnknownName, name, std::move(known));
        }
        for (std::size_t j = 0; j < i; ++j) {
            if (fields[j].first == name) return fail(Errc::BadArgument, name, fields[i].second);
        }
    }
    return {};
}

Result<const KindSpec*> kindNamed(const Fields& fields) {
    const std::string* text = textOf(fields, "kind");
    if (text == nullptr) return &kKinds[0];
    std::string known;
    for (const KindSpec& kind : kKinds) {
        if (*text == kind.name) return &kind;
        known += (known.empty() ? "" : ", ") + std::string(kind.name);
    }
    return fail(Errc::UnknownName, *text, std::move(known));
}

Result<const MessageSpec*> messageNamed(const Fields& fields) {
    const std::string* text = textOf(fields, "message");
    if (text == nullptr) return fail(Errc::BadArgument, "message", "");
    if (const MessageSpec* message = findMessage(std::string_view(*text))) return message;
    std::string known;
    for (const MessageSpec& message : messages())
        known += (known.empty() ? "" : ", ") + std::string(message.name);
    return fail(Errc::UnknownName, *text, std::move(known));
}

/// The two bytes of the message that the fields name.
Result<std::array<std::uint8_t, kMessageBytes>> messageBytes(const MessageSpec& message,
                                                             const Fields& fields) {
    static constexpr FieldSpec kParameter{"parameter", FieldKind::Unsigned, 0, 8, 0, 255, "", ""};
    auto bytes = encodeMessage({message.opcode, 0});
    const ByteSpan parameter = ByteSpan(bytes).subspan(1);
    if (auto written = writeFields({&kParameter, 1}, fields, parameter); !written)
        return fail(written.error());
    if (auto written = writeFields(message.fields, fields, parameter); !written) return fail(written.error());
    return bytes;
}

}  // namespace

Result<std::vector<NamedField>> decodeNamedFrame(std::string_view name, ByteView bytes) {
    const auto mode = modeOf(name);
    if (!mode) return fail(mode.error());
    xbee::Parser parser(*mode);
    const auto data = soleFrame(parser, bytes);
    if (!data) return fail(data.error());
    const KindSpec* kind = kindOf((*data)[0]);
    if (kind == nullptr) return fail(Errc::Malformed, "kind", "it is none of tx, rx, tx-status");
    const std::size_t size = kind->headerBytes + (kind->hasMessage ? kMessageBytes : 0);
    const auto wanted = static_cast<std::int64_t>(size);
    if (data->size() != size)
        return malformed("length", wanted, wanted, static_cast<std::int64_t>(data->size()));
    std::vector<NamedField> fields;
    fields.push_back({"kind", (*data)[0], kind->name, {}, "", "What the frame is"});
    for (const FieldSpec& spec : kind->header)
        fields.push_back(named(spec, readField(spec, *data)));
    if (!kind->hasMessage) return fields;
    const auto message = decodeMessage(data->subspan(kind->headerBytes));
    if (!message)
        return fail(Errc::Malformed, "message", "there is no such message, or not with this parameter");
    appendMessage(fields, *message);
    return fields;
}

Result<std::vector<std::uint8_t>> encodeNamedFrame(std::string_view name, const Fields& fields) {
    const auto mode = modeOf(name);
    if (!mode) return fail(mode.error());
    const auto kind = kindNamed(fields);
    if (!kind) return fail(kind.error());
    const MessageSpec* message = nullptr;
    if ((*kind)->hasMessage) {
        const auto named = messageNamed(fields);
        if (!named) return fail(named.error());
        message = *named;
    }
    if (auto right = checkNames(fields, **kind, message); !right) return fail(right.error());
    xbee::FrameData data;
    data.resize((*kind)->headerBytes);
    data.span()[0] = static_cast<std::uint8_t>((*kind)->type);
    if (message != nullptr && message->broadcast && (*kind)->type == xbee::FrameType::Tx16)
        storeBe16(data.span(), 2, xbee::kBroadcast);
    if (auto written = writeFields((*kind)->header, fields, data.span()); !written)
        return fail(written.error());
    if (message != nullptr) {
        const auto bytes = messageBytes(*message, fields);
        if (!bytes) return fail(bytes.error());
        data.append(*bytes);
    }
    const xbee::LineFrame line = xbee::wrapFrame(data.view(), *mode);
    return std::vector<std::uint8_t>(line.begin(), line.end());
}

std::vector<std::string> namedFrameFields() {
    std::vector<std::string> names{"kind"};
    const auto add = [&names](std::string_view name) {
        if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
    };
    for (const KindSpec& kind : kKinds) {
        for (const FieldSpec& field : kind.header)
            add(field.name);
    }
    add("message");
    add("parameter");
    for (const MessageSpec& message : messages()) {
        for (const FieldSpec& field : message.fields)
            add(field.name);
    }
    return names;
}

}  // namespace kickstand::coach::wire
