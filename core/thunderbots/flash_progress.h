#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/time.h"
#include "core/thunderbots/image/flash_image.h"
#include "core/thunderbots/wire/parameters.h"

namespace kickstand::thunderbots {

/// What an upload to one robot is doing, in this order; with two images it goes through it twice.
enum class FlashStage : std::uint8_t {
    Reading,     ///< Its operational parameters.
    Marking,     ///< As having no data in its flash, before anything in there changes.
    Surveying,   ///< What an earlier upload has left there that need not be sent again.
    Erasing,     ///< The whole flash.
    Writing,     ///< Page by page.
    Verifying,   ///< Block by block.
    Activating,  ///< Names the image that was verified in its parameters, and commits them.
    Rebooting,   ///< Waits until the robot is back; the microcontroller copies its image meanwhile.
    Confirming,  ///< Reads its parameters and signatures.
    Done,
    Failed,
    Cancelled,
};

/// In what state an upload leaves its robot, or would if it ended now.
enum class FlashLeft : std::uint8_t {
    Untouched,  ///< As it was before.
    NoData,     ///< It says that its flash has no data: it runs, and cannot drive before the next upload.
    Activated,  ///< What was verified has been named, or nothing: it takes effect at its next reboot.
    Rebooted,   ///< It was told to reboot with what was verified, and has not been heard to have done so.
    Complete,   ///< It runs what was sent.
};

/// A line of an upload's log. Text for people is made in core/engine/describe_flash.h.
enum class FlashNote : std::uint8_t {
    Began,     ///< a: signature of the image, b: pages to be sent.
    Contents,  ///< a: the flash contents that the robot named.
    MarkedNoData,
    Found,       ///< What is there already. a: pages that are missing, b: pages in all.
    FoundOther,  ///< Something that has to be erased. a: its address.
    Erasing,     ///< a: for which time.
    Erased,      ///< a: ms that took.
    Wrote,       ///< a: pages, b: ms that took.
    PageAgain,   ///< A page was not taken. a: its number, b: for which time it is sent.
    Verified,    ///< a: bytes, b: ms that took.
    Activated,   ///< a: the flash contents that it names now.
    RebootSent,
    Back,          ///< a: ms it was away.
    NotYetCopied,  ///< It is back, and has still to copy the image.
    Signatures,    ///< a: of the microcontroller, b: of the flash.
    Paused,
    Resumed,
    Ended,  ///< a: 0 done, otherwise the Errc.
};
struct FlashLogLine {
    TimePoint time{};
    FlashNote note = FlashNote::Began;
    std::int64_t a = 0;
    std::int64_t b = 0;
};
using FlashLog = std::vector<FlashLogLine>;

/// How an upload to one robot goes.
struct FlashProgress {
    std::size_t images = 1;                                ///< How many it has.
    std::size_t image = 0;                                 ///< Which of them it is about, from 0.
    image::FlashTarget target = image::FlashTarget::Fpga;  ///< Of that one.
    FlashStage stage = FlashStage::Reading;
    bool paused = false;  ///< By STOP, until a person resumes it.
    FlashLeft left = FlashLeft::Untouched;
    std::optional<Error> error;       ///< Why it failed.
    std::uint32_t done_B = 0;         ///< Of this stage: bytes written or verified.
    std::uint32_t total_B = 0;        ///< Of this stage; 0 where bytes are not what it is about.
    double rate_Bps = 0;              ///< Of this stage.
    Duration remaining{};             ///< Until the end of the whole, as far as it can be foreseen.
    int attempt = 1;                  ///< Of what it does now.
    int erases = 0;                   ///< How often it was erased.
    std::uint32_t pagesSent = 0;      ///< Of all images, repetitions too.
    image::ImageSignatures expected;  ///< Of the image it is about.
    std::optional<wire::OperationalParameters> parametersBefore;  ///< As they were at its beginning.
    TimePoint beganAt{};
    TimePoint endedAt{};
    std::shared_ptr<const FlashLog> log = std::make_shared<const FlashLog>();

    bool running() const { return stage < FlashStage::Done; }
};

/// "reading", "marking", …; "untouched", …: stable names for JSON. Any thread.
std::string_view name(FlashStage stage);
std::string_view name(FlashLeft left);
std::string_view name(FlashNote note);

}  // namespace kickstand::thunderbots
