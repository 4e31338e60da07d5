#include <array>

#include "app/kickstandctl/families.h"
#include "app/kickstandctl/firmware_files.h"
#include "app/kickstandctl/history.h"
#include "app/kickstandctl/json.h"
#include "app/kickstandctl/motion.h"
#include "app/kickstandctl/output.h"
#include "app/kickstandctl/save_file.h"
#include "app/kickstandctl/session_runner.h"
#include "app/kickstandctl/text.h"
#include "app/kickstandctl/values.h"
#include "app/kickstandctl/words.h"
#include "core/engine/describe_flash.h"
#include "core/engine/describe_images.h"

namespace kickstand::ctl {
namespace {

using thunderbots::FlashProgress;
using thunderbots::FlashStage;
using thunderbots::maskOf;
using thunderbots::RobotMask;

/// Sixteen robots and two images on a radio that carries little take hours; no upload waits longer for any
/// one thing than a minute.
constexpr Duration kUploadLimit = std::chrono::hours(24);
constexpr Duration kRequestLimit = std::chrono::minutes(2);
constexpr Duration kTellEvery = std::chrono::seconds(1);

QString nameOf(std::string_view text) {
    return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size()));
}

/// Robots and files, and what passes between them.
class Flashing {
  public:
    Flashing(const Context& context, std::vector<FirmwareFile> files, RobotMask robots)
        : context_(context),
          runner_(context),
          motion_(context, runner_, Motion::Style::Stream),
          files_(std::move(files)),
          robots_(robots) {}

    Outcome begin() {
        motion_.setListener([this](const EngineEvent& event) {
            if (!history_) history_.emplace(runner_);
            history_->take(event);
        });
        return motion_.begin(robots_);
    }
    Outcome end(Outcome outcome) {
        tellEnds();
        outcome = motion_.end(std::move(outcome));
        if (history_) history_->finish();
        return outcome;
    }

    /// Finds out what each robot has already, and says it.
    Outcome compare() {
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            if (!thunderbots::contains(robots_, robot)) continue;
            const auto there = imagesThere(robot);
            if (!there) return tl::unexpected(there.error());
            there_[static_cast<std::size_t>(robot)] = *there;
        }
        return {};
    }
    /// The robots that lack at least one of the images.
    RobotMask incomplete() const {
        RobotMask robots = 0;
        for (std::size_t there = 0; there < files_.size(); ++there)
            robots = static_cast<RobotMask>(robots | robotsWith(there));
        return robots;
    }

    /// Reading shows only what a robot has until its next reboot: what is already there is committed too, so
    /// that it is there afterwards.
    Outcome commitWhatIsThere() {
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            if (!thunderbots::contains(robotsWith(files_.size()), robot)) continue;
            const auto& block = *knownOf(robot).robot;
            const auto& channels = runner_.state().channels;
            const bool asItIsHeard =
                block.robotNumber == robot &&
                (!channels || *channels == thunderbots::wire::Channels{block.channel0, block.channel1});
            if (!asItIsHeard) return failed({.code = Errc::RebootNeeded, .robot = robot});
            if (auto done = runner_.perform(thunderbots::CommitParameters{robot}, kRequestLimit); !done)
                return done;
        }
        return {};
    }

    Outcome upload() {
        started_ = incomplete();
        // A cable's device goes away with its robot, when that reboots.
        if (runner_.state().cable) runner_.watchOnly();
        // A robot that is refused keeps no other one from its upload.
        Outcome begun;
        for (std::size_t there = 0; there < files_.size(); ++there) {
            if (robotsWith(there) == 0) continue;
            auto one = start(robotsWith(there), there);
            if (begun) begun = std::move(one);
        }
        // The answer may be here before the state that belongs to it.
        const TimePoint answered = runner_.engine().now();
        const auto current = runner_.waitUntil([&] { return runner_.state().time > answered; }, kTellEvery);
        if (!current) return tl::unexpected(current.error());
        const auto ended = runner_.waitUntil([this] { return look(); }, kUploadLimit);
        if (!ended) return tl::unexpected(ended.error());
        if (!begun) {
            if (begun.error().code == nameOf(name(Errc::ReadingsUnknown)))
                begun.error().text.remedy =
                    Words::tr("See that its capacitor is empty, then give --discharged.");
            return begun;
        }
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            const FlashProgress* progress = progressOf(robot);
            if (progress && progress->error) return failed(*progress->error);
            // Whatever else there may be: only what was done is called done.
            if (thunderbots::contains(started_, robot) && (!progress || progress->stage != FlashStage::Done))
                return failed({.code = Errc::Cancelled, .robot = robot});
        }
        return {};
    }

  private:
    /// The robots that have just so many of the images.
    RobotMask robotsWith(std::size_t there) const {
        RobotMask robots = 0;
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            if (thunderbots::contains(robots_, robot) && there_[static_cast<std::size_t>(robot)] == there)
                robots = static_cast<RobotMask>(robots | maskOf(robot));
        }
        return robots;
    }
    /// Begins with the image after those that are there: what comes before it would erase it again.
    Outcome start(RobotMask robots, std::size_t there) {
        thunderbots::StartFlash start;
        start.robots = robots;
        for (std::size_t file = there; file < files_.size(); ++file)
            start.plans.push_back(files_[file].plan);
        start.options.lowBattery = context_.invocation.has("--low-battery");
        start.options.capacitorUnknown = context_.invocation.has("--discharged");
        return runner_.perform(start);
    }

    const FlashProgress* progressOf(int robot) const {
        const auto& progress = runner_.state().flash[static_cast<std::size_t>(robot)];
        return progress && thunderbots::contains(started_, robot) ? &*progress : nullptr;
    }

    /// How many of the images a robot has already, counted from the first.
    Expected<std::size_t> imagesThere(int robot) {
        for (const thunderbots::Command& command :
             {thunderbots::Command(thunderbots::ReadParameters{robot}),
              thunderbots::Command(thunderbots::ReadSignatures{robot})}) {
            if (auto done = runner_.perform(command, kRequestLimit); !done)
                return tl::unexpected(done.error());
        }
        const auto known = runner_.waitUntil(
            [&] { return knownOf(robot).robot.has_value() && knownOf(robot).signatures.has_value(); },
            kTellEvery);
        if (!known) return tl::unexpected(known.error());
        if (!*known) return failed({.code = Errc::TimedOut, .robot = robot});
        const auto& signatures = *knownOf(robot).signatures;
        std::size_t there = 0;
        while (there < files_.size() && isThere(robot, files_[there]))
            ++there;
        const bool same = there == files_.size();
        motion_.tell(QStringLiteral("signatures"),
                     {{QStringLiteral("robot"), robot},
                      {QStringLiteral("microcontroller"), signatures.microcontrollerCrc},
                      {QStringLiteral("flash"), signatures.flashCrc},
                      {QStringLiteral("already_there"), same}},
                     (same ? Words::tr("Robot %1 has microcontroller %2, flash %3: already there.")
                           : Words::tr("Robot %1 has microcontroller %2, flash %3."))
                         .arg(robot)
                         .arg(crcText(signatures.microcontrollerCrc), crcText(signatures.flashCrc)));
        return there;
    }
    const thunderbots::ParameterState& knownOf(int robot) const {
        return runner_.state().parameters[static_cast<std::size_t>(robot)];
    }
    bool isThere(int robot, const FirmwareFile& file) const {
        const auto& known = knownOf(robot);
        if (file.plan->target() == thunderbots::image::FlashTarget::Microcontroller)
            return known.signatures->microcontrollerCrc == file.signature();
        return known.signatures->flashCrc == file.signature() &&
               known.robot->flash() == file.plan->contents();
    }

    /// Tells what is new; true when no upload runs any more.
    bool look() {
        bool running = false;
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            const FlashProgress* progress = progressOf(robot);
            if (!progress) continue;
            // Nobody is there to resume what a STOP has paused.
            running = running || (progress->running() && !progress->paused);
            tellProgress(robot, *progress);
        }
        return !running;
    }

    void tellProgress(int robot, const FlashProgress& progress) {
        Told& told = told_[static_cast<std::size_t>(robot)];
        const TimePoint now = runner_.engine().now();
        const bool news = progress.stage != told.stage || progress.image != told.image;
        if (!progress.running() || (!news && now - told.at < kTellEvery)) return;
        told = {progress.stage, progress.image, now};
        motion_.tell(QStringLiteral("progress"), toJson(robot, progress),
                     describeFlash(robot, progress).what);
    }

    QJsonObject toJson(int robot, const FlashProgress& progress) const {
        return {{QStringLiteral("robot"), robot},
                {QStringLiteral("target"), nameOf(thunderbots::image::name(progress.target))},
                {QStringLiteral("stage"), nameOf(name(progress.stage))},
                {QStringLiteral("left"), nameOf(name(progress.left))},
                {QStringLiteral("paused"), progress.paused},
                {QStringLiteral("attempt"), progress.attempt},
                {QStringLiteral("done_B"), static_cast<qint64>(progress.done_B)},
                {QStringLiteral("total_B"), static_cast<qint64>(progress.total_B)},
                {QStringLiteral("rate_Bps"), rounded(progress.rate_Bps)},
                {QStringLiteral("remaining_s"), rounded(seconds(progress.remaining))}};
    }

    /// How each upload ended; one that still runs ends with this command.
    void tellEnds() {
        if (started_ == 0) return;
        QStringList log;
        for (int robot = 0; robot < thunderbots::kRobots; ++robot) {
            const FlashProgress* progress = progressOf(robot);
            if (!progress) continue;
            FlashProgress shown = *progress;
            if (shown.running()) {
                shown.stage = FlashStage::Cancelled;
                shown.endedAt = runner_.engine().now();
            }
            QJsonObject facts = toJson(robot, shown);
            if (shown.error) facts[QStringLiteral("error")] = ctl::toJson(*shown.error);
            facts[QStringLiteral("seconds")] = rounded(seconds(shown.endedAt - shown.beganAt));
            const QString text = describeFlash(robot, shown).line();
            motion_.tell(QStringLiteral("upload"), facts, text);
            log << Words::tr("Robot %1").arg(robot) << flashLogLines(shown) << text << QString();
        }
        saveLog(log);
    }
    void saveLog(const QStringList& log) {
        if (!context_.invocation.has("--log")) return;
        const std::string_view path = context_.invocation.text("--log");
        const auto saved = saveFile(QString::fromUtf8(path.data(), static_cast<qsizetype>(path.size())),
                                    log.join(u'\n').toUtf8());
        // What became of the robots is what the exit code says.
        if (!saved) context_.output.line(saved.error().text.line());
    }

    struct Told {
        FlashStage stage = FlashStage::Done;
        std::size_t image = 0;
        TimePoint at{};
    };
    const Context& context_;
    SessionRunner runner_;
    Motion motion_;
    std::optional<History> history_;
    const std::vector<FirmwareFile> files_;
    const RobotMask robots_;
    std::array<std::size_t, thunderbots::kRobots> there_{};  ///< Images that each robot has.
    RobotMask started_ = 0;                                  ///< Those that an upload was begun for.
    std::array<Told, thunderbots::kRobots> told_;
};

Outcome flashThrough(const Context& context, Flashing& flashing) {
    if (auto begun = flashing.begin(); !begun) return begun;
    if (!context.invocation.has("--force")) {
        if (auto compared = flashing.compare(); !compared) return compared;
        if (flashing.incomplete() == 0) {
            context.output.line(Words::tr("Nothing is to be done; --force sends it all the same."));
            return context.invocation.has("--yes") ? flashing.commitWhatIsThere() : Outcome{};
        }
    }
    if (!context.invocation.has("--yes")) {
        return tl::unexpected<Failure>(
            {kFailed,
             {Words::tr("This would replace the firmware of %1.").arg(robotsPhrase(flashing.incomplete())),
              Words::tr("If that is meant, give --yes."),
              {}},
             QStringLiteral("needs-yes")});
    }
    if (auto kept = flashing.commitWhatIsThere(); !kept) return kept;
    return flashing.upload();
}

Outcome flash(const Context& context) {
    const auto robots = parseRobots(context.invocation.text("--robot"));
    if (!robots) return tl::unexpected(robots.error());
    auto files = readFirmwareFiles(context.invocation);
    if (!files) return tl::unexpected(files.error());
    for (const FirmwareFile& file : *files) {
        QJsonObject facts = firmwareToJson(file);
        facts[QStringLiteral("type")] = QStringLiteral("image");
        context.output.value(facts);
        context.output.line(firmwareText(file));
    }
    if (files->size() == 1 &&
        files->front().plan->target() == thunderbots::image::FlashTarget::Microcontroller)
        context.output.line(
            Words::tr("Afterwards the robot has no bitstream, and cannot drive before it is sent one."));
    if (context.invocation.has("--dry-run")) return {};
    Flashing flashing(context, *std::move(files), *robots);
    return flashing.end(flashThrough(context, flashing));
}

Outcome verifyOne(Flashing& flashing, int robot) {
    if (auto begun = flashing.begin(); !begun) return begun;
    if (auto compared = flashing.compare(); !compared) return compared;
    if (flashing.incomplete() == 0) return {};
    Failure failure;
    failure.text = {
        Words::tr("Robot %1 has something else than the file.").arg(robot), Words::tr("Flash it."), {}};
    failure.code = nameOf(name(Errc::NotVerified));
    return tl::unexpected(std::move(failure));
}

Outcome verify(const Context& context) {
    const auto robot = parseRobot(context.invocation.text("--robot"));
    if (!robot) return tl::unexpected(robot.error());
    auto files = readFirmwareFiles(context.invocation);
    if (!files) return tl::unexpected(files.error());
    Flashing flashing(context, *std::move(files), maskOf(*robot));
    return flashing.end(verifyOne(flashing, *robot));
}

constexpr OptionSpec kTarget{
    "--target", "pic|fpga",
    QT_TRANSLATE_NOOP("kickstandctl", "what the one file is for, where its bytes do not show it")};
constexpr std::array kFlashOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "robots: 3, or 0,5-7"), true},
    kTarget,
    OptionSpec{"--yes", "", QT_TRANSLATE_NOOP("kickstandctl", "do it; without it nothing is changed")},
    OptionSpec{"--dry-run", "", QT_TRANSLATE_NOOP("kickstandctl", "only read the files; needs no robot")},
    OptionSpec{"--force", "",
               QT_TRANSLATE_NOOP("kickstandctl", "send it to robots too that have it already")},
    OptionSpec{"--low-battery", "",
               QT_TRANSLATE_NOOP("kickstandctl", "flash robots too whose battery is below 14 V")},
    OptionSpec{"--discharged", "",
               QT_TRANSLATE_NOOP("kickstandctl",
                                 "a robot that reports nothing has an empty capacitor: you have "
                                 "seen to it")},
    OptionSpec{"--log", "FILE", QT_TRANSLATE_NOOP("kickstandctl", "write down what was done, and when")}};
constexpr std::array kVerifyOptions{
    OptionSpec{"--robot", "N", QT_TRANSLATE_NOOP("kickstandctl", "0-15"), true}, kTarget};

constexpr CommandSpec kCommands[] = {
    {"thunderbots flash", "FILE [FILE]", 1, 2,
     QT_TRANSLATE_NOOP("kickstandctl", "Uploads firmware to robots, verifies it and reboots them."),
     QT_TRANSLATE_NOOP(
         "kickstandctl",
         "Files: Intel HEX, binary, Xilinx .bit; one, or one for the microcontroller and one for the FPGA. "
         "Robots that have it already are left out. They have to be at rest and discharged. Ctrl+C cancels "
         "and says how each robot is left; the next run goes on from there. Exit 1 when any upload failed."),
     kFlashOptions, "thunderbots flash --robot 0-5 --yes main.hex fpga.bit", flash},
    {"thunderbots verify", "FILE [FILE]", 1, 2,
     QT_TRANSLATE_NOOP("kickstandctl", "Compares a robot's firmware with files, by its signatures."),
     QT_TRANSLATE_NOOP("kickstandctl", "Exit 0 when they are the same, 1 when not. Changes nothing."),
     kVerifyOptions, "thunderbots verify --robot 3 fpga.bit", verify},
};

}  // namespace

std::span<const CommandSpec> thunderbotsFlashCommands() {
    return kCommands;
}

}  // namespace kickstand::ctl
