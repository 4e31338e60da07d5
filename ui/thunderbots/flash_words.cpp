#include "ui/thunderbots/flash_words.h"

#include <QCoreApplication>

#include "core/engine/describe_flash.h"
#include "core/engine/describe_images.h"
#include "ui/thunderbots/words.h"

namespace kickstand::ui {

using namespace thunderbots;
using image::FlashTarget;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(FlashWizard)
};

QString signature(std::uint16_t crc) {
    return QStringLiteral("0x%1").arg(crc, 4, 16, QLatin1Char('0'));
}

QString obstacleSentence(const FlashHold& hold, const Snapshot* snapshot) {
    if (snapshot == nullptr) return {};
    return Words::tr("Robot %1: %2.").arg(hold.robot).arg(obstacleText(hold.obstacle, *snapshot, hold.robot));
}

QString capacitorObstacle(const RobotState& robot, bool known) {
    if (!robot.capacitor) return Words::tr("its capacitor was never measured: treat as live");
    const QString volts = capacitorText(robot.capacitor->last_V);
    return known ? Words::tr("%1 on its capacitor: discharge it").arg(volts)
                 : Words::tr("last %1 on its capacitor, not measured any more: treat as live").arg(volts);
}

QString unrestText(FlashObstacle obstacle) {
    switch (obstacle) {
        case FlashObstacle::Wheels:
            return Words::tr("its wheels run");
        case FlashObstacle::Dribbler:
            return Words::tr("its dribbler runs");
        case FlashObstacle::Charger:
            return Words::tr("its charger is on");
        case FlashObstacle::Autokick:
            return Words::tr("autokick is armed");
        case FlashObstacle::Sweeping:
            return Words::tr("a kick sweep runs");
        case FlashObstacle::Checking:
            return Words::tr("it is being checked");
        case FlashObstacle::Armed:
            return Words::tr("its high voltage is armed");
        case FlashObstacle::Uncommitted:
            return Words::tr(
                "parameters were applied and not committed: an upload would make some of them permanent");
        case FlashObstacle::Asked:
            return Words::tr("it is being asked something: a moment");
        default:
            return {};
    }
}

QString kibibytes(std::uint32_t bytes) {
    return QString::number(bytes / 1024.0, 'f', 1);
}

/// "for the microcontroller", "for the FPGA".
QString targetText(FlashTarget target) {
    return target == FlashTarget::Fpga ? Words::tr("the FPGA's bitstream")
                                       : Words::tr("the microcontroller's firmware");
}

}  // namespace

QString flashStepText(FlashStep step) {
    switch (step) {
        case FlashStep::Robots:
            return Words::tr("Robots");
        case FlashStep::Files:
            return Words::tr("Files");
        case FlashStep::Review:
            return Words::tr("Review");
        case FlashStep::Progress:
            return Words::tr("Progress");
        case FlashStep::Result:
            return Words::tr("Result");
    }
    return {};
}

QString obstacleText(FlashObstacle obstacle, const Snapshot& snapshot, int robot) {
    const RobotState& state = snapshot.robots[static_cast<std::size_t>(robot)];
    switch (obstacle) {
        case FlashObstacle::NotHeard:
            return Words::tr("not heard: switch it on, or leave it out");
        case FlashObstacle::Uploading:
            return Words::tr("an upload to it is running");
        case FlashObstacle::Discharging:
            return Words::tr("discharging, %1").arg(capacitorText(state.readings.capacitor_V));
        case FlashObstacle::CapacitorLive:
            return capacitorObstacle(state, true);
        case FlashObstacle::CapacitorUnknown:
            return capacitorObstacle(state, false);
        case FlashObstacle::BatteryLow:
            return Words::tr("battery at %1, too low: change it").arg(batteryText(state.readings.battery_V));
        default:
            return unrestText(obstacle);
    }
}

QString remedyText(FlashObstacle obstacle) {
    switch (obstacle) {
        case FlashObstacle::Wheels:
            return Words::tr("Brake");
        case FlashObstacle::Dribbler:
            return Words::tr("Dribbler off");
        case FlashObstacle::Charger:
            return Words::tr("Charger off");
        case FlashObstacle::Autokick:
            return Words::tr("Autokick off");
        case FlashObstacle::Sweeping:
            return Words::tr("End sweep");
        case FlashObstacle::Checking:
            return Words::tr("End check");
        case FlashObstacle::CapacitorLive:
            return Words::tr("Arm and discharge");
        case FlashObstacle::Armed:
            return Words::tr("Disarm");
        case FlashObstacle::Uncommitted:
            return Words::tr("Parameters\u2026");
        default:
            return {};
    }
}

QString holdText(const FlashHold& hold, const FlashWizardState& state, const Snapshot* snapshot) {
    switch (hold.kind) {
        case FlashHold::Kind::NotConnected:
            return Words::tr("Not connected.");
        case FlashHold::Kind::LinkNotRunning:
            return Words::tr("The link does not run: %1.")
                .arg(snapshot ? describe(snapshot->link) : QString());
        case FlashHold::Kind::Stopped:
            return Words::tr("Everything is stopped: re-arm first.");
        case FlashHold::Kind::NoRobot:
            return Words::tr("Tick the robots that are to be flashed.");
        case FlashHold::Kind::Robot:
            return obstacleSentence(hold, snapshot);
        case FlashHold::Kind::NoFile:
            return Words::tr("Choose a file.");
        case FlashHold::Kind::Reading:
            return Words::tr("The file is being read.");
        case FlashHold::Kind::File:
            return Words::tr("%1 cannot be used.").arg(state.files[hold.file].name);
        case FlashHold::Kind::SameTarget:
            return Words::tr("Both files are for %1: remove one, or change its target.")
                .arg(targetText(state.files.front().target));
        case FlashHold::Kind::ReadingRobots:
            return Words::tr("The robots are being asked for their signatures.");
        case FlashHold::Kind::RobotUnread:
            return Words::tr("Robot %1 did not tell what it has. Read again, or go back and leave it out.")
                .arg(hold.robot);
        case FlashHold::Kind::NothingToDo:
            return Words::tr("Every robot has it already: there is nothing to do.");
        case FlashHold::Kind::Uploading:
            return Words::tr("Stay near: the upload runs on when this panel is closed.");
    }
    return {};
}

QStringList fileFacts(const FlashFile& file) {
    QStringList facts;
    if (!file.isImage()) return facts;
    QString kind = describe(file.format);
    const image::BitHeader& header = file.header;
    if (!header.part.empty()) kind += Words::tr(" \u00b7 part %1").arg(QString::fromStdString(header.part));
    if (!header.date.empty()) {
        kind += Words::tr(" \u00b7 made %1 %2")
                    .arg(QString::fromStdString(header.date), QString::fromStdString(header.time));
    }
    facts << kind;
    const SharedFlashPlan plan = file.plan();
    if (!plan) return facts;
    facts << Words::tr("%1 bytes of data \u00b7 %2 of %3 pages are sent, the others are blank")
                 .arg(plan->image().dataBytes())
                 .arg(plan->pages().size())
                 .arg((plan->image().bytes.size() + wire::kFlashPageBytes - 1) / wire::kFlashPageBytes);
    for (const image::DataRange& range : plan->image().skipped) {
        facts << Words::tr("%1\u2013%2 is left out: the robot keeps its own configuration there")
                     .arg(addressText(range.begin), addressText(range.end - 1));
    }
    facts << (plan->target() == FlashTarget::Fpga
                  ? Words::tr("signature of the flash %1").arg(signature(plan->signatures().flash))
                  : Words::tr("signature of the firmware %1")
                        .arg(signature(plan->signatures().microcontroller)));
    return facts;
}

QString fileProblem(const FlashFile& file) {
    if (!file.unreadable.isEmpty()) return Words::tr("It cannot be read: %1.").arg(file.unreadable);
    if (const auto refusal = file.refusal()) return describe(*refusal).line();
    if (file.isBlank()) return Words::tr("There is nothing in it but erased bytes: nothing would be sent.");
    return {};
}

QString filesNotice(const FlashWizardState& state) {
    if (state.losesBitstream()) {
        return Words::tr(
            "Microcontroller firmware takes the place of the FPGA's bitstream in the robot's one "
            "flash. The robot will not drive until the FPGA's bitstream is uploaded again.");
    }
    if (state.plans().size() == 2) {
        return Words::tr(
            "The microcontroller's firmware is sent first, then the FPGA's bitstream: the other "
            "way round the second would erase the first.");
    }
    return {};
}

QString signatureText(const FlashWizardState& state, int robot) {
    const FlashReview& review = state.reviews[static_cast<std::size_t>(robot)];
    switch (review.state) {
        case FlashReview::State::Unread:
            return Words::tr("not read yet");
        case FlashReview::State::Reading:
            return Words::tr("being read\u2026");
        case FlashReview::State::Failed:
            return review.error ? describe(*review.error).line() : Words::tr("not read");
        case FlashReview::State::Read:
            break;
    }
    QStringList parts;
    for (const SharedFlashPlan& plan : state.plans()) {
        const bool fpga = plan->target() == FlashTarget::Fpga;
        parts << Words::tr("%1: has %2, gets %3")
                     .arg(fpga ? Words::tr("flash") : Words::tr("microcontroller"),
                          signature(fpga ? review.signatures.flashCrc : review.signatures.microcontrollerCrc),
                          signature(fpga ? plan->signatures().flash : plan->signatures().microcontroller));
    }
    return parts.join(u'\n');
}

QString thereText(const FlashWizardState& state, int robot) {
    if (!state.canLeaveOut(robot)) return {};
    const auto all = state.plans();
    const bool everything = all.size() == 1 || state.isThere(robot, *all.back());
    return everything ? Words::tr("already there: leave it out")
                      : Words::tr("firmware already there: only the FPGA");
}

QStringList orderOfThings(const std::vector<SharedFlashPlan>& plans) {
    QStringList lines;
    lines << Words::tr(
        "Each robot's parameters are read; it is marked as having no data, so that it never starts half "
        "an image.");
    for (const SharedFlashPlan& plan : plans) {
        const bool fpga = plan->target() == FlashTarget::Fpga;
        lines << Words::tr(
                     "%1: the flash is erased (8 s), %2 pages are written, then every block is verified.")
                     .arg(describe(plan->target()))
                     .arg(plan->pages().size());
        lines << (fpga ? Words::tr("Only then the bitstream is named as valid, and the robot reboots.")
                       : Words::tr(
                             "Only then the firmware is named as valid; the robot reboots, copies it (5 s) "
                             "and reboots again."));
    }
    lines << Words::tr("Its signatures are read and compared.");
    return lines;
}

QString stageText(const FlashRunRobot& robot) {
    switch (robot.outcome()) {
        case FlashOutcome::Asked:
            return Words::tr("beginning");
        case FlashOutcome::Refused:
            return Words::tr("not begun");
        case FlashOutcome::Gone:
            return Words::tr("connection closed");
        default:
            break;
    }
    const FlashProgress& progress = *robot.progress;
    QString text = describe(progress.stage);
    if (progress.paused) text = Words::tr("paused while %1").arg(text);
    if (progress.running() && progress.images > 1)
        text = QStringLiteral("%1: %2").arg(describe(progress.target), text);
    return text;
}

QString figuresText(const FlashRunRobot& robot) {
    if (!robot.progress || robot.ended()) return {};
    const FlashProgress& progress = *robot.progress;
    QStringList parts;
    if (progress.total_B > 0) {
        parts << Words::tr("%1 of %2 KiB").arg(kibibytes(progress.done_B), kibibytes(progress.total_B));
        if (progress.rate_Bps > 0) parts << Words::tr("%1 KiB/s").arg(progress.rate_Bps / 1024, 0, 'f', 1);
    }
    if (!progress.paused) parts << Words::tr("%1 left").arg(durationText(progress.remaining));
    if (progress.attempt > 1) parts << Words::tr("attempt %1").arg(progress.attempt);
    return parts.join(QStringLiteral(" \u00b7 "));
}

QString outcomeText(int robot, const FlashRunRobot& entry) {
    switch (entry.outcome()) {
        case FlashOutcome::Asked:
            return Words::tr("The upload to robot %1 has not begun yet.").arg(robot);
        case FlashOutcome::Refused:
            return Words::tr("The upload to robot %1 was not begun. %2")
                .arg(robot)
                .arg(describe(*entry.refusal).line());
        case FlashOutcome::Gone: {
            const QString left = describe(entry.progress ? entry.progress->left : FlashLeft::Untouched);
            return Words::tr("The connection was closed during the upload to robot %1. %2")
                .arg(robot)
                .arg(left);
        }
        default:
            return describeFlash(robot, *entry.progress).line();
    }
}

QString logText(int robot, const FlashRunRobot& entry) {
    QStringList lines;
    lines << outcomeText(robot, entry);
    for (const SharedFlashPlan& plan : entry.plans) {
        lines << Words::tr("%1: pages %2, signatures %3 (firmware), %4 (flash)")
                     .arg(describe(plan->target()))
                     .arg(plan->pages().size())
                     .arg(signature(plan->signatures().microcontroller), signature(plan->signatures().flash));
    }
    if (entry.progress) lines << QString() << flashLogLines(*entry.progress);
    return lines.join(u'\n') + u'\n';
}

}  // namespace kickstand::ui
