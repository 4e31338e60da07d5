#include <string>
#include <utility>
#include <vector>

#include "core/coach/wire/named_frame.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::coach::wire;

/// What is taken apart by name goes together again by the same names.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    for (const std::string_view name : {kFrameName, kEscapedFrameName}) {
        const auto fields = decodeNamedFrame(name, input);
        if (!fields) continue;
        std::vector<std::pair<std::string, std::string>> texts;
        for (const NamedField& field : *fields) {
            const bool word = field.name == "kind" || field.name == "message";
            texts.emplace_back(field.name, word ? field.label : std::to_string(field.value));
        }
        const auto bytes = encodeNamedFrame(name, texts);
        fuzz::require(bytes.has_value(), "what was read can be written");
        const auto again = decodeNamedFrame(name, *bytes);
        fuzz::require(again.has_value() && again->size() == fields->size(), "and reads as the same");
        for (std::size_t i = 0; i < fields->size(); ++i) {
            // Minus zero is written as zero, which the raw parameter shows.
            if ((*fields)[i].name == "parameter") continue;
            fuzz::require((*again)[i].value == (*fields)[i].value, "field by field");
        }
    }
    return 0;
}
