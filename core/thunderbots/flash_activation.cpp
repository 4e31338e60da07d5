// The last part of an upload: from an image that was verified to a robot that runs it.

#include <algorithm>
#include <utility>

#include "core/thunderbots/flash_uploader.h"

namespace kickstand::thunderbots {
namespace {

using Response = wire::FirmwareResponse;

/// By then a robot that was told to reboot has gone, and is not back yet.
constexpr Duration kGone = std::chrono::seconds(1);
/// How often a microcontroller that is back is asked whether it has copied its image.
constexpr Duration kLookAgain = std::chrono::seconds(1);
/// Reboot, copy, reboot and being found again take some fifteen (protocol 6.8).
constexpr Duration kReturnLimit = std::chrono::seconds(60);

}  // namespace

void FlashUploader::activate() {
    setStage(FlashStage::Activating);
    // An erase has loaded the parameters afresh: what was read before it may not hold any more.
    ask(wire::ReadParametersRequest{}, &FlashUploader::freshParametersRead);
}

void FlashUploader::freshParametersRead(const Response& response) {
    parameters_ = std::get<wire::ReadParametersResponse>(response).parameters;
    change(&FlashUploader::nameContents);
}

void FlashUploader::nameContents() {
    if (!mayDo(&FlashUploader::nameContents)) return;
    // From here to the commit nothing stops it for long: a robot whose volatile copy alone names the image
    // looks like one that has it, and boots without it.
    naming_ = true;
    parameters_.flashContents = static_cast<std::uint8_t>(plan().contents());
    ask(wire::SetParametersRequest{parameters_}, &FlashUploader::contentsSet);
}

void FlashUploader::contentsSet(const Response&) {
    ask(wire::ReadParametersRequest{}, &FlashUploader::contentsReadBack);
}

void FlashUploader::contentsReadBack(const Response& response) {
    if (std::get<wire::ReadParametersResponse>(response).parameters != parameters_)
        return failed({.code = Errc::NotVerified, .subject = "parameters"});
    progress_.left = FlashLeft::Activated;
    ask(wire::CommitParametersRequest{}, &FlashUploader::contentsCommitted);
}

void FlashUploader::contentsCommitted(const Response&) {
    naming_ = false;
    note(FlashNote::Activated, parameters_.flashContents);
    if (cancelled_) return failed({.code = Errc::Cancelled});
    change(&FlashUploader::reboot);
}

void FlashUploader::reboot() {
    if (!mayDo(&FlashUploader::reboot)) return;
    setStage(FlashStage::Rebooting);
    progress_.left = FlashLeft::Rebooted;
    away_ = false;
    note(FlashNote::RebootSent);
    askAtRest(wire::RebootRequest{}, &FlashUploader::reboot, &FlashUploader::rebooting,
              &FlashUploader::rebootUnanswered);
}

void FlashUploader::rebootUnanswered(const Error& error) {
    progress_.left = FlashLeft::Activated;
    failed(error);
}

void FlashUploader::rebooting(const Response&) {
    // What is in the page buffer does not outlive it.
    buffer_.reset();
    awaitLoss();
}

void FlashUploader::awaitLoss() {
    // A robot that is found again at once is never reported as lost: the dongle tells its status every 25 ms
    // (protocol 3.2). One that is rebooting leaves a request unanswered.
    unansweredBefore_ = around_.requests.state(robot_).unanswered;
    if (!away_) waitFor(kGone, &FlashUploader::probe);
}

void FlashUploader::probe() {
    ask(wire::ReadParametersRequest{}, &FlashUploader::probeAnswered);
}

void FlashUploader::probeAnswered(const Response& response) {
    if (around_.requests.state(robot_).unanswered == unansweredBefore_) {
        progress_.left = FlashLeft::Activated;
        return failed({.code = Errc::Unanswered, .subject = wire::name(wire::FirmwareOp::Reboot)});
    }
    note(FlashNote::Back, stage_ms());
    progress_.stage = FlashStage::Confirming;
    finalContentsRead(response);
}

void FlashUploader::neverCameBack() {
    Error why{.code = Errc::RobotNotAlive};
    why.robot = robot_;
    end(FlashStage::Failed, std::move(why));
}

bool FlashUploader::withTheRobot(Errc why) const {
    return why == Errc::RobotNotAlive || (why == Errc::Disconnected && around_.onCable());
}

void FlashUploader::lost(Errc why) {
    if (!running()) return;
    if (!expectsLoss() || !withTheRobot(why)) return failed({.code = why});
    awaitReturn();
    around_.changed();
}

void FlashUploader::awaitReturn() {
    away_ = true;
    progress_.stage = FlashStage::Rebooting;
    // Counted from the reboot on, however often it comes and goes.
    const Duration left = kReturnLimit - (around_.scheduler.now() - stageAt_);
    waitFor(std::max(left, Duration::zero()), &FlashUploader::neverCameBack);
}

void FlashUploader::found() {
    if (!expectsLoss() || !away_) return;
    away_ = false;
    around_.scheduler.cancel(std::exchange(timer_, 0));
    note(FlashNote::Back, stage_ms());
    confirm();
}

void FlashUploader::confirm() {
    progress_.stage = FlashStage::Confirming;
    ask(wire::ReadParametersRequest{}, &FlashUploader::finalContentsRead);
}

void FlashUploader::finalContentsRead(const Response& response) {
    const auto contents = std::get<wire::ReadParametersResponse>(response).parameters.flash();
    const bool copies = plan().target() == image::FlashTarget::Microcontroller;
    if (copies && contents == wire::FlashContents::Microcontroller) {
        note(FlashNote::NotYetCopied);
        if (around_.scheduler.now() - stageAt_ >= kReturnLimit) return neverCameBack();
        return waitFor(kLookAgain, &FlashUploader::confirm);
    }
    const auto expected = copies ? wire::FlashContents::NoData : plan().contents();
    if (contents != expected) return failed({.code = Errc::NotVerified, .subject = "parameters"});
    ask(wire::ReadSignaturesRequest{}, &FlashUploader::signaturesRead);
}

void FlashUploader::signaturesRead(const Response& response) {
    const auto& read = std::get<wire::ReadSignaturesResponse>(response);
    note(FlashNote::Signatures, read.microcontrollerCrc, read.flashCrc);
    const image::ImageSignatures& wanted = plan().signatures();
    const bool copied = plan().target() == image::FlashTarget::Microcontroller;
    const bool right =
        copied ? read.microcontrollerCrc == wanted.microcontroller : read.flashCrc == wanted.flash;
    if (!right) {
        Error error{.code = Errc::WrongSignature};
        error.got = copied ? read.microcontrollerCrc : read.flashCrc;
        error.highest = copied ? wanted.microcontroller : wanted.flash;
        return failed(error);
    }
    progress_.left = FlashLeft::Complete;
    if (progress_.image + 1 == plans_.size()) return end(FlashStage::Done, std::nullopt);
    ++progress_.image;
    beginImage();
}

}  // namespace kickstand::thunderbots
