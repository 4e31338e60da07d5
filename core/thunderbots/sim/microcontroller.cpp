#include "core/thunderbots/sim/microcontroller.h"

#include "core/framing/crc16.h"

namespace kickstand::thunderbots::sim {
namespace {

// The program of the factory fills this much with a pattern; blank memory follows.
constexpr std::size_t kFactoryProgramBytes = 0x9C00;

std::uint16_t factorySignature() {
    std::uint16_t sum = kCrc16Initial;
    for (std::size_t i = 0; i < kFactoryProgramBytes; ++i) {
        const auto byte = static_cast<std::uint8_t>(i * 31 + (i >> 8));
        sum = crc16(ByteView{&byte, 1}, sum);
    }
    return crc16Fill(0xFF, Microcontroller::kSignedBytes - kFactoryProgramBytes, sum);
}

}  // namespace

void Microcontroller::commitNoData() {
    reload();
    shadow_.flashContents = static_cast<std::uint8_t>(wire::FlashContents::NoData);
    commit();
}

std::uint16_t Microcontroller::signature() const {
    return program_.empty() ? factorySignature() : crc16(program_);
}

void Microcontroller::copyProgram(const FlashChip& flash) {
    program_.resize(kSignedBytes);
    flash.read(0, program_);
}

}  // namespace kickstand::thunderbots::sim
