#include "app/kickstand-sim/pty_carrier.h"

#include <QJsonArray>

#include "app/kickstand-sim/words.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {

ctl::Expected<std::unique_ptr<PtyCarrier>> PtyCarrier::serve(Scheduler& scheduler,
                                                             const std::vector<ServedLine>& lines,
                                                             QString link) {
    auto carrier = std::unique_ptr<PtyCarrier>(new PtyCarrier(std::move(link)));
    for (const ServedLine& line : lines) {
        auto port = makePtyPort(scheduler, *line.device, line.path);
        if (!port) {
            ctl::Failure failure = ctl::failed(port.error()).value();
            const QString path = printable(line.path);
            if (port.error().code == Errc::ClaimedElsewhere)
                failure.text = {Words::tr("Another program serves a serial port at %1.").arg(path),
                                Words::tr("End that one, or choose another path with --pty."),
                                {}};
            else
                failure.text = {
                    Words::tr("Nothing can be served at %1: %2.").arg(path, printable(port.error().detail)),
                    Words::tr("Choose another path with --pty."),
                    {}};
            return tl::unexpected(std::move(failure));
        }
        carrier->ports_.push_back({line.path, std::move(*port)});
    }
    return carrier;
}

QString PtyCarrier::uriOf(const Port& port) const {
    return QStringLiteral("serial:%1%2").arg(printable(port.path), link_);
}

QJsonObject PtyCarrier::report() const {
    QJsonArray ports;
    for (const Port& port : ports_) {
        ports.append(QJsonObject{{QStringLiteral("link"), uriOf(port)},
                                 {QStringLiteral("path"), printable(port.path)},
                                 {QStringLiteral("terminal"), QString::fromStdString(port.port->terminal())},
                                 {QStringLiteral("lost_bytes"), static_cast<qint64>(port.port->lost())}});
    }
    return {{QStringLiteral("kind"), QStringLiteral("pty")},
            {QStringLiteral("link"), ports_.empty() ? QString() : uriOf(ports_.front())},
            {QStringLiteral("ports"), ports}};
}

QStringList PtyCarrier::howToReach() const {
    QStringList lines{Words::tr("From any program, at these serial ports:")};
    for (const Port& port : ports_)
        lines << QStringLiteral("  ") + printable(port.path);
    lines << Words::tr("From this one's other half:");
    for (const Port& port : ports_)
        lines << QStringLiteral("  kickstandctl --link '%1' …").arg(uriOf(port));
    return lines;
}

}  // namespace kickstand::sim
