#include "core/thunderbots/wire/drive.h"

#include "core/thunderbots/wire/layout_drive.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::drive;

WireResult<std::array<std::uint8_t, kDriveBytes>> encodeDrive(const DriveBlock& block) noexcept {
    std::array<std::uint8_t, kDriveBytes> bytes{};
    FieldWriter<BitOrder::MsbFirst> out(bytes);
    out.number(at::kRun, block.run);
    out.number(at::kCharge, block.charge);
    out.number(at::kDribble, block.dribble);
    out.number(at::kMask1, block.autokick.flag1);
    out.number(at::kMask2, block.autokick.flag2);
    out.number(at::kArmed, block.autokickArmed);
    for (std::size_t i = 0; i < kWheelCount; ++i)
        out.number(at::kWheels[i], block.wheels[i]);
    out.number(at::kTestClass, block.testClass);
    out.number(at::kTestTarget, block.testTarget);
    out.number(at::kT1, block.autokick.t1);
    out.number(at::kT2, block.autokick.t2);
    out.number(at::kDt, block.autokick.dt);
    return out.result(bytes);
}

WireResult<DriveBlock> decodeDrive(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kDriveBytes, kDriveBytes))
        return tl::unexpected(*error);
    FieldReader<BitOrder::MsbFirst> in(payload);
    DriveBlock block;
    block.run = in.flag(at::kRun);
    block.charge = in.flag(at::kCharge);
    block.dribble = in.flag(at::kDribble);
    block.autokick.flag1 = in.flag(at::kMask1);
    block.autokick.flag2 = in.flag(at::kMask2);
    block.autokickArmed = in.flag(at::kArmed);
    const auto speed = [&in](const FieldSpec& field) { return static_cast<std::int16_t>(in.number(field)); };
    block.wheels = {speed(at::kWheels[0]), speed(at::kWheels[1]), speed(at::kWheels[2]),
                    speed(at::kWheels[3])};
    block.testClass = in.byte(at::kTestClass);
    block.testTarget = in.byte(at::kTestTarget);
    block.autokick.t1 = in.byte(at::kT1);
    block.autokick.t2 = in.byte(at::kT2);
    block.autokick.dt = in.byte(at::kDt);
    return in.result(block);
}

bool hasReservedDriveBits(ByteView payload) noexcept {
    if (payload.size() != kDriveBytes) return false;
    FieldReader<BitOrder::MsbFirst> in(payload);
    return in.number(at::kReserved) != 0 || in.number(at::kLastBit) != 0;
}

}  // namespace kickstand::thunderbots::wire
