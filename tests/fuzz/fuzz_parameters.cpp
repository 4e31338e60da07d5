#include "core/thunderbots/wire/parameters.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    const auto parameters = decodeParameters(input);
    if (!parameters) return 0;
    const ParameterBytes bytes = encodeParameters(*parameters);
    fuzz::require(fuzz::sameBytes(bytes.view(), input), "a block is written back as it was read");
    const auto verdict = checkParameters(*parameters);
    fuzz::require(verdict || verdict.error().fault == WireFault::OutOfRange, "only ranges are checked");
    return 0;
}
