#include "core/framing/crc16.h"

#include <array>
#include <cstddef>

namespace kickstand {
namespace {

constexpr std::uint16_t kReflectedPolynomial = 0x8408;

constexpr std::array<std::uint16_t, 256> makeTable() {
    std::array<std::uint16_t, 256> table{};
    for (std::size_t byte = 0; byte < table.size(); ++byte) {
        auto crc = static_cast<std::uint16_t>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            crc = static_cast<std::uint16_t>((crc & 1) != 0 ? crc >> 1 ^ kReflectedPolynomial : crc >> 1);
        }
        table[byte] = crc;
    }
    return table;
}
constexpr std::array<std::uint16_t, 256> kTable = makeTable();

constexpr std::uint16_t step(std::uint16_t crc, std::uint8_t byte) {
    return static_cast<std::uint16_t>(crc >> 8 ^ kTable[(crc ^ byte) & 0xFF]);
}

}  // namespace

std::uint16_t crc16(ByteView bytes, std::uint16_t soFar) noexcept {
    for (const std::uint8_t byte : bytes)
        soFar = step(soFar, byte);
    return soFar;
}

std::uint16_t crc16Fill(std::uint8_t byte, std::size_t count, std::uint16_t soFar) noexcept {
    for (std::size_t i = 0; i < count; ++i)
        soFar = step(soFar, byte);
    return soFar;
}

}  // namespace kickstand
