#include <array>
#include <vector>

#include "core/framing/cobs.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const ByteView input{data, size};
    // Written, it holds no zero and reads as the same.
    std::vector<std::uint8_t> encoding(cobsMost(size));
    encoding.resize(cobsEncode(input, encoding));
    fuzz::require(std::find(encoding.begin(), encoding.end(), 0) == encoding.end(), "no zero is left");
    std::vector<std::uint8_t> back(encoding.size());
    const auto length = cobsDecode(encoding, back);
    fuzz::require(length && fuzz::sameBytes(ByteView(back).first(*length), input), "it comes back");
    // Read as it is, it stays within its room.
    std::vector<std::uint8_t> read(size);
    if (const auto taken = cobsDecode(input, read)) fuzz::require(*taken <= size, "no more than there was");
    return 0;
}
