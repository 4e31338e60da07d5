#include "core/thunderbots/sim/flash_chip.h"

#include <algorithm>

#include "core/framing/crc16.h"

namespace kickstand::thunderbots::sim {

void FlashChip::erase() {
    for (auto& sector : sectors_)
        sector.reset();
}

void FlashChip::program(std::size_t page, const Page& data) {
    const bool changesNothing =
        std::all_of(data.begin(), data.end(), [](std::uint8_t byte) { return byte == kBlank; });
    if (changesNothing) return;
    const std::size_t address = page * data.size();
    std::unique_ptr<Sector>& sector = sectors_[address / kSectorBytes];
    if (!sector) {
        sector = std::make_unique<Sector>();
        sector->fill(kBlank);
    }
    for (std::size_t i = 0; i < data.size(); ++i)
        (*sector)[address % kSectorBytes + i] &= data[i];
}

bool FlashChip::blank() const {
    return std::all_of(sectors_.begin(), sectors_.end(), [](const auto& sector) { return !sector; });
}

template <class Visit>
void FlashChip::visitPieces(std::uint32_t address, std::size_t length, Visit visit) const {
    while (length > 0) {
        const std::size_t offset = address % kSectorBytes;
        const std::size_t piece = std::min(length, kSectorBytes - offset);
        visit(sectors_[address / kSectorBytes].get(), offset, piece);
        address += static_cast<std::uint32_t>(piece);
        length -= piece;
    }
}

void FlashChip::read(std::uint32_t address, ByteSpan into) const {
    auto place = into.begin();
    visitPieces(address, into.size(), [&](const Sector* sector, std::size_t offset, std::size_t piece) {
        if (sector) {
            place = std::copy_n(sector->begin() + static_cast<std::ptrdiff_t>(offset), piece, place);
        } else {
            place = std::fill_n(place, piece, kBlank);
        }
    });
}

std::uint16_t FlashChip::crc(std::uint32_t address, std::uint32_t length) const {
    std::uint16_t sum = kCrc16Initial;
    visitPieces(address, length, [&](const Sector* sector, std::size_t offset, std::size_t piece) {
        sum = sector ? crc16(ByteView(*sector).subspan(offset, piece), sum) : crc16Fill(kBlank, piece, sum);
    });
    return sum;
}

}  // namespace kickstand::thunderbots::sim
