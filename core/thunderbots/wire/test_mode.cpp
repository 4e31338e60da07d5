#include "core/thunderbots/wire/test_mode.h"

#include <algorithm>

#include "core/thunderbots/wire/layout_robot.h"

namespace kickstand::thunderbots::wire {
namespace at = layout::test_mode;
namespace {

std::optional<WireError> targetFault(WireFault kind, TestClass testClass, std::uint8_t target) noexcept {
    const TestTargets targets = targetsOf(testClass);
    if (!targets.any() || (target >= targets.first && target <= targets.last)) return std::nullopt;
    return WireError{kind, at::kTarget.name, targets.first, targets.last, target};
}

}  // namespace

const char* name(TestClass testClass) noexcept {
    const auto number = static_cast<std::size_t>(testClass);
    return number < at::kClassNames.size() ? at::kClassNames[number] : "undefined";
}

std::optional<TestClass> testClassFromName(std::string_view name) noexcept {
    const auto* const found = std::find(at::kClassNames.begin(), at::kClassNames.end(), name);
    if (found == at::kClassNames.end()) return std::nullopt;
    return static_cast<TestClass>(found - at::kClassNames.begin());
}

WireResult<std::array<std::uint8_t, kTestModeBytes>> encodeTestMode(const TestMode& mode) noexcept {
    std::array<std::uint8_t, kTestModeBytes> bytes{};
    FieldWriter<BitOrder::LsbFirst> out(bytes);
    out.number(at::kClass, static_cast<std::int32_t>(mode.testClass));
    out.number(at::kTarget, mode.target);
    if (const auto error = targetFault(WireFault::OutOfRange, mode.testClass, mode.target)) {
        return tl::unexpected(*error);
    }
    return out.result(bytes);
}

WireResult<TestMode> decodeTestMode(ByteView payload) noexcept {
    if (const auto error = lengthFault(payload.size(), kTestModeBytes, kTestModeBytes)) {
        return tl::unexpected(*error);
    }
    FieldReader<BitOrder::LsbFirst> in(payload);
    TestMode mode;
    mode.testClass = static_cast<TestClass>(in.byte(at::kClass));
    mode.target = in.byte(at::kTarget);
    if (const auto error = targetFault(WireFault::BadValue, mode.testClass, mode.target)) {
        return tl::unexpected(*error);
    }
    return in.result(mode);
}

}  // namespace kickstand::thunderbots::wire
