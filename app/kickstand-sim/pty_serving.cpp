#include "app/kickstand-sim/pty_serving.h"

#include <QString>
#include <filesystem>

#include "app/kickstand-sim/serving.h"
#include "app/kickstand-sim/words.h"

namespace kickstand::sim {
namespace {

std::string absolute(const std::string& path) {
    std::error_code error;
    return std::filesystem::absolute(path, error).string();
}

tl::unexpected<ctl::Failure> nowhere() {
    return ctl::badUsage(Words::tr("Nothing says where the serial port is to be."),
                         Words::tr("Add --pty PATH."));
}

}  // namespace

ctl::Expected<std::vector<std::string>> readPtyPaths(const Invocation& invocation) {
    std::vector<std::string> paths;
    const QString given = QString::fromStdString(std::string(invocation.text("--pty")));
    for (const QString& path : given.split(QLatin1Char(','), Qt::SkipEmptyParts))
        paths.push_back(absolute(path.toStdString()));
    if (paths.empty()) return nowhere();
    return paths;
}

ctl::Expected<std::string> readPtyPath(const Invocation& invocation) {
    if (invocation.text("--pty").empty()) return nowhere();
    return absolute(std::string(invocation.text("--pty")));
}

ctl::Outcome servePtysUntilTold(const Invocation& invocation, const QString& link,
                                const MakePtySimulation& make) {
    return serveUntilTold(invocation, [&](Scheduler& scheduler, Log&) -> ctl::Expected<Served> {
        PtySimulation made = make(scheduler);
        auto carrier = PtyCarrier::serve(scheduler, made.lines, link);
        if (!carrier) return tl::unexpected(carrier.error());
        return Served{std::move(made.simulation), std::move(*carrier)};
    });
}

}  // namespace kickstand::sim
