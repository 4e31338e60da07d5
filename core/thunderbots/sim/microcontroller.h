#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/thunderbots/sim/flash_chip.h"
#include "core/thunderbots/wire/parameters.h"

namespace kickstand::thunderbots::sim {

/// What lives in the microcontroller's own flash: the program and the operational parameters, beside the
/// parameters' volatile shadow (protocol 4.8, 6.7).
class Microcontroller {
  public:
    /// The part of the program memory that is copied from the SPI flash and signed.
    static constexpr std::size_t kSignedBytes = 0x1F000;

    explicit Microcontroller(const wire::OperationalParameters& committed)
        : committed_(committed), shadow_(committed) {}

    const wire::OperationalParameters& committed() const { return committed_; }
    const wire::OperationalParameters& shadow() const { return shadow_; }
    /// Writes the shadow.
    void setShadow(const wire::OperationalParameters& parameters) { shadow_ = parameters; }
    /// Keeps the shadow over reboots.
    void commit() { committed_ = shadow_; }
    /// Loads the shadow afresh: what was not committed is lost.
    void reload() { shadow_ = committed_; }
    /// Marks the SPI flash as empty, for good; uncommitted changes of the shadow are lost.
    void commitNoData();

    /// The CRC-16 of the program. It only changes with an image that is copied, which a reboot follows.
    std::uint16_t signature() const;
    /// Copies the program from the SPI flash. The parameters lie above it and stay.
    void copyProgram(const FlashChip& flash);

  private:
    wire::OperationalParameters committed_;
    wire::OperationalParameters shadow_;
    /// Empty: the program it was delivered with.
    std::vector<std::uint8_t> program_;
};

}  // namespace kickstand::thunderbots::sim
