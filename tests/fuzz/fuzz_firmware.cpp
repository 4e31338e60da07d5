#include "core/thunderbots/wire/firmware.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    fuzz::requireEcho(input, decodeFirmwareResponse, encodeFirmwareResponse);
    const auto request = decodeFirmwareRequest(input);
    if (!request) return 0;
    const auto* const set = std::get_if<SetParametersRequest>(&*request);
    if (set != nullptr && !checkParameters(set->parameters)) {
        fuzz::require(!encodeFirmwareRequest(*request), "parameters no robot can live with are not written");
        return 0;
    }
    fuzz::requireEcho(input, decodeFirmwareRequest, encodeFirmwareRequest);
    return 0;
}
