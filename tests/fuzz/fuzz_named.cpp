// The codecs by name, which read whatever a person types: the first byte chooses the message, a byte with its
// highest bit set the message's family.
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/hex.h"
#include "core/thunderbots/wire/fields.h"
#include "core/thunderbots/wire/generic.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

namespace {

std::vector<FieldText> textOf(const std::vector<DecodedField>& decoded) {
    std::vector<FieldText> fields;
    fields.reserve(decoded.size());
    for (const DecodedField& field : decoded) {
        fields.emplace_back(field.name, field.isBytes ? toHex(field.bytes) : std::to_string(field.value));
    }
    return fields;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const MessageSpec& message = messages()[(data[0] & 0x7F) % messages().size()];
    std::string_view name = message.name;
    if ((data[0] & 0x80) != 0) name = name.substr(0, name.rfind('.'));
    const ByteView input{data + 1, size - 1};

    const auto decoded = decodeMessage(name, input);
    if (!decoded) {
        fuzz::require(!decoded.error().subject.empty(), "an error says what it is about");
    } else if (const MessageSpec* const found = findMessageFor(name, input)) {
        const auto encoded = encodeMessage(found->name, textOf(*decoded));
        fuzz::require(!encoded || *encoded == std::vector<std::uint8_t>(input.begin(), input.end()),
                      "what was read is written the same");
    }

    const std::string text(input.begin(), input.end());
    for (const FieldSpec& field : message.fields) {
        const std::vector<FieldText> given{{field.name, text}, {text, "1"}};
        static_cast<void>(encodeMessage(message.name, std::span(given).first(1)));
        static_cast<void>(encodeMessage(message.name, std::span(given).subspan(1)));
    }
    return 0;
}
