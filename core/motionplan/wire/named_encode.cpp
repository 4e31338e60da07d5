#include <charconv>
#include <limits>

#include "core/base/hex.h"
#include "core/motionplan/wire/message.h"
#include "core/motionplan/wire/named.h"
#include "core/motionplan/wire/named_names.h"
#include "core/motionplan/wire/plan_text.h"
#include "core/motionplan/wire/telegram.h"

namespace kickstand::motionplan::wire {
namespace {

/// The fields that were given, each taken at most once.
class Given {
  public:
    explicit Given(std::span<const NamedText> fields) : fields_(fields) {}

    const std::string* find(std::string_view name) const {
        for (const NamedText& field : fields_) {
            if (field.first == name) return &field.second;
        }
        return nullptr;
    }
    /// A number within its range; `otherwise` where it was not given.
    Result<int> number(const char* name, int lowest, int highest, int otherwise,
                       std::span<const char* const> labels = {}) const {
        const std::string* const text = find(name);
        auto value = text == nullptr ? Result<int>(otherwise) : read(name, *text, labels);
        if (!value) return value;
        if (*value >= lowest && *value <= highest) return value;
        return fail(
            {.code = Errc::OutOfRange, .subject = name, .lowest = lowest, .highest = highest, .got = *value});
    }

  private:
    static Result<int> read(const char* name, const std::string& text, std::span<const char* const> labels) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            if (text == labels[i]) return static_cast<int>(i);
        }
        const bool hex = text.starts_with("0x") || text.starts_with("0X");
        const char* const begin = text.data() + (hex ? 2 : 0);
        const char* const end = text.data() + text.size();
        int value = 0;
        const auto [stop, error] = std::from_chars(begin, end, value, hex ? 16 : 10);
        if (error == std::errc::result_out_of_range)
            return text.starts_with('-') ? std::numeric_limits<int>::min() : std::numeric_limits<int>::max();
        if (error != std::errc{} || stop != end) return fail(Errc::BadArgument, name, text);
        return value;
    }

    std::span<const NamedText> fields_;
};

Result<std::vector<std::uint8_t>> readBytes(const Given& given, const char* name) {
    const std::string* const text = given.find(name);
    if (text == nullptr) return fail(Errc::BadArgument, name, "it is missing");
    auto bytes = parseHex(*text);
    if (!bytes) return fail(Errc::BadArgument, name, *text);
    return bytes;
}

/// Movements as hex or in words.
Result<std::vector<std::uint8_t>> readMovements(const Given& given, const char* name) {
    const std::string* const text = given.find(name);
    if (text == nullptr) return fail(Errc::BadArgument, name, "it is missing");
    if (auto bytes = parseHex(*text)) return bytes;
    const auto movements = parsePlanText(*text);
    if (!movements) return fail(movements.error());
    std::vector<std::uint8_t> bytes;
    for (const Movement& movement : *movements) {
        const auto byte = encodeMovement(movement);
        if (!byte) return fail(byte.error());
        bytes.push_back(*byte);
    }
    return bytes;
}

Result<std::vector<std::uint8_t>> finish(const Telegram& telegram) {
    const auto bytes = encodeTelegram(telegram);
    if (!bytes) return fail(bytes.error());
    return std::vector<std::uint8_t>(bytes->begin(), bytes->end());
}

Result<std::vector<std::uint8_t>> encodeWrite(const Given& given, int box, ByteView content) {
    const auto reply = given.number("reply", 0, 1, 0);
    if (!reply) return fail(reply.error());
    const auto chosen = given.number("box", 0, kMailboxes - 1, box);
    if (!chosen) return fail(chosen.error());
    MessageWrite write{*reply != 0, static_cast<std::uint8_t>(*chosen), {}};
    if (!write.content.append(content) || !write.content.append(std::uint8_t{0}))
        return fail({.code = Errc::OutOfRange,
                     .subject = "content",
                     .lowest = 0,
                     .highest = kMostMessageBytes,
                     .got = static_cast<std::int64_t>(content.size())});
    return finish(write);
}

Result<std::vector<std::uint8_t>> encodeMessageWrite(const MessageSpec& spec, const Given& given) {
    Message message;
    message.kind = spec.kind;
    for (const FieldSpec& field : spec.fields) {
        if (field.isBytes()) {
            auto movements = readMovements(given, field.name);
            if (!movements) return fail(movements.error());
            message.movements = std::move(*movements);
            continue;
        }
        const auto value = given.number(field.name, field.lowest, field.highest, 0, field.labels);
        if (!value) return fail(value.error());
        message.setValue(field.id, *value);
    }
    const auto bytes = encodeMessage(message);
    if (!bytes) return fail(bytes.error());
    // What a robot sends stands in its outboxes; written, it goes where a host writes.
    const int box = spec.box < kMailboxes ? spec.box : spec.box - kMailboxes;
    return encodeWrite(given, box, bytes->view());
}

Result<std::vector<std::uint8_t>> encodeRead(const Given& given) {
    const auto remote = given.number("remote-box", 0, kRemoteMailboxes - 1, kCommandOutbox);
    if (!remote) return fail(remote.error());
    const auto local = given.number("local-box", 0, kMailboxes - 1, 0);
    if (!local) return fail(local.error());
    const auto remove = given.number("remove", 0, 1, 0);
    if (!remove) return fail(remove.error());
    return finish(
        MessageRead{static_cast<std::uint8_t>(*remote), static_cast<std::uint8_t>(*local), *remove != 0});
}

Result<std::vector<std::uint8_t>> encodeWriteReply(const Given& given) {
    const auto status = given.number("status", 0, 255, 0);
    if (!status) return fail(status.error());
    return finish(WriteReply{static_cast<std::uint8_t>(*status)});
}

Result<std::vector<std::uint8_t>> encodeReadReply(const Given& given) {
    const auto status = given.number("status", 0, 255, 0);
    if (!status) return fail(status.error());
    const auto local = given.number("local-box", 0, kMailboxes - 1, 0);
    if (!local) return fail(local.error());
    ReadReply reply{static_cast<std::uint8_t>(*status), static_cast<std::uint8_t>(*local), {}};
    if (given.find("content") != nullptr) {
        const auto content = readBytes(given, "content");
        if (!content) return fail(content.error());
        if (!reply.content.append(*content))
            return fail({.code = Errc::OutOfRange,
                         .subject = "content",
                         .lowest = 0,
                         .highest = kMailboxBytes,
                         .got = static_cast<std::int64_t>(content->size())});
    }
    return finish(reply);
}

Result<void> checkFields(const NamedSpec& spec, std::span<const NamedText> fields) {
    std::string known;
    for (const std::string& name : spec.fields)
        known += (known.empty() ? "" : ", ") + name;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        bool found = false;
        for (const std::string& name : spec.fields)
            found = found || name == fields[i].first;
        if (!found) return fail(Errc::UnknownName, fields[i].first, known);
        for (std::size_t before = 0; before < i; ++before) {
            if (fields[before].first == fields[i].first)
                return fail(Errc::BadArgument, fields[i].first, "it is given twice");
        }
    }
    return {};
}

}  // namespace

Result<std::vector<std::uint8_t>> encodeNamed(std::string_view name, std::span<const NamedText> fields) {
    const NamedSpec* spec = nullptr;
    for (const NamedSpec& one : namedTelegrams()) {
        if (one.name == name) spec = &one;
    }
    if (spec == nullptr) return fail(Errc::UnknownName, std::string(name), knownTelegrams());
    if (auto checked = checkFields(*spec, fields); !checked) return fail(checked.error());
    const Given given(fields);
    if (name == kReadName) return encodeRead(given);
    if (name == kWriteReplyName) return encodeWriteReply(given);
    if (name == kReadReplyName) return encodeReadReply(given);
    if (name == kWriteName) {
        const auto content = readBytes(given, "content");
        if (!content) return fail(content.error());
        return encodeWrite(given, kCommandBox, *content);
    }
    for (const MessageSpec& message : messageSpecs()) {
        if (nameOf(message.kind) == name) return encodeMessageWrite(message, given);
    }
    return fail(Errc::UnknownName, std::string(name), knownTelegrams());
}

}  // namespace kickstand::motionplan::wire
