#include "core/engine/describe_parameters.h"

#include <QCoreApplication>

#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

namespace wire = thunderbots::wire;
using thunderbots::EventKind;
using thunderbots::ParameterField;
using thunderbots::ParameterRisk;
using thunderbots::ParameterStanding;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(Parameters)
};

QString channelText(std::uint8_t channel) {
    if (channel == 0) return Words::tr("not configured");
    return QStringLiteral("0x%1 (%2)").arg(channel, 2, 16, QLatin1Char('0')).arg(channel);
}

QString signatureText(std::int64_t signature) {
    return QStringLiteral("0x%1").arg(signature & 0xFFFF, 4, 16, QLatin1Char('0'));
}

/// When a warning comes true, to begin its sentence.
QString whenText(ParameterStep step) {
    switch (step) {
        case ParameterStep::Apply:
            return Words::tr("Once this is committed and the robot has rebooted,");
        case ParameterStep::Commit:
            return Words::tr("From the robot's next boot on, be it a reboot or its switch,");
        case ParameterStep::Reboot:
            return Words::tr("When the robot comes back,");
    }
    return {};
}

}  // namespace

QString describe(const thunderbots::ParameterState& state) {
    switch (state.standing) {
        case ParameterStanding::Unread:
            if (state.movedTo >= 0)
                return Words::tr("Rebooted, to come back as robot %1.").arg(state.movedTo);
            return Words::tr("Not read yet.");
        case ParameterStanding::AsRead:
            return Words::tr("As read from the robot; nothing changed since.");
        case ParameterStanding::Applied:
            return Words::tr("Applied: lives until the robot reboots. Commit it to keep it.");
        case ParameterStanding::Committed:
            return Words::tr("Committed, unproven until the next reboot.");
        case ParameterStanding::Rebooted:
            return Words::tr("Committed and rebooted; reading it again will prove it.");
        case ParameterStanding::Proven:
            return Words::tr("Proven: read after a reboot, and just what was committed.");
        case ParameterStanding::Disproven:
            return Words::tr("Not kept: after the reboot the robot has something else than was committed.");
    }
    return {};
}

QString describe(ParameterField field) {
    switch (field) {
        case ParameterField::FlashContents:
            return Words::tr("Flash contents");
        case ParameterField::Channel0:
            return Words::tr("Channel of radio 0");
        case ParameterField::Channel1:
            return Words::tr("Channel of radio 1");
        case ParameterField::RobotNumber:
            return Words::tr("Robot number");
        case ParameterField::DribblerDuty:
            return Words::tr("Dribbler duty");
    }
    return {};
}

QString describe(wire::FlashContents contents) {
    switch (contents) {
        case wire::FlashContents::FpgaBitstream:
            return Words::tr("FPGA bitstream");
        case wire::FlashContents::Microcontroller:
            return Words::tr("microcontroller");
        case wire::FlashContents::NoData:
            return Words::tr("no data");
    }
    return {};
}

QString describeValue(ParameterField field, std::uint8_t value) {
    switch (field) {
        case ParameterField::FlashContents: {
            wire::OperationalParameters block;
            block.flashContents = value;
            return describe(block.flash());
        }
        case ParameterField::Channel0:
        case ParameterField::Channel1:
            return channelText(value);
        case ParameterField::RobotNumber:
            return QString::number(value);
        case ParameterField::DribblerDuty:
            return Words::tr("%1 (%2 %)").arg(value).arg(thunderbots::dutyPercent(value), 0, 'f', 0);
    }
    return {};
}

QString describe(const thunderbots::ParameterWarning& warning, ParameterStep step) {
    const QString when = whenText(step) + QLatin1Char(' ');
    switch (warning.risk) {
        case ParameterRisk::NoChannel:
            return when + Words::tr(
                              "one of its radios has no channel: no dongle hears robot %1 any more, and "
                              "only its cable reaches it.")
                              .arg(warning.robot);
        case ParameterRisk::OtherChannels:
            return when + Words::tr(
                              "it uses channels %1 and %2, and this dongle does not: robot %3 is lost to it "
                              "until the dongle is set to those channels too.")
                              .arg(channelText(warning.channel0), channelText(warning.channel1))
                              .arg(warning.robot);
        case ParameterRisk::NumberTaken:
            return when + Words::tr(
                              "it answers as robot %1, and so does the robot %1 that is heard now: the "
                              "two disturb each other, and both do what either is told.")
                              .arg(warning.nextNumber);
        case ParameterRisk::NumberChanges:
            return when +
                   Words::tr("robot %1 answers as robot %2.").arg(warning.robot).arg(warning.nextNumber);
        case ParameterRisk::CopiesFlash:
            return when + Words::tr(
                              "it copies whatever is in its flash into its microcontroller. If that is "
                              "no verified firmware, the robot does not start any more.");
        case ParameterRisk::OtherBitstream:
            return when + Words::tr(
                              "its FPGA is given whatever is in the flash. If that is no verified "
                              "bitstream, the robot cannot drive.");
        case ParameterRisk::NoBitstream:
            return when + Words::tr("its FPGA gets no bitstream, and it cannot drive.");
    }
    return {};
}

std::optional<EventText> describeParameterEvent(const thunderbots::Event& event) {
    switch (event.kind) {
        case EventKind::ParametersRead:
            return EventText{Words::tr("parameters read: %1").arg(printable(event.text)),
                             Severity::Information};
        case EventKind::ParametersApplied:
            return EventText{Words::tr("parameters applied: they live until the robot reboots"),
                             Severity::Information};
        case EventKind::ParametersCommitted:
            return EventText{Words::tr("parameters committed, unproven until the next reboot"),
                             Severity::Information};
        case EventKind::ParametersProven:
            if (event.code != 0)
                return EventText{Words::tr("parameters proven: kept over the reboot"), Severity::Information};
            return EventText{Words::tr("parameters not kept: the robot has something else after its reboot"),
                             Severity::Warning};
        case EventKind::SignaturesRead:
            return EventText{Words::tr("build signatures: microcontroller %1, flash %2")
                                 .arg(signatureText(event.code), signatureText(event.previous)),
                             Severity::Information};
        case EventKind::RobotRebooting:
            return EventText{Words::tr("reboots, and is gone for some seconds"), Severity::Information};
        default:
            return std::nullopt;
    }
}

}  // namespace kickstand
