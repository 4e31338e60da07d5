#include "app/kickstand-sim/serving.h"

#include <QJsonArray>

#include "app/kickstand-sim/control_path.h"
#include "app/kickstand-sim/control_server.h"
#include "app/kickstand-sim/end_signals.h"
#include "app/kickstand-sim/run_on.h"
#include "app/kickstand-sim/words.h"
#include "core/base/thread_scheduler.h"
#include "core/engine/describe_facts.h"

namespace kickstand::sim {
namespace {

ctl::Failure explainControl(const Error& error, const std::string& path) {
    ctl::Failure failure = ctl::failed(error).value();
    const QString shown = printable(path);
    if (error.code == Errc::ClaimedElsewhere && error.detail.empty()) {
        failure.text = {Words::tr("Another simulator has its control socket at %1.").arg(shown),
                        Words::tr("End that one, or name another place with --control PATH."),
                        {}};
    } else {
        const QString why = error.detail.empty() ? QLatin1String(name(error.code)) : printable(error.detail);
        failure.text = {Words::tr("There can be no control socket at %1: %2.").arg(shown, why),
                        Words::tr("Name another place with --control PATH."),
                        {}};
    }
    return failure;
}

/// Everything that lives on the simulator's thread, in the order in which it may go: last first.
struct Stage {
    Served served;
    std::unique_ptr<ControlDesk> desk;
    std::unique_ptr<ControlServer> control;
};

/// Makes the stage and says so. On the simulator's thread.
class Opening {
  public:
    Opening(Scheduler& scheduler, Log& log, const Invocation& invocation)
        : scheduler_(scheduler), log_(log), given_(invocation.text("--control")) {}

    ctl::Outcome open(const Make& make, Stage& stage) {
        const ControlPath where = given_.empty() ? defaultControlPath() : ControlPath{given_, {}};
        if (auto made = makeFolder(where); !made) return made;
        auto served = make(scheduler_, log_);
        if (!served) return tl::unexpected(served.error());
        stage.served = std::move(*served);
        stage.desk = std::make_unique<ControlDesk>(*stage.served.simulation, stage.served.carrier.get());
        auto control = ControlServer::serve(scheduler_, where.path, *stage.desk,
                                            [this](const std::string& line) { log_.event(line); });
        if (!control) return tl::unexpected(explainControl(control.error(), where.path));
        stage.control = std::move(*control);
        announce(stage.served, where.path);
        return {};
    }

  private:
    void announce(const Served& served, const std::string& path) {
        const Simulation& simulation = *served.simulation;
        const QString shown = printable(path);
        QStringList text{Words::tr("Serving %1.").arg(simulation.description()), {}};
        text << served.carrier->howToReach() << QString();
        text << Words::tr("Control socket: %1").arg(shown);
        text << QStringLiteral("  kickstand-sim ctl%1 show")
                    .arg(given_.empty() ? QString() : QStringLiteral(" --control ") + shown);
        text << QString() << Words::tr("Ctrl+C ends it. Who comes and goes:");
        QJsonArray units;
        for (const int unit : simulation.units())
            units.append(unit);
        log_.announce(text.join(QLatin1Char('\n')),
                      {{QStringLiteral("type"), QStringLiteral("serving")},
                       {QStringLiteral("system"), QLatin1String(simulation.family())},
                       {QLatin1String(simulation.unitName()) + QLatin1Char('s'), units},
                       {QStringLiteral("carrier"), served.carrier->report()},
                       {QStringLiteral("control"), shown}});
    }

    Scheduler& scheduler_;
    Log& log_;
    const std::string given_;
};

}  // namespace

ctl::Outcome serveUntilTold(const Invocation& invocation, const Make& make) {
    if (invocation.has("--control") && invocation.text("--control").empty())
        return ctl::badUsage(Words::tr("--control names no place."), Words::tr("Give the path of a file."));
    EndSignals ending;
    Log log(invocation.has("--json"));
    ThreadScheduler scheduler;
    Opening opening(scheduler, log, invocation);
    Stage stage;
    ctl::Outcome opened = runOn(scheduler, [&] { return opening.open(make, stage); });
    if (opened) log.event("ended by " + ending.wait());
    runOn(scheduler, [&] {
        stage.control.reset();
        stage.desk.reset();
        stage.served.carrier.reset();
        stage.served.simulation.reset();
    });
    return opened;
}

}  // namespace kickstand::sim
