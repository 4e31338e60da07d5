#include "core/motionplan/wire/error_codes.h"

#include <array>
#include <cstddef>

namespace kickstand::motionplan::wire {
namespace {

constexpr std::array<ErrorCode, kErrorCodes> kCodes{{
    {kErrorSlotFull, MessageKind::Create, "slot-full", "there is a plan in that slot already"},
    {kErrorUpdateOtherPlan, MessageKind::Update, "update-other-plan",
     "the plan in that slot has another ID, so it was not updated"},
    {kErrorUpdateEmptySlot, MessageKind::Update, "update-empty-slot",
     "there is no plan in that slot to be updated"},
    {kErrorUpdateIdle, MessageKind::Update, "update-idle", "no plan is executing, so none was updated"},
    {kErrorExecuteOtherPlan, MessageKind::Execute, "execute-other-plan",
     "the plan in that slot has another ID, so it was not executed"},
    {kErrorExecuteEmptySlot, MessageKind::Execute, "execute-empty-slot",
     "there is no plan in that slot to be executed"},
    {kErrorStopIdle, MessageKind::Stop, "stop-idle", "no plan was executing, so none was stopped"},
    {kErrorAdjustIdle, MessageKind::Adjust, "adjust-idle", "no plan is executing, so no speed was adjusted"},
}};

}  // namespace

const char* name(MessageKind kind) noexcept {
    constexpr std::array<const char*, kMessageKinds> kNames{"create", "stop",   "update", "execute", "status",
                                                            "query",  "adjust", "error",  "trigger"};
    const auto index = static_cast<std::size_t>(kind);
    return index < kNames.size() ? kNames[index] : "unknown";
}

std::span<const ErrorCode> errorCodes() noexcept {
    return kCodes;
}

ErrorCode errorCode(int code) noexcept {
    if (code >= 0 && code < kErrorCodes) return kCodes[static_cast<std::size_t>(code)];
    ErrorCode unknown;
    unknown.code = code;
    return unknown;
}

}  // namespace kickstand::motionplan::wire
