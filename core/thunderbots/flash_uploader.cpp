#include "core/thunderbots/flash_uploader.h"

#include <algorithm>
#include <utility>

#include "core/framing/crc16.h"
#include "core/thunderbots/flash_estimate.h"

namespace kickstand::thunderbots {
namespace {

using Response = wire::FirmwareResponse;

/// A page that is not taken so often in a row is not taken at all.
constexpr int kPageAttempts = 5;
constexpr int kMostErases = 3;
/// How long somebody else's request to the robot is waited for: as long as reading signatures may take.
constexpr Duration kCollisionPause = std::chrono::milliseconds(20);
constexpr int kMostCollisions = 500;
/// How long a cancel waits for the robot to commit what its volatile copy names already.
constexpr Duration kNamingLimit = std::chrono::milliseconds(800);
/// How often pages that turn out to be missing are sent after all.
constexpr int kMostRounds = 3;

const wire::OperationalParameters& parametersOf(const Response& response) {
    return std::get<wire::ReadParametersResponse>(response).parameters;
}

}  // namespace

FlashUploader::FlashUploader(int robot, std::vector<SharedFlashPlan> plans,
                             const FlashSurroundings& surroundings)
    : robot_(robot), plans_(std::move(plans)), around_(surroundings) {
    progress_.images = plans_.size();
}

FlashUploader::~FlashUploader() {
    around_.scheduler.cancel(timer_);
}

void FlashUploader::start() {
    progress_.beganAt = around_.scheduler.now();
    beginImage();
}

// ---- Before anything changes ----

void FlashUploader::beginImage() {
    progress_.target = plan().target();
    progress_.expected = plan().signatures();
    progress_.erases = 0;
    rounds_ = 0;
    const bool fpga = plan().target() == image::FlashTarget::Fpga;
    note(FlashNote::Began, fpga ? progress_.expected.flash : progress_.expected.microcontroller,
         static_cast<std::int64_t>(plan().pages().size()));
    setStage(FlashStage::Reading);
    ask(wire::ReadParametersRequest{}, &FlashUploader::contentsRead);
}

void FlashUploader::contentsRead(const Response& response) {
    parameters_ = parametersOf(response);
    if (!progress_.parametersBefore) progress_.parametersBefore = parameters_;
    note(FlashNote::Contents, parameters_.flashContents);
    // Naming the contents commits the whole block: a number or channels that somebody has only applied would
    // come true at a reboot, and lose the robot.
    const wire::Channels kept{parameters_.channel0, parameters_.channel1};
    if (parameters_.robotNumber != robot_ || around_.channels().value_or(kept) != kept)
        return failed({.code = Errc::RebootNeeded});
    // Reading shows the volatile copy alone: that it has no data may be what the robot would forget at its
    // next reboot, so it is made to hold in any case (protocol 4.8). What a broken upload has written is
    // still there.
    resumes_ = parameters_.flash() == wire::FlashContents::NoData;
    change(&FlashUploader::markNoData);
}

void FlashUploader::markNoData() {
    setStage(FlashStage::Marking);
    if (!mayDo(&FlashUploader::markNoData)) return;
    parameters_.flashContents = static_cast<std::uint8_t>(wire::FlashContents::NoData);
    ask(wire::SetParametersRequest{parameters_}, &FlashUploader::noDataSet);
}

void FlashUploader::noDataSet(const Response&) {
    progress_.left = FlashLeft::NoData;
    ask(wire::CommitParametersRequest{}, &FlashUploader::noDataMarked);
}

void FlashUploader::noDataMarked(const Response&) {
    note(FlashNote::MarkedNoData);
    if (resumes_) return survey(FlashStage::Surveying, wire::kFlashBytes);
    change(&FlashUploader::erase);
}

// ---- What is there ----

void FlashUploader::survey(FlashStage stage, std::uint32_t end) {
    setStage(stage, end);
    survey_.emplace(plan(), end);
    surveyNext();
}

void FlashUploader::surveyNext() {
    const auto range = survey_->next();
    if (!range) return surveyed();
    ask(wire::BlockCrcRequest{range->address, range->length}, &FlashUploader::blockAnswered);
}

void FlashUploader::blockAnswered(const Response& response) {
    survey_->answered(std::get<wire::BlockCrcResponse>(response).crc);
    progress_.done_B = survey_->known_B();
    showRate();
    surveyNext();
}

void FlashUploader::surveyed() {
    if (const auto& dirtyAt = survey_->dirtyAt()) {
        note(FlashNote::FoundOther, *dirtyAt);
        if (progress_.erases < kMostErases) return change(&FlashUploader::erase);
        return failed({.code = Errc::NotVerified, .got = *dirtyAt});
    }
    const auto& missing = survey_->missing();
    if (progress_.stage == FlashStage::Verifying && missing.empty()) return verified();
    note(FlashNote::Found, static_cast<std::int64_t>(missing.size()),
         static_cast<std::int64_t>(plan().pages().size()));
    write(missing);
}

void FlashUploader::verified() {
    note(FlashNote::Verified, plan().extent(), stage_ms());
    activate();
}

// ---- Erase and write ----

void FlashUploader::erase() {
    setStage(FlashStage::Erasing);
    if (!mayDo(&FlashUploader::erase)) return;
    progress_.attempt = ++progress_.erases;
    progress_.left = FlashLeft::NoData;
    note(FlashNote::Erasing, progress_.erases);
    begin([this] {
        return around_.requests.askOnce(
            robot_, wire::EraseChipRequest{},
            done(&FlashUploader::erased, &FlashUploader::eraseUnanswered, &FlashUploader::erase),
            [this] { return around_.mayChange(robot_); });
    });
}

void FlashUploader::erased(const Response&) {
    note(FlashNote::Erased, stage_ms());
    write(plan().pages());
}

void FlashUploader::eraseUnanswered(const Error&) {
    // It may have been done all the same, which is quicker to find out than to do.
    survey(FlashStage::Surveying, wire::kFlashBytes);
}

void FlashUploader::write(std::vector<std::uint16_t> pages) {
    pages_ = std::move(pages);
    nextPage_ = 0;
    setStage(FlashStage::Writing, static_cast<std::uint32_t>(pages_.size() * wire::kFlashPageBytes));
    writePage();
}

void FlashUploader::writePage() {
    if (nextPage_ == pages_.size()) {
        if (++rounds_ > kMostRounds) return failed({.code = Errc::NotVerified});
        note(FlashNote::Wrote, static_cast<std::int64_t>(pages_.size()), stage_ms());
        return survey(FlashStage::Verifying, plan().extent());
    }
    if (pausing_) return change(&FlashUploader::writePage);
    ++progress_.pagesSent;
    begin([this] {
        const std::uint16_t number = pages_[nextPage_];
        const FlashPage page = plan().page(number);
        return around_.requests.program(robot_, planFills(buffer_, page), {number, crc16(page)},
                                        done(&FlashUploader::pageWritten, &FlashUploader::pageUnanswered));
    });
}

void FlashUploader::pageWritten(const Response&) {
    buffer_ = plan().page(pages_[nextPage_]);
    ++nextPage_;
    progress_.attempt = 1;
    progress_.done_B = static_cast<std::uint32_t>(nextPage_ * wire::kFlashPageBytes);
    showRate();
    writePage();
}

void FlashUploader::pageUnanswered(const Error& error) {
    // A wrong CRC is passed over in silence (protocol 4.7): the page buffer holds something else. Writing a
    // page that was written already changes nothing in it.
    buffer_.reset();
    if (progress_.attempt == kPageAttempts) return failed(error);
    note(FlashNote::PageAgain, pages_[nextPage_], ++progress_.attempt);
    writePage();
}

// ---- Requests and their ends ----

void FlashUploader::ask(const wire::FirmwareRequest& request, Then then, Otherwise otherwise) {
    begin([this, request, then, otherwise] {
        return around_.requests.ask(robot_, request, done(then, otherwise));
    });
}

void FlashUploader::begin(std::function<Result<void>()> ask) {
    collisions_ = 0;
    asking_ = std::move(ask);
    beginAgain();
}

void FlashUploader::beginAgain() {
    const auto begun = asking_();
    if (begun) return;
    const bool collided = begun.error().code == Errc::RequestPending && ++collisions_ < kMostCollisions;
    if (!collided) return failed(begun.error());
    waitFor(kCollisionPause, &FlashUploader::beginAgain);
}

void FlashUploader::askAtRest(const wire::FirmwareRequest& request, Step step, Then then,
                              Otherwise otherwise) {
    begin([this, request, step, then, otherwise] {
        return around_.requests.ask(robot_, request, done(then, otherwise, step),
                                    [this] { return around_.mayChange(robot_); });
    });
}

RobotRequests::Done FlashUploader::done(Then then, Otherwise otherwise, Step step) {
    return [this, then, otherwise, step](const Result<Response>& result) {
        if (result) {
            (this->*then)(*result);
        } else if (step && result.error().code == Errc::StopLatched) {
            pause();
            held_ = step;
        } else if (otherwise && result.error().code == Errc::Unanswered) {
            (this->*otherwise)(result.error());
        } else {
            failed(result.error());
        }
        around_.changed();
    };
}

void FlashUploader::failed(const Error& error) {
    // A microcontroller that takes over its image may show itself before it has done so.
    if (expectsLoss() && withTheRobot(error.code)) return awaitReturn();
    Error why = error;
    why.robot = robot_;
    end(error.code == Errc::Cancelled ? FlashStage::Cancelled : FlashStage::Failed, std::move(why));
}

void FlashUploader::cancel() {
    if (!running()) return;
    if (naming_ && !cancelled_) {
        cancelled_ = true;
        around_.scheduler.cancel(timer_);
        waitFor(kNamingLimit, &FlashUploader::cancel);
        return;
    }
    // Whatever it asks ends with Cancelled, and the upload with it.
    around_.requests.cancel(robot_);
    if (running()) failed({.code = Errc::Cancelled});
}

void FlashUploader::change(Step step) {
    if (pausing_) {
        held_ = step;
    } else {
        (this->*step)();
    }
}

bool FlashUploader::mayDo(Step step) {
    const auto may = around_.mayChange(robot_);
    if (may) return true;
    if (may.error().code == Errc::StopLatched) {
        pause();
        held_ = step;
    } else {
        failed(may.error());
    }
    return false;
}

void FlashUploader::pause() {
    if (!running() || pausing_) return;
    pausing_ = true;
    progress_.paused = true;
    note(FlashNote::Paused);
    around_.paused(robot_);
}

void FlashUploader::resume() {
    if (!running() || !pausing_) return;
    pausing_ = false;
    progress_.paused = false;
    note(FlashNote::Resumed);
    if (const Step step = std::exchange(held_, nullptr)) (this->*step)();
}

void FlashUploader::setStage(FlashStage stage, std::uint32_t total_B) {
    progress_.stage = stage;
    progress_.done_B = 0;
    progress_.total_B = total_B;
    progress_.rate_Bps = 0;
    progress_.attempt = 1;
    stageAt_ = around_.scheduler.now();
    tick();
}

void FlashUploader::tick() {
    if (!running()) return;
    progress_.remaining = estimateRemaining(plans_, progress_, around_.scheduler.now() - stageAt_);
    around_.changed();
}

void FlashUploader::showRate() {
    const double time_s = seconds(around_.scheduler.now() - stageAt_);
    progress_.rate_Bps = time_s > 0 ? progress_.done_B / time_s : 0;
}

void FlashUploader::note(FlashNote note, std::int64_t a, std::int64_t b) {
    auto log = std::make_shared<FlashLog>(*progress_.log);
    log->push_back({around_.scheduler.now(), note, a, b});
    progress_.log = std::move(log);
    around_.changed();
}

void FlashUploader::end(FlashStage stage, std::optional<Error> why) {
    if (!running()) return;
    around_.scheduler.cancel(std::exchange(timer_, 0));
    note(FlashNote::Ended, why ? static_cast<std::int64_t>(why->code) : 0);
    progress_.stage = stage;
    progress_.paused = false;
    progress_.remaining = {};
    progress_.error = std::move(why);
    progress_.endedAt = around_.scheduler.now();
    held_ = nullptr;
    survey_.reset();
    around_.changed();
    around_.ended(robot_, progress_);
}

void FlashUploader::waitFor(Duration time, Step then) {
    around_.scheduler.cancel(timer_);
    timer_ = around_.scheduler.callAfter(time, [this, then] {
        timer_ = 0;
        (this->*then)();
    });
}

std::int64_t FlashUploader::stage_ms() const {
    return std::chrono::duration_cast<std::chrono::milliseconds>(around_.scheduler.now() - stageAt_).count();
}

}  // namespace kickstand::thunderbots
