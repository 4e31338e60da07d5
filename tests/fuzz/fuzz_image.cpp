#include <algorithm>

#include "core/thunderbots/image/image_file.h"
#include "tests/fuzz/fuzz.h"

using namespace kickstand;
using namespace kickstand::thunderbots::image;

namespace {

void requireSound(const FlashImage& image) {
    fuzz::require(!image.data.empty(), "an image has data");
    std::uint32_t before = 0;
    for (const DataRange& range : image.data) {
        fuzz::require(range.begin < range.end, "a range has bytes");
        fuzz::require(range.begin == image.data.front().begin || range.begin > before,
                      "ranges ascend and do not touch");
        const auto gap = image.bytes.begin() + static_cast<std::ptrdiff_t>(before);
        const auto own = image.bytes.begin() + static_cast<std::ptrdiff_t>(range.begin);
        fuzz::require(std::all_of(gap, own, [](std::uint8_t byte) { return byte == kErased; }),
                      "gaps are erased");
        before = range.end;
    }
    fuzz::require(image.bytes.size() == before && before <= kFlashBytes, "the bytes end with the data");
}

std::uint64_t total(const FlashImage& image) {
    std::uint64_t sum = image.dataBytes();
    for (const DataRange& range : image.skipped)
        sum += range.size();
    return sum;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    for (const char* name : {"file", "file.hex", "file.bit", "file.bin"}) {
        const auto image = readImage(name, {data, size});
        if (!image) continue;
        requireSound(*image);
        for (const FlashTarget target : {FlashTarget::Microcontroller, FlashTarget::Fpga}) {
            const auto settled = forTarget(*image, target);
            if (!settled) continue;
            requireSound(*settled);
            fuzz::require(total(*settled) == total(*image), "what is not taken is listed");
        }
    }
    return 0;
}
