#pragma once

#include <cstdint>
#include <optional>

/// The messages of the ME218C protocol (2009), as bytes and back.
namespace kickstand::coach::wire {

/// A team's number, 0-255: the low byte of both its radios' addresses (coach protocol 3).
using Team = std::uint8_t;

/// Which side a radio is on.
enum class Role : std::uint8_t {
    Coach,  ///< The console from which a boat is steered.
    Towrp,  ///< The boat.
};

/// The 16-bit address of a team's radio (coach protocol 3). Any thread.
constexpr std::uint16_t addressOf(Role role, Team team) noexcept {
    return static_cast<std::uint16_t>((role == Role::Coach ? 0xBC00 : 0xAF00) | team);
}

/// Which side an address is on; nothing where it is neither's. Any thread.
constexpr std::optional<Role> roleOf(std::uint16_t address) noexcept {
    if (address >> 8 == 0xBC) return Role::Coach;
    if (address >> 8 == 0xAF) return Role::Towrp;
    return std::nullopt;
}

/// The team in an address. Any thread.
constexpr Team teamOf(std::uint16_t address) noexcept {
    return static_cast<Team>(address & 0xFF);
}

}  // namespace kickstand::coach::wire
