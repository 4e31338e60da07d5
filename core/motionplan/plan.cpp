#include "core/motionplan/plan.h"

#include "core/motionplan/wire/plan_text.h"

namespace kickstand::motionplan {

std::string alternativeTo(const Movement& movement) {
    if (wire::encodeMovement(movement)) return {};
    const auto sum = wire::exactSum(movement.wheels, movement.amount, wire::kMostMovements);
    if (sum) return wire::toText(*sum);
    const Error& error = sum.error();
    if (error.code != Errc::NoEncoding) return {};
    const auto nearest = [&movement](std::int64_t amount) {
        return wire::toText({movement.wheels, static_cast<int>(amount)});
    };
    const std::string above = nearest(*error.highest);
    return *error.lowest < movement.amount ? nearest(*error.lowest) + " or " + above : above;
}

Result<std::vector<std::uint8_t>> planBytes(std::span<const Movement> movements, PlanUse use) {
    const auto count = static_cast<std::int64_t>(movements.size());
    if (count < 1 || count > mostMovements(use))
        return fail({.code = Errc::OutOfRange,
                     .subject = "number of movements",
                     .lowest = 1,
                     .highest = mostMovements(use),
                     .got = count});
    std::vector<std::uint8_t> bytes;
    bytes.reserve(movements.size());
    for (const Movement& movement : movements) {
        const auto byte = wire::encodeMovement(movement);
        if (!byte)
            return fail({.code = Errc::NoMovementCode,
                         .subject = wire::toText(movement),
                         .got = static_cast<std::int64_t>(bytes.size()),
                         .detail = alternativeTo(movement)});
        bytes.push_back(*byte);
    }
    return bytes;
}

std::vector<Movement> movementsOf(std::span<const std::uint8_t> bytes) {
    std::vector<Movement> movements;
    for (const std::uint8_t byte : bytes) {
        if (const auto movement = wire::decodeMovement(byte)) movements.push_back(*movement);
    }
    return movements;
}

}  // namespace kickstand::motionplan
