#include "core/thunderbots/wire/generic_names.h"

#include <string_view>

namespace kickstand::thunderbots::wire {
namespace {

void appendWord(std::string& text, std::string_view word) {
    if (!text.empty()) text += ' ';
    text += word;
}

}  // namespace

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
