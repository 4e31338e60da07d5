#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ui/thunderbots/flash_file.h"
#include "ui/thunderbots/flash_obstacle.h"
#include "ui/thunderbots/flash_run.h"

namespace kickstand::ui {

/// The pages of the wizard, in order.
enum class FlashStep { Robots, Files, Review, Progress, Result };
inline constexpr int kFlashSteps = 5;

/// Why a page cannot be passed.
struct FlashHold {
    enum class Kind {
        NotConnected,
        LinkNotRunning,
        Stopped,
        NoRobot,
        Robot,  ///< `robot` has `obstacle`.
        NoFile,
        Reading,        ///< Files are still being read.
        File,           ///< `file` cannot be used.
        SameTarget,     ///< Both files are for the same chip.
        ReadingRobots,  ///< Signatures are being read.
        RobotUnread,    ///< `robot` did not tell its signatures.
        NothingToDo,    ///< All robots are left out.
        Uploading,
    };
    Kind kind = Kind::NotConnected;
    int robot = -1;
    FlashObstacle obstacle = FlashObstacle::None;
    std::size_t file = 0;
    friend bool operator==(const FlashHold&, const FlashHold&) = default;
};

/// What a robot said of the firmware that it has.
struct FlashReview {
    enum class State { Unread, Reading, Read, Failed };
    State state = State::Unread;
    TimePoint askedAt{};
    std::optional<Error> error;  ///< Why it failed.
    thunderbots::wire::ReadSignaturesResponse signatures;
    thunderbots::wire::FlashContents contents = thunderbots::wire::FlashContents::NoData;
    bool leaveOut = true;  ///< What is there already is not sent again.
};

/// All that a person has chosen in the wizard, and what is wrong with it. Pure: nothing is asked for here.
struct FlashWizardState {
    static constexpr std::size_t kMostFiles = 2;

    FlashStep step = FlashStep::Robots;
    thunderbots::RobotMask robots = 0;
    bool chosenHere = false;  ///< A person has ticked robots in the wizard: it follows nothing else any more.
    thunderbots::FlashOptions options;
    std::vector<FlashFile> files;
    int reading = 0;  ///< Files that are being read.
    std::array<FlashReview, thunderbots::kRobots> reviews;
    FlashRun run;

    /// Takes a file, in the place of an earlier reading of it. False where there are two others already.
    bool addFile(FlashFile file);
    /// What the files come to, in the order of the upload: the microcontroller's first. Empty where one
    /// cannot be used.
    std::vector<thunderbots::SharedFlashPlan> plans() const;
    /// Whether only the microcontroller's firmware would be sent: the robot loses its bitstream by it.
    bool losesBitstream() const;
    /// Whether a robot has what this plan would give it.
    bool isThere(int robot, const thunderbots::FlashPlan& plan) const;
    /// Whether some of what is to be sent need not be.
    bool canLeaveOut(int robot) const;
    /// What is to be sent to a robot: all, or less where a person leaves out what is there.
    std::vector<thunderbots::SharedFlashPlan> plansFor(int robot) const;
    /// Takes over what robots have said since they were asked.
    void takeReviews(const thunderbots::Snapshot& snapshot);
    /// Forgets what the robots said.
    void forgetReviews() { reviews = {}; }

    /// Why this step cannot be passed now. `snapshot` may be null. `stopped`: STOP is latched.
    std::optional<FlashHold> hold(const thunderbots::Snapshot* snapshot, bool stopped) const;
    /// How long it will take, all robots together: from what the steps need, on a good radio.
    Duration estimate() const;

  private:
    std::optional<FlashHold> robotsHold(const thunderbots::Snapshot* snapshot, bool stopped) const;
    std::optional<FlashHold> filesHold() const;
    std::optional<FlashHold> reviewHold() const;
};

}  // namespace kickstand::ui
