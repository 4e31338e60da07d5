#include "tests/unit/image/image_files.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

namespace kickstand::thunderbots::image::testing {

Bytes readData(const std::string& name) {
    std::ifstream in(KICKSTAND_IMAGE_DATA "/" + name, std::ios::binary);
    EXPECT_TRUE(in.good()) << name;
    return {std::istreambuf_iterator<char>(in), {}};
}

ImageResult<FlashImage> imageOf(const std::string& name) {
    return readImage(name, readData(name));
}

Bytes bytesOf(const std::string& text) {
    return {text.begin(), text.end()};
}

std::string hexRecord(int type, unsigned offset, const Bytes& data) {
    std::string text = ":";
    unsigned sum = 0;
    const auto put = [&text, &sum](unsigned byte) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02X", byte & 0xFFU);
        text += digits;
        sum += byte;
    };
    put(static_cast<unsigned>(data.size()));
    put(offset >> 8 & 0xFFU);
    put(offset & 0xFFU);
    put(static_cast<unsigned>(type));
    for (const std::uint8_t byte : data)
        put(byte);
    put(0x100U - (sum & 0xFFU));
    return text;
}

std::string hexOf(const FlashImage& image, std::size_t size) {
    std::string text;
    unsigned base = 0;
    for (const DataRange& range : image.data) {
        for (std::uint32_t at = range.begin; at < range.end;) {
            if (at >> 16 != base) {
                base = at >> 16;
                text += hexRecord(
                            4, 0,
                            {static_cast<std::uint8_t>(base >> 8), static_cast<std::uint8_t>(base & 0xFFU)}) +
                        "\n";
            }
            const auto next = static_cast<std::uint32_t>(
                std::min<std::size_t>({at + size, range.end, (at / 0x10000 + 1) * 0x10000}));
            text += hexRecord(0, at & 0xFFFFU, Bytes(image.bytes.begin() + at, image.bytes.begin() + next)) +
                    "\n";
            at = next;
        }
    }
    return text + hexRecord(1, 0, {}) + "\n";
}

}  // namespace kickstand::thunderbots::image::testing
