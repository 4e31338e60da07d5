#pragma once

#include <string>

#include "core/motionplan/wire/error_codes.h"

namespace kickstand::motionplan::wire {

// The names under which telegrams are decoded and encoded (named.h).
inline constexpr char kFamilyName[] = "motionplan.telegram";
inline constexpr char kWriteName[] = "motionplan.telegram.write";
inline constexpr char kReadName[] = "motionplan.telegram.read";
inline constexpr char kWriteReplyName[] = "motionplan.telegram.write-reply";
inline constexpr char kReadReplyName[] = "motionplan.telegram.read-reply";

/// Of a telegram that writes such a message. Any thread.
inline std::string nameOf(MessageKind kind) {
    return std::string(kFamilyName) + '.' + name(kind);
}
/// All names, parted by commas. Any thread.
std::string knownTelegrams();

}  // namespace kickstand::motionplan::wire
