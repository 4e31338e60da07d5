#include "core/engine/describe_smartdevice.h"

#include <QCoreApplication>

#include "core/engine/describe_facts.h"

namespace kickstand {
namespace {

using smartdevice::EventKind;

struct DeviceWords {
    Q_DECLARE_TR_FUNCTIONS(DeviceWords)
};

EventText information(QString text) {
    return {std::move(text), Severity::Information};
}
EventText warning(QString text) {
    return {std::move(text), Severity::Warning};
}

/// Why a port cannot be used, to stand behind a colon.
QString reason(const smartdevice::Event& event) {
    Error error;
    error.code = static_cast<Errc>(event.code);
    error.port = event.text;
    QString what = describe(error).what;
    if (what.endsWith(QLatin1Char('.'))) what.chop(1);
    return what;
}

QString errorText(std::int64_t code) {
    switch (code) {
        case 0xFD:
            return DeviceWords::tr("unexpected packet delimiter");
        case 0xFE:
            return DeviceWords::tr("wrong checksum");
        case 0xFF:
            return DeviceWords::tr("generic error");
        default:
            return DeviceWords::tr("error %1").arg(code);
    }
}

EventText portEvent(const smartdevice::Event& event) {
    const QString port = printable(event.text);
    switch (event.kind) {
        case EventKind::PortFound:
            return information(DeviceWords::tr("serial port found: %1").arg(port));
        case EventKind::PortGone:
            return information(DeviceWords::tr("serial port gone: %1").arg(port));
        case EventKind::PortFailed:
            return warning(reason(event));
        case EventKind::PortSilent:
            return warning(DeviceWords::tr("nobody answers at %1").arg(port));
        default:
            return warning(
                DeviceWords::tr("the user's catalogue cannot be read, so it is left out: %1").arg(port));
    }
}

}  // namespace

QString describe(smartdevice::Presence presence) {
    switch (presence) {
        case smartdevice::Presence::Live:
            return DeviceWords::tr("live");
        case smartdevice::Presence::Quiet:
            return DeviceWords::tr("quiet");
        case smartdevice::Presence::Lost:
            return DeviceWords::tr("lost");
    }
    return {};
}

QString describe(smartdevice::PortPhase phase) {
    switch (phase) {
        case smartdevice::PortPhase::Opening:
            return DeviceWords::tr("opening");
        case smartdevice::PortPhase::Asking:
            return DeviceWords::tr("asking who is there");
        case smartdevice::PortPhase::Talking:
            return DeviceWords::tr("connected");
        case smartdevice::PortPhase::Silent:
            return DeviceWords::tr("nobody answers");
        case smartdevice::PortPhase::Failed:
            return DeviceWords::tr("cannot be opened");
    }
    return {};
}

QString describe(smartdevice::WriteVerdict verdict) {
    switch (verdict) {
        case smartdevice::WriteVerdict::None:
            return {};
        case smartdevice::WriteVerdict::Pending:
            return DeviceWords::tr("pending");
        case smartdevice::WriteVerdict::Done:
            return DeviceWords::tr("done");
        case smartdevice::WriteVerdict::Refused:
            return DeviceWords::tr("refused");
        case smartdevice::WriteVerdict::Changed:
            return DeviceWords::tr("changed by the device");
        case smartdevice::WriteVerdict::Unconfirmed:
            return DeviceWords::tr("sent, unconfirmed");
    }
    return {};
}

Description describeCatalogueError(const Error& error) {
    return {DeviceWords::tr("The catalogue of your own boards is left out: %1: %2.")
                .arg(printable(error.subject), printable(error.detail)),
            DeviceWords::tr("Put the file right, or take it away; what it has to be stands in the help."),
            {}};
}

QString ownNameKey(const smartdevice::wire::Uid& uid) {
    return QStringLiteral("smartdevice/names/") + QString::fromStdString(smartdevice::wire::toText(uid));
}

EventText describeSmartDeviceEvent(const smartdevice::Event& event) {
    const QString text = printable(event.text);
    switch (event.kind) {
        case EventKind::DeviceFound:
            return information(DeviceWords::tr("found: %1").arg(text));
        case EventKind::DeviceBack:
            return information(DeviceWords::tr("back: %1").arg(text));
        case EventKind::DeviceQuiet:
            return warning(DeviceWords::tr("nothing comes from it"));
        case EventKind::DeviceLost:
            return warning(DeviceWords::tr("lost: %1").arg(text));
        case EventKind::DeviceReset:
            return warning(DeviceWords::tr("it began anew; its updates were asked for again"));
        case EventKind::Subscribed:
            if (event.code == 0) return information(DeviceWords::tr("sends no updates"));
            return information(DeviceWords::tr("sends updates every %1 ms").arg(event.code));
        case EventKind::Ungranted:
            return warning(
                DeviceWords::tr("grants no updates, though it was asked %1 times").arg(event.code));
        case EventKind::Update:
            return information(DeviceWords::tr("sent an update"));
        case EventKind::WriteRefused:
            return warning(DeviceWords::tr("%1 was refused").arg(text));
        case EventKind::WriteChanged:
            return warning(DeviceWords::tr("%1 was changed to %2").arg(text).arg(event.value));
        case EventKind::Disabled:
            return information(DeviceWords::tr("disabled"));
        case EventKind::DeviceError:
            return warning(DeviceWords::tr("it reports: %1").arg(errorText(event.code)));
        case EventKind::Misfit:
            return warning(
                DeviceWords::tr("its data do not fit its kind: %1 bytes came where %2 were expected")
                    .arg(event.code)
                    .arg(event.previous));
        case EventKind::Stopped:
            return information(DeviceWords::tr("stopped and disabled: %1").arg(text));
        default:
            return portEvent(event);
    }
}

}  // namespace kickstand
