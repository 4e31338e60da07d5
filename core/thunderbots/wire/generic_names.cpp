#include "core/thunderbots/wire/generic_names.h"

#include <algorithm>

namespace kickstand::thunderbots::wire {
namespace {

void appendWord(std::string& text, std::string_view word) {
    if (!text.empty()) text += ' ';
    text += word;
}

}  // namespace

bool isFamily(std::string_view name) noexcept {
    return findMessage(name) == nullptr &&
           std::any_of(messages().begin(), messages().end(), [name](const MessageSpec& message) {
               const std::string_view full = message.name;
               return full.size() > name.size() && full.starts_with(name) && full[name.size()] == '.' &&
                      !message.fields.empty() && message.fields.front().kind == FieldKind::Opcode;
           });
}

std::string knownMessageNames() {
    std::string names;
    for (const MessageSpec& message : messages())
        appendWord(names, message.name);
    return names;
}

std::string knownFieldNames(const MessageSpec& message) {
    std::string names;
    for (const FieldSpec& field : message.fields) {
        if (field.kind != FieldKind::Reserved) appendWord(names, field.name);
    }
    return names;
}

}  // namespace kickstand::thunderbots::wire
