#include "app/kickstand-sim/usbip_carrier.h"

#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

constexpr const char* kBusId = "1-1";
constexpr std::uint16_t kUsbipPort = 3240;

bool isEveryAddress(const std::string& address) {
    return address == "0.0.0.0" || address == "::";
}

/// The address by which a program on this machine gets there.
QString localAddress(const std::string& address) {
    if (address == "0.0.0.0") return QStringLiteral("127.0.0.1");
    if (address == "::") return QStringLiteral("::1");
    return printable(address);
}

QString linkTo(const QString& address, std::uint16_t port) {
    const QString host = address.contains(QLatin1Char(':')) ? QStringLiteral("[%1]").arg(address) : address;
    return QStringLiteral("usbip:%1:%2/%3").arg(host).arg(port).arg(QLatin1String(kBusId));
}

/// The server's refusal in the terms of this program's options.
ctl::Failure explain(const Error& error, const UsbipServerOptions& options) {
    ctl::Failure failure = ctl::failed(error).value();
    const QString address = printable(options.address);
    if (error.code == Errc::ClaimedElsewhere) {
        failure.text = {Words::tr("Port %1 of %2 is in use.").arg(options.port).arg(address),
                        Words::tr("Choose another with --port N, or --port 0 for any that is free."),
                        {}};
    } else if (error.code == Errc::PermissionDenied) {
        failure.text = {Words::tr("This user may not listen on port %1.").arg(options.port),
                        Words::tr("Choose one from 1024 on, with --port N."),
                        {}};
    } else if (error.code == Errc::BadArgument) {
        failure.exitCode = ctl::kBadUsage;
        failure.text = {
            options.anyAddress
                ? Words::tr("“%1” is not an address of this machine.").arg(address)
                : Words::tr("“%1” is not an address that only this machine reaches.").arg(address),
            Words::tr("It is a numeric one, as 127.0.0.1 or ::1; one that other machines reach needs "
                      "--any-address, and whoever reaches it can use the device."),
            {}};
    } else {
        failure.text.what = Words::tr("Nothing can be served at %1, port %2: %3.")
                                .arg(address)
                                .arg(options.port)
                                .arg(printable(error.detail));
        failure.text.remedy = Words::tr("Choose another with --address and --port.");
    }
    return failure;
}

}  // namespace

UsbipCarrier::UsbipCarrier(std::unique_ptr<UsbipServer> server, std::string address)
    : server_(std::move(server)), address_(std::move(address)) {}

ctl::Expected<std::unique_ptr<UsbipCarrier>> UsbipCarrier::serve(Scheduler& scheduler, UsbDeviceModel& device,
                                                                 const UsbipServerOptions& options,
                                                                 UsbipServer::Log log) {
    auto server =
        UsbipServer::serve(scheduler, {{.busId = kBusId, .model = &device}}, options, std::move(log));
    if (!server) return tl::unexpected(explain(server.error(), options));
    return std::unique_ptr<UsbipCarrier>(new UsbipCarrier(std::move(*server), options.address));
}

QJsonObject UsbipCarrier::report() const {
    const UsbipServerReport report = server_->report();
    return {{QStringLiteral("kind"), QStringLiteral("usbip")},
            {QStringLiteral("link"), linkTo(localAddress(address_), server_->port())},
            {QStringLiteral("address"), printable(address_)},
            {QStringLiteral("port"), server_->port()},
            {QStringLiteral("bus_id"), QLatin1String(kBusId)},
            {QStringLiteral("in_use"), report.inUse},
            {QStringLiteral("connections"), static_cast<qint64>(report.connections)},
            {QStringLiteral("refused"), static_cast<qint64>(report.refused)},
            {QStringLiteral("malformed"), static_cast<qint64>(report.malformed)},
            {QStringLiteral("overrun"), static_cast<qint64>(report.overrun)},
            {QStringLiteral("imports"), static_cast<qint64>(report.imports)},
            {QStringLiteral("transfers"), static_cast<qint64>(report.transfers)},
            {QStringLiteral("unlinked"), static_cast<qint64>(report.unlinked)}};
}

QStringList UsbipCarrier::howToReach() const {
    const QString address = localAddress(address_);
    const QString port =
        server_->port() == kUsbipPort ? QString() : QStringLiteral(" --tcp-port %1").arg(server_->port());
    QStringList lines{
        Words::tr("From a program, without the kernel:"),
        QStringLiteral("  kickstandctl --link %1 doctor").arg(linkTo(address, server_->port())),
        Words::tr("As a USB device of this machine (Linux; usbip is in the package “usbip”):"),
        QStringLiteral("  sudo modprobe vhci-hcd && sudo usbip%1 attach -r %2 -b %3")
            .arg(port, address, QLatin1String(kBusId)),
    };
    if (isEveryAddress(address_))
        lines << Words::tr("From another machine: the same, with this machine's address in place of %1.")
                     .arg(address);
    return lines;
}

}  // namespace kickstand::sim
