// Plans as people write them, or as whatever a file holds.
#include "core/motionplan/wire/plan_text.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::motionplan::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(data, data + size);
    const auto movements = parsePlanText(text);
    if (!movements) {
        fuzz::require(!movements.error().subject.empty(), "an error says what it is about");
        return 0;
    }
    const auto again = parsePlanText(toText(*movements));
    fuzz::require(again && *again == *movements, "what was read comes back through its text");
    for (const Movement& movement : *movements) {
        const auto byte = encodeMovement(movement);
        if (byte) fuzz::require(decodeMovement(*byte) == movement, "what has a code comes back");
    }
    return 0;
}
