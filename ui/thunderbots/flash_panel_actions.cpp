// What the wizard asks of the robots and of the disk.

#include <QDateTime>
#include <bit>
#include <utility>

#include "core/engine/describe.h"
#include "ui/shell/bench.h"
#include "ui/thunderbots/flash_panel.h"
#include "ui/thunderbots/flash_words.h"
#include "ui/thunderbots/robot_choice.h"
#include "ui/widgets/save_file.h"

namespace kickstand::ui {

using namespace thunderbots;

void FlashPanel::ask(const thunderbots::Command& command) {
    refusal_.clear();
    bench().submit(SystemCommand{command}, this, [this](const Result<void>& result) {
        if (!result) {
            refusal_ = describe(result.error()).line();
            dischargeAsked_ = 0;
        }
        refresh();
    });
}

// ---- Robots ----

void FlashPanel::remedy(int robot) {
    const Snapshot* now = snapshot();
    if (now == nullptr) return;
    const FlashObstacle obstacle = obstacleOf(*now, robot, state_.options);
    if (obstacle == FlashObstacle::Uncommitted) {
        choice_.choose(maskOf(robot));
        bench().goTo(QStringLiteral("parameters"));
        return;
    }
    if (obstacle == FlashObstacle::CapacitorLive) dischargeAsked_ |= maskOf(robot);
    for (const thunderbots::Command& command : remedyOf(obstacle, robot))
        ask(command);
}

void FlashPanel::disarmDischarged(const Snapshot& snapshot) {
    for (int robot = 0; robot < kRobots; ++robot) {
        const RobotMask mask = maskOf(robot);
        const RobotIntent& intent = snapshot.intents[static_cast<std::size_t>(robot)];
        if (contains(dischargeAsked_, robot) && intent.discharging) {
            dischargeAsked_ = static_cast<RobotMask>(dischargeAsked_ & ~mask);
            discharging_ |= mask;
        }
        if (!contains(discharging_, robot) || intent.discharging) continue;
        discharging_ = static_cast<RobotMask>(discharging_ & ~mask);
        // It was armed for the discharge alone.
        if (intent.highVoltageArmed) ask(ArmHighVoltage{mask, false});
    }
}

void FlashPanel::sessionGone() {
    state_.run.letGo();
    forgetReviews();
    refusal_.clear();
    discharging_ = 0;
    dischargeAsked_ = 0;
    refresh();
}

// ---- Files ----

void FlashPanel::addFiles(const QStringList& paths) {
    filesNotice_.clear();
    for (const QString& path : paths)
        reader_.read(path);
    refresh();
}

void FlashPanel::takeFile(const FlashFile& file) {
    // Those that run, and what a person has reviewed, are not changed under their feet.
    if (state_.step > FlashStep::Files) return refresh();
    if (!state_.addFile(file))
        filesNotice_ = tr("%1 was not taken: one file for each chip is all there can be. Remove one first.")
                           .arg(file.name);
    refresh();
}

void FlashPanel::removeFile(std::size_t file) {
    filesNotice_.clear();
    if (file < state_.files.size())
        state_.files.erase(state_.files.begin() + static_cast<std::ptrdiff_t>(file));
    refresh();
}

// ---- Review ----

void FlashPanel::forgetReviews() {
    ++reviewRound_;
    state_.forgetReviews();
}

void FlashPanel::readAgain() {
    for (FlashReview& review : state_.reviews) {
        if (review.state == FlashReview::State::Failed) review.state = FlashReview::State::Unread;
    }
    refresh();
}

void FlashPanel::readRobots() {
    const Snapshot* now = snapshot();
    for (int robot = 0; now != nullptr && robot < kRobots; ++robot) {
        const auto at = static_cast<std::size_t>(robot);
        const bool wanted =
            contains(state_.robots, robot) && state_.reviews[at].state == FlashReview::State::Unread;
        if (wanted && now->robots[at].live && !now->requests[at].op) readRobot(robot);
    }
}

void FlashPanel::readRobot(int robot) {
    FlashReview& review = state_.reviews[static_cast<std::size_t>(robot)];
    review.state = FlashReview::State::Reading;
    review.askedAt = bench().client().now();
    const auto failed = [this, robot, round = reviewRound_](const Error& error) {
        if (round != reviewRound_) return;
        FlashReview& answered = state_.reviews[static_cast<std::size_t>(robot)];
        answered.state = FlashReview::State::Failed;
        answered.error = error;
        refresh();
    };
    // Its parameters too: a bitstream that it does not name is one that it does not have.
    bench().submit(SystemCommand{thunderbots::Command{ReadParameters{robot}}}, this,
                   [this, robot, failed, round = reviewRound_](const Result<void>& read) {
                       if (!read) return failed(read.error());
                       if (round != reviewRound_) return;
                       bench().submit(SystemCommand{thunderbots::Command{ReadSignatures{robot}}}, this,
                                      [failed](const Result<void>& result) {
                                          if (!result) failed(result.error());
                                      });
                   });
}

// ---- Progress ----

void FlashPanel::start() {
    state_.run.begin(bench().client().now());
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(state_.robots, robot)) continue;
        auto plans = state_.plansFor(robot);
        if (plans.empty()) continue;
        state_.run.add(robot, plans);
        // Each for itself: what one of them is refused for is not the others' affair.
        bench().submit(
            SystemCommand{thunderbots::Command{StartFlash{maskOf(robot), std::move(plans), state_.options}}},
            this, [this, robot](const Result<void>& result) {
                if (!result) state_.run.refuse(robot, result.error());
                refresh();
            });
    }
    go(FlashStep::Progress);
}

void FlashPanel::cancel(RobotMask robots) {
    if (robots != 0) ask(CancelFlash{robots});
}

void FlashPanel::resume(RobotMask robots) {
    if (robots != 0) ask(ResumeFlash{robots});
}

// ---- Result ----

void FlashPanel::uploadAgain(RobotMask robots) {
    state_.robots = robots;
    state_.chosenHere = true;
    state_.options = {};
    go(FlashStep::Robots);
}

void FlashPanel::startOver() {
    state_.chosenHere = false;
    state_.options = {};
    state_.robots = choice_.chosen();
    go(FlashStep::Robots);
}

void FlashPanel::saveLogs(RobotMask robots) {
    const QString name = std::has_single_bit(robots)
                             ? QStringLiteral("robot%1-upload.txt").arg(std::countr_zero(robots))
                             : QStringLiteral("uploads.txt");
    // As it is now: a new upload may have begun by the time a place has been chosen.
    askToSave(this, tr("Save log"), name, QStringLiteral("txt"), [logs = logsOf(robots)] { return logs; });
}

QByteArray FlashPanel::logsOf(RobotMask robots) const {
    QStringList texts;
    for (int robot = 0; robot < kRobots; ++robot) {
        if (!contains(robots, robot)) continue;
        const FlashRunRobot& entry = state_.run.at(robot);
        QString text = logText(robot, entry);
        if (entry.progress) {
            const auto began = bench().client().wallTime(entry.progress->beganAt);
            const auto began_ms =
                std::chrono::duration_cast<std::chrono::milliseconds>(began.time_since_epoch()).count();
            text.prepend(QDateTime::fromMSecsSinceEpoch(began_ms).toString(Qt::ISODate) + u'\n');
        }
        texts << text;
    }
    return texts.join(u'\n').toUtf8();
}

}  // namespace kickstand::ui
