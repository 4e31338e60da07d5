#include "core/link/paced/byte_faults.h"

namespace kickstand {
namespace {

constexpr std::uint32_t kByteValues = 256;
constexpr std::uint32_t kBits = 8;

}  // namespace

bool ByteFaults::happens(double probability) {
    return probability > 0 &&
           static_cast<double>(random_()) < probability * static_cast<double>(std::mt19937::max());
}

std::vector<std::uint8_t> ByteFaults::pass(ByteView bytes) {
    if (!options_.any()) return {bytes.begin(), bytes.end()};
    std::vector<std::uint8_t> passed;
    passed.reserve(bytes.size());
    for (std::uint8_t byte : bytes) {
        if (happens(options_.insert)) passed.push_back(static_cast<std::uint8_t>(random_() % kByteValues));
        if (happens(options_.lose)) continue;
        if (happens(options_.damage)) byte = static_cast<std::uint8_t>(byte ^ 1U << random_() % kBits);
        passed.push_back(byte);
    }
    return passed;
}

}  // namespace kickstand
