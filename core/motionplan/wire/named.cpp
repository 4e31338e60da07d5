#include "core/motionplan/wire/named.h"

#include "core/motionplan/wire/message.h"
#include "core/motionplan/wire/named_names.h"
#include "core/motionplan/wire/nxt_status.h"
#include "core/motionplan/wire/plan_text.h"
#include "core/motionplan/wire/telegram.h"

namespace kickstand::motionplan::wire {
namespace {

NamedField number(const char* fieldName, std::int64_t value, const char* description,
                  std::string label = {}) {
    NamedField field;
    field.name = fieldName;
    field.value = value;
    field.label = std::move(label);
    field.description = description;
    return field;
}

NamedField bytesField(const char* fieldName, ByteView bytes, const char* description,
                      std::string label = {}) {
    NamedField field = number(fieldName, static_cast<std::int64_t>(bytes.size()), description);
    field.isBytes = true;
    field.bytes.assign(bytes.begin(), bytes.end());
    field.label = std::move(label);
    return field;
}

std::string textOf(ByteView movementBytes) {
    std::vector<Movement> movements;
    for (const std::uint8_t byte : movementBytes) {
        if (const auto movement = decodeMovement(byte)) movements.push_back(*movement);
    }
    return toText(movements);
}

std::string labelOf(const FieldSpec& field, int value) {
    if (field.id == FieldId::Error) return errorCode(value).text;
    const auto index = static_cast<std::size_t>(value);
    return index < field.labels.size() ? field.labels[index] : "";
}

void listMessage(const Message& message, std::vector<NamedField>& fields) {
    fields.push_back(number("message", static_cast<int>(message.kind), specOf(message.kind).summary,
                            wire::name(message.kind)));
    for (const FieldSpec& spec : specOf(message.kind).fields) {
        if (spec.isBytes()) {
            fields.push_back(
                bytesField(spec.name, message.movements, spec.description, textOf(message.movements)));
            continue;
        }
        const int value = message.value(spec.id);
        NamedField field = number(spec.name, value, spec.description, labelOf(spec, value));
        field.unit = spec.unit;
        if (!field.unit.empty()) field.physical = value;
        fields.push_back(std::move(field));
    }
}

/// The message in a mailbox's content, or its bytes where it is none.
void listContent(ByteView content, std::vector<NamedField>& fields) {
    const ByteView bytes = withoutTerminator(content);
    if (const auto message = decodeMessage(bytes))
        listMessage(*message, fields);
    else
        fields.push_back(bytesField("content", bytes, "What the mailbox holds, without its terminator"));
}

std::vector<NamedField> list(const MessageWrite& write) {
    std::vector<NamedField> fields{number("reply", write.reply ? 1 : 0, "Whether a status is asked for"),
                                   number("box", write.box, "The robot's mailbox")};
    listContent(write.content.view(), fields);
    return fields;
}
std::vector<NamedField> list(const WriteReply& reply) {
    return {number("status", reply.status, "How the NXT took it", nxtStatus(reply.status).text)};
}
std::vector<NamedField> list(const MessageRead& read) {
    return {number("remote-box", read.remoteBox, "The mailbox to be read; 10 to 19 are the robot's out"),
            number("local-box", read.localBox, "Comes back in the reply"),
            number("remove", read.remove ? 1 : 0, "Whether what was read leaves the mailbox")};
}
std::vector<NamedField> list(const ReadReply& reply) {
    std::vector<NamedField> fields{
        number("status", reply.status, "How the NXT took it", nxtStatus(reply.status).text),
        number("local-box", reply.localBox, "As it was asked for")};
    if (!reply.content.empty()) listContent(reply.content.view(), fields);
    return fields;
}

std::string nameOf(const Telegram& telegram) {
    if (std::holds_alternative<MessageRead>(telegram)) return kReadName;
    if (std::holds_alternative<ReadReply>(telegram)) return kReadReplyName;
    if (std::holds_alternative<WriteReply>(telegram)) return kWriteReplyName;
    const auto& write = std::get<MessageWrite>(telegram);
    const auto message = decodeMessage(withoutTerminator(write.content.view()));
    return message ? nameOf(message->kind) : std::string(kWriteName);
}

std::vector<std::string> fieldNames(const MessageSpec& message) {
    std::vector<std::string> names{"reply", "box"};
    for (const FieldSpec& field : message.fields)
        names.emplace_back(field.name);
    return names;
}

std::vector<NamedSpec> makeSpecs() {
    std::vector<NamedSpec> specs;
    for (const MessageSpec& message : messageSpecs())
        specs.push_back({nameOf(message.kind), fieldNames(message)});
    specs.push_back({kWriteName, {"reply", "box", "content"}});
    specs.push_back({kReadName, {"remote-box", "local-box", "remove"}});
    specs.push_back({kWriteReplyName, {"status"}});
    specs.push_back({kReadReplyName, {"status", "local-box", "content"}});
    return specs;
}

}  // namespace

const std::vector<NamedSpec>& namedTelegrams() {
    static const std::vector<NamedSpec> kSpecs = makeSpecs();
    return kSpecs;
}

std::string knownTelegrams() {
    std::string names;
    for (const NamedSpec& spec : namedTelegrams())
        names += (names.empty() ? "" : ", ") + spec.name;
    return names;
}

Result<std::vector<NamedField>> decodeNamed(std::string_view name, ByteView bytes) {
    bool known = name == kFamilyName;
    for (const NamedSpec& spec : namedTelegrams())
        known = known || spec.name == name;
    if (!known) return fail(Errc::UnknownName, std::string(name), knownTelegrams());
    const auto telegram = decodeTelegram(bytes);
    if (!telegram) return fail(telegram.error());
    const std::string found = nameOf(*telegram);
    // A write of any content may be read as such, whatever message it carries.
    const bool same = name == kFamilyName || name == found ||
                      (name == kWriteName && std::holds_alternative<MessageWrite>(*telegram));
    if (!same) return fail(Errc::Malformed, std::string(name), "these bytes are " + found);
    return std::visit([](const auto& one) { return list(one); }, *telegram);
}

}  // namespace kickstand::motionplan::wire
