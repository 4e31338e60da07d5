#include "core/engine/describe_flash.h"

#include <QCoreApplication>
#include <cmath>

#include "core/base/hex.h"
#include "core/engine/describe_images.h"
#include "core/engine/describe_parameters.h"
#include "core/thunderbots/wire/parameters.h"

namespace kickstand {
namespace {

using thunderbots::EventKind;
using thunderbots::FlashLeft;
using thunderbots::FlashLogLine;
using thunderbots::FlashNote;
using thunderbots::FlashProgress;
using thunderbots::FlashStage;

struct FlashWords {
    Q_DECLARE_TR_FUNCTIONS(FlashWords)
};

QString hexText(std::int64_t number) {
    return QStringLiteral("0x%1").arg(number & 0xFFFF, 4, 16, QLatin1Char('0'));
}

QString secondsText(std::int64_t time_ms) {
    return FlashWords::tr("%1 s").arg(static_cast<double>(time_ms) / 1000, 0, 'f', 1);
}

QString contentsText(std::int64_t number) {
    thunderbots::wire::OperationalParameters parameters;
    parameters.flashContents = static_cast<std::uint8_t>(number);
    return describe(parameters.flash());
}

QString reasonText(std::int64_t code) {
    Error error;
    error.code = static_cast<Errc>(code);
    return describe(error).what;
}

/// What happened to the flash, up to the verification.
std::optional<QString> writingNote(const FlashLogLine& line) {
    switch (line.note) {
        case FlashNote::Began:
            return FlashWords::tr("begun: signature %1, pages to send: %2").arg(hexText(line.a)).arg(line.b);
        case FlashNote::Contents:
            return FlashWords::tr("the robot says that its flash has: %1").arg(contentsText(line.a));
        case FlashNote::MarkedNoData:
            return FlashWords::tr("marked as having no data");
        case FlashNote::Found:
            return FlashWords::tr("pages that are still missing: %1 of %2").arg(line.a).arg(line.b);
        case FlashNote::FoundOther:
            return FlashWords::tr("something else is at %1: it has to be erased")
                .arg(addressText(static_cast<std::uint32_t>(line.a)));
        case FlashNote::Erasing:
            return FlashWords::tr("erasing, attempt %1").arg(line.a);
        case FlashNote::Erased:
            return FlashWords::tr("erased in %1").arg(secondsText(line.a));
        case FlashNote::Wrote:
            return FlashWords::tr("pages written: %1, in %2").arg(line.a).arg(secondsText(line.b));
        case FlashNote::PageAgain:
            return FlashWords::tr("page %1 was not taken: attempt %2").arg(line.a).arg(line.b);
        case FlashNote::Verified:
            return FlashWords::tr("bytes verified: %1, in %2").arg(line.a).arg(secondsText(line.b));
        default:
            return std::nullopt;
    }
}

QString noteText(const FlashLogLine& line) {
    if (auto text = writingNote(line)) return *std::move(text);
    switch (line.note) {
        case FlashNote::Activated:
            return FlashWords::tr("committed: its flash has %1").arg(contentsText(line.a));
        case FlashNote::RebootSent:
            return FlashWords::tr("told to reboot");
        case FlashNote::Back:
            return FlashWords::tr("back after %1").arg(secondsText(line.a));
        case FlashNote::NotYetCopied:
            return FlashWords::tr("it has still to copy the image");
        case FlashNote::Signatures:
            return FlashWords::tr("signatures: microcontroller %1, flash %2")
                .arg(hexText(line.a), hexText(line.b));
        case FlashNote::Paused:
            return FlashWords::tr("paused by STOP");
        case FlashNote::Resumed:
            return FlashWords::tr("resumed");
        default:
            return line.a == 0 ? FlashWords::tr("done") : FlashWords::tr("ended: %1").arg(reasonText(line.a));
    }
}

Description runningText(int robot, const FlashProgress& progress) {
    const QString what = describe(progress.target);
    if (progress.paused) {
        return {FlashWords::tr("Robot %1, %2: paused by STOP while %3.")
                    .arg(robot)
                    .arg(what, describe(progress.stage)),
                FlashWords::tr("Re-arm and resume, or cancel it."),
                {}};
    }
    QString text = FlashWords::tr("Robot %1, %2: %3").arg(robot).arg(what, describe(progress.stage));
    if (progress.total_B > 0)
        text += FlashWords::tr(", %1 %").arg(100.0 * progress.done_B / progress.total_B, 0, 'f', 0);
    return {FlashWords::tr("%1, about %2 left.").arg(text, durationText(progress.remaining)), {}, {}};
}

}  // namespace

QString describe(FlashStage stage) {
    switch (stage) {
        case FlashStage::Reading:
            return FlashWords::tr("reading its parameters");
        case FlashStage::Marking:
            return FlashWords::tr("marking it as without data");
        case FlashStage::Surveying:
            return FlashWords::tr("looking at what is there");
        case FlashStage::Erasing:
            return FlashWords::tr("erasing");
        case FlashStage::Writing:
            return FlashWords::tr("writing");
        case FlashStage::Verifying:
            return FlashWords::tr("verifying");
        case FlashStage::Activating:
            return FlashWords::tr("committing");
        case FlashStage::Rebooting:
            return FlashWords::tr("rebooting");
        case FlashStage::Confirming:
            return FlashWords::tr("reading its signatures");
        case FlashStage::Done:
            return FlashWords::tr("done");
        case FlashStage::Failed:
            return FlashWords::tr("failed");
        case FlashStage::Cancelled:
            return FlashWords::tr("cancelled");
    }
    return {};
}

QString describe(FlashLeft left) {
    switch (left) {
        case FlashLeft::Untouched:
            return FlashWords::tr("Nothing in it has changed.");
        case FlashLeft::NoData:
            return FlashWords::tr(
                "It says that its flash has no data: it runs, and cannot drive before the next upload, "
                "which goes on where this one ended.");
        case FlashLeft::Activated:
            return FlashWords::tr(
                "What it has in its flash was verified; it takes effect at its next reboot.");
        case FlashLeft::Rebooted:
            return FlashWords::tr(
                "It was told to reboot with what was verified, and has not said that it runs it.");
        case FlashLeft::Complete:
            return FlashWords::tr("It runs what was sent.");
    }
    return {};
}

QString durationText(Duration span) {
    const auto time_s = static_cast<std::int64_t>(std::ceil(seconds(span)));
    if (time_s < 60) return FlashWords::tr("%1 s").arg(time_s);
    return FlashWords::tr("%1 min %2 s").arg(time_s / 60).arg(time_s % 60);
}

Description describeFlash(int robot, const FlashProgress& progress) {
    if (progress.running()) return runningText(robot, progress);
    const QString took = durationText(progress.endedAt - progress.beganAt);
    switch (progress.stage) {
        case FlashStage::Done:
            return {FlashWords::tr("Robot %1 has its new firmware, verified and running, after %2.")
                        .arg(robot)
                        .arg(took),
                    {},
                    {}};
        case FlashStage::Cancelled:
            return {FlashWords::tr("The upload to robot %1 was cancelled. %2")
                        .arg(robot)
                        .arg(describe(progress.left)),
                    {},
                    {}};
        default:
            break;
    }
    Description text = progress.error ? describe(*progress.error) : Description{};
    text.what = FlashWords::tr("The upload to robot %1 failed: %2 %3")
                    .arg(robot)
                    .arg(text.what, describe(progress.left));
    return text;
}

QStringList flashLogLines(const FlashProgress& progress) {
    QStringList lines;
    if (progress.parametersBefore) {
        const auto block = thunderbots::wire::encodeParameters(*progress.parametersBefore);
        lines << FlashWords::tr("parameters before it began: %1")
                     .arg(QString::fromStdString(toHex(block.view())));
    }
    for (const FlashLogLine& line : *progress.log) {
        lines << QStringLiteral("%1  %2")
                     .arg(seconds(line.time - progress.beganAt), 8, 'f', 3)
                     .arg(noteText(line));
    }
    return lines;
}

std::optional<EventText> describeFlashEvent(const thunderbots::Event& event) {
    const auto information = [](QString text) { return EventText{std::move(text), Severity::Information}; };
    const auto warning = [](QString text) { return EventText{std::move(text), Severity::Warning}; };
    switch (event.kind) {
        case EventKind::FlashStarted:
            return information(FlashWords::tr("upload begun, pages to send: %1").arg(event.code));
        case EventKind::FlashPaused:
            return warning(FlashWords::tr("upload paused by STOP"));
        case EventKind::FlashResumed:
            return information(FlashWords::tr("upload resumed"));
        case EventKind::FlashEnded: {
            if (event.code == 0)
                return information(
                    FlashWords::tr("upload done after %1").arg(durationText(fromSeconds(event.value))));
            return warning(
                FlashWords::tr("upload ended: %1 %2")
                    .arg(reasonText(event.code), describe(static_cast<FlashLeft>(event.previous))));
        }
        default:
            return std::nullopt;
    }
}

}  // namespace kickstand
