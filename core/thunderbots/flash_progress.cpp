#include "core/thunderbots/flash_progress.h"

namespace kickstand::thunderbots {

std::string_view name(FlashStage stage) {
    switch (stage) {
        case FlashStage::Reading:
            return "reading";
        case FlashStage::Marking:
            return "marking";
        case FlashStage::Surveying:
            return "surveying";
        case FlashStage::Erasing:
            return "erasing";
        case FlashStage::Writing:
            return "writing";
        case FlashStage::Verifying:
            return "verifying";
        case FlashStage::Activating:
            return "activating";
        case FlashStage::Rebooting:
            return "rebooting";
        case FlashStage::Confirming:
            return "confirming";
        case FlashStage::Done:
            return "done";
        case FlashStage::Failed:
            return "failed";
        case FlashStage::Cancelled:
            return "cancelled";
    }
    return "unknown";
}

std::string_view name(FlashLeft left) {
    switch (left) {
        case FlashLeft::Untouched:
            return "untouched";
        case FlashLeft::NoData:
            return "no-data";
        case FlashLeft::Activated:
            return "activated";
        case FlashLeft::Rebooted:
            return "rebooted";
        case FlashLeft::Complete:
            return "complete";
    }
    return "unknown";
}

std::string_view name(FlashNote note) {
    switch (note) {
        case FlashNote::Began:
            return "began";
        case FlashNote::Contents:
            return "contents";
        case FlashNote::MarkedNoData:
            return "marked-no-data";
        case FlashNote::Found:
            return "found";
        case FlashNote::FoundOther:
            return "found-other";
        case FlashNote::Erasing:
            return "erasing";
        case FlashNote::Erased:
            return "erased";
        case FlashNote::Wrote:
            return "wrote";
        case FlashNote::PageAgain:
            return "page-again";
        case FlashNote::Verified:
            return "verified";
        case FlashNote::Activated:
            return "activated";
        case FlashNote::RebootSent:
            return "reboot-sent";
        case FlashNote::Back:
            return "back";
        case FlashNote::NotYetCopied:
            return "not-yet-copied";
        case FlashNote::Signatures:
            return "signatures";
        case FlashNote::Paused:
            return "paused";
        case FlashNote::Resumed:
            return "resumed";
        case FlashNote::Ended:
            return "ended";
    }
    return "unknown";
}

}  // namespace kickstand::thunderbots
