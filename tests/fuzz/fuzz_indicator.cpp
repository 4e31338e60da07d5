#include "core/thunderbots/wire/indicator.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::requireEcho({data, size}, decodeIndicator, encodeIndicator);
    return 0;
}
