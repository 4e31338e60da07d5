#include <array>

#include "core/thunderbots/wire/dongle.h"
#include "core/thunderbots/wire/faults.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    fuzz::requireEcho(input, decodeChannels, encodeChannels);
    if (const auto status = decodeStatus(input)) {
        fuzz::require(fuzz::sameBytes(encodeStatus(*status), input), "a status comes back");
        fuzz::require(*name(status->eStop) != '\0' && *name(status->radios) != '\0', "states have names");
    }
    if (const auto versions = decodeRadioVersions(input)) {
        fuzz::require(fuzz::sameBytes(encodeRadioVersions(*versions), input), "versions come back");
    }
    for (const std::uint8_t code : input) {
        fuzz::require(dongleFault(code).known == (code < kDongleFaultCount), "every code is known or is not");
        fuzz::require(!describe(robotFault(code)).empty(), "every code has a text");
    }
    return 0;
}
