#include <cstring>

#include "core/thunderbots/wire/kick_timing.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::wire;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    KickPulses asked;
    if (size != sizeof asked) return 0;
    std::memcpy(&asked, data, sizeof asked);
    const auto encoding = encodePulses(asked);
    if (!encoding) {
        fuzz::require(encoding.error().solenoid == 1 || encoding.error().solenoid == 2,
                      "a solenoid is named");
        fuzz::require(!toError(encoding.error()).subject.empty(), "and told to the outside");
        return 0;
    }
    fuzz::require(encodeKick(encoding->times).has_value(), "what was encoded fits the message");
    fuzz::require(personTermsOf(encoding->times) == encoding->sent, "what is reported is what is sent");
    fuzz::require(encoding->snapped == (encoding->sent != asked), "every change is reported");
    const auto again = encodePulses(encoding->sent);
    fuzz::require(again && again->times == encoding->times, "what was snapped stays where it is");
    return 0;
}
