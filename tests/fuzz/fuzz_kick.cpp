#include <array>

#include "core/thunderbots/wire/kick_timing.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto times = decodeKick({data, size});
    if (!times) return 0;
    const auto bytes = encodeKick(*times);
    fuzz::require(bytes.has_value(), "what was read can be written");
    fuzz::require(*decodeKick(*bytes) == *times, "what was written reads as the same");
    const KickPulses terms = personTermsOf(*times);
    const auto encoding = encodePulses(terms);
    fuzz::require(encoding.has_value(), "every kick of the wire has a person's terms that encode");
    fuzz::require(encoding->sent == terms && !encoding->snapped, "and they encode exactly");
    return 0;
}
