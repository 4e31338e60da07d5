#include <algorithm>

#include "core/thunderbots/wire/faults.h"
#include "core/thunderbots/wire/field_codec.h"
#include "core/thunderbots/wire/generic.h"
#include "core/thunderbots/wire/generic_names.h"

namespace kickstand::thunderbots::wire {
namespace {

std::string labelOf(const FieldSpec& field, std::int32_t value) {
    if (field.kind == FieldKind::FaultCode) return describe(dongleFault(static_cast<std::uint8_t>(value)));
    const auto index = static_cast<std::size_t>(value);
    return index < field.labels.size() ? field.labels[index] : "";
}

DecodedField decodeBytes(const FieldSpec& field, ByteView bytes) {
    DecodedField decoded;
    decoded.name = field.name;
    decoded.isBytes = true;
    decoded.bytes.assign(bytes.begin(), bytes.end());
    decoded.value = static_cast<std::int64_t>(bytes.size());
    decoded.description = field.description;
    return decoded;
}

DecodedField decodeNumber(const FieldSpec& field, std::int32_t value) {
    DecodedField decoded;
    decoded.name = field.name;
    decoded.value = value;
    decoded.unit = field.scale.unit;
    if (!decoded.unit.empty()) decoded.physical = field.scale.factor * value + field.scale.offset;
    decoded.label = labelOf(field, value);
    decoded.description = field.description;
    return decoded;
}

Result<std::vector<DecodedField>> decodeOne(const MessageSpec& message, ByteView bytes) {
    if (const auto error = lengthFault(bytes.size(), message.minBytes, message.maxBytes)) {
        return fail(toError(*error, message.name));
    }
    if (const auto verdict = message.mayBeRead(bytes); !verdict)
        return fail(toError(verdict.error(), message.name));

    std::vector<DecodedField> decoded;
    for (const FieldSpec& field : message.fields) {
        if (field.kind == FieldKind::Bytes) {
            decoded.push_back(decodeBytes(field, bytes.subspan(field.firstBit / 8U)));
            continue;
        }
        const std::int32_t value = readField(message, field, bytes);
        if (field.kind != FieldKind::Reserved || value != 0) decoded.push_back(decodeNumber(field, value));
    }
    return decoded;
}

/// How many of `rest` the next message of a list takes.
std::size_t lengthOfNext(const MessageSpec& message, ByteView rest) {
    const bool counted = message.fields.front().kind == FieldKind::Length;
    return std::min<std::size_t>(counted ? rest[0] : message.maxBytes, rest.size());
}

Result<std::vector<DecodedField>> decodeList(const MessageSpec& message, ByteView bytes) {
    if (const auto error = lengthFault(bytes.size(), 0, message.maxListBytes)) {
        return fail(toError(*error, message.name));
    }
    std::vector<DecodedField> all;
    for (int number = 1; !bytes.empty(); ++number) {
        const std::size_t length = lengthOfNext(message, bytes);
        auto decoded = decodeOne(message, bytes.first(length));
        const std::string prefix = std::to_string(number) + '.';
        if (!decoded) {
            decoded.error().detail += ", in message " + std::to_string(number) + " of the list";
            return decoded;
        }
        for (DecodedField& field : *decoded) {
            field.name.insert(0, prefix);
            all.push_back(std::move(field));
        }
        bytes = bytes.subspan(length);
    }
    return all;
}

}  // namespace

Result<std::vector<DecodedField>> decodeMessage(std::string_view name, ByteView bytes) {
    const MessageSpec* const message = findMessageFor(name, bytes);
    if (message == nullptr) {
        if (!isFamily(name)) return fail(Errc::UnknownName, std::string(name), knownMessageNames());
        if (bytes.empty()) return fail(toError({WireFault::TooShort, "length", 1, 64, 0}, std::string(name)));
        return fail(toError({WireFault::UnknownKind, "opcode", 0, 9, bytes[0]}, std::string(name)));
    }
    return message->maxListBytes != 0 ? decodeList(*message, bytes) : decodeOne(*message, bytes);
}

}  // namespace kickstand::thunderbots::wire
