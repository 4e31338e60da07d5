#include <array>

#include "core/thunderbots/wire/feedback.h"
#include "core/thunderbots/wire/readings.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto block = decodeFeedback({data, size});
    if (!block) return 0;
    const auto bytes = encodeFeedback(*block);
    fuzz::require(bytes.has_value(), "what was read can be written");
    fuzz::require(*decodeFeedback(*bytes) == *block, "what was written reads as the same");
    fuzz::require((*bytes)[0] == (data[0] & 0x0F), "only reserved flags are left out");
    fuzz::require(fuzz::sameBytes(ByteView(*bytes).subspan(1), {data + 1, size - 1}), "readings are kept");
    fuzz::require(battery_adc(battery_V(block->battery_adc)) == block->battery_adc, "volts lead back");
    fuzz::require(capacitor_adc(capacitor_V(block->capacitor_adc)) == block->capacitor_adc,
                  "volts lead back");
    fuzz::require(thermistor_adc(dribbler_C(block->thermistor_adc)) == block->thermistor_adc,
                  "degrees lead back");
    return 0;
}
