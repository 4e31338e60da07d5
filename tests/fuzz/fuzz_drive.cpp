#include <array>

#include "core/thunderbots/wire/drive.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    const auto block = decodeDrive(input);
    if (!block) return 0;
    const auto bytes = encodeDrive(*block);
    fuzz::require(bytes.has_value(), "what was read can be written");
    fuzz::require(*decodeDrive(*bytes) == *block, "what was written reads as the same");
    fuzz::require(hasReservedDriveBits(input) != fuzz::sameBytes(*bytes, input),
                  "bytes differ in reserved bits only");
    return 0;
}
