#include "core/motionplan/wire/nxt_status.h"

namespace kickstand::motionplan::wire {
namespace {

constexpr NxtStatus kStatuses[] = {
    {kStatusSuccess, "success", "done"},
    {kStatusPending, "pending", "an earlier transaction is still in progress"},
    {kStatusMailboxEmpty, "mailbox-empty", "the mailbox is empty"},
    {0xBD, "failed", "the request failed, as when a file is not there"},
    {kStatusUnknownCommand, "unknown-command", "the command is not known to it"},
    {0xBF, "insane-packet", "the telegram made no sense to it"},
    {0xC0, "out-of-range", "a value was out of range"},
    {0xDD, "bus-error", "its bus reports an error"},
    {0xDE, "no-buffer", "it has no room for the message"},
    {0xDF, "bad-channel", "the connection is not valid"},
    {0xE0, "busy-channel", "the connection is not set up, or busy"},
    {kStatusNoProgram, "no-program", "no program is running on it"},
    {kStatusBadSize, "bad-size", "the size is not legal"},
    {kStatusBadMailbox, "bad-mailbox", "there is no such mailbox"},
    {0xEF, "bad-field", "an invalid field was accessed"},
    {0xF0, "bad-port", "there is no such input or output"},
    {0xFB, "no-memory", "its memory does not suffice"},
    {0xFF, "bad-arguments", "the arguments are bad"},
};

}  // namespace

std::span<const NxtStatus> nxtStatuses() noexcept {
    return kStatuses;
}

NxtStatus nxtStatus(std::uint8_t code) noexcept {
    for (const NxtStatus& status : kStatuses) {
        if (status.code == code) return status;
    }
    NxtStatus unknown;
    unknown.code = code;
    return unknown;
}

}  // namespace kickstand::motionplan::wire
