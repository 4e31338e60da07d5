#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "core/base/scheduler.h"
#include "core/thunderbots/flash_progress.h"
#include "core/thunderbots/flash_survey.h"
#include "core/thunderbots/robot_requests.h"
#include "core/thunderbots/wire/dongle.h"

namespace kickstand::thunderbots {

/// What an upload works with. All of it outlives the upload.
struct FlashSurroundings {
    Scheduler& scheduler;
    RobotRequests& requests;
    /// Whether a robot may be erased or rebooted now: at rest, and without high voltage.
    std::function<Result<void>(int robot)> mayChange;
    /// Whether the robot is on a cable, whose device goes away with the robot.
    std::function<bool()> onCable;
    /// The dongle's channels, as far as they are known; none on a cable.
    std::function<std::optional<wire::Channels>()> channels;
    std::function<void()> changed;
    /// STOP has paused an upload.
    std::function<void(int robot)> paused;
    std::function<void(int robot, const FlashProgress& progress)> ended;
};

/// Uploads images to one robot, one after the other, as FlashStage tells (protocol 4.7, 6.7, 6.8). At every
/// moment a robot that loses its power comes up with what it had, with what was verified, or saying that it
/// has no data. Engine thread.
class FlashUploader {
  public:
    /// `plans` are not null, one or two: the microcontroller's first. `surroundings` outlives it.
    FlashUploader(int robot, std::vector<SharedFlashPlan> plans, const FlashSurroundings& surroundings);
    ~FlashUploader();
    FlashUploader(const FlashUploader&) = delete;
    FlashUploader& operator=(const FlashUploader&) = delete;

    void start();
    /// Ends it at once; progress().left says how the robot is left.
    void cancel();
    /// Finishes what the robot is at, and sends nothing more that changes anything until resume().
    void pause();
    void resume();
    /// The dongle has found the robot, or lost it; after RobotRequests has heard of it.
    void found();
    void lost(Errc why);
    /// Time has passed: brings the figures up to date.
    void tick();

    bool running() const { return progress_.running(); }
    const FlashProgress& progress() const { return progress_; }
    /// Whether the robot is to vanish about now.
    bool expectsLoss() const { return running() && progress_.stage >= FlashStage::Rebooting; }

  private:
    using Then = void (FlashUploader::*)(const wire::FirmwareResponse&);
    using Step = void (FlashUploader::*)();
    using Otherwise = void (FlashUploader::*)(const Error&);

    const FlashPlan& plan() const { return *plans_[progress_.image]; }
    void beginImage();
    void contentsRead(const wire::FirmwareResponse& response);
    void markNoData();
    void noDataSet(const wire::FirmwareResponse& response);
    void noDataMarked(const wire::FirmwareResponse& response);

    void survey(FlashStage stage, std::uint32_t end);
    void surveyNext();
    void blockAnswered(const wire::FirmwareResponse& response);
    void surveyed();
    void verified();

    void erase();
    void erased(const wire::FirmwareResponse& response);
    void eraseUnanswered(const Error& error);
    void write(std::vector<std::uint16_t> pages);
    void writePage();
    void pageWritten(const wire::FirmwareResponse& response);
    void pageUnanswered(const Error& error);

    void activate();
    void freshParametersRead(const wire::FirmwareResponse& response);
    void nameContents();
    void contentsSet(const wire::FirmwareResponse& response);
    void contentsReadBack(const wire::FirmwareResponse& response);
    void contentsCommitted(const wire::FirmwareResponse& response);
    void reboot();
    void rebooting(const wire::FirmwareResponse& response);
    void rebootUnanswered(const Error& error);
    void awaitLoss();
    /// Whether what was lost is the robot, and not the way to it.
    bool withTheRobot(Errc why) const;
    void probe();
    void probeAnswered(const wire::FirmwareResponse& response);
    void awaitReturn();
    void neverCameBack();
    void confirm();
    void finalContentsRead(const wire::FirmwareResponse& response);
    void signaturesRead(const wire::FirmwareResponse& response);

    void ask(const wire::FirmwareRequest& request, Then then, Otherwise otherwise = nullptr);
    /// Calls `ask`, and again while somebody else is asking the robot something.
    void begin(std::function<Result<void>()> ask);
    void beginAgain();
    /// Asks for what only a robot at rest may be asked for; where STOP comes before it is sent, a resume does
    /// `step`.
    void askAtRest(const wire::FirmwareRequest& request, Step step, Then then, Otherwise otherwise);
    RobotRequests::Done done(Then then, Otherwise otherwise, Step step = nullptr);
    void failed(const Error& error);
    /// Does a step that changes something in the robot: now, or when it is resumed.
    void change(Step step);
    /// Whether the robot is fit for a step. Where it is not the upload fails; where STOP was pressed a moment
    /// ago it pauses, and a resume does the step.
    bool mayDo(Step step);
    void setStage(FlashStage stage, std::uint32_t total_B = 0);
    void note(FlashNote note, std::int64_t a = 0, std::int64_t b = 0);
    void showRate();
    void end(FlashStage stage, std::optional<Error> why);
    void waitFor(Duration time, Step then);
    std::int64_t stage_ms() const;

    const int robot_;
    const std::vector<SharedFlashPlan> plans_;
    const FlashSurroundings& around_;
    FlashProgress progress_;
    wire::OperationalParameters parameters_;
    std::optional<FlashSurvey> survey_;
    std::vector<std::uint16_t> pages_;  ///< That are to be written.
    std::size_t nextPage_ = 0;
    std::optional<FlashPage> buffer_;  ///< What the robot's page buffer holds; none: nobody knows.
    bool resumes_ = false;  ///< It said that it has no data: there may be something of an earlier upload.
    int rounds_ = 0;        ///< How often this image was verified.
    bool away_ = false;     ///< The robot went to reboot.
    std::uint32_t unansweredBefore_ = 0;
    bool naming_ = false;     ///< The volatile copy may name what is not committed yet.
    bool cancelled_ = false;  ///< Ends as soon as both copies say the same.
    bool pausing_ = false;
    Step held_ = nullptr;                   ///< What a resume goes on with.
    std::function<Result<void>()> asking_;  ///< Waits until the robot can be asked.
    int collisions_ = 0;
    TimePoint stageAt_{};
    TimerId timer_ = 0;
};

}  // namespace kickstand::thunderbots
