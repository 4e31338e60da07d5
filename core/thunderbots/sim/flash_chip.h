#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/bytes.h"
#include "core/thunderbots/wire/firmware.h"

namespace kickstand::thunderbots::sim {

/// The robot's SPI flash: 2 MiB of NOR cells (protocol 6.7). Programming can only clear bits; erasing sets
/// them all. Only what is not blank takes memory.
class FlashChip {
  public:
    using Page = std::array<std::uint8_t, wire::kFlashPageBytes>;

    FlashChip() : sectors_(kSectors) {}

    /// Sets every bit.
    void erase();
    /// Clears the bits that `data` has clear. `page` is below wire::kFlashPageCount.
    void program(std::size_t page, const Page& data);
    /// Whether nothing was programmed since the last erase.
    bool blank() const;
    /// Copies what begins at `address` into `into`; the two must lie within the chip.
    void read(std::uint32_t address, ByteSpan into) const;
    /// The CRC-16 of `length` bytes from `address`, which must lie within the chip.
    std::uint16_t crc(std::uint32_t address, std::uint32_t length) const;

  private:
    static constexpr std::size_t kSectorBytes = 4096;
    static constexpr std::size_t kSectors = wire::kFlashBytes / kSectorBytes;
    static constexpr std::uint8_t kBlank = 0xFF;
    using Sector = std::array<std::uint8_t, kSectorBytes>;

    /// Calls `visit` with each piece of the range: its sector (null where blank), offset there, and length.
    template <class Visit>
    void visitPieces(std::uint32_t address, std::size_t length, Visit visit) const;

    std::vector<std::unique_ptr<Sector>> sectors_;
};

}  // namespace kickstand::thunderbots::sim
