#include "core/motionplan/plan.h"

#include <utility>

#include "core/motionplan/wire/message.h"
#include "core/motionplan/wire/plan_text.h"

namespace kickstand::motionplan {

std::string alternativeTo(const Movement& movement) {
    if (wire::encodeMovement(movement)) return {};
    const auto sum = wire::exactSum(movement.wheels, movement.amount, wire::kMostMovements);
    if (sum) return wire::toText(*sum);
    const Error& error = sum.error();
    if (error.code != Errc::NoEncoding) return {};
    // The neighbours may have no code of their own either: 93 degrees are 90 and 3.
    std::string nearest;
    for (const std::int64_t amount : {*error.lowest, *error.highest}) {
        const auto there = wire::exactSum(movement.wheels, static_cast<int>(amount), wire::kMostMovements);
        if (there && wire::toText(*there) != nearest)
            nearest += (nearest.empty() ? "" : " or ") + wire::toText(*there);
    }
    return nearest;
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

Result<SentPlan> sentPlan(bool update, int plan, int slot, std::span<const Movement> movements) {
    auto bytes = planBytes(movements, PlanUse::Slot);
    if (!bytes) return fail(bytes.error());
    wire::Message message;
    message.kind = update ? wire::MessageKind::Update : wire::MessageKind::Create;
    message.plan = plan;
    message.slot = slot;
    message.movements = std::move(*bytes);
    const auto encoded = wire::encodeMessage(message);
    if (!encoded) return fail(encoded.error());
    const ByteView sent = encoded->view();
    return SentPlan{{sent.begin(), sent.end()}, wire::zeroBytes(sent)};
}

std::vector<Movement> movementsOf(std::span<const std::uint8_t> bytes) {
    std::vector<Movement> movements;
    for (const std::uint8_t byte : bytes) {
        if (const auto movement = wire::decodeMovement(byte)) movements.push_back(*movement);
    }
    return movements;
}

}  // namespace kickstand::motionplan
